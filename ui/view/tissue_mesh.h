// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The drawn tissue: current surface triangles turned into a smooth, shaded mesh. What was cut open
// gets vertices of its own (the wall's colours end at the rim) and is rounded, so that no
// tetrahedron shows.

#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/view_field.h"
#include "ui/view/wound_refinement.h"
#include "ui/view/wound_smoothing.h"

namespace placode::view {

/// 16 floats a vertex: position 3, normal 3, rest + depth 4, damage 4, hollow, fresh. [mm]
inline constexpr int kTissueVertexFloats = 16;
inline constexpr float kBodyC = 37;  ///< Tissue that was never heated [deg C].

class TissueMesh {
 public:
    explicit TissueMesh(const ViewField& field);

    /// Follows the snapshot. True when `indices()` changed.
    bool update(const sim::Snapshot& snapshot);
    /// Whether triangles around a cut are drawn in four; from the next update on.
    void set_fine(bool fine);
    /// True where something has been cut open.
    [[nodiscard]] bool cut() const { return !smoothing_.moving().empty(); }
    [[nodiscard]] const std::vector<float>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<unsigned>& indices() const {
        return fine_ ? refined_ : indices_;
    }

 private:
    void rebuild(const sim::Snapshot& snapshot);
    void rest_places(const sim::Snapshot& snapshot);
    void number_vertices(const sim::Snapshot& snapshot);
    void link_neighbours();
    void place(const sim::Snapshot& snapshot);
    void shade();
    void smooth_normals();
    void find_hollows();
    void write();
    void write_middles();
    [[nodiscard]] bool drawn(const sim::SurfaceTriangle& triangle) const;

    std::vector<Eigen::Vector3f> rest_mm_;
    std::vector<float> depth_mm_;
    size_t whole_ = 0;  // vertices of the field; copies follow
    bool has_depth_ = false, has_sac_ = false;
    Eigen::Vector2f low_ = Eigen::Vector2f::Zero(), high_ = low_;  // box of the field [mm]
    uint32_t version_ = 0;
    size_t triangle_count_ = 0;
    int32_t slides_ = 0;
    std::vector<Eigen::Vector3f> mesh_mm_;  // (V) at rest in the mesh
    bool built_ = false, fine_ = false;

    // Compact vertices: one for each (vertex, fresh) that is drawn.
    std::vector<int> slot_of_;    // (2 V)
    std::vector<int> vertex_of_;  // compact -> V
    std::vector<WoundSmoothing::Vertex> marks_;
    std::vector<unsigned> indices_, refined_;
    std::vector<int> near_start_, near_;  // neighbours of compact vertices, CSR
    std::vector<Eigen::Vector3f> position_, normal_, scratch_;
    std::vector<Eigen::Vector4f> rest_, damage_;  // place and depth at rest; heat
    std::vector<float> hollow_, scratch_hollow_;
    std::vector<float> vertices_;
    WoundSmoothing smoothing_;
    WoundRefinement refinement_;
};

}  // namespace placode::view
