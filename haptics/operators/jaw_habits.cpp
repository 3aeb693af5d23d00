// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/jaw_habits.h"

#include <array>

namespace placode::haptics {

namespace {

JawHabits intermediate() {
    JawHabits h;
    h.squeeze = 0.22;
    h.close_rad_s = 0.5;
    h.aim_error_m = 4e-4;
    h.lift_m = 0.0016;
    h.lift_m_s = 0.004;
    h.tension_m = 0.0009;
    h.blade_rad = 0.28;
    h.snip_step_m = 0.0008;
    h.wander_m = 3e-4;
    h.outward_m = 2e-4;
    h.clear_m = 3e-4;
    h.passes = 3;
    h.leaves = 0.35;
    return h;
}

JawHabits novice() {
    JawHabits h;
    h.squeeze = 1.0;
    h.close_rad_s = 1.5;
    h.aim_error_m = 8e-4;
    h.lift_m = 0.0045;
    h.lift_m_s = 0.012;
    h.tension_m = 0.0030;
    h.blade_rad = 0.45;
    h.snip_rad_s = 3.0;
    h.snip_step_m = 0.0012;
    h.depth_m = 0.0014;
    h.wander_m = 6e-4;
    h.outward_m = 6e-4;
    h.clear_m = -1;  // does not look
    h.passes = 2;
    h.leaves = 0.6;
    return h;
}

}  // namespace

const JawHabits& jaw_habits(OperatorLevel level) noexcept {
    static const std::array habits{JawHabits{}, intermediate(), novice()};
    return habits[static_cast<size_t>(level)];
}

}  // namespace placode::haptics
