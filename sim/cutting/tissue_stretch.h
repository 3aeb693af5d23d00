// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far tissue is stretched against its stress-free shape: of one tet, and as a mean over a
// neighbourhood of a size that tissue has and a mesh has not.
// Source of the mean: G. Pijaudier-Cabot, Z. P. Bazant, "Nonlocal damage theory", J. Eng. Mech. 113
// (1987). At the tip of a cut strain grows without end as elements get smaller; the mean over a
// fixed length does not, and so whether tissue tears does not hang on the mesh.

#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// Right Cauchy-Green deformation of a tet against its stress-free shape.
[[nodiscard]] Mat3 cauchy_green(const Scene& scene, const State& state, int tet) noexcept;

/// Largest principal stretch of a tet.
[[nodiscard]] double principal_stretch(const Scene& scene, const State& state, int tet) noexcept;

/// Largest principal stretch of the mean right stretch tensor U over the tissue within `radius_m`
/// at rest of a tet: of its own kind, and joined to it within that distance over uncut faces.
/// Weights are volume times (1 - (d / radius)^2)^2. Of one tet where the radius is 0.
[[nodiscard]] double mean_stretch(const Scene& scene, const State& state, int tet,
                                  double radius_m) noexcept;

}  // namespace placode::sim
