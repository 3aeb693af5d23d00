// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A patch against itself. Where it is folded, every vertex keeps the thickness of the patch from
// what lies in front of it and behind it: a spring that pushes the vertex alone, against where the
// other part goes by its velocity, as its tie to the tissue (patch_vertex.h). The vertices of the
// other part do the same, so that both give way; what the two do not have in common the six
// unknowns of the whole correct (patch_modes.h). Not here: a fold that is pressed through itself by
// more than its thickness, which is pushed out on that side.

#include <cstdint>

#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// Start of a frame: which triangles of the patch every vertex may meet before the next one.
void collect_patch_folds(const Scene& scene, State& state) noexcept;

/// A spring on one vertex of a patch: force = k (place - x), both kept as sums.
struct PatchSpring {
    Mat3 k_n_m = Mat3::Zero();
    Vec3 k_place_n = Vec3::Zero();  ///< k place [N].
};

/// Within a substep: what keeps vertex `number` of the patch off the rest of it. False when nothing
/// does. @param press_pa_m pressure for every metre of overlap. h [s].
bool add_patch_folds(const Scene& scene, const State& state, int32_t number, double press_pa_m,
                     double h, PatchSpring& spring) noexcept;

}  // namespace placode::sim
