// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The drawn tissue: current surface triangles turned into a smooth, shaded mesh. What was cut open
// gets vertices of its own (a crease at the rim) and is rounded, so that no tetrahedron shows.

#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/view_field.h"

namespace placode::view {

/// 16 floats a vertex: position 3, normal 3, rest + depth 4, damage 4, hollow, fresh. [mm]
inline constexpr int kTissueVertexFloats = 16;

class TissueMesh {
 public:
    explicit TissueMesh(const ViewField& field);

    /// Follows the snapshot. True when `indices()` changed.
    bool update(const sim::Snapshot& snapshot);
    [[nodiscard]] const std::vector<float>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<unsigned>& indices() const { return indices_; }

    /// The back beyond the simulated field: follows the field's edge, never moves.
    [[nodiscard]] const std::vector<float>& skirt_vertices() const { return skirt_vertices_; }
    [[nodiscard]] const std::vector<unsigned>& skirt_indices() const { return skirt_indices_; }

 private:
    void rebuild(const sim::Snapshot& snapshot);
    void place(const sim::Snapshot& snapshot);
    void shade();
    [[nodiscard]] bool on_rim(size_t c) const;  // of a cut, by compact vertex
    void build_skirt(const ViewField& field);
    [[nodiscard]] bool drawn(const sim::SurfaceTriangle& triangle) const;

    std::vector<Eigen::Vector3f> rest_mm_;
    std::vector<float> depth_mm_;
    size_t whole_ = 0;  // vertices of the field; copies follow
    bool has_depth_ = false;
    uint32_t version_ = 0;
    size_t triangle_count_ = 0;
    int32_t slides_ = 0;
    std::vector<Eigen::Vector3f> mesh_mm_;  // (V) at rest in the mesh
    bool built_ = false;

    // Compact vertices: one for each (vertex, fresh) that is drawn.
    std::vector<int> slot_of_;      // (2 V)
    std::vector<int> vertex_of_;    // compact -> V
    std::vector<uint8_t> fresh_;    // compact
    std::vector<uint8_t> touched_;  // (V) part of a fresh triangle
    std::vector<unsigned> indices_;
    std::vector<int> near_start_, near_;  // neighbours of compact vertices, CSR
    std::vector<Eigen::Vector3f> position_, normal_, scratch_;
    std::vector<float> hollow_, scratch_hollow_;
    std::vector<float> vertices_;
    std::vector<float> skirt_vertices_;
    std::vector<unsigned> skirt_indices_;
};

}  // namespace placode::view
