// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Habits of one level with jaws and blades. Chosen by trial on the default operative field so that
// the levels order by what they do to the tissue.

#include "haptics/operators/operator_profile.h"

namespace placode::haptics {

struct JawHabits {
    double open_rad = 0.35;       ///< Grasper, before it takes hold.
    double meet_rad = 0.12;       ///< Where jaws feel tissue (a script feels no resistance).
    double squeeze = 0.15;        ///< Share of the way from there to shut.
    double close_rad_s = 0.6;     ///< Speed of closing.
    double aim_error_m = 1e-4;    ///< Where it takes hold, rms.
    double lift_m = 0.0011;       ///< Height that it lifts to.
    double lift_m_s = 0.003;      ///< How fast.
    double hold_s = 3;            ///< For how long.
    double tension_m = 0.0005;    ///< Lift while the other hand cuts.
    double blade_rad = 0.22;      ///< Opening of the blades.
    double snip_rad_s = 1.6;      ///< Speed of closing.
    double snip_step_m = 0.0009;  ///< Advance between snips.
    double depth_m = 0.0008;      ///< Tips below the surface.
    double wander_m = 1e-4;       ///< Snips beside the line, rms.
    double outward_m = 0;         ///< Mean error away from the marked tissue.
    double clear_m = 6e-4;        ///< Blades do not close nearer to the placode than that.
    int passes = 4;               ///< Along what is not parted yet.
    double leaves = 0.1;          ///< Share of the marked tissue that is left where it is.
    [[nodiscard]] double squeezed_rad() const noexcept { return meet_rad * (1 - squeeze); }
};
[[nodiscard]] const JawHabits& jaw_habits(OperatorLevel level) noexcept;

}  // namespace placode::haptics
