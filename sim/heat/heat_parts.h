// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the files of heat.h share. Internal to it.

#include <algorithm>
#include <array>

#include "sim/heat/heat.h"

namespace placode::sim {

inline constexpr double kBoilC = 100;

/// So many powers are worked out side by side: each is a chain of divisions, which a processor
/// overlaps and vectorises.
inline constexpr int kPowers = 8;
using Powers = std::array<double, kPowers>;

/// 2^x of each, from arithmetic alone. The C library's exp2 may give other bits on another
/// processor, and replays must not.
void exp2_portable(Powers& x) noexcept;

/// Exponents of 2 in the rates of thermal dose and of damage. 0.25^x = 2^(-2x), 0.5^x = 2^(-x).
[[nodiscard]] double cem43_exponent(double temperature_c) noexcept;
[[nodiscard]] double arrhenius_exponent(double ea_j_mol, double temperature_c) noexcept;

[[nodiscard]] inline double smoothstep(double from, double to, double x) noexcept {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Gradients of the barycentric coordinates (3 x 4) [1/m], and the volume [m^3].
[[nodiscard]] Eigen::Matrix<double, 3, 4> shape_gradients(const TetMesh& mesh, int tet,
                                                          double& volume) noexcept;
/// Of the face opposite to local vertex `face` [m^2].
[[nodiscard]] double face_area(const TetMesh& mesh, int tet, int face) noexcept;

}  // namespace placode::sim
