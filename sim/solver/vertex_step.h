// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One vertex that is solved by itself, because an instrument or a needle acts on it: Newton's step,
// kept within the elements around it. Any one system of units.

#include <Eigen/Cholesky>
#include <cmath>

#include "sim/solver/soft_body.h"

namespace placode::sim {

/// Share of the shortest edge at a vertex that one solve of it may move it.
inline constexpr double kLongestContactStep = 0.25;

/// Some axes are held: the vertex does not step along them, and they take no part in the others.
/// @param axes bit 0 = x, bit 1 = y, bit 2 = z.
inline void hold_axes(VertexSystem& system, uint8_t axes) noexcept {
    for (int a = 0; a < 3; ++a) {
        if ((axes >> a & 1) == 0) continue;
        system.gradient[a] = 0;
        system.hessian.row(a).setZero();
        system.hessian.col(a).setZero();
        system.hessian(a, a) = 1;
    }
}

/// Newton's step of one vertex and how long it may be.
struct VertexStep {
    Vec3 step = Vec3::Zero();
    bool finite = true;    ///< false: the step is nothing.
    bool limited = false;  ///< It was longer than the elements allow, and was cut.
};

[[nodiscard]] inline VertexStep vertex_step(const VertexSystem& system, double relaxation,
                                            double shortest_edge_m) noexcept {
    VertexStep out;
    out.step = -relaxation * system.hessian.llt().solve(system.gradient);
    const double length = out.step.norm(), longest = kLongestContactStep * shortest_edge_m;
    out.finite = std::isfinite(length);
    if (!out.finite) {
        out.step = Vec3::Zero();
    } else if (length > longest) {
        out.limited = true;
        out.step *= longest / length;
    }
    return out;
}

}  // namespace placode::sim
