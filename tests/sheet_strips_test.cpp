// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of sheets against the same energy in double precision, vertex by vertex.
#include "sim/solver/sheet_strips.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/random.h"
#include "sim/solver/kernel_layout.h"

using namespace placode::sim;

namespace THIS_TEST {

constexpr double kSide = 1e-3;

SoftBodySpec empty_spec(double unit = 1) {
    SoftBodySpec spec;
    for (Material& m : spec.materials) {
        m.youngs_modulus_pa = 200e3 / (unit * unit);
        m.poissons_ratio = 0.45;
        m.density_kg_m3 = 1000 / (unit * unit * unit * unit);
        m.damping_per_s = 0;
    }
    spec.solver.gravity_m_s2.setZero();
    spec.solver.over_relaxation = 1;
    return spec;
}

/// Squares with crossed diagonals; every third triangle is wound the other moved round.
SoftBodySpec grid(int cells, double thickness, double curl = 0, double unit = 1) {
    SoftBodySpec spec = empty_spec(unit);
    const double edge = kSide * unit;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i)
            spec.mesh.rest.emplace_back(edge * i, edge * j, curl * edge * (i * i - 0.5 * i * j));
    }
    const auto add = [&](int32_t a, int32_t b, int32_t c) {
        if (spec.sheet.size() % 3 == 0) std::swap(b, c);
        spec.sheet.push_back({{a, b, c}, Tissue::kSkin, thickness * unit});
    };
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int a = j * (cells + 1) + i, b = a + 1, d = a + cells + 1, c = d + 1;
            if ((i + j) % 2 == 0) {
                add(a, b, c);
                add(a, c, d);
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    }
    return spec;
}

/// Two fans that meet in one vertex only, and a closed surface that meets them in it too.
SoftBodySpec pinched() {
    SoftBodySpec spec = empty_spec();
    const double e = kSide;
    spec.mesh.rest = {{0, 0, 0},       {e, 0, 0},      {0, e, 0},       {e, e, 0},
                      {-e, 0, 0},      {-e, -e, 0},    {0, -e, 0},      {e, 0, -2 * e},
                      {-e, 0, -2 * e}, {0, e, -2 * e}, {0, -e, -2 * e}, {0, 0, -4 * e}};
    for (const auto& t : std::vector<std::array<int32_t, 3>>{{0, 1, 3},
                                                             {0, 3, 2},
                                                             {0, 4, 5},
                                                             {0, 5, 6},
                                                             {0, 7, 9},
                                                             {0, 9, 8},
                                                             {0, 8, 10},
                                                             {0, 10, 7},
                                                             {11, 7, 9},
                                                             {11, 9, 8},
                                                             {11, 8, 10},
                                                             {11, 10, 7}})
        spec.sheet.push_back({t, Tissue::kSkin, 0.3e-3});
    return spec;
}

