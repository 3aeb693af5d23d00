// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A surface that is drawn and never operated on, vertex by vertex and square by square. Vertices as
// in tissue_mesh.h.

#include <Eigen/Dense>
#include <iterator>
#include <vector>

#include "ui/view/tissue_mesh.h"

namespace placode::view {

struct DrawnMesh {
    std::vector<float> vertices;
    std::vector<unsigned> indices;
};

/// What a vertex of these surfaces needs; they were never heated.
struct DrawnVertex {
    Eigen::Vector3f place, normal;
    float depth_mm = 0, hollow = 0, fresh = 0;
};

inline void add_vertex(DrawnMesh& mesh, const DrawnVertex& r) {
    const Eigen::Vector3f &p = r.place, &n = r.normal;
    const float row[kTissueVertexFloats] = {p.x(), p.y(),  p.z(),    n.x(),      n.y(), n.z(),
                                            p.x(), p.y(),  p.z(),    r.depth_mm, 0,     0,
                                            0,     kBodyC, r.hollow, r.fresh};
    mesh.vertices.insert(mesh.vertices.end(), std::begin(row), std::end(row));
}

/// Two triangles between p, p + 1 and q, q + 1 beside them.
inline void add_square(DrawnMesh& mesh, unsigned p, unsigned q) {
    mesh.indices.insert(mesh.indices.end(), {p, p + 1, q, q, p + 1, q + 1});
}

}  // namespace placode::view
