// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a straight line meets first of the tissue's surface as it is now.

#include "sim/core/geometry.h"

namespace placode::sim {

struct State;

struct RayHit {
    int triangle = -1;  ///< Into SurfaceState::triangles(); -1 = nothing within reach.
    double distance_m = 0;
    Vec3 weight = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  ///< Outward.
};

/// @param direction of length 1; from outside only: faces seen from behind are not met.
[[nodiscard]] RayHit first_hit(const State& state, const Vec3& from, const Vec3& direction,
                               double reach_m) noexcept;

}  // namespace placode::sim
