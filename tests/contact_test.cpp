// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments on a block of tissue: balance of forces, friction, fast tips, hands that are lost.

#include "sim/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/box_scene.h"

namespace placode::sim {
namespace {

using test::BoxOptions;
using test::frame;
using test::upright;

/// A probe of 1.5 mm radius that a machine holds: its proxy is where it is put.
ToolSpec stiff_probe() {
    ToolSpec tool;
    tool.kind = ToolKind::kProbe;
    tool.tip_radius_m = tool.shaft_radius_m = 0.0015;
    tool.grip_n_m = 1e7;
    return tool;
}

Material skin() {
    Material m;
    m.youngs_modulus_pa = 60000;
    m.density_kg_m3 = 1050;
    m.damping_per_s = 30;
    m.friction = 0;
    m.fail_stretch = m.injury_stretch = 100;
    return m;
}

/// Runs for `seconds` with the hand at rest; returns the last feedback.
ToolFeedback hold(const Scene& scene, State& state, const Vec3& p, double seconds) {
    ToolFeedback feedback;
    for (int i = 0; i < static_cast<int>(seconds * 1000); ++i) {
        frame(scene, state, upright(p), feedback);
    }
    return feedback;
}

/// Lowers the tip at 20 mm/s, so that the tissue follows quasi-statically, and waits.
ToolFeedback press(const Scene& scene, State& state, double depth, double seconds) {
    ToolFeedback feedback;
    const int ramp = static_cast<int>((depth + 0.0003) / 0.00002);
    for (int i = 0; i < ramp; ++i) {
        frame(scene, state, upright(Vec3(0, 0, 0.0003 - 0.00002 * i)), feedback);
    }
    return hold(scene, state, Vec3(0, 0, -depth), seconds);
}

TEST(Contact, TheForceOnTheToolIsWhatTheTissueCarries) {
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    options.tool = stiff_probe();
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    const ToolFeedback f = press(scene, state, 0.0003, 0.4);
    // At rest every free vertex is in balance: what the elements pull together is what the tool
    // pushes, so the sum over the tissue equals the force on the tool.
    Vec3 carried = Vec3::Zero();
    for (int v = 0; v < scene.body.vertex_count(); ++v) {
        if (state.body.x[v].w > 0) carried += elastic_force(scene.body, state.body, v);
    }
    EXPECT_GT(f.force_n.z(), 0.005);
    // The two passes of a substep leave the stiff contacts converged to some percent.
    EXPECT_LT((carried - f.force_n).norm(), 0.05 * f.force_n.norm());
}

TEST(Contact, TheProxyYieldsByForceOverGrip) {
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    options.tool = stiff_probe();
    options.tool.grip_n_m = 50;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    const ToolFeedback f = press(scene, state, 0.0006, 0.3);
    const double lag = f.proxy.p.z() + 0.0006;
    EXPECT_GT(lag, 0.0001);
    EXPECT_NEAR(f.force_n.z(), 50 * lag, 0.02 * f.force_n.z());
    EXPECT_GT(f.stiffness_n_m, 10);
}

TEST(Contact, AThinTipDoesNotSlipBetweenVertices) {
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    options.size_m = Vec3(0.008, 0.008, 0.004);
    options.cells = {8, 8, 4};  // edges of 1 mm under a tip of 0.25 mm radius
    options.tool.grip_n_m = 1e7;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    ToolFeedback f;
    const Vec3 at(0.0006, 0.0003, 0);  // inside a triangle
    for (int i = 0; i < 300; ++i) {
        frame(scene, state, upright(at + Vec3(0, 0, std::max(-0.0003, 0.0002 - 0.00001 * i))), f);
    }
    EXPECT_GT(f.force_n.z(), 0.001);
    // k = 3000 N/m: some 10 mN are an overlap of 4 um; 20 leaves room for the triangle's tilt.
    EXPECT_GT(state.tools[0].tip_gap_m, -20e-6);
    EXPECT_LT(state.tools[0].tip_gap_m, 20e-6);
}

TEST(Contact, ATipAtHalfAMetrePerSecondDoesNotTunnel) {
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    ToolFeedback f;
    double deepest = 0;
    for (int i = 0; i < 200; ++i) {
        const double z = std::max(-0.0008, 0.005 - 0.0005 * i);
        frame(scene, state, upright(Vec3(0.0001, 0.0002, z)), f);
        deepest = std::min(deepest, state.tools[0].tip_gap_m);
    }
    // One substep brings the tip 0.125 mm nearer, and the surface has left by the end of it.
    EXPECT_GT(deepest, -0.0001);
    EXPECT_GT(f.force_n.z(), 0.005);
}

TEST(Contact, AJumpOfTheHandDoesNotCarryTheTipThroughTheTissue) {
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    ToolFeedback f;
    hold(scene, state, Vec3(0, 0, 0.001), 0.02);
    double deepest = 0;
    for (int i = 0; i < 40; ++i) {
        frame(scene, state, upright(Vec3(0, 0, -0.001)), f);
        deepest = std::min(deepest, state.tools[0].tip_gap_m);
    }
    EXPECT_GT(deepest, -0.00015);
    EXPECT_GT(f.force_n.z(), 0.005);
}

struct Drag {
    double mean_ratio = 0, first = 0, last = 0;
};

/// Presses the probe down and drags it sideways at 5 mm/s for 1.5 mm.
Drag drag(double friction, double ratio) {
    BoxOptions options;
    options.material = skin();
    options.material.friction = friction;
    options.material.friction_static_ratio = ratio;
    options.heat = false;
    options.size_m = Vec3(0.010, 0.006, 0.002);
    options.cells = {30, 18, 6};
    options.tool = stiff_probe();
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    press(scene, state, 0.0002, 0.05);
    ToolFeedback f;
    Drag result;
    int counted = 0;
    for (int i = 0; i < 300; ++i) {
        frame(scene, state, upright(Vec3(0.000005 * i, 0, -0.0002)), f);
        if (i < 150) continue;
        result.mean_ratio += -f.force_n.x() / f.force_n.z();
        ++counted;
    }
    result.mean_ratio /= counted;
    return result;
}

TEST(Contact, ADraggedProbeSlidesAtTheCoulombForce) {
    // Normals differ over the contact patch and the mesh is bumpy: 10 %.
    EXPECT_NEAR(drag(0.3, 1.3).mean_ratio, 0.3, 0.03);
    EXPECT_NEAR(drag(0.1, 1.3).mean_ratio, 0.1, 0.015);
    EXPECT_NEAR(drag(0.0, 1.3).mean_ratio, 0.0, 0.015);
}

TEST(Contact, AProbeBelowTheConeSticksWithoutCreeping) {
    BoxOptions options;
    options.material = skin();
    options.material.friction = 0.5;
    options.heat = false;
    options.tool = stiff_probe();
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    press(scene, state, 0.0002, 0.1);
    // 20 um sideways: far below what 0.5 of the normal force would let slide.
    const ToolFeedback early = hold(scene, state, Vec3(0.00002, 0, -0.0002), 0.3);
    const ToolFeedback late = hold(scene, state, Vec3(0.00002, 0, -0.0002), 1.0);
    const double ratio = -early.force_n.x() / early.force_n.z();
    EXPECT_GT(ratio, 0.02);
    EXPECT_LT(ratio, 0.4);
    // A creep of 1 um of the 20 would be 5 % of the force.
    EXPECT_NEAR(late.force_n.x(), early.force_n.x(), 0.05 * std::abs(early.force_n.x()));
}

TEST(Contact, AHandThatIsNotThereExertsNoForce) {
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    const Scene scene = test::box_scene(options);
    State state(scene, 1), untouched(scene, 1);
    ToolInput lost = upright(Vec3(0, 0, -0.0005), kPedalCut);
    lost.engaged = 0;
    ToolInput senseless = upright(Vec3(0, 0, -0.0005), kPedalCut);
    senseless.position_m[1] = std::numeric_limits<float>::quiet_NaN();
    ToolInput turned = upright(Vec3(0, 0, -0.0005), kPedalCut);
    turned.orientation = {0, 0, 0, 0};
    ToolFeedback f;
    for (const ToolInput& input : {lost, senseless, turned}) {
        for (int i = 0; i < 20; ++i) frame(scene, state, input, f);
        EXPECT_EQ(f.force_n.norm(), 0);
        EXPECT_TRUE(f.proxy.p.allFinite());
        EXPECT_EQ(state.tools[0].energised, 0);
    }
    ToolInput away = upright(Vec3(0, 0, 0.05));
    for (int i = 0; i < 60; ++i) frame(scene, untouched, away, f);
    EXPECT_EQ(state_hash(state.body), state_hash(untouched.body));
}

TEST(Contact, APushedXpbdBodyCarriesTheSameForce) {
    BoxOptions options;
    options.material = skin();
    options.material.youngs_modulus_pa = 3000;
    options.heat = false;
    options.size_m = Vec3(0.010, 0.010, 0.005);
    options.cells = {10, 10, 5};
    options.substeps = 16;
    options.tool = stiff_probe();
    double force[2];
    for (const Method method : {Method::kVbd, Method::kXpbd}) {
        options.method = method;
        const Scene scene = test::box_scene(options);
        State state(scene, 1);
        force[method == Method::kXpbd] = press(scene, state, 0.0005, 0.3).force_n.z();
    }
    EXPECT_GT(force[0], 0.0005);
    // Courant number 0.16: the XPBD block itself is exact to some percent there.
    EXPECT_NEAR(force[1], force[0], 0.1 * force[0]);
}

}  // namespace
}  // namespace placode::sim
