// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Working memory of a patch: what its vertices touch within a substep (sim/contact/patch_vertex.h),
// and which of its own triangles they may meet within a frame (sim/contact/patch_fold.h).

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/tool_shape.h"

namespace placode::sim {

struct Scene;

/// A vertex of the patch on the tissue. Set before the sweep of a substep, read after it.
struct PatchTie {
    bool touches = false;  ///< Nearer to a face than half of the thickness, or about to be.
    bool holds = false;    ///< The spring below acts in this substep.
    std::array<int32_t, 3> face{};
    Vec3 weight = Vec3::Zero(), n = Vec3::UnitZ();  ///< Nearest point of the face, way from there.
    Triangle ahead;                                 ///< The face at the end of the substep.
    double press_n_m = 0;                           ///< Along n.
    double overlap_at_m = 0;                        ///< n . x below which it presses.
    Vec3 anchor = Vec3::Zero();                     ///< Where friction holds it.
    Mat3 k_n_m = Mat3::Zero();
    Vec3 place = Vec3::Zero();   ///< Force of the tissue: -k (x - place).
    Vec3 load_n = Vec3::Zero();  ///< What the face bears of it, after the sweep.
};

/// Sized by the constructor, never grows. Empty in a scene without a patch.
struct PatchScratch {
    explicit PatchScratch(const Scene& scene);

    std::vector<PatchTie> ties;  ///< (vertices of the patch)
    /// The nearest triangle of the patch that is no neighbour at rest, and the nearest on the other
    /// side; -1 = none within reach (vertices of the patch). Not to be read unless `folded`.
    std::vector<std::array<int32_t, 2>> folds;
    bool folded = false;  ///< In this frame.
    /// Cells of space, each with its triangles: of cell c triangle[start[c] .. start[c + 1]).
    std::vector<int32_t> cell_start, cell_triangle;
    std::vector<int32_t> cell_of;   ///< (triangles)
    std::vector<Vec3> rest_centre;  ///< (triangles) Constant.
    double apart_m = 0;             ///< At rest, what is nearer cannot meet. Constant.
};

}  // namespace placode::sim
