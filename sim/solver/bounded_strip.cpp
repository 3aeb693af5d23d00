// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/solver/bounded_strip.h"

#include <algorithm>

namespace placode::sim {

void BoundedStrip::build(std::span<const LinkTriangle> triangles) noexcept {
    triangles_ = triangles.first(std::min<size_t>(triangles.size(), kMostTriangles));
    size_ = 0;
    if (triangles_.empty()) return;
    find_neighbours();
    int best_size = 0;
    for (int k = 0; k < 3; ++k) {
        run(0, k);
        if (best_size == 0 || size_ < best_size) {
            std::copy_n(steps_.begin(), size_, best_.begin());
            std::copy_n(met_.begin(), triangles_.size(), best_met_.begin());
            best_size = size_;
        }
        if (best_size == static_cast<int>(triangles_.size()) + 2) break;
    }
    size_ = best_size;
    std::copy_n(best_.begin(), size_, steps_.begin());
    std::copy_n(best_met_.begin(), triangles_.size(), met_.begin());
}

int BoundedStrip::local(size_t f, int32_t vertex) const noexcept {
    for (int k = 0; k < 3; ++k) {
        if (corner(f, k) == vertex) return k;
    }
    return -1;
}

/// neighbours_[f][k] = triangle over the edge opposite to local vertex k; edges are met twice, in
/// opposite directions, because the link is oriented.
void BoundedStrip::find_neighbours() noexcept {
    const size_t n = triangles_.size();
    for (size_t f = 0; f < n; ++f) neighbours_[f] = {-1, -1, -1};
    for (size_t f = 0; f < n; ++f) {
        for (int k = 0; k < 3; ++k) {
            if (neighbours_[f][static_cast<size_t>(k)] >= 0) continue;
            const int32_t a = corner(f, k + 1), b = corner(f, k + 2);
            for (size_t g = f + 1; g < n; ++g) {
                for (int m = 0; m < 3; ++m) {
                    if (corner(g, m + 1) != b || corner(g, m + 2) != a) continue;
                    neighbours_[f][static_cast<size_t>(k)] = static_cast<int8_t>(g);
                    neighbours_[g][static_cast<size_t>(m)] = static_cast<int8_t>(f);
                }
            }
        }
    }
}

void BoundedStrip::run(size_t first, int last_corner) noexcept {
    size_ = 0;
    std::fill_n(visited_.begin(), triangles_.size(), uint8_t{0});
    left_ = static_cast<int>(triangles_.size());
    pair_ = {-1, -1};
    load(corner(first, last_corner + 1), false);
    load(corner(first, last_corner + 2), false);
    int current = enter(first);
    while (left_ > 0) {
        const int next = follow(current);
        current = next >= 0 ? enter(static_cast<size_t>(next)) : restart();
    }
}

int BoundedStrip::open_sides(size_t f) const noexcept {
    int n = 0;
    for (const int g : neighbours_[f]) n += g >= 0 && visited_[static_cast<size_t>(g)] == 0 ? 1 : 0;
    return n;
}

/// A vertex without a triangle: the older of the pair goes, or the newer where `keep`.
void BoundedStrip::load(int32_t vertex, bool keep) noexcept {
    steps_[static_cast<size_t>(size_++)] = {vertex, -1, 1, keep};
    pair_ = {keep ? pair_[0] : pair_[1], vertex};
}

/// The step of triangle `f`, whose other two vertices are the pair.
int BoundedStrip::enter(size_t f) noexcept {
    int k = 0;
    while (corner(f, k) == pair_[0] || corner(f, k) == pair_[1]) ++k;
    const int8_t sign = corner(f, k + 1) == pair_[0] ? 1 : -1;
    met_[f] = static_cast<int16_t>(size_);
    steps_[static_cast<size_t>(size_++)] = {corner(f, k), triangles_[f].tet, sign, false};
    before_ = pair_;
    pair_ = {pair_[1], corner(f, k)};
    visited_[f] = 1;
    --left_;
    return static_cast<int>(f);
}

void BoundedStrip::choose_older(bool keep) noexcept {
    steps_[static_cast<size_t>(size_ - 1)].keep = keep;
    pair_[0] = keep ? before_[0] : before_[1];
}

/// Next triangle over one of the two new edges: the one with fewer sides on. -1 = dead end.
int BoundedStrip::follow(int current) noexcept {
    int best = -1, best_sides = 4;
    bool best_keep = false;
    for (const bool keep : {false, true}) {
        const int gone = local(static_cast<size_t>(current), before_[keep ? 1 : 0]);
        const int g = neighbours_[static_cast<size_t>(current)][static_cast<size_t>(gone)];
        if (g < 0 || visited_[static_cast<size_t>(g)] != 0) continue;
        const int sides = open_sides(static_cast<size_t>(g));
        if (sides < best_sides) {
            best = g;
            best_sides = sides;
            best_keep = keep;
        }
    }
    if (best >= 0) choose_older(best_keep);
    return best;
}

/// After a dead end: a triangle that shares a vertex with the pair costs one load, any other two.
int BoundedStrip::restart() noexcept {
    size_t best = 0;
    int best_cost = 1000;
    for (size_t f = 0; f < triangles_.size(); ++f) {
        if (visited_[f] != 0) continue;
        const bool newest = local(f, pair_[1]) >= 0;
        const bool older = local(f, before_[0]) >= 0 || local(f, before_[1]) >= 0;
        const int cost = (newest ? 0 : older ? 4 : 8) + open_sides(f);
        if (cost < best_cost) {
            best = f;
            best_cost = cost;
        }
    }
    const int shared = local(best, pair_[1]);
    if (shared >= 0) {
        load(corner(best, shared + 1), false);
        return enter(best);
    }
    for (const bool keep : {false, true}) {
        const int k = local(best, before_[keep ? 0 : 1]);
        if (k < 0) continue;
        choose_older(keep);  // that vertex is kept through one load
        load(corner(best, k + 1), true);
        return enter(best);
    }
    load(corner(best, 0), false);
    load(corner(best, 1), false);
    return enter(best);
}

}  // namespace placode::sim
