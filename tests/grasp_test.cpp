// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Jaws on a block of tissue: what they hold, how it pulls, when it slips, is crushed, is let go.

#include "sim/cutting/grasp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/ledger/ledger.h"
#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

using test::BoxOptions;
using test::frame;
using test::upright;

constexpr double kTouch = 0.0001;  // height of the tip over the block while grasping [m]

BoxOptions options_for(double youngs_pa = 10000) {
    BoxOptions options;
    options.size_m = Vec3(0.008, 0.008, 0.003);
    options.cells = {16, 16, 6};
    options.tissue = Tissue::kZone;
    options.material.youngs_modulus_pa = youngs_pa;
    options.material.damping_per_s = 30;
    options.material.fail_stretch = options.material.injury_stretch = 100;
    options.heat = false;
    options.tool.kind = ToolKind::kGrasper;
    options.tool.tip_radius_m = 0.0005;
    options.tool.tip_length_m = 0.010;
    options.tool.hand_n_m = 1e7;
    return options;
}

struct Jaws {
    explicit Jaws(const BoxOptions& options, int threads = 1)
        : scene(test::box_scene(options)), state(scene, threads) {}

    /// Moves the tip to z and the jaws to an opening, linearly over `frames`.
    void go(double z, double jaw, int frames) {
        const double z0 = z_, jaw0 = jaw_;
        for (int i = 1; i <= frames; ++i) {
            const double s = static_cast<double>(i) / frames;
            ToolInput input = upright(Vec3(0, 0, z0 + s * (z - z0)));
            input.jaw_rad = static_cast<float>(jaw0 + s * (jaw - jaw0));
            frame(scene, state, input, feedback);
            for (int e = 0; e < state.event_count; ++e) events.push_back(state.events[e]);
        }
        z_ = z;
        jaw_ = jaw;
    }
    /// Opens, comes down, and squeezes with a share of the full jaw force.
    void grasp(double squeeze) {
        go(kTouch, 0.6, 50);
        go(kTouch, (1 - squeeze) * grip_angle(scene.tools[0]), 100);
    }
    [[nodiscard]] const Event* find(EventKind kind) const {
        for (const Event& e : events)
            if (e.kind == kind) return &e;
        return nullptr;
    }
    [[nodiscard]] const Grasp& held() const { return state.grasps[0]; }

    Scene scene;
    State state;
    ToolFeedback feedback;
    std::vector<Event> events;

 private:
    static void frame(const Scene& scene, State& state, const ToolInput& input,
                      ToolFeedback& feedback) {
        test::frame(scene, state, input, feedback);
    }
    double z_ = 0.002, jaw_ = 0.6;
};

TEST(Grasp, ClosingJawsTakeWhatLiesBetweenThemAndOpeningLetsGo) {
    Jaws jaws(options_for());
    jaws.go(0.002, 0.0, 100);
    EXPECT_EQ(jaws.held().count, 0);  // in the air there is nothing to take
    jaws.go(kTouch, 0.0, 50);
    EXPECT_EQ(jaws.held().count, 0);  // and shut jaws take nothing either
    jaws.go(0.002, 0.6, 50);
    jaws.grasp(0.4);
    const int held = jaws.held().count;
    EXPECT_GE(held, 4);
    const Event* e = jaws.find(EventKind::kGrasped);
    ASSERT_NE(e, nullptr);
    EXPECT_EQ(e->tissue, Tissue::kZone);
    EXPECT_NEAR(e->rest_position_m[0], 0, 0.0006);
    EXPECT_NEAR(e->rest_position_m[2], 0, 1e-6);
    jaws.go(kTouch, 0.6, 50);
    EXPECT_EQ(jaws.held().count, 0);
    EXPECT_NE(jaws.find(EventKind::kReleased), nullptr);
    for (int v = 0; v < jaws.scene.body.vertex_count(); ++v) {
        EXPECT_EQ(jaws.state.held_by[v], -1);
    }
    // Let go, the tissue goes home.
    jaws.go(0.004, 0.6, 500);
    double worst = 0;
    for (int v = 0; v < jaws.scene.body.vertex_count(); ++v) {
        const Float4& x = jaws.state.body.x[v];
        worst = std::max(worst, (Vec3(x.x, x.y, x.z) - jaws.scene.body.mesh().rest[v]).norm());
    }
    EXPECT_LT(worst, 2e-5);
}

TEST(Grasp, JawsThatBeginWithNoNumberOrBelowShutHoldAndLetGoLikeOthers) {
    for (const float first : {NAN, -0.01F}) {
        Jaws jaws(options_for());
        jaws.go(kTouch, 0.6, 50);
        // Shut in a device that is not engaged: the first engaged frame begins the grasp.
        jaws.state.grasps[0].shut = 0;
        jaws.state.grasps[0].jaw_rad = 0;
        ToolInput input = upright(Vec3(0, 0, kTouch));
        input.jaw_rad = first;
        frame(jaws.scene, jaws.state, input, jaws.feedback);
        EXPECT_TRUE(std::isfinite(jaws.held().meet_rad));
        EXPECT_GE(jaws.held().meet_rad, 0);
        jaws.go(kTouch, 0.6, 50);
        EXPECT_EQ(jaws.held().count, 0);
    }
}

TEST(Grasp, TheForceOnTheJawsIsWhatTheBedCarries) {
    Jaws jaws(options_for());
    jaws.grasp(0.6);
    jaws.go(0.0006, 0.4 * grip_angle(jaws.scene.tools[0]), 300);
    jaws.go(0.0006, 0.4 * grip_angle(jaws.scene.tools[0]), 500);
    ASSERT_GT(jaws.held().count, 0);
    // In balance the held bottom carries what the jaws pull: every free vertex is at rest.
    Vec3 carried = Vec3::Zero();
    for (int v = 0; v < jaws.scene.body.vertex_count(); ++v) {
        if (jaws.state.body.x[v].w == 0 && jaws.state.held_by[v] < 0) {
            carried += elastic_force(jaws.scene.body, jaws.state.body, v);
        }
    }
    const Vec3 pull = jaws.feedback.force_n;
    EXPECT_LT(pull.z(), -0.002);  // tissue pulls the jaws down
    // What is left of the swing after half a second.
    EXPECT_LT((pull + carried).norm(), 0.03 * pull.norm());
}

TEST(Grasp, SlipsAboveTwiceFrictionTimesJawForce) {
    BoxOptions options = options_for(40000);
    options.tool.jaw_force_n = 0.05;
    Jaws jaws(options);
    jaws.grasp(0.5);
    const double jaw = 0.5 * grip_angle(jaws.scene.tools[0]);
    const double limit = 2 * options.tool.jaw_friction * options.tool.jaw_force_n * 0.5;
    ASSERT_GT(jaws.held().count, 0);
    double peak = 0;
    for (int i = 0; i < 60 && jaws.held().count > 0; ++i) {
        jaws.go(kTouch + 0.00005 * i, jaw, 20);
        peak = std::max(peak, jaws.held().force_n.norm());
    }
    EXPECT_EQ(jaws.held().count, 0);  // pulled out in the end
    // It slides at the limit: a substep lets go 0.02 mm, which is the margin.
    EXPECT_GT(peak, 0.8 * limit);
    EXPECT_LT(peak, 1.3 * limit);
    const Event* e = jaws.find(EventKind::kSlipped);
    ASSERT_NE(e, nullptr);
    EXPECT_GT(e->value, 0.0001);
    EXPECT_NE(jaws.find(EventKind::kReleased), nullptr);
}

TEST(Grasp, HoldsBelowThatForce) {
    BoxOptions options = options_for(10000);
    Jaws jaws(options);
    jaws.grasp(0.5);
    const int held = jaws.held().count;
    jaws.go(0.0008, 0.5 * grip_angle(jaws.scene.tools[0]), 300);
    EXPECT_EQ(jaws.held().count, held);
    EXPECT_EQ(jaws.find(EventKind::kSlipped), nullptr);
    // What is held has come along: 0.7 mm up with the jaws.
    for (int i = 0; i < held; ++i) {
        EXPECT_GT(jaws.state.body.x[jaws.held().held[i].vertex].z, 0.0004F);
    }
}

TEST(Grasp, CrushesAboveTheTissuesPressureAndOnlyThen) {
    BoxOptions options = options_for();
    options.material.crush_pa = 100000;
    Jaws gentle(options), rough(options);
    gentle.grasp(0.15);  // 0.15 N on at least 2 mm2: below 75 kPa
    rough.grasp(1.0);    // 1 N on 2 to 3 mm2: above 300 kPa
    EXPECT_EQ(gentle.find(EventKind::kCrushed), nullptr);
    const Event* e = rough.find(EventKind::kCrushed);
    ASSERT_NE(e, nullptr);
    EXPECT_GT(e->value, 100000);
    EXPECT_EQ(e->tissue, Tissue::kZone);
}

TEST(Grasp, CrushesFromTheVeryPressureOn) {
    BoxOptions options = options_for();
    options.material.crush_pa = 1e9;
    Jaws first(options);
    first.grasp(0.5);
    const double pressure = first.held().pinch_n / static_cast<double>(first.held().area_m2);
    ASSERT_GT(pressure, 50000);
    options.material.crush_pa = 0.9 * pressure;
    Jaws above(options);
    above.grasp(0.5);
    EXPECT_NE(above.find(EventKind::kCrushed), nullptr);
    options.material.crush_pa = 1.1 * pressure;
    Jaws below(options);
    below.grasp(0.5);
    EXPECT_EQ(below.find(EventKind::kCrushed), nullptr);
}

TEST(Grasp, APullAboveTheLimitIsEnteredWithItsPeak) {
    BoxOptions options = options_for(40000);
    options.material.traction_limit_n = 0.02;
    Jaws jaws(options);
    jaws.grasp(0.6);
    const double jaw = 0.4 * grip_angle(jaws.scene.tools[0]);
    jaws.go(0.0008, jaw, 300);
    jaws.go(0.0008, jaw, 400);
    jaws.go(kTouch, jaw, 300);
    jaws.go(kTouch, jaw, 400);
    const Event* e = jaws.find(EventKind::kOverTraction);
    ASSERT_NE(e, nullptr);
    EXPECT_GT(e->value, 0.3F);
    EXPECT_GT(e->value2, 0.02F);
}

/// Jaws that hold tissue which nothing moves: the pull is what the test says.
struct Tugs {
    Tugs() : scene(test::box_scene(options_for())), state(scene, 1) {
        Grasp& g = state.grasps[0];
        g.held[0].vertex = 0;
        g.count = g.grasped = 1;
        g.tet = 0;
        g.tissue = Tissue::kZone;
        g.meet_rad = static_cast<float>(grip_angle(scene.tools[0]));
        state.tools[0].engaged = 1;
        state.tools[0].jaw_rad = g.meet_rad;
        limit_n = scene.body.spec().materials[static_cast<int>(Tissue::kZone)].traction_limit_n;
    }
    void pull(int frames, double share_of_limit) {
        for (int i = 0; i < frames; ++i) {
            ++state.frame;
            state.time_s = static_cast<double>(state.frame) * 1e-3;
            state.event_count = 0;
            state.grasps[0].force_n = Vec3(0, 0, -share_of_limit * limit_n);
            update_grasps(scene, state, 1e-3);
            for (int e = 0; e < state.event_count; ++e)
                if (state.events[e].kind == EventKind::kOverTraction)
                    pulls.push_back(state.events[e]);
                else if (state.events[e].kind == EventKind::kSlipped)
                    slips.push_back(state.events[e]);
        }
    }
    /// A frame in which the tissue slides by so much and the jaws go to a share of the angle at
    /// which they met it.
    void slide(double way_m, double share) {
        Grasp& g = state.grasps[0];
        if (way_m > 0) g.slip_pause_s = 0;
        g.slip_m += static_cast<float>(way_m);
        state.tools[0].jaw_rad = static_cast<float>(share) * g.meet_rad;
        pull(1, 0.5);
    }

    Scene scene;
    State state;
    double limit_n = 0;
    std::vector<Event> pulls, slips;
};

