// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How well a slit was sewn up: what is left of its opening when the attempt ends.

#include "assessment/metrics.h"

namespace placode::assessment {

/// The event of the station that gapes most; nullptr where there was no slit, or nobody looked.
[[nodiscard]] const sim::Event* widest_gap(const sim::Recording& recording);

/// Edges this near at the end count as shut [m].
inline constexpr double kShutM = 0.0002;

/// A leak is stated at this pressure: 6 cmH2O [Pa]. In the sac 6 to 12.5 cmH2O were measured
/// during repair. Source: J Pediatr Surg 2020;55:726 (abstract).
inline constexpr double kLeakPa = 588.4;

/// A stretch of a slit that goes right through tissue of rigid walls [m].
struct LeakyGap {
    double length_m = 0;             ///< Along the slit.
    double mouth_m = 0, neck_m = 0;  ///< Between the walls, at the surface and at the narrowest.
    double depth_m = 0;              ///< The walls taper straight from mouth to neck.
};

/// Fluid that it lets through at kLeakPa [m3/s]: viscous between the walls, and through the neck as
/// through an orifice, in series. Nothing where it is shut; finite for every finite gap.
/// Source: Reynolds' lubrication, 12 mu L Q / (w g^3), its integral over a taper; Torricelli with
/// a discharge coefficient of 0.6.
[[nodiscard]] double leak_m3_s(const LeakyGap& gap);

/// Share that is shut, mean and widest gap, leak; nothing where there was no slit, no leak where
/// its depth was not recorded.
void add_closure_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
