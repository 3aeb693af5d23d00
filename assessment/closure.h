// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How well a slit was sewn up: what is left of its opening when the attempt ends, and what it
// holds.

#include <optional>

#include "assessment/metrics.h"
#include "sim/world/slit.h"

namespace placode::assessment {

/// The event of the station that gapes most; nullptr where there was no slit, or nobody looked.
[[nodiscard]] const sim::Event* widest_gap(const sim::Recording& recording);

/// Edges this near at the end count as shut [m].
inline constexpr double kShutM = 0.0002;

/// A leak between rigid walls is stated at this pressure [Pa].
inline constexpr double kLeakPa = sim::WatertightSpec::kPassPa;

/// A stretch of a slit that goes right through tissue of rigid walls [m].
struct LeakyGap {
    double length_m = 0;             ///< Along the slit.
    double mouth_m = 0, neck_m = 0;  ///< Between the walls, at the surface and at the narrowest.
    double depth_m = 0;              ///< The walls taper straight from mouth to neck.
};

/// Fluid that it lets through at kLeakPa [m3/s]: sim/contact/slit_flow.h. Nothing where it is shut;
/// finite for every finite gap.
[[nodiscard]] double leak_m3_s(const LeakyGap& gap);

/// A slit put under pressure (sim/step/watertight.h).
struct Watertight {
    double pass_m3_s = 0, good_m3_s = 0;  ///< Leak at the lower and at the higher pressure.
    double held_pa = 0;                   ///< It burst here, or the pressure rose no further.
    const sim::Event* worst = nullptr;    ///< The station that leaks most at the lower one.
};
/// Absent where it was not tested, or the test was not finished.
[[nodiscard]] std::optional<Watertight> watertight_of(const sim::Recording& recording);

/// Share that is shut, mean and widest gap, leaks, pressure that it held, where it leaks most and
/// where it burst; nothing where there was no slit. The leak between rigid walls only where it was
/// not tested and its depth was recorded.
void add_closure_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
