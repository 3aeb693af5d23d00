// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments against each other, far from tissue.
#include "sim/contact/tool_contact.h"

#include <gtest/gtest.h>

#include <numbers>

#include "box_scene.h"
#include "sim/core/tool_shape.h"

using namespace placode::sim;
using namespace placode::sim::test;

namespace THIS_TEST {

constexpr double kRadius = 0.0015, kGrip = 600;

ToolSpec rod(ToolKind kind = ToolKind::kProbe, double hand_n_m = kGrip) {
    ToolSpec spec;
    spec.kind = kind;
    spec.shaft_radius_m = spec.tip_radius_m = kRadius;  // a plain capsule
    spec.hand_n_m = hand_n_m;
    return spec;
}

Scene two_rods(const ToolSpec& a, const ToolSpec& b) {
    BoxOptions options;
    options.cells = {4, 4, 2};
    options.heat = false;
    Scene scene = box_scene(options);
    scene.tools = {a, b};
    return scene;
}

/// A rod whose tip is at `tip` and whose shaft comes from direction `from`.
ToolInput held(const Vec3& tip, const Vec3& from) {
    ToolInput input;
    input.set_pose({tip, Quat::FromTwoVectors(Vec3::UnitZ(), -from.normalized())});
    input.engaged = 1;
    return input;
}

struct Two {
    Scene scene;
    State state{scene, 1};
    std::array<ToolFeedback, 2> feedback{};

    void go(const ToolInput& a, const ToolInput& b) {
        const std::array<ToolInput, 2> inputs{a, b};
        step(scene, state, inputs, feedback);
    }
    [[nodiscard]] double gap() const {
        return gap_between(make_tool_shape(scene.tools[0]), state.tools[0].proxy,
                           make_tool_shape(scene.tools[1]), state.tools[1].proxy)
            .value_m;
    }
};

// One along x, one along y, high above the block, tips 30 mm beyond the crossing.
ToolInput along_x(double z) { return held(Vec3(0.03, 0, z), -Vec3::UnitX()); }
ToolInput along_y(double z) { return held(Vec3(0, 0.03, z), -Vec3::UnitY()); }

TEST(ToolContact, GapOfTwoCapsulesIsTheDistanceOfTheirAxesLessTheRadii) {
    const ToolShape shape = make_tool_shape(rod());
    const Pose a = along_x(0.050).pose(), b = along_y(0.054).pose();
    const ToolGap gap = gap_between(shape, a, shape, b);
    EXPECT_NEAR(gap.value_m, 0.004 - 2 * kRadius, 1e-9);  // poses are floats
    EXPECT_NEAR(gap.n.z(), 1, 1e-9);
}

TEST(ToolContact, ShaftsThatCrossPushEachOtherApartByTheStiffnessOfTheHands) {
    Two two{two_rods(rod(), rod(ToolKind::kGrasper, 300))};
    two.scene.tools[1] = rod(ToolKind::kProbe, 300);
    for (int i = 0; i < 20; ++i) two.go(along_x(0.050), along_y(0.054 - 1e-4 * i));
    two.go(along_x(0.050), along_y(0.0521));  // still: forces are means over a frame
    // The hands are 2.1 mm apart, the radii need 3 mm: 0.9 mm, shared as the grips yield.
    EXPECT_NEAR(two.gap(), 0, 1e-9);
    EXPECT_NEAR(two.state.tools[0].proxy.p.z(), 0.050 - 0.0003, 1e-7);
    EXPECT_NEAR(two.state.tools[1].proxy.p.z(), 0.0521 + 0.0006, 1e-7);
    const Vec3 first = two.feedback[0].force_n, second = two.feedback[1].force_n;
    EXPECT_NEAR(first.z(), -kGrip * 0.0003, 1e-4);
    EXPECT_LT((first + second).norm(), 1e-6) << "action and reaction";
    EXPECT_LT(first.head<2>().norm(), 1e-6);
    EXPECT_EQ(two.state.tools[0].force_n, Vec3::Zero()) << "no tissue was touched";
}

TEST(ToolContact, HandsThatCrossDoNotCarryTheShaftsThroughEachOther) {
    Two two{two_rods(rod(), rod())};
    double lowest = 1;
    for (int i = 0; i <= 12; ++i) {  // 0.5 m/s, down to 2 mm below the other hand
        two.go(along_x(0.050), along_y(0.054 - 5e-4 * i));
        lowest = std::min(lowest, two.gap());
    }
    two.go(along_x(0.050), along_y(0.048));
    EXPECT_GT(lowest, -1e-9);
    EXPECT_GT(two.state.tools[1].proxy.p.z(), two.state.tools[0].proxy.p.z()) << "still above";
    EXPECT_NEAR(two.feedback[1].force_n.z(), kGrip * (2 * kRadius + 0.002) / 2, 1e-3);
    for (int i = 12; i >= 0; --i) two.go(along_x(0.050), along_y(0.054 - 5e-4 * i));
    EXPECT_EQ(two.feedback[1].force_n, Vec3::Zero());
    EXPECT_NEAR(two.state.tools[1].proxy.p.z(), 0.054, 1e-8) << "where the hand is";
}

TEST(ToolContact, ShaftsThatAreFarThroughEachOtherAreLetPass) {
    Two two{two_rods(rod(), rod())};
    two.go(along_x(0.050), along_y(0.054));
    for (int i = 0; i < 200; ++i) two.go(along_x(0.050), along_y(0.054 - 1e-4 * i));
    EXPECT_EQ(two.feedback[0].force_n, Vec3::Zero());
    EXPECT_NEAR(two.state.tools[1].proxy.p.z(), 0.054 - 0.0199, 1e-8);
}

TEST(ToolContact, TipsSlidePastEachOtherWithoutAJump) {
    Two two{two_rods(rod(), rod())};
    Vec3 before = along_y(0.052).pose().p;
    double jump = 0;
    // The second rod, 1 mm into the first, is drawn back over its tip in steps of 0.1 mm.
    for (int i = 0; i < 400; ++i) {
        const ToolInput second = held(Vec3(0.01 + 1e-4 * i, 0.03, 0.052), -Vec3::UnitY());
        two.go(along_x(0.050), second);
        const Vec3 now = two.state.tools[1].proxy.p;
        if (i > 0) jump = std::max(jump, (now - before).norm());
        before = now;
        EXPECT_GT(two.gap(), -1e-9);
    }
    EXPECT_LT(jump, 2e-4) << "0.1 mm of the hand and what the round tip adds";
    EXPECT_EQ(two.feedback[1].force_n, Vec3::Zero()) << "past the tip";
}

TEST(ToolContact, TheScopeAndALostHandTouchNothing) {
    Two scope{two_rods(rod(), rod(ToolKind::kScope))};
    scope.go(along_x(0.050), along_y(0.051));
    EXPECT_EQ(scope.feedback[0].force_n, Vec3::Zero());
    Two lost{two_rods(rod(), rod())};
    ToolInput gone = along_y(0.051);
    gone.engaged = 0;
    lost.go(along_x(0.050), gone);
    EXPECT_EQ(lost.feedback[0].force_n, Vec3::Zero());
}

}  // namespace THIS_TEST
