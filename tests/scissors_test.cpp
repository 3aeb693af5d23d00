// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts by scissors: nothing is lost, nothing hangs by a point, nothing heals.

#include "sim/cutting/scissors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "sim/solver/topology.h"
#include "tests/box_scene.h"
#include "tests/cut_checks.h"

namespace placode::sim {
namespace THIS_TEST {

using test::at;
using test::blades;
using test::BoxOptions;
using test::expect_closed_surface;
using test::expect_whole_vertices;
using test::force_by_tets;
using test::living_volume;

BoxOptions sheet(Method method = Method::kVbd) {
    return test::scissors_sheet(Vec3(0.006, 0.006, 0.001), {12, 12, 2}, 600, method);
}

/// Opens to `angle` at a pose and closes within `frames`.
void snip(const Scene& scene, State& state, const Pose& pose, double angle = 0.7, int frames = 4) {
    ToolInput input;
    input.set_pose(pose);
    input.engaged = 1;
    ToolFeedback feedback;
    input.jaw_rad = 0;
    test::frame(scene, state, input, feedback);
    for (int i = 0; i <= frames; ++i) {
        input.jaw_rad = static_cast<float>(angle * (frames - i) / frames);
        test::frame(scene, state, input, feedback);
    }
    // What did not fit into a frame follows.
    for (int i = 0; i < 20; ++i) test::frame(scene, state, input, feedback);
}

TEST(Scissors, CutThroughASheetItFallsIntoTwoThatDoNotHeal) {
    for (const Method method : {Method::kVbd, Method::kXpbd}) {
        BoxOptions options = sheet(method);
        options.size_m.y() = 0.004;
        options.cells[1] = 8;
        const Scene scene = test::box_scene(options);
        State state(scene, 1);
        // Along x, tip beyond the far edge, blades above and below.
        snip(scene, state, blades(Vec3(0.0035, 0, -0.0005), Vec3::UnitX(), Vec3::UnitZ()));
        EXPECT_GT(state.splits, 20);
        ASSERT_EQ(state.flags & kCutRefused, 0U);
        expect_whole_vertices(scene, state);
        // Pull the parts 1 mm to either side: nothing holds them together.
        for (int v = 0; v < state.body.topology->vertices; ++v) {
            const auto around = tets_around(scene.body, state.body, v);
            double y = 0;
            for (const int32_t c : corners(scene.body, state.body, around[0]))
                y += at(state, c).y();
            state.body.x[static_cast<size_t>(v)].y += y > 0 ? 0.001F : -0.001F;
        }
        ToolFeedback feedback;
        for (int i = 0; i < 300; ++i) {
            test::frame(scene, state, test::upright(Vec3(0, 0, 0.05)), feedback);
        }
        // Still apart: no tet reaches across the gap.
        for (int t = 0; t < scene.body.tet_count(); ++t) {
            double low = 1, high = -1;
            for (const int32_t v : corners(scene.body, state.body, t)) {
                low = std::min(low, at(state, v).y());
                high = std::max(high, at(state, v).y());
            }
            EXPECT_LT(high - low, 0.001);
            EXPECT_TRUE(low > 0.0004 || high < -0.0004);
        }
    }
}

TEST(Scissors, NothingChangesBeyondTheCut) {
    const Scene scene = test::box_scene(sheet());
    State state(scene, 1);
    const auto before = state.body.x;
    snip(scene, state, blades(Vec3(-0.001, 0, -0.0005), Vec3::UnitX(), Vec3::UnitZ()));
    EXPECT_GT(state.splits, 0);
    // At rest and without gravity a cut opens nothing: every vertex and copy is where it was.
    for (int v = 0; v < state.body.topology->vertices; ++v) {
        const int o = origin_of(state.body, v);
        EXPECT_LT((at(state, v) - Vec3(before[o].x, before[o].y, before[o].z)).norm(), 1e-6);
    }
    // The blades ended 1 mm behind the middle: the tissue ahead is whole.
    for (int v = scene.body.vertex_count(); v < state.body.topology->vertices; ++v) {
        EXPECT_LT(at(state, v).x(), -0.001 + 0.0005 + 2e-4);
        EXPECT_LT(std::abs(at(state, v).y()), 0.0006);
    }
    // No face farther ahead than the roundness of the tips is parted, by its middle.
    constexpr double kTipX = -0.001, kRoundness = 2e-4;
    double farthest = -1;
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        for (int f = 0; f < 4; ++f) {
            const bool inner = scene.surface.neighbours()[static_cast<size_t>(t)][f] >= 0;
            if (!inner || !state.surface.on_surface(t, f)) continue;
            double x = 0;
            for (const int k : kTetFaces[f])
                x += at(state, corners(scene.body, state.body, t)[k]).x() / 3;
            farthest = std::max(farthest, x);
        }
    }
    EXPECT_GT(farthest, kTipX - 0.0005) << "and up to the tips it is";
    EXPECT_LT(farthest, kTipX + kRoundness + 1e-6);
    double mass = 0, whole = 0;
    for (int v = 0; v < state.body.topology->vertices; ++v) {
        mass += static_cast<double>(mass_of(scene.body, state.body, v));
    }
    for (const float m : scene.body.mass_kg()) whole += static_cast<double>(m);
    EXPECT_NEAR(mass / whole, 1, 1e-6);
}

TEST(Scissors, BladesThatMissOrStayOpenCutNothing) {
    const Scene scene = test::box_scene(sheet());
    State state(scene, 1);
    snip(scene, state, blades(Vec3(0, 0, 0.006), Vec3::UnitX(), Vec3::UnitZ()), 0.4);
    EXPECT_EQ(state.splits, 0);
    ToolInput input;
    input.engaged = 1;
    input.set_pose(blades(Vec3(0.0035, 0, -0.0005), Vec3::UnitX(), Vec3::UnitZ()));
    ToolFeedback feedback;
    for (int i = 0; i < 20; ++i) {
        input.jaw_rad = 0.03F * static_cast<float>(i);
        test::frame(scene, state, input, feedback);
    }
    EXPECT_EQ(state.splits, 0);
}

// Open blades lie in the side of a sheet, with nothing to cut between them: closed, they have to
// come out of it without a blow.
TEST(Scissors, BladesThatCloseInsideTissueComeOutGently) {
    BoxOptions options = sheet();
    options.hold_bottom = true;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    ToolInput input;
    input.set_pose(blades(Vec3(0.00305, 0.003, -0.0005), Vec3::UnitY(), Vec3::UnitZ()));
    input.engaged = 1;
    ToolFeedback feedback;
    double peak_n = 0;
    for (int i = 0; i < 400; ++i) {
        input.jaw_rad = static_cast<float>(std::max(0.0, 0.22 * (1 - i / 100.0)));
        test::frame(scene, state, input, feedback);
        peak_n = std::max(peak_n, feedback.force_n.norm());
    }
    EXPECT_EQ(state.splits, 0);
    EXPECT_GT(state.tools[0].gap_m, -2e-5);
    EXPECT_GT(feedback.force_n.norm(), 0.005);
    EXPECT_LT(peak_n, 1.5 * feedback.force_n.norm());
}

TEST(Scissors, ASnipIsEnteredWithItsAreaAndTheCutOfThePlacodeApart) {
    for (const Tissue tissue : {Tissue::kZone, Tissue::kPlacode}) {
        BoxOptions options = sheet();
        options.tissue = tissue;
        const Scene scene = test::box_scene(options);
        State state(scene, 1);
        ToolInput input;
        input.engaged = 1;
        input.set_pose(blades(Vec3(0.0035, 0, -0.0005), Vec3::UnitX(), Vec3::UnitZ()));
        ToolFeedback feedback;
        std::vector<Event> events;
        for (int i = 0; i < 30; ++i) {
            input.jaw_rad = std::max(0.0F, 0.7F - 0.05F * static_cast<float>(i));
            test::frame(scene, state, input, feedback);
            for (int e = 0; e < state.event_count; ++e) events.push_back(state.events[e]);
        }
        int snips = 0, placode = 0;
        for (const Event& e : events) {
            if (e.kind == EventKind::kSnipped) {
                ++snips;
                EXPECT_EQ(e.tissue, tissue);
                // 6 x 1 mm; faces of a mesh zigzag, by at most sqrt(3) here.
                EXPECT_GT(e.value, 5e-6F);
                EXPECT_LT(e.value, 11e-6F);
            }
            placode += e.kind == EventKind::kPlacodeCut ? 1 : 0;
        }
        EXPECT_EQ(snips, 1);
        EXPECT_EQ(placode, tissue == Tissue::kPlacode ? 1 : 0);
    }
}

TEST(Scissors, PartingThePlacodeFromTheZoneIsNoCutOfThePlacode) {
    for (const double y : {0.0, 0.0015}) {
        BoxOptions options = sheet();
        options.tissue_at = [](const Vec3& p) {
            return p.y() > 0 ? Tissue::kPlacode : Tissue::kZone;
        };
        const Scene scene = test::box_scene(options);
        State state(scene, 1);
        ToolInput input;
        input.engaged = 1;
        input.set_pose(blades(Vec3(0.0035, y, -0.0005), Vec3::UnitX(), Vec3::UnitZ()));
        ToolFeedback feedback;
        int snips = 0, placode = 0;
        for (int i = 0; i < 30; ++i) {
            input.jaw_rad = std::max(0.0F, 0.7F - 0.05F * static_cast<float>(i));
            test::frame(scene, state, input, feedback);
            for (int e = 0; e < state.event_count; ++e) {
                snips += state.events[static_cast<size_t>(e)].kind == EventKind::kSnipped ? 1 : 0;
                placode +=
                    state.events[static_cast<size_t>(e)].kind == EventKind::kPlacodeCut ? 1 : 0;
            }
        }
        EXPECT_EQ(snips, 1);
        EXPECT_EQ(placode, y > 0 ? 1 : 0) << "cut at y = " << y;
    }
}

TEST(Scissors, ThousandsOfRandomCutsKeepTheMeshSound) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&] {
        Vec3 v;
        do v = Vec3(unit(random), unit(random), unit(random));
        while (v.norm() > 1 || v.norm() < 0.1);
        return v;
    };
    int cuts = 0, splits = 0;
    for (int field = 0; field < 20; ++field) {
        BoxOptions options = sheet(field % 5 == 4 ? Method::kXpbd : Method::kVbd);
        options.size_m = Vec3(0.003, 0.003, 0.0015);
        options.cells = {6, 6, 3};
        options.spare_vertices = 2600;  // every corner may become a vertex
        const Scene scene = test::box_scene(options);
        State state(scene, 1);
        const double volume = living_volume(scene, state);
        for (int i = 0; i < 100; ++i, ++cuts) {
            const Vec3 middle(0.0015 * unit(random), 0.0015 * unit(random), -0.0008);
            ToolInput input;
            input.engaged = 1;
            input.set_pose(blades(middle, vector(), vector()));
            ToolFeedback feedback;
            for (const float jaw : {0.0F, 0.5F, 0.2F, 0.0F}) {
                input.jaw_rad = jaw;
                test::frame(scene, state, input, feedback);
            }
            ASSERT_EQ(state.flags & (kCutRefused | kNotFinite), 0U) << "cut " << cuts;
            if (i % 20 != 19) continue;
            for (int k = 0; k < 30; ++k) {  // what waits for its turn
                test::frame(scene, state, input, feedback);
            }
            expect_closed_surface(scene, state);
            expect_whole_vertices(scene, state);
            ASSERT_NEAR(living_volume(scene, state) / volume, 1, 1e-12);
            for (int v = 0; v < state.body.topology->vertices; ++v) {
                ASSERT_TRUE(at(state, v).allFinite());
                // What the kernels' strips say is what the tets say.
                if (v % 17 != i % 17) continue;
                const Vec3 tets = force_by_tets(scene, state, v);
                const Vec3 strip = elastic_force(scene.body, state.body, v);
                // Float constants: some 1e-6 of E L^2 = 2.5 mN for each tet.
                ASSERT_LT((tets - strip).norm(), 1e-7 + 1e-3 * tets.norm()) << "vertex " << v;
            }
        }
        EXPECT_EQ(state.body.topology->refused, 0);
        splits += state.splits;
    }
    EXPECT_EQ(cuts, 2000);
    EXPECT_GT(splits, 4000);
}

