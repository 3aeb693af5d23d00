// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/wound_refinement.h"

#include <algorithm>
#include <array>
#include <utility>

namespace placode::view {

using Eigen::Vector3f;
namespace {

using Pair = std::pair<int, int>;

Pair sorted(unsigned a, unsigned b) {
    return {static_cast<int>(std::min(a, b)), static_cast<int>(std::max(a, b))};
}

// The other end of the rim at `at`, seen from `from`; -1 where the rim ends or forks.
int beyond(const std::vector<std::array<int, 2>>& next, int at, int from) {
    const std::array<int, 2>& n = next[static_cast<size_t>(at)];
    if (n[0] == from) return std::max(n[1], -1);
    return n[1] == from ? std::max(n[0], -1) : -1;
}

}  // namespace

int WoundRefinement::number_of(unsigned a, unsigned b) const {
    const Pair key = sorted(a, b);
    const auto found =
        std::lower_bound(edges_.begin(), edges_.end(), key, [](const Edge& e, const Pair& k) {
            return Pair{e.a, e.b} < k;
        });
    if (found == edges_.end() || Pair{found->a, found->b} != key) return -1;
    return static_cast<int>(found - edges_.begin());
}

void WoundRefinement::build(std::span<const WoundSmoothing::Vertex> vertices,
                            std::span<const unsigned> triangles, std::vector<unsigned>& refined) {
    std::vector<Pair> pairs;
    for (size_t k = 0; k + 2 < triangles.size(); k += 3) {
        for (size_t e = 0; e < 3; ++e) {
            const unsigned a = triangles[k + e], b = triangles[k + (e + 1) % 3];
            if (vertices[a].moves || vertices[b].moves) pairs.push_back(sorted(a, b));
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    edges_.clear();
    for (const auto& [a, b] : pairs) edges_.push_back({a, b, -1, -1, false});
    find_rim(vertices, triangles);

    const auto base = static_cast<unsigned>(vertices.size());
    refined.clear();
    const auto add = [&](unsigned a, unsigned b, unsigned c) {
        refined.insert(refined.end(), {a, b, c});
    };
    for (size_t k = 0; k + 2 < triangles.size(); k += 3) {
        const std::array<unsigned, 3> v{triangles[k], triangles[k + 1], triangles[k + 2]};
        std::array<int, 3> split{};
        int splits = 0;
        for (size_t e = 0; e < 3; ++e) {
            split[e] = number_of(v[e], v[(e + 1) % 3]);
            splits += split[e] >= 0 ? 1 : 0;
        }
        const auto middle = [&](size_t e) { return base + static_cast<unsigned>(split[e % 3]); };
        if (splits == 0) add(v[0], v[1], v[2]);
        if (splits == 3) {
            for (size_t e = 0; e < 3; ++e) add(v[e], middle(e), middle(e + 2));
            add(middle(0), middle(1), middle(2));
        }
        for (size_t e = 0; e < 3 && splits == 1; ++e) {
            if (split[e] < 0) continue;
            const unsigned across = v[(e + 2) % 3];
            add(v[e], middle(e), across);
            add(middle(e), v[(e + 1) % 3], across);
        }
        for (size_t e = 0; e < 3 && splits == 2; ++e) {
            if (split[e] >= 0) continue;  // the edge that stays whole
            const unsigned a = v[e], b = v[(e + 1) % 3], c = v[(e + 2) % 3];
            add(middle(e + 1), c, middle(e + 2));
            add(a, b, middle(e + 1));
            add(a, middle(e + 1), middle(e + 2));
        }
    }
}

// The rim lies where a triangle of the skin and one of a wall meet.
void WoundRefinement::find_rim(std::span<const WoundSmoothing::Vertex> vertices,
                               std::span<const unsigned> triangles) {
    const auto skin = [&](unsigned c) {
        const WoundSmoothing::Vertex& v = vertices[c];
        return v.twin >= 0 && v.fresh ? static_cast<unsigned>(v.twin) : c;
    };
    std::vector<Pair> walls, rim;
    for (size_t k = 0; k + 2 < triangles.size(); k += 3) {
        if (!vertices[triangles[k]].fresh) continue;
        for (size_t e = 0; e < 3; ++e) {
            const unsigned a = triangles[k + e], b = triangles[k + (e + 1) % 3];
            if (vertices[a].twin >= 0 && vertices[b].twin >= 0)
                walls.push_back(sorted(skin(a), skin(b)));
        }
    }
    std::sort(walls.begin(), walls.end());
    for (const Edge& e : edges_) {
        const auto& a = vertices[static_cast<size_t>(e.a)];
        if (!a.fresh && std::binary_search(walls.begin(), walls.end(), Pair{e.a, e.b}))
            rim.emplace_back(e.a, e.b);
    }
    std::vector<std::array<int, 2>> next(vertices.size(), {-1, -1});
    const auto note = [&](int at, int other) {
        std::array<int, 2>& n = next[static_cast<size_t>(at)];
        if (n[0] == -1) {
            n[0] = other;
        } else {
            n = {n[0], n[1] == -1 ? other : -2};
            if (n[1] == -2) n = {-2, -2};  // it forks
        }
    };
    for (const auto& [a, b] : rim) {
        note(a, b);
        note(b, a);
    }
    for (Edge& e : edges_) {
        const unsigned a = skin(static_cast<unsigned>(e.a)), b = skin(static_cast<unsigned>(e.b));
        if (!std::binary_search(rim.begin(), rim.end(), sorted(a, b))) continue;
        e.rim = true;
        e.before = beyond(next, static_cast<int>(a), static_cast<int>(b));
        e.after = beyond(next, static_cast<int>(b), static_cast<int>(a));
    }
}

Vector3f WoundRefinement::place(size_t i, std::span<const Vector3f> position,
                                std::span<const Vector3f> normal) const {
    const Edge& e = edges_[i];
    const Vector3f a = position[static_cast<size_t>(e.a)], b = position[static_cast<size_t>(e.b)];
    const Vector3f middle = 0.5F * (a + b);
    if (!e.rim) {
        constexpr float kBend = 0.75F;
        const Vector3f &m = normal[static_cast<size_t>(e.a)], &n = normal[static_cast<size_t>(e.b)];
        return middle - 0.5F * kBend * (m.dot(middle - a) * m + n.dot(middle - b) * n);
    }
    if (e.before < 0 || e.after < 0) return middle;
    // The middle of the cubic whose ends point along the rim.
    const Vector3f in = (b - position[static_cast<size_t>(e.before)]).normalized(),
                   out = (position[static_cast<size_t>(e.after)] - a).normalized();
    return middle + 0.125F * (b - a).norm() * (in - out);
}

}  // namespace placode::view
