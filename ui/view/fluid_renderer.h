// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Standing fluid, jets, crumbs and spots of blood, made anew for every picture. Corners are in the
// layout of tissue_vertex.glsl, in W [mm].

#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/gl_program.h"

namespace placode::view {

/// Corners and indices of one kind of thing.
struct FluidMesh {
    std::vector<float> vertices;
    std::vector<unsigned> indices;

    /// The surface of what stands deeper than a film, run on a little into the tissue around.
    void build_pool(const sim::FluidSnapshot& fluid);
    /// Lumps of char and flat clots.
    void build_specks(const sim::FluidSnapshot& fluid);
    void build_jets(const sim::Snapshot& snapshot);

 private:
    /// The cells of a pool: their levels, and which of them have a corner.
    void level_cells(const sim::FluidSnapshot& fluid);
    void add_pool_corners(const sim::FluidSnapshot& fluid);
    void add_pool_faces(int columns, int rows);
    void clear() noexcept;
    void corner(const Eigen::Vector3f& p, const Eigen::Vector3f& n, float material, float a,
                float b, float c);
    std::vector<int> number_;  ///< (cells) Of the corner in a cell, -1 = none.
    std::vector<float> level_;
};

class FluidRenderer {
 public:
    FluidRenderer();
    /// Over tissue and instruments. With the program of the instruments, in use.
    void draw(const sim::Snapshot& snapshot, GlProgram& program);

 private:
    void draw_mesh();
    FluidMesh mesh_;
    GlMesh gl_;
};

}  // namespace placode::view
