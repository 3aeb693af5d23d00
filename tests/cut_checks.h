// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What must hold of a body after any cut, and forces found without the kernels.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "sim/solver/topology.h"
#include "tests/box_scene.h"

namespace placode::sim::test {

/// Soft tissue that nothing holds, with scissors over it.
inline BoxOptions scissors_sheet(const Vec3& size_m, const std::array<int, 3>& cells,
                                 int spare_vertices, Method method) {
    BoxOptions options;
    options.size_m = size_m;
    options.cells = cells;
    options.tissue = Tissue::kZone;
    // XPBD needs a small Courant number.
    options.material.youngs_modulus_pa = method == Method::kXpbd ? 300 : 10000;
    options.material.damping_per_s = 60;
    options.material.fail_stretch = options.material.injury_stretch = 100;
    options.method = method;
    options.heat = false;
    options.hold_bottom = false;
    options.spare_vertices = spare_vertices;
    options.tool.kind = ToolKind::kScissors;
    options.tool.tip_radius_m = 0.0003;
    options.tool.tip_length_m = 0.008;
    options.tool.hand_n_m = 1e7;
    return options;
}

inline Vec3 at(const State& state, int v) {
    const Float4& x = state.body.x[static_cast<size_t>(v)];
    return {x.x, x.y, x.z};
}

/// Tip at p, blades along `ahead`, plane of the blades spanned by `ahead` and `up`.
inline Pose blades(const Vec3& p, const Vec3& ahead, const Vec3& up) {
    Mat3 axes;
    axes.col(2) = ahead.normalized();
    axes.col(1) = (up - up.dot(axes.col(2)) * axes.col(2)).normalized();
    axes.col(0) = axes.col(1).cross(axes.col(2));
    return {p, Quat(axes)};
}

inline double living_volume(const Scene& scene, const State& state) {
    double sum = 0;
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        if (state.body.tet_alive[static_cast<size_t>(t)])
            sum += static_cast<double>(rest_volume_of(scene.body, state.body, t));
    }
    return sum;
}

/// Every edge of the boundary is run through as often one way as the other, and every corner of a
/// triangle belongs to the tet behind it.
inline void expect_closed_surface(const Scene& scene, const State& state) {
    std::map<std::pair<int, int>, int> edges;
    for (const SurfaceTriangle& t : state.surface.triangles()) {
        ASSERT_TRUE(state.body.tet_alive[static_cast<size_t>(t.tet)]);
        const auto& c = corners(scene.body, state.body, t.tet);
        for (size_t i = 0; i < 3; ++i) {
            ASSERT_NE(std::find(c.begin(), c.end(), t.vertex[i]), c.end());
            ++edges[{t.vertex[i], t.vertex[(i + 1) % 3]}];
        }
    }
    for (const auto& [edge, n] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        ASSERT_TRUE(back != edges.end() && back->second == n);
    }
}

/// Tets around every vertex hang together over uncut faces, lists and corners agree, and no vertex
/// in use is without a tet.
inline void expect_whole_vertices(const Scene& scene, const State& state) {
    const Topology& top = *state.body.topology;
    std::vector<int> seen(top.origin.size(), 0);
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        for (const int32_t v : top.tets[static_cast<size_t>(t)]) {
            const auto around = tets_around(scene.body, state.body, v);
            ASSERT_NE(std::find(around.begin(), around.end(), t), around.end());
            ++seen[static_cast<size_t>(v)];
        }
    }
    for (int v = 0; v < top.vertices; ++v) {
        const auto around = tets_around(scene.body, state.body, v);
        ASSERT_EQ(static_cast<size_t>(seen[static_cast<size_t>(v)]), around.size());
        ASSERT_GT(around.size(), 0U);
        std::set<int32_t> reached{around[0]}, rim{around[0]};
        while (!rim.empty()) {
            const int32_t t = *rim.begin();
            rim.erase(rim.begin());
            for (int f = 0; f < 4; ++f) {
                if (top.tets[static_cast<size_t>(t)][static_cast<size_t>(f)] == v) continue;
                if (state.surface.on_surface(t, f)) continue;
                const int32_t other =
                    scene.surface.neighbours()[static_cast<size_t>(t)][static_cast<size_t>(f)];
                if (reached.insert(other).second) rim.insert(other);
            }
        }
        ASSERT_EQ(reached.size(), around.size()) << "vertex " << v << " joins two parts";
    }
}

/// Elastic force on a vertex from its tets one by one, F by F: nothing in common with strips.
inline Vec3 force_by_tets(const Scene& scene, const State& state, int v) {
    Vec3 force = Vec3::Zero();
    for (const int32_t t : tets_around(scene.body, state.body, v)) {
        if (!state.body.tet_alive[static_cast<size_t>(t)]) continue;
        const auto& c = corners(scene.body, state.body, t);
        Mat3 rest, now;
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<size_t>(i) + 1;
            rest.col(i) =
                rest_place(scene.body, state.body, c[k]) - rest_place(scene.body, state.body, c[0]);
            now.col(i) = at(state, c[k]) - at(state, c[0]);
        }
        const Mat3 inverse = rest.inverse(), f = now * inverse;
        const Material& m =
            scene.body.spec()
                .materials[static_cast<size_t>(scene.body.mesh().tissue[static_cast<size_t>(t)])];
        const NeoHookean n = neo_hookean(m.youngs_modulus_pa, m.poissons_ratio);
        const double j = f.determinant();
        const Mat3 cofactor = j * f.inverse().transpose();
        const Mat3 p = n.mu_pa * f + n.lambda_pa * (j - n.gamma) * cofactor;
        const auto k = std::find(c.begin(), c.end(), v) - c.begin();
        Vec3 gradient = -inverse.colwise().sum().transpose();
        if (k > 0) gradient = inverse.row(k - 1).transpose();
        force -= rest.determinant() / 6 * p * gradient;
    }
    return force;
}

}  // namespace placode::sim::test
