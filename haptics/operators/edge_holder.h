// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A hand that holds the edge of a wound while the other one bites: with its grasper from above, the
// jaws open along the wound, beside the place where the needle passes.

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

class EdgeHolder {
 public:
    EdgeHolder(const OperatorProfile& profile, uint64_t seed, const Vec3& home_m)
        : motion_(profile, seed, home_m) {}

    /// Where it shall hold now, which way the wound runs, and how far it shall raise the edge;
    /// nowhere without `wanted`. A place that differs from the one it holds by little is the same.
    void want(bool wanted, const Vec3& place_m, const Vec3& along, double raise_m) noexcept;
    void see(bool holds) noexcept { holds_ = holds; }
    [[nodiscard]] HandAction act(double time_s, double dt_s) noexcept;
    /// What was wanted is done: it holds there, or cannot; it has let go and is away.
    [[nodiscard]] bool ready() const noexcept;

 private:
    enum class Stage : uint8_t { kAway, kOver, kDown, kClose, kHold, kLetGo, kUp };
    void stage(Stage next) noexcept;

    HandMotion motion_;
    Stage stage_ = Stage::kAway;
    Vec3 place_m_ = Vec3::Zero(), wanted_m_ = Vec3::Zero(), along_ = Vec3::UnitX();
    bool wanted_ = false, holds_ = false, changed_ = false, raised_ = false;
    double stage_s_ = 0, raise_m_ = 0;
    int tries_ = 0;
};

}  // namespace placode::haptics
