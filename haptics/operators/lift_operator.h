// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator for grasping and lifting: takes hold of the zone at three places around the
// placode, lifts, holds, lowers, lets go.

#include <vector>

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

class LiftOperator final : public ScriptedOperator {
 public:
    LiftOperator(OperatorLevel level, uint64_t seed, size_t tool, const Vec3& home_m);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

 private:
    enum class Stage : uint8_t {
        kLook,
        kReach,
        kLower,
        kClose,
        kLift,
        kHold,
        kLay,
        kOpen,
        kRise,
        kLeave,
        kDone
    };
    void stage(Stage next) noexcept;
    void move(double dt_s) noexcept;
    void go_to_the_place() noexcept;
    void rise(double dt_s) noexcept;
    void lower(double dt_s) noexcept;
    void close(double dt_s) noexcept;
    void lay(double dt_s) noexcept;
    void next_round() noexcept;
    [[nodiscard]] Vec3 place() const noexcept;

    OperatorLevel level_;
    OperatorProfile profile_;
    HandMotion hand_;
    size_t tool_;
    std::vector<Vec3> contour_, normal_;
    Vec3 centre_ = Vec3::Zero(), error_ = Vec3::Zero();
    bool touches_ = false, holds_ = false;
    Stage stage_ = Stage::kLook;
    double time_s_ = 0, stage_s_ = 0, height_m_ = 0, low_m_ = 0;
    int round_ = 0, tries_ = 0;
};

}  // namespace placode::haptics
