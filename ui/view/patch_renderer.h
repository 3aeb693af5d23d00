// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A patch as a wet, translucent sheet over the tissue, made anew for every picture.

#include <array>
#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/gl_program.h"

namespace placode::view {

/// Corners and indices of the patch, in the layout of tissue_vertex.glsl, in W [mm].
struct PatchMesh {
    std::vector<float> vertices;
    std::vector<unsigned> indices;
    /// @param rest places at rest [m], by vertex of the field: its felt moves with it.
    void build(const sim::Snapshot& snapshot, const std::vector<std::array<float, 3>>& rest);

 private:
    /// Corners of edges that belong to one triangle alone: looked for again when there are others.
    void find_rim(const sim::Snapshot& snapshot, int32_t first, size_t count);

    void find_corners(const sim::Snapshot& snapshot, int32_t first);
    void split_corners();

    struct Corner {
        std::array<size_t, 2> triangles;
        unsigned a, b;  ///< Ends of the side that both have.
    };
    std::vector<Corner> corners_;
    std::vector<float> rim_;  ///< By vertex from the patch's first: 1 at its edge, 0 inside.
    size_t rim_triangles_ = 0;
};

class PatchRenderer {
 public:
    explicit PatchRenderer(const std::vector<std::array<float, 3>>& rest);
    /// Over what is drawn already. With the program of the instruments, in use.
    void draw(const sim::Snapshot& snapshot, GlProgram& program);

 private:
    std::vector<std::array<float, 3>> rest_;
    PatchMesh mesh_;
    GlMesh gl_;
};

}  // namespace placode::view
