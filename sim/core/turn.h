// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small turns of rods, needles and other rigid things, as Newton's steps take them.

#include <algorithm>
#include <cmath>

#include "sim/core/geometry.h"

namespace placode::sim {

/// Turn that takes `from` to `to` [rad, W], as turn_by() takes it; the angle while it is small.
[[nodiscard]] inline Vec3 turn_between(const Quat& from, const Quat& to) noexcept {
    Quat d = to * from.conjugate();
    if (d.w() < 0) d.coeffs() = -d.coeffs();
    return 2 / std::max(d.w(), 1e-3) * d.vec();
}

/// Turns `q` by a small turn [rad, W]: by (1, turn / 2), normalised.
inline void turn_by(Quat& q, const Vec3& turn) noexcept {
    q = Quat(1, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()) * q;
    q.coeffs() *= 1 / std::sqrt(q.squaredNorm());
}

/// Inertia of a point about the origin: m (r . r - r r^T) [kg m^2].
[[nodiscard]] inline Mat3 inertia_of(double mass_kg, const Vec3& r_m) noexcept {
    return mass_kg * (r_m.squaredNorm() * Mat3::Identity() - r_m * r_m.transpose());
}

}  // namespace placode::sim
