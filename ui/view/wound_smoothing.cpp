// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/wound_smoothing.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace placode::view {

void WoundSmoothing::build(std::span<const Vertex> vertices, std::span<const unsigned> triangles) {
    moving_.clear();
    twin_.clear();
    for (size_t c = 0; c < vertices.size(); ++c) {
        const Vertex& v = vertices[c];
        if (!v.moves || (v.twin >= 0 && v.fresh)) continue;  // set together with its other half
        moving_.push_back(static_cast<int>(c));
        twin_.push_back(v.twin);
    }
    link(vertices, triangles);
}

void WoundSmoothing::link(std::span<const Vertex> vertices, std::span<const unsigned> triangles) {
    // Both halves of a rim vertex count as one: its half on the skin.
    const auto one = [&](unsigned c) {
        const Vertex& v = vertices[c];
        return v.twin >= 0 && v.fresh ? v.twin : static_cast<int>(c);
    };
    std::vector<int> slot(vertices.size(), -1);
    for (size_t m = 0; m < moving_.size(); ++m)
        slot[static_cast<size_t>(moving_[m])] = static_cast<int>(m);
    struct Edge {
        int at, other;  // place among moving_, neighbour
        int sides;      // 1 = of the skin, 2 = of a wall, 3 = between them: the rim
        bool operator<(const Edge& e) const {
            return std::tie(at, other) < std::tie(e.at, e.other);
        }
    };
    std::vector<Edge> edges;
    for (size_t k = 0; k + 2 < triangles.size(); k += 3) {
        const int side = vertices[triangles[k]].fresh ? 2 : 1;
        for (size_t e = 0; e < 3; ++e) {
            const int a = one(triangles[k + e]), b = one(triangles[k + (e + 1) % 3]);
            const int at_a = slot[static_cast<size_t>(a)], at_b = slot[static_cast<size_t>(b)];
            if (at_a >= 0) edges.push_back({at_a, b, side});
            if (at_b >= 0) edges.push_back({at_b, a, side});
        }
    }
    std::sort(edges.begin(), edges.end());
    all_start_.assign(1, 0);
    all_.clear();
    rim_.clear();
    rim_start_.assign(1, 0);
    rim_all_.clear();
    size_t at = 0;
    for (size_t m = 0; m < moving_.size(); ++m) {
        const bool rim = twin_[m] >= 0;
        const size_t all = all_.size(), along = rim_all_.size();
        while (at < edges.size() && edges[at].at == static_cast<int>(m)) {
            const int other = edges[at].other;
            int sides = 0;
            for (; at < edges.size() && edges[at].at == static_cast<int>(m) &&
                   edges[at].other == other;
                 ++at)
                sides |= edges[at].sides;
            all_.push_back(other);
            if (rim && sides == 3) rim_all_.push_back(other);
        }
        // A rim is a curve: neighbours beside it, more on one side than on the other, would pull
        // its corners out again.
        if (rim_all_.size() >= along + 2) {
            all_.resize(all);
            all_.insert(all_.end(), rim_all_.begin() + static_cast<std::ptrdiff_t>(along),
                        rim_all_.end());
        }
        all_start_.push_back(static_cast<int>(all_.size()));
        if (!rim) continue;
        rim_.push_back(static_cast<int>(m));
        rim_start_.push_back(static_cast<int>(rim_all_.size()));
    }
}

}  // namespace placode::view