TEST(Scissors, TheBitsAreTheSameForOneToFourThreads) {
    uint64_t first = 0;
    for (const int threads : {1, 2, 3, 4}) {
        BoxOptions options = sheet();
        options.size_m = Vec3(0.004, 0.004, 0.001);
        options.cells = {8, 8, 2};
        options.gravity = Vec3(0, 0, -9.81);
        const Scene scene = test::box_scene(options);
        State state(scene, threads);
        ToolInput input;
        input.engaged = 1;
        input.set_pose(blades(Vec3(0.001, 0.0003, -0.0005), Vec3(1, 0.4, 0), Vec3::UnitZ()));
        ToolFeedback feedback;
        for (int i = 0; i < 25; ++i) {
            input.jaw_rad = std::max(0.0F, 0.7F - 0.05F * static_cast<float>(i));
            test::frame(scene, state, input, feedback);
        }
        EXPECT_GT(state.splits, 10);
        const uint64_t hash = state_hash(state);
        if (threads == 1) first = hash;
        EXPECT_EQ(hash, first) << threads << " threads";
    }
}

TEST(Scissors, ABodyWithoutSparesIsNotCut) {
    BoxOptions options = sheet();
    options.spare_vertices = 0;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    const size_t triangles = state.surface.triangles().size();
    snip(scene, state, blades(Vec3(0.0035, 0, -0.0005), Vec3::UnitX(), Vec3::UnitZ()));
    EXPECT_EQ(state.splits, 0);
    EXPECT_EQ(state.surface.triangles().size(), triangles);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
