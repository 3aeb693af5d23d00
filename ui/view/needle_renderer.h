// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A suture needle and its thread as tubes, made anew for every picture: both bend and move.

#include <array>
#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/gl_program.h"

namespace placode::view {

/// Corners and indices of tubes, in the layout of tissue_vertex.glsl, in W [mm].
struct NeedleMesh {
    std::vector<float> vertices;
    std::vector<unsigned> indices;
    /// Takes the needle, steel with a taper at its point and a thicker swage, the thread and the
    /// loop at its end.
    void build(const sim::NeedleSnapshot& needle);
};

class NeedleRenderer {
 public:
    NeedleRenderer();
    /// With the program of the instruments, in use.
    void draw(const sim::NeedleSnapshot& needle, GlProgram& program);

 private:
    NeedleMesh mesh_;
    GlMesh gl_;
};

}  // namespace placode::view
