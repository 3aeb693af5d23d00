// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The law of a touched vertex: a spring along the normal while things overlap, dry friction with a
// memory, and a step that stays within the elements. Used by contact_core.cpp. Any one system of
// units.

#include <cassert>

#include "sim/solver/vertex_step.h"

namespace placode::sim {

/// Stiffness of a contact against what the touched vertices answer at once. Sphere of 1.5 mm
/// pressed 0.1 mm into skin (edges 0.1 mm): 2 to 8 are quiet and 0.2 to 1 % below the rigid force;
/// 25 and more burst, because a vertex with a small weight then overshoots before its neighbours
/// answer.
inline constexpr double kContactRatio = 6;

/// A spring along the normal acts on a vertex that carries share `b` of the touched point.
/// @param gap negative: the overlap. @pre gap < 0
inline void add_normal_contact(VertexSystem& system, double k, double b, double gap,
                               const Vec3& n) noexcept {
    assert(gap < 0);
    system.gradient += k * gap * b * n;
    system.hessian += (k * b * b) * n * n.transpose();
}

/// Tangential spring to the place where a vertex sticks, softened where Coulomb's cone ends.
struct Friction {
    Vec3 slide = Vec3::Zero();  ///< Tangential part of the distance from the anchor.
    Vec3 normal = Vec3::UnitZ();
    double stiffness_n_m = 0, limit_n = 0;
};

/// @param load normal force on the vertex. @pre not zero
/// @param from_anchor from the place where it sticks to where it is now.
/// @param limit_n what the cone holds. @param stiffness_n_m of the spring while it sticks.
[[nodiscard]] inline Friction dry_friction(const Vec3& load, const Vec3& from_anchor,
                                           double limit_n, double stiffness_n_m) noexcept {
    assert(load != Vec3::Zero());
    Friction f;
    f.normal = load / load.norm();
    f.slide = from_anchor - f.normal * f.normal.dot(from_anchor);
    f.limit_n = limit_n;
    f.stiffness_n_m = stiffness_n_m;
    const double length = f.slide.norm();
    if (length * f.stiffness_n_m > f.limit_n) f.stiffness_n_m = f.limit_n / length;
    return f;
}

inline void add_friction(VertexSystem& system, const Friction& f) noexcept {
    system.gradient += f.stiffness_n_m * f.slide;
    system.hessian += f.stiffness_n_m * (Mat3::Identity() - f.normal * f.normal.transpose());
}

}  // namespace placode::sim
