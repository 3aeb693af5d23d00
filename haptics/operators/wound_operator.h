// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator that closes a wide wound: two graspers undermine the skin on both sides, then
// the right hand changes to the needle driver and sews, while the left one holds the edge through
// which the point passes and lets go before the thread is drawn.

#include "haptics/operators/edge_holder.h"
#include "haptics/operators/suture_operator.h"
#include "haptics/operators/undermine_operator.h"

namespace placode::haptics {

/// Which tool is which.
struct WoundTools {
    std::array<size_t, 2> graspers{};  ///< Right, left.
    size_t driver = 0;
};

class WoundOperator final : public ScriptedOperator {
 public:
    WoundOperator(OperatorLevel level, uint64_t seed, const WoundTools& tools,
                  std::span<const sim::ToolSpec> specs, std::span<const Vec3> homes);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

 private:
    enum class Stage : uint8_t { kUndermine, kChange, kSew };
    void hold_edge() noexcept;

    WoundTools tools_;
    bool holds_edge_;  ///< A novice leaves the other hand where it is.
    Stage stage_ = Stage::kUndermine;
    UndermineOperator undermine_;
    SutureOperator suture_;
    EdgeHolder holder_;
    sim::PracticeGoal goal_;
    double time_s_ = 0;
};

}  // namespace placode::haptics
