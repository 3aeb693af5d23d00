// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Splits the drawn triangles around a cut into four, with curved edges: a wall bends instead of
// folding at every element, and its rim is a curve instead of a polygon.

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "ui/view/wound_smoothing.h"

namespace placode::view {

class WoundRefinement {
 public:
    /// Every edge with an end that moves is split; triangles beside them follow, so that no gap
    /// opens. Fills `refined` with the triangles to draw: new vertices follow the given ones.
    void build(std::span<const WoundSmoothing::Vertex> vertices,
               std::span<const unsigned> triangles, std::vector<unsigned>& refined);
    [[nodiscard]] size_t count() const { return edges_.size(); }
    /// Place of new vertex `i`. Inner edges bend as the normals at their ends ask (Boubekeur &
    /// Alexa 2008, "Phong tessellation"), those of the rim as its neighbours along the rim do.
    [[nodiscard]] Eigen::Vector3f place(size_t i, std::span<const Eigen::Vector3f> position,
                                        std::span<const Eigen::Vector3f> normal) const;
    struct Edge {
        int a = 0, b = 0;             ///< Ends, a < b.
        int before = -1, after = -1;  ///< On the rim: its next vertices beyond a and b.
        bool rim = false;
    };
    [[nodiscard]] const Edge& edge(size_t i) const { return edges_[i]; }

 private:
    void find_rim(std::span<const WoundSmoothing::Vertex> vertices,
                  std::span<const unsigned> triangles);
    [[nodiscard]] int number_of(unsigned a, unsigned b) const;  // among edges_, or -1
    std::vector<Edge> edges_;                                   // sorted by (a, b)
};

}  // namespace placode::view