void disturb(SoftBodyState& state, double noise, const Mat3& f, uint64_t seed) {
    SplitMix64 random(seed);
    for (Float4& p : state.x) {
        const Vec3 moved =
            f * to_vec(p) +
            noise * Vec3(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
        p = {static_cast<float>(moved.x()), static_cast<float>(moved.y()),
             static_cast<float>(moved.z()), p.w};
    }
    state.x_start = state.x;
}

/// What one sweep should do: colour by colour, every vertex from where the others stand.
std::vector<Vec3> swept_one_by_one(const SoftBody& body, SoftBodyState state, double h) {
    const SheetStrips& strips = body.packed().sheet_strips;
    for (size_t c = 0; c + 1 < strips.colour_start.size(); ++c) {
        std::vector<std::pair<int32_t, Vec3>> moved;
        for (int i = strips.colour_start[c]; i < strips.colour_start[c + 1]; ++i) {
            const VertexBatch& batch =
                body.packed().batches[as_index(strips.batches[as_index(i)].batch)];
            for (size_t lane = 0; lane < as_index(batch.count); ++lane) {
                const int32_t v = batch.vertex[lane];
                const VertexSystem s = vertex_system(body, state, v, h);
                Vec3 step = -s.hessian.ldlt().solve(s.gradient);
                const double limit = static_cast<double>(body.shortest_edge_m()[as_index(v)]) / 4;
                if (step.norm() > limit) step *= limit / step.norm();
                moved.emplace_back(v, step);
            }
        }
        for (const auto& [v, step] : moved) {
            const Vec3 to = to_vec(state.x[as_index(v)]) + step;
            state.x[as_index(v)] = {static_cast<float>(to.x()), static_cast<float>(to.y()),
                                    static_cast<float>(to.z()), state.x[as_index(v)].w};
        }
    }
    std::vector<Vec3> out;
    for (const Float4& p : state.x) out.push_back(to_vec(p));
    return out;
}

/// Largest difference of a sweep from the one above, of the longest moved that it goes.
double kernel_error(const SoftBody& body, const SoftBodyState& start, double h) {
    SoftBodyState state = start;
    Workers workers(1);
    sweep(body, state, h, workers);
    const std::vector<Vec3> expected = swept_one_by_one(body, start, h);
    double off = 0, moved = 0;
    for (size_t v = 0; v < expected.size(); ++v) {
        off = std::max(off, (to_vec(state.x[v]) - expected[v]).norm());
        moved = std::max(moved, (expected[v] - to_vec(start.x[v])).norm());
    }
    return off / moved;
}

TEST(SheetStrips, TheKernelStepsAsTheEnergyInDoublePrecisionDoes) {
    const Mat3 turned =
        1.04 * Eigen::AngleAxisd(0.8, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    for (const double bending : {1.0, 0.0}) {
        for (const double curl : {0.0, 0.05}) {  // flat and curved at rest
            // Small waves, then folds over which the angle passes half a turn.
            for (const double noise : {0.1, 2.5}) {
                SoftBodySpec spec = grid(9, 0.4e-3, curl);
                spec.sheet_bending = bending;
                spec.fixed = {0, 37};
                const SoftBody body(spec);
                SoftBodyState state(body);
                disturb(state, noise * kSide, turned, 7);
                // Rounding of positions beside steps of a tenth of an edge; where a triangle is
                // crushed its angles hang on the last digits of its normal.
                EXPECT_LT(kernel_error(body, state, 2.5e-4), noise < 1 ? 2e-5 : 2e-3)
                    << "bending " << bending << " curl " << curl << " noise " << noise;
            }
        }
    }
}

TEST(SheetStrips, SeveralFansAtOneVertexAreWalkedOneBehindTheOther) {
    const SoftBody body(pinched());
    SoftBodyState state(body);
    disturb(state, 0.1 * kSide, Mat3::Identity(), 3);
    EXPECT_LT(kernel_error(body, state, 2.5e-4), 2e-5);
    const SheetFans fans(body);
    EXPECT_EQ(fans.steps(0), (2 + 1) + 2 + (2 + 1) + 2 + 4);
    EXPECT_EQ(fans.steps(11), 4);
}

TEST(SheetStrips, UnitsOfLengthDoNotMatter) {
    // The same sheet in kilometres and in micrometres: squares of areas would leave a float.
    for (const double unit : {1e-3, 1e6}) {
        const SoftBody body(grid(6, 0.4e-3, 0.05, unit));
        SoftBodyState state(body);
        disturb(state, 0.1 * kSide * unit, Mat3::Identity(), 5);
        EXPECT_LT(kernel_error(body, state, 2.5e-4), 5e-5) << unit;
    }
}

TEST(SheetStrips, VerticesOfAColourAreInNoEnergyTogether) {
    const SoftBody body(grid(20, 0.1e-3));
    const SheetStrips& strips = body.packed().sheet_strips;
    const SheetElements& sheet = body.packed().sheet;
    std::vector<int32_t> colour(as_index(body.vertex_count()), -1);
    for (size_t c = 0; c + 1 < strips.colour_start.size(); ++c) {
        for (int i = strips.colour_start[c]; i < strips.colour_start[c + 1]; ++i) {
            const VertexBatch& batch =
                body.packed().batches[as_index(strips.batches[as_index(i)].batch)];
            for (size_t lane = 0; lane < as_index(batch.count); ++lane)
                colour[as_index(batch.vertex[lane])] = static_cast<int32_t>(c);
        }
    }
    EXPECT_EQ(std::count(colour.begin(), colour.end(), -1), 0);
    for (const SheetElement& t : sheet.triangles) {
        std::vector<int32_t> there;
        for (const auto& list : {t.v, t.flap}) {
            for (const int32_t v : list) {
                if (v >= 0) there.push_back(colour[as_index(v)]);
            }
        }
        std::sort(there.begin(), there.end());
        EXPECT_EQ(std::adjacent_find(there.begin(), there.end()), there.end());
    }
}

TEST(SheetStrips, ASheetOfManyBatchesHasTheSameBitsOnAnyNumberOfThreads) {
    SoftBodySpec spec = grid(60, 0.1e-3, 0.002);
    spec.solver.gravity_m_s2 = Vec3(0, 0, -9.81);
    for (int32_t v = 0; v <= 60; ++v) spec.fixed.push_back(v);
    const SoftBody body(spec);
    uint64_t first = 0;
    for (const int threads : {1, 2, 3, 4}) {
        SoftBodyState state(body);
        Workers workers(threads);
        run_substeps(body, state, 100, workers);
        if (threads == 1) first = state_hash(state);
        EXPECT_EQ(state_hash(state), first) << threads;
    }
}

}  // namespace THIS_TEST
