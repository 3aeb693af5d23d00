// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/mesh/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace placode::sim {
namespace THIS_TEST {

using Key = std::array<int32_t, 3>;

// Rotated so that the smallest vertex comes first: orientation survives, starting point does not.
Key oriented_key(std::array<int32_t, 3> v) {
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    return v;
}

std::map<Key, int> keys_of(std::span<const SurfaceTriangle> triangles) {
    std::map<Key, int> found;
    for (const SurfaceTriangle& triangle : triangles) {
        EXPECT_TRUE(found.emplace(oriented_key(triangle.vertex), triangle.tet).second)
            << "the same triangle twice";
    }
    return found;
}

// The boundary of the living tets, found without any neighbour table.
std::map<Key, int> recomputed(const TetMesh& mesh, const std::vector<uint8_t>& alive) {
    std::map<Key, int> open;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        if (!alive[t]) continue;
        for (const auto& face : kTetFaces) {
            const Key key =
                oriented_key({mesh.tets[t][face[0]], mesh.tets[t][face[1]], mesh.tets[t][face[2]]});
            const Key mirrored = oriented_key({key[0], key[2], key[1]});
            if (open.erase(mirrored) == 0) open.emplace(key, static_cast<int>(t));
        }
    }
    return open;
}

// 0 and 1 so that tets with a common face differ, as they can in a Kuhn lattice.
std::vector<uint8_t> two_kinds(const Surface& surface) {
    std::vector<uint8_t> kind(surface.neighbours().size(), 2);
    std::vector<int32_t> waiting{0};
    kind[0] = 0;
    while (!waiting.empty()) {
        const int32_t t = waiting.back();
        waiting.pop_back();
        for (const int32_t other : surface.neighbours()[t]) {
            if (other < 0) continue;
            EXPECT_NE(kind[other], kind[t]);
            if (kind[other] != 2) continue;
            kind[other] = 1 - kind[t];
            waiting.push_back(other);
        }
    }
    return kind;
}

TEST(Surface, OfABoxIsClosedAndPointsOutward) {
    const TetMesh mesh = box_mesh(Vec3(0.004, 0.003, 0.002), {4, 3, 2});
    const Surface surface(mesh);
    // Two triangles a cell face.
    ASSERT_EQ(surface.rest_triangles().size(), 2u * 2 * (4 * 3 + 3 * 2 + 4 * 2));
    double volume = 0;
    std::map<std::pair<int, int>, int> edges;
    for (const SurfaceTriangle& triangle : surface.rest_triangles()) {
        const auto& v = triangle.vertex;
        volume += mesh.rest[v[0]].dot(mesh.rest[v[1]].cross(mesh.rest[v[2]])) / 6;
        for (int i = 0; i < 3; ++i) ++edges[{v[i], v[(i + 1) % 3]}];
    }
    // Divergence theorem; rounding only.
    EXPECT_NEAR(volume, 0.004 * 0.003 * 0.002, 1e-18);
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
}

TEST(Surface, NeighboursAreMutualAndShareThreeVertices) {
    const TetMesh mesh = box_mesh(Vec3(0.003, 0.003, 0.003), {3, 3, 3});
    const Surface surface(mesh);
    int interior = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        for (int f = 0; f < 4; ++f) {
            const int other = surface.neighbours()[t][f];
            if (other < 0) continue;
            ++interior;
            const auto& back = surface.neighbours()[other];
            EXPECT_EQ(std::count(back.begin(), back.end(), static_cast<int>(t)), 1);
            for (int i : kTetFaces[f]) {
                const auto& v = mesh.tets[other];
                EXPECT_NE(std::find(v.begin(), v.end(), mesh.tets[t][i]), v.end());
            }
        }
    }
    EXPECT_EQ(interior, static_cast<int>(4 * mesh.tets.size() - surface.rest_triangles().size()));
}

