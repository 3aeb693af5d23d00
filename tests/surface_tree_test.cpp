// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of boxes gives the same answers as looking at every triangle, on a body that is bent and
// has holes.

#include "sim/mesh/surface_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sim/core/workers.h"
#include "sim/mesh/surface.h"

namespace placode::sim {
namespace THIS_TEST {

std::vector<Float4> bent(const TetMesh& mesh, double amount) {
    std::vector<Float4> x(mesh.rest.size());
    for (size_t v = 0; v < x.size(); ++v) {
        const Vec3& r = mesh.rest[v];
        x[v] = {static_cast<float>(r.x() + amount * std::sin(300 * r.y())),
                static_cast<float>(r.y()),
                static_cast<float>(r.z() + amount * std::cos(200 * r.x())), 1};
    }
    return x;
}

Vec3 corner(const std::vector<Float4>& x, int v) { return {x[v].x, x[v].y, x[v].z}; }

/// Slots with a vertex within `radius` of `centre`, by looking at all.
std::vector<int> near_by_scan(const SurfaceState& surface, const std::vector<Float4>& x,
                              const Vec3& centre, double radius) {
    std::vector<int> found;
    const auto triangles = surface.triangles();
    for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
        for (const int32_t v : triangles[i].vertex) {
            if ((corner(x, v) - centre).norm() > radius) continue;
            found.push_back(i);
            break;
        }
    }
    return found;
}

std::vector<int> near_by_tree(const SurfaceState& surface, const std::vector<Float4>& x,
                              const Vec3& centre, double radius, int& asked) {
    std::vector<int> found;
    surface.tree().walk(
        [&](const SurfaceTree::Box& box) {
            for (int k = 0; k < 3; ++k) {
                if (box.low[k] > centre[k] + radius || box.high[k] < centre[k] - radius)
                    return true;
            }
            return false;
        },
        [&](int i) {
            ++asked;
            for (const int32_t v : surface.triangles()[i].vertex) {
                if ((corner(x, v) - centre).norm() > radius) continue;
                found.push_back(i);
                break;
            }
        });
    std::sort(found.begin(), found.end());
    return found;
}

TEST(SurfaceTree, FindsWhatAScanFindsOnABentBodyWithHoles) {
    const TetMesh mesh = box_mesh(Vec3(0.012, 0.010, 0.003), {12, 10, 3}, Tissue::kSkin);
    const Surface surface(mesh);
    SurfaceState state(surface, mesh, false);
    std::vector<uint8_t> alive(mesh.tets.size(), 1);
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    int asked = 0, scanned = 0, hits = 0;
    for (int round = 0; round < 40; ++round) {
        for (int n = 0; n < 20; ++n) {
            const int tet = static_cast<int>(random() % mesh.tets.size());
            if (!alive[tet]) continue;
            alive[tet] = 0;
            state.remove_tet(surface, mesh, alive, tet);
        }
        const std::vector<Float4> x = bent(mesh, 0.0001 * round);
        state.refit(x);
        for (int n = 0; n < 20; ++n) {
            const Vec3 centre(uniform(-0.002, 0.014), uniform(-0.002, 0.012),
                              uniform(-0.002, 0.005));
            const double radius = uniform(0.0002, 0.002);
            const auto expected = near_by_scan(state, x, centre, radius);
            EXPECT_EQ(near_by_tree(state, x, centre, radius, asked), expected);
            hits += static_cast<int>(expected.size());
            scanned += static_cast<int>(state.triangles().size());
        }
    }
    EXPECT_GT(hits, 1000);
    // What it is for: a query of 0.2 to 2 mm on a body of 12 mm leaves most of it alone.
    EXPECT_LT(asked, scanned / 5);
}

TEST(SurfaceTree, LookingAtWhatMovesGivesTheSameBoxes) {
    const TetMesh mesh = box_mesh(Vec3(0.012, 0.010, 0.003), {12, 10, 3}, Tissue::kSkin);
    const Surface surface(mesh);
    SurfaceState whole(surface, mesh, false), part(surface, mesh, false);
    std::vector<uint8_t> alive(mesh.tets.size(), 1);
    std::vector<Float4> x = bent(mesh, 0);
    std::vector<uint8_t> moves(static_cast<size_t>(part.tree().nodes()), 0);
    std::mt19937 random(3);
    Workers workers(2, Workers::Team::kFixed);
    int moved = 0;
    for (int round = 1; round < 60; ++round) {
        std::fill(moves.begin(), moves.end(), uint8_t{0});
        const int cut = static_cast<int>(random() % mesh.tets.size());
        if (alive[cut]) {
            alive[cut] = 0;
            whole.remove_tet(surface, mesh, alive, cut);
            part.remove_tet(surface, mesh, alive, cut);
        }
        // In every third round what moved before has fallen asleep, after a last motion that no
        // refit has seen.
        const bool falls_asleep = round % 3 == 0;
        if (!falls_asleep) moved = static_cast<int>(random() % mesh.tets.size());
        const auto& corners = mesh.tets[static_cast<size_t>(moved)];
        for (const int32_t v : corners) x[static_cast<size_t>(v)].z += 1e-4F;
        for (size_t t = 0; t < mesh.tets.size() && !falls_asleep; ++t) {
            for (const int32_t v : mesh.tets[t]) {
                if (std::count(corners.begin(), corners.end(), v) == 0) continue;
                moves[static_cast<size_t>(part.tree().leaf_of(static_cast<int>(t)))] = 1;
            }
        }
        whole.refit(x);
        part.refit(x, moves, workers);
        std::vector<SurfaceTree::Box> expected, found;
        const auto keep = [](std::vector<SurfaceTree::Box>& boxes) {
            return [&boxes](const SurfaceTree::Box& box) {
                boxes.push_back(box);
                return false;
            };
        };
        whole.tree().walk(keep(expected), [](int) {});
        part.tree().walk(keep(found), [](int) {});
        ASSERT_EQ(found.size(), expected.size());
        for (size_t n = 0; n < found.size(); ++n) {
            ASSERT_EQ(found[n].low, expected[n].low) << "round " << round << ", box " << n;
            ASSERT_EQ(found[n].high, expected[n].high) << "round " << round << ", box " << n;
        }
    }
}

TEST(SurfaceTree, ABodyThatIsGoneIsEmpty) {
    const TetMesh mesh = box_mesh(Vec3(0.002, 0.002, 0.002), {2, 2, 2}, Tissue::kSkin);
    const Surface surface(mesh);
    SurfaceState state(surface, mesh, false);
    std::vector<uint8_t> alive(mesh.tets.size(), 1);
    EXPECT_FALSE(state.tree().empty());
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
        alive[t] = 0;
        state.remove_tet(surface, mesh, alive, t);
    }
    EXPECT_TRUE(state.tree().empty());
    EXPECT_TRUE(state.triangles().empty());
    state.refit(bent(mesh, 0));
    state.tree().walk([](const SurfaceTree::Box&) { return false; },
                      [](int) { ADD_FAILURE() << "a triangle is left"; });
}

TEST(SurfaceTree, AVertexThatIsNotANumberDoesNotHideTheOthers) {
    const TetMesh mesh = box_mesh(Vec3(0.002, 0.002, 0.002), {2, 2, 2}, Tissue::kSkin);
    const Surface surface(mesh);
    SurfaceState state(surface, mesh, false);
    std::vector<Float4> x = bent(mesh, 0);
    x[0] = {std::nanf(""), std::nanf(""), std::nanf(""), 1};
    state.refit(x);
    EXPECT_NEAR(state.tree().bounds().high[0], 0.002F, 1e-9F);
    EXPECT_NEAR(state.tree().bounds().low[2], 0.0F, 1e-9F);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
