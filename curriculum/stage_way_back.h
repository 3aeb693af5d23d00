// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What hands do when a stage has been reached: they let go of tissue, rise from it, go back to
// where they began, and wait until the tissue is calm. A driver keeps its needle, and goes the
// straight way: its thread may be taut, and no detour may pull at it.

#include <array>
#include <span>

#include "sim/core/tool.h"
#include "sim/world/state.h"

namespace placode::curriculum {

class StageWayBack {
 public:
    using Hands = std::array<sim::ToolInput, sim::kMaxTools>;
    /// @param home where they began. @param now where they are.
    StageWayBack(const sim::Scene& scene, const sim::State& state, const Hands& home,
                 const Hands& now);

    /// The inputs of the next frame, `dt_s` after the last one; false: the way is over.
    [[nodiscard]] bool next(const sim::State& state, std::span<sim::ToolInput> hands, double dt_s);

 private:
    void place(std::span<sim::ToolInput> hands) const;

    const sim::Scene& scene_;
    Hands home_, from_;
    std::array<bool, sim::kMaxTools> keeps_{}, holds_{};  ///< A needle; tissue.
    double time_s_ = 0, calm_s_ = 0, release_s_ = 0, travel_s_ = 0;
};

}  // namespace placode::curriculum