TEST(Surface, RefusesAFaceOfThreeTets) {
    TetMesh mesh;
    mesh.rest = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0),
                 Vec3(0, 0, 1), Vec3(0, 0, 2), Vec3(0, 0, 3)};
    mesh.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}};
    mesh.tissue.assign(3, Tissue::kSkin);
    EXPECT_THROW(Surface{mesh}, MeshError);
}

TEST(Surface, AfterEveryRemovalEqualsTheBoundaryComputedAnew) {
    TetMesh mesh = box_mesh(Vec3(0.004, 0.004, 0.003), {4, 4, 3});
    for (size_t t = 0; t < mesh.tets.size(); ++t) mesh.tissue[t] = static_cast<Tissue>(t % 8);
    const Surface surface(mesh);
    SurfaceState state(surface, mesh, false);
    const SurfaceTriangle* storage = state.triangles().data();
    std::vector<uint8_t> alive(mesh.tets.size(), 1);
    std::vector<int> order(mesh.tets.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    const std::map<Key, int> at_rest = recomputed(mesh, alive);
    uint32_t version = state.version();
    for (const int tet : order) {
        alive[tet] = 0;
        state.remove_tet(surface, mesh, alive, tet);
        EXPECT_EQ(state.version(), ++version);
        ASSERT_EQ(keys_of(state.triangles()), recomputed(mesh, alive));
        for (const SurfaceTriangle& triangle : state.triangles()) {
            EXPECT_EQ(triangle.tissue, mesh.tissue[triangle.tet]);
            EXPECT_EQ(triangle.fresh, at_rest.count(oriented_key(triangle.vertex)) ? 0 : 1);
        }
    }
    EXPECT_TRUE(state.triangles().empty());
    EXPECT_EQ(state.triangles().data(), storage) << "the list must not be reallocated";
}

TEST(Surface, EveryOtherTetGoneFillsTheRoomToTheLastFace) {
    // With one of two kinds gone every face is on the surface, inner ones from one side: there is
    // room for no more. The gone kind's own faces of the boundary are what is left over.
    const TetMesh mesh = box_mesh(Vec3(0.003, 0.003, 0.002), {3, 3, 2});
    const Surface surface(mesh);
    const std::vector<uint8_t> kind = two_kinds(surface);
    for (const uint8_t gone : {0, 1}) {
        SurfaceState state(surface, mesh, false);
        std::vector<uint8_t> alive(mesh.tets.size(), 1);
        for (size_t t = 0; t < kind.size(); ++t) {
            if (kind[t] != gone) continue;
            alive[t] = 0;
            state.remove_tet(surface, mesh, alive, static_cast<int>(t));
        }
        const auto left = static_cast<size_t>(std::count(alive.begin(), alive.end(), 1));
        EXPECT_EQ(state.triangles().size(), 4 * left);
        EXPECT_LE(2 * state.triangles().size(),
                  4 * mesh.tets.size() + surface.rest_triangles().size());
        EXPECT_EQ(keys_of(state.triangles()), recomputed(mesh, alive));
    }
}

TEST(Surface, SameRemovalsGiveTheSameOrderAndSoDoesTheRoom) {
    const TetMesh mesh = box_mesh(Vec3(0.003, 0.003, 0.003), {3, 3, 3});
    const Surface surface(mesh);
    SurfaceState a(surface, mesh, false), b(surface, mesh, true);
    std::vector<uint8_t> alive(mesh.tets.size(), 1);
    for (const int tet : {3, 77, 40, 41, 12}) {
        alive[tet] = 0;
        a.remove_tet(surface, mesh, alive, tet);
        b.remove_tet(surface, mesh, alive, tet);
    }
    ASSERT_EQ(a.triangles().size(), b.triangles().size());
    for (size_t i = 0; i < a.triangles().size(); ++i) {
        EXPECT_EQ(a.triangles()[i].vertex, b.triangles()[i].vertex);
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim
