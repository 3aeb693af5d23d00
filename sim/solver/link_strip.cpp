// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/link_strip.h"

#include <algorithm>

namespace placode::sim {
namespace {

class Builder {
 public:
    explicit Builder(const std::vector<LinkTriangle>& triangles)
        : triangles_(triangles), neighbours_(triangles.size(), {-1, -1, -1}) {
        // neighbours_[f][k] = triangle over the edge opposite to local vertex k.
        for (size_t f = 0; f < triangles.size(); ++f) {
            for (size_t g = 0; g < triangles.size(); ++g) {
                if (f == g) continue;
                int shared = 0, odd = -1;
                for (int k = 0; k < 3; ++k) {
                    if (local(g, triangles[f].vertex[static_cast<size_t>(k)]) >= 0) {
                        ++shared;
                    } else {
                        odd = k;
                    }
                }
                if (shared == 2) neighbours_[f][static_cast<size_t>(odd)] = static_cast<int>(g);
            }
        }
    }

    /// The strip that begins with triangle `f`, local vertex `k` loaded last.
    const std::vector<StripStep>& build(size_t f, int k) {
        steps_.clear();
        visited_.assign(triangles_.size(), 0);
        left_ = static_cast<int>(triangles_.size());
        pair_[0] = pair_[1] = -1;
        load(corner(f, k + 1));
        load(corner(f, k + 2));
        int current = enter(f);
        while (left_ > 0) {
            const int next = follow(current);
            current = next >= 0 ? enter(static_cast<size_t>(next)) : restart(current);
        }
        return steps_;
    }

 private:
    [[nodiscard]] int32_t corner(size_t f, int k) const {
        return triangles_[f].vertex[static_cast<size_t>(k % 3)];
    }
    [[nodiscard]] int local(size_t f, int32_t vertex) const {
        for (int k = 0; k < 3; ++k) {
            if (corner(f, k) == vertex) return k;
        }
        return -1;
    }
    [[nodiscard]] int unvisited_neighbours(size_t f) const {
        int n = 0;
        for (const int g : neighbours_[f]) n += g >= 0 && visited_[static_cast<size_t>(g)] == 0;
        return n;
    }

    /// Loads a vertex without a triangle; the older of the pair goes.
    void load(int32_t vertex) {
        steps_.push_back({vertex, -1, 1, false});
        pair_ = {pair_[1], vertex};
    }

    /// The step of triangle `f`, whose other two vertices are the pair. `keep` is set later.
    int enter(size_t f) {
        int k = 0;
        while (corner(f, k) == pair_[0] || corner(f, k) == pair_[1]) ++k;
        const int8_t sign = corner(f, k + 1) == pair_[0] ? 1 : -1;
        steps_.push_back({corner(f, k), triangles_[f].tet, sign, false});
        before_ = pair_;
        pair_ = {pair_[1], corner(f, k)};
        visited_[f] = 1;
        --left_;
        return static_cast<int>(f);
    }

    void choose_older(bool keep) {
        steps_.back().keep = keep;
        pair_[0] = keep ? before_[0] : before_[1];
    }

    /// Next triangle over one of the two new edges: the one with fewer sides on. -1 = dead end.
    int follow(int current) {
        int best = -1, best_sides = 4;
        bool best_keep = false;
        for (const bool keep : {false, true}) {
            // The edge (kept, P) lies opposite to the vertex that goes.
            const int gone = local(static_cast<size_t>(current), before_[keep ? 1 : 0]);
            const int g = neighbours_[static_cast<size_t>(current)][static_cast<size_t>(gone)];
            if (g < 0 || visited_[static_cast<size_t>(g)] != 0) continue;
            const int sides = unvisited_neighbours(static_cast<size_t>(g));
            if (sides < best_sides) {
                best = g;
                best_sides = sides;
                best_keep = keep;
            }
        }
        if (best >= 0) choose_older(best_keep);
        return best;
    }

    /// After a dead end: a triangle that shares a vertex with the last one costs one load.
    int restart(int current) {
        size_t best = triangles_.size();
        int best_cost = 100;
        for (size_t f = 0; f < triangles_.size(); ++f) {
            if (visited_[f] != 0) continue;
            bool touches = false;
            for (int k = 0; k < 3; ++k) {
                touches |= local(f, corner(static_cast<size_t>(current), k)) >= 0;
            }
            const int cost = 4 * (touches ? 1 : 2) + unvisited_neighbours(f);
            if (cost < best_cost) {
                best = f;
                best_cost = cost;
            }
        }
        int shared = local(best, pair_[1]);
        if (shared < 0) {
            for (const bool keep : {false, true}) {
                const int k = local(best, before_[keep ? 0 : 1]);
                if (k < 0) continue;
                // Keep that vertex through one load: (kept, P) -> load with keep -> (kept, new).
                choose_older(keep);
                steps_.push_back({corner(best, k + 1), -1, 1, true});
                pair_ = {pair_[0], corner(best, k + 1)};
                return enter(best);
            }
            load(corner(best, 0));
            shared = 0;
        }
        load(corner(best, shared + 1));
        return enter(best);
    }

    const std::vector<LinkTriangle>& triangles_;
    std::vector<std::array<int, 3>> neighbours_;
    std::vector<StripStep> steps_;
    std::vector<uint8_t> visited_;
    std::array<int32_t, 2> pair_{}, before_{};
    int left_ = 0;
};

}  // namespace

std::vector<StripStep> link_strip(const std::vector<LinkTriangle>& triangles) {
    std::vector<StripStep> best;
    Builder builder(triangles);
    for (size_t f = 0; f < triangles.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto& steps = builder.build(f, k);
            if (best.empty() || steps.size() < best.size()) best = steps;
            if (best.size() == triangles.size() + 2) return best;
        }
    }
    return best;
}

}  // namespace placode::sim
