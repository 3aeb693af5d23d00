// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A patch that covers the lesion: a sheet without tetrahedra, whose vertices and triangles are part
// of the one soft body. What never changes of it. docs/patch.md

#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh/surface.h"

namespace placode::sim {

struct Patch {
    int32_t first_vertex = 0, vertex_count = 0;  ///< Behind those of the tissue.
    /// Both sides can be touched. Without a tet: `tet` is -1, and `tissue` only a label.
    std::vector<SurfaceTriangle> triangles;
    std::vector<float> area_m2;  ///< (vertices of the patch) Share of its area.
    /// (V) 1 = a vertex of the tissue's surface that can bear the patch: set_load() works there.
    std::vector<uint8_t> bears;
    double thickness_m = 4e-4;
    double friction = 0.3;       ///< Coulomb, on wet tissue.
    double tool_friction = 0.2;  ///< The same on instruments, dynamic.

    [[nodiscard]] bool owns(int32_t vertex) const noexcept {
        return vertex >= first_vertex && vertex < first_vertex + vertex_count;
    }
};

}  // namespace placode::sim
