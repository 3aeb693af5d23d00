// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/mesh/surface_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "sim/core/float_lanes.h"
#include "sim/core/workers.h"
#include "sim/mesh/surface.h"

namespace placode::sim {
namespace {

// Tets to a leaf: on the layered field some five to ten triangles in a leaf at the surface.
constexpr int kLeafTets = 16;

void store(std::array<float, 4>& p, FloatLanes v) noexcept { p = {v[0], v[1], v[2], v[3]}; }

constexpr int kBranches = 8;  // some more than threads

constexpr float kHuge = std::numeric_limits<float>::max();

}  // namespace

SurfaceTree::SurfaceTree(const TetMesh& mesh, size_t capacity, size_t tet_capacity)
    : leaf_of_tet_(std::max(tet_capacity, mesh.tets.size()), 0),
      leaf_(capacity, -1),
      next_(capacity, -1),
      previous_(capacity, -1) {
    std::vector<Vec3> centroid;
    centroid.reserve(mesh.tets.size());
    for (const auto& tet : mesh.tets) {
        centroid.push_back(
            (mesh.rest[tet[0]] + mesh.rest[tet[1]] + mesh.rest[tet[2]] + mesh.rest[tet[3]]) / 4);
    }
    std::vector<int32_t> order(mesh.tets.size());
    std::iota(order.begin(), order.end(), 0);
    build(centroid, order, 0, static_cast<int>(order.size()), -1);
    for (int n = 0; n < nodes();) {
        const bool large = after_[n] - n > nodes() / kBranches + 1;
        (large ? crown_ : branch_).push_back(n);
        n = large ? n + 1 : after_[n];
    }
    count_.assign(boxes_.size(), 0);
    first_.assign(boxes_.size(), -1);
    pending_.assign(boxes_.size(), 1);
    moved_.assign(boxes_.size(), 1);
    fresh_.assign(boxes_.size(), 0);
}

int SurfaceTree::build(const std::vector<Vec3>& centroid, std::vector<int32_t>& order, int first,
                       int last, int parent) {
    const int node = static_cast<int>(boxes_.size());
    boxes_.emplace_back();
    after_.push_back(node + 1);
    parent_.push_back(parent);
    if (last - first <= kLeafTets) {
        for (int i = first; i < last; ++i) leaf_of_tet_[order[i]] = node;
        return node;
    }
    Vec3 low = centroid[order[first]], high = low;
    for (int i = first; i < last; ++i) {
        low = low.cwiseMin(centroid[order[i]]);
        high = high.cwiseMax(centroid[order[i]]);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const int middle = (first + last) / 2;
    std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
                     [&](int32_t a, int32_t b) {
                         const double xa = centroid[a][axis], xb = centroid[b][axis];
                         return xa != xb ? xa < xb : a < b;
                     });
    build(centroid, order, first, middle, node);
    build(centroid, order, middle, last, node);
    after_[node] = static_cast<int32_t>(boxes_.size());
    return node;
}

void SurfaceTree::insert(int slot, int tet) noexcept {
    const int32_t leaf = leaf_of_tet_[tet], head = first_[leaf];
    leaf_[slot] = leaf;
    used_ = std::max(used_, slot + 1);
    next_[slot] = head;
    previous_[slot] = -1;
    if (head >= 0) previous_[head] = slot;
    first_[leaf] = slot;
    pending_[leaf] = 1;
    for (int32_t n = leaf; n >= 0; n = parent_[n]) ++count_[n];
}

void SurfaceTree::remove(int slot) noexcept {
    const int32_t leaf = leaf_[slot], before = previous_[slot], behind = next_[slot];
    (before >= 0 ? next_[before] : first_[leaf]) = behind;
    if (behind >= 0) previous_[behind] = before;
    leaf_[slot] = next_[slot] = previous_[slot] = -1;
    pending_[leaf] = 1;
    for (int32_t n = leaf; n >= 0; n = parent_[n]) --count_[n];
}

void SurfaceTree::renumber(int from, int to) noexcept {
    if (from == to) return;
    const int32_t leaf = leaf_[from], before = previous_[from], behind = next_[from];
    leaf_[to] = leaf;
    previous_[to] = before;
    next_[to] = behind;
    (before >= 0 ? next_[before] : first_[leaf]) = to;
    if (behind >= 0) previous_[behind] = to;
    leaf_[from] = next_[from] = previous_[from] = -1;
}

void SurfaceTree::fit(int node, std::span<const SurfaceTriangle> triangles,
                      std::span<const Float4> x) noexcept {
    const FloatLanes huge = {kHuge, kHuge, kHuge, kHuge};
    FloatLanes low = huge, high = -huge;
    if (after_[node] == node + 1) {
        for (int32_t s = first_[node]; s >= 0; s = next_[s]) {
            for (const int32_t v : triangles[s].vertex) {
                const FloatLanes p = lanes_of(x[v]);
                low = least(p, low);
                high = most(p, high);
            }
        }
    } else {
        for (const int child : {node + 1, static_cast<int>(after_[node + 1])}) {
            if (count_[child] == 0) continue;
            low = least(low, lanes_of(boxes_[child].low));
            high = most(high, lanes_of(boxes_[child].high));
        }
    }
    store(boxes_[node].low, low);
    store(boxes_[node].high, high);
}

void SurfaceTree::refit(std::span<const SurfaceTriangle> triangles,
                        std::span<const Float4> x) noexcept {
    for (int n = nodes() - 1; n >= 0; --n) {
        if (count_[n] != 0) fit(n, triangles, x);
    }
}

void SurfaceTree::refit_range(int first, int last, std::span<const SurfaceTriangle> triangles,
                              std::span<const Float4> x, std::span<const uint8_t> moves) noexcept {
    for (int n = last - 1; n >= first; --n) {
        if (after_[n] == n + 1) {
            fresh_[n] = moves[n] | moved_[n] | pending_[n];
            moved_[n] = moves[n];
            pending_[n] = 0;
        } else {
            fresh_[n] = fresh_[n + 1] | fresh_[after_[n + 1]];
        }
        if (fresh_[n] != 0 && count_[n] != 0) fit(n, triangles, x);
    }
}

void SurfaceTree::refit(std::span<const SurfaceTriangle> triangles, std::span<const Float4> x,
                        std::span<const uint8_t> moves, Workers& workers) noexcept {
    struct Job {
        SurfaceTree& tree;
        std::span<const SurfaceTriangle> triangles;
        std::span<const Float4> x;
        std::span<const uint8_t> moves;
        void branch(int i) noexcept {
            const int first = tree.branch_[i];
            tree.refit_range(first, tree.after_[first], triangles, x, moves);
        }
    } job{*this, triangles, x, moves};
    workers.run<&Job::branch>(static_cast<int>(branch_.size()), job);
    for (size_t i = crown_.size(); i-- > 0;) {
        refit_range(crown_[i], crown_[i] + 1, triangles, x, moves);
    }
}

}  // namespace placode::sim