TEST(Grasp, TugsThatFollowEachOtherAtOnceAreOnePull) {
    Tugs tugs;
    for (int i = 0; i < 20; ++i) {
        tugs.pull(290, 1.5);
        tugs.pull(10, 0.5);
    }
    EXPECT_TRUE(tugs.pulls.empty()) << "it is not over";
    ASSERT_TRUE(open_traction(tugs.state, 0).has_value());
    tugs.pull(400, 0.5);
    ASSERT_EQ(tugs.pulls.size(), 1U);
    EXPECT_NEAR(tugs.pulls[0].value, 20 * 0.29, 0.01) << "time below the limit does not count";
    EXPECT_NEAR(tugs.pulls[0].time_s, 5.99, 0.002) << "the last moment above the limit";
    EXPECT_NEAR(tugs.pulls[0].value2, 1.5 * tugs.limit_n, 1e-4 * tugs.limit_n);
    EXPECT_FALSE(open_traction(tugs.state, 0).has_value());
}

TEST(Grasp, AShortPullCostsNothingNorDoesOneAfterAPause) {
    Tugs tugs;
    tugs.pull(290, 1.5);
    tugs.pull(400, 0.5);
    tugs.pull(290, 1.5);
    tugs.pull(400, 0.5);
    EXPECT_TRUE(tugs.pulls.empty());
    tugs.pull(350, 1.5);
    tugs.pull(400, 0.5);
    EXPECT_EQ(tugs.pulls.size(), 1U);
}

TEST(Grasp, WhatSlidBeforeTheJawsOpenIsASlip) {
    Tugs tugs;
    for (int i = 0; i < 20; ++i) tugs.slide(1e-4, 0.5);
    EXPECT_TRUE(tugs.slips.empty()) << "it is not over";
    tugs.slide(0, 2);
    ASSERT_EQ(tugs.state.grasps[0].count, 0);
    ASSERT_EQ(tugs.slips.size(), 1U);
    EXPECT_NEAR(tugs.slips[0].value, 2e-3, 1e-7);
}

TEST(Grasp, WhatSlidesOnlyWhileTheJawsOpenIsLetGo) {
    Tugs tugs;
    tugs.slide(0, 0.5);
    for (int i = 1; i <= 10; ++i) tugs.slide(1e-4, 0.5 + 0.1 * i);
    ASSERT_EQ(tugs.state.grasps[0].count, 0);
    EXPECT_TRUE(tugs.slips.empty());
}

TEST(Grasp, ASlipThatTheAttemptsEndMeetsIsEntered) {
    Tugs tugs;
    tugs.slide(2e-4, 0.5);
    EXPECT_TRUE(open_spells(tugs.scene, tugs.state).empty()) << "settles between the jaws";
    for (int i = 0; i < 20; ++i) tugs.slide(1e-4, 0.5);
    tugs.slide(1e-4, 0.6);
    const std::vector<Event> open = open_spells(tugs.scene, tugs.state);
    ASSERT_EQ(open.size(), 1U);
    EXPECT_EQ(open[0].kind, EventKind::kSlipped);
    EXPECT_NEAR(open[0].value, 2.2e-3, 1e-7) << "the jaws have begun to open";
}

TEST(Grasp, OverStretchedTissueTearsAndNamesTheGrasper) {
    BoxOptions options = options_for(10000);
    options.material.fail_stretch = 1.5;
    Jaws jaws(options);
    jaws.grasp(0.9);
    jaws.go(0.0025, 0.1 * grip_angle(jaws.scene.tools[0]), 400);
    const Event* e = jaws.find(EventKind::kTorn);
    ASSERT_NE(e, nullptr);
    EXPECT_EQ(e->tool, 0);
    for (const Float4& x : jaws.state.body.x) EXPECT_TRUE(std::isfinite(x.x + x.y + x.z));
}

TEST(Grasp, TheBitsAreTheSameForOneToFourThreads) {
    uint64_t first = 0;
    for (const int threads : {1, 2, 3, 4}) {
        BoxOptions options = options_for(10000);
        options.size_m = Vec3(0.004, 0.004, 0.002);
        options.cells = {8, 8, 4};
        options.material.fail_stretch = 1.5;
        Jaws jaws(options, threads);
        jaws.go(kTouch, grip_angle(jaws.scene.tools[0]), 10);
        jaws.go(0.0018, 0.4 * grip_angle(jaws.scene.tools[0]), 30);
        EXPECT_GT(jaws.held().count, 0);
        const uint64_t hash = state_hash(jaws.state);
        if (threads == 1) first = hash;
        EXPECT_EQ(hash, first) << threads << " threads";
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim
