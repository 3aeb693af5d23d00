// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Instruments on a block of tissue: balance of forces, friction, fast tips, hands that are lost.

#include "sim/contact/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

using test::BoxOptions;
using test::frame;
using test::upright;

/// A probe of 1.5 mm radius that a machine holds: its proxy is where it is put.
ToolSpec stiff_probe() {
    ToolSpec tool;
    tool.kind = ToolKind::kProbe;
    tool.tip_radius_m = tool.shaft_radius_m = 0.0015;
    tool.hand_n_m = 1e7;
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
    // After 0.4 s the last of the creep is below a percent.
    EXPECT_LT((carried - f.force_n).norm(), 0.01 * f.force_n.norm());
}

TEST(Contact, TheProxyYieldsByForceOverGrip) {
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    options.tool = stiff_probe();
    options.tool.hand_n_m = 50;
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
    options.tool.hand_n_m = 1e7;
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

TEST(Contact, AHalfMillimetreMembraneIsNotTunnelledThrough) {
    // Held at its rim only: a sheet with its ends fixed, one layer of tets 0.5 mm thick.
    for (const double radius : {0.00025, 0.0015}) {
        BoxOptions options;
        options.material = skin();
        options.heat = false;
        options.hold_bottom = false;
        options.size_m = Vec3(0.010, 0.010, 0.0005);
        options.cells = {20, 20, 1};
        options.tool.tip_radius_m = radius;
        const Scene scene = test::box_scene(options);
        State state(scene, 1);
        for (int v = 0; v < scene.body.vertex_count(); ++v) {
            const Vec3& x = scene.body.mesh().rest[v];
            if (std::max(std::abs(x.x()), std::abs(x.y())) > 0.005 - 1e-9) state.body.x[v].w = 0;
        }
        update_free_vertices(scene.body, state.body);
        ToolFeedback f;
        double deepest = 0;
        for (int i = 0; i < 60; ++i) {
            const double z = std::max(-0.002, 0.005 - 0.0005 * i);
            frame(scene, state, upright(Vec3(0.0001, 0.0002, z)), f);
            deepest = std::min(deepest, state.tools[0].tip_gap_m);
        }
        // The sheet bulges by 2 mm and carries the tip; half its thickness would be half through.
        EXPECT_GT(deepest, -0.0001) << radius;
        EXPECT_GT(f.force_n.z(), 0.01) << radius;
    }
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

/// A slab under a "floor" of 50 m radius, which is flat to 0.1 um over it: every normal is
/// vertical, so that the force on the instrument shows Coulomb's cone without the shape of a tip.
BoxOptions under_a_floor(double friction, double static_ratio) {
    BoxOptions options;
    options.material = skin();
    options.material.friction = friction;
    options.material.friction_static_ratio = static_ratio;
    options.heat = false;
    options.size_m = Vec3(0.004, 0.004, 0.002);
    options.cells = {8, 8, 4};
    options.tool = stiff_probe();
    options.tool.tip_radius_m = options.tool.shaft_radius_m = 50;
    options.tool.length_m = 200;
    options.tool.hand_n_m = 1e9;
    return options;
}

double angle_deg(const ToolFeedback& f) {
    return std::atan2(-f.force_n.x(), f.force_n.z()) * 180 / M_PI;
}

TEST(Contact, AFloorSlidesAtTheAngleOfFriction) {
    for (const double mu : {0.05, 0.1, 0.3, 0.5}) {
        const Scene scene = test::box_scene(under_a_floor(mu, 1.0));
        State state(scene, 1);
        press(scene, state, 0.00005, 0.05);
        ToolFeedback f;
        for (int i = 0; i < 350; ++i) frame(scene, state, upright(Vec3(1e-6 * i, 0, -5e-5)), f);
        // 0.3 degrees is what a surgeon's hand cannot tell; measured 0.001.
        EXPECT_NEAR(angle_deg(f), std::atan(mu) * 180 / M_PI, 0.3) << "mu " << mu;
    }
}

TEST(Contact, AFloorThatHasSlidTurnsItsFrictionWhenItTurns) {
    const double mu = 0.3, full = std::atan(mu) * 180 / M_PI;
    const Scene scene = test::box_scene(under_a_floor(mu, 1.0));
    State state(scene, 1);
    press(scene, state, 0.00005, 0.05);
    ToolFeedback f;
    for (int i = 0; i < 350; ++i) frame(scene, state, upright(Vec3(1e-6 * i, 0, -5e-5)), f);
    ASSERT_NEAR(angle_deg(f), full, 0.3);
    // Twice the shear of the slab lies between the cones: what slid does not remember
    // where it once stuck.
    for (int i = 350; i > 150; --i) frame(scene, state, upright(Vec3(1e-6 * i, 0, -5e-5)), f);
    EXPECT_NEAR(angle_deg(f), -full, 1);
}

TEST(Contact, AFloorSticksJustBelowTheAngleOfFriction) {
    const double mu = 0.3, stop = std::atan(mu) * 180 / M_PI - 0.3;
    const Scene scene = test::box_scene(under_a_floor(mu, 1.0));
    State state(scene, 1);
    press(scene, state, 0.00005, 0.05);
    ToolFeedback f;
    double x = 0;
    // Slowly sideways until the force leans by 0.3 degrees less than the cone.
    for (int i = 0; i < 800 && angle_deg(f) < stop; ++i) {
        x += 2e-7;
        frame(scene, state, upright(Vec3(x, 0, -5e-5)), f);
    }
    // A hand at rest relaxes a little: come back up in steps small enough to stay settled.
    for (int i = 0; i < 200; ++i) {
        f = hold(scene, state, Vec3(x, 0, -5e-5), 0.01);
        if (angle_deg(f) > stop) break;
        x += 2e-7;
    }
    ASSERT_NEAR(angle_deg(f), stop, 0.1);
    const ToolFeedback early = hold(scene, state, Vec3(x, 0, -5e-5), 0.1);
    const ToolFeedback late = hold(scene, state, Vec3(x, 0, -5e-5), 0.9);
    // The slab answers with some 0.13 N/mm: a drift of 1 um would take 0.13 mN of 10 mN away.
    EXPECT_NEAR(late.force_n.x(), early.force_n.x(), 0.01 * std::abs(early.force_n.x()));
    EXPECT_NEAR(angle_deg(late), angle_deg(early), 0.05);
}

TEST(Contact, StaticFrictionHoldsLongerThanDynamic) {
    int slipping[2];
    for (const double ratio : {1.0, 1.5}) {
        BoxOptions options = under_a_floor(0.2, ratio);
        options.material.poissons_ratio = 0;  // no sideways shear from pressing alone
        const Scene scene = test::box_scene(options);
        State state(scene, 1);
        press(scene, state, 0.00005, 0.05);
        ToolFeedback f;
        double x = 0;
        for (int i = 0; i < 600 && angle_deg(f) < std::atan(0.16) * 180 / M_PI; ++i) {
            frame(scene, state, upright(Vec3(x += 2e-7, 0, -5e-5)), f);
        }
        int& count = slipping[ratio > 1];
        count = 0;
        for (const FrictionAnchor& anchor : state.friction) count += anchor.slipping != 0;
        for (int i = 0; i < 300; ++i) frame(scene, state, upright(Vec3(x += 1e-6, 0, -5e-5)), f);
        EXPECT_NEAR(angle_deg(f), std::atan(0.2) * 180 / M_PI, 0.3) << ratio;
    }
    // At 0.8 of the dynamic cone the rim of the slab, which carries more shear, has begun to slip;
    // a static cone 1.5 times as wide still holds all of it.
    EXPECT_GT(slipping[0], 5);
    EXPECT_EQ(slipping[1], 0);
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

/// Block of 12 x 12 x 12 mm whose triangles have edges of 0.1 mm within 0.6 mm of the origin, and
/// grow by 1.35 from layer to layer outside.
BoxOptions fine_patch() {
    constexpr int kFine = 6, kBeside = 10, kBelow = 13;
    BoxOptions options;
    options.material = skin();
    options.heat = false;
    options.tool = stiff_probe();
    // Lattice steps of 1 m are only numbers of planes here.
    options.size_m = Vec3(2 * (kFine + kBeside), 2 * (kFine + kBeside), kFine + kBelow);
    options.cells = {2 * (kFine + kBeside), 2 * (kFine + kBeside), kFine + kBelow};
    options.graded = [](int axis, double x) {
        const double reach = axis == 2 ? 0.012 : 0.006, n = std::abs(x);
        if (n <= kFine) return 1e-4 * x;
        double outer = 0, all = 0;
        for (int i = 1; i <= (axis == 2 ? kBelow : kBeside); ++i) {
            all += std::pow(1.35, i);
            if (i <= n - kFine + 0.5) outer += std::pow(1.35, i);
        }
        return std::copysign(6e-4 + (reach - 6e-4) * outer / all, x);
    };
    return options;
}

TEST(Contact, ASphereOnAFineMeshPressesWithTheForceOfHertz) {
    const Scene scene = test::box_scene(fine_patch());
    State state(scene, 1);
    const double radius = 0.0015, depth = 0.0001;
    double low = 1e9, high = 0;
    press(scene, state, depth, 0.2);
    for (int i = 0; i < 20; ++i) {
        const ToolFeedback f = hold(scene, state, Vec3(0, 0, -depth), 0.002);
        low = std::min(low, f.force_n.z());
        high = std::max(high, f.force_n.z());
    }
    const double hertz =
        4.0 / 3 * 60000 / (1 - 0.45 * 0.45) * std::sqrt(radius) * std::pow(depth, 1.5);
    // Linear tets are too stiff: contact radius over edge 1.3 / 1.9 / 3.9 / 5.5 gives +44, +20, +8
    // and +5 % (the held bottom at 12 mm is 2 to 4 of them). Here the ratio is 3.9.
    EXPECT_NEAR(high, hertz, 0.1 * hertz);
    // A patch of 250 vertices does not tremble: it used to show 20 times the force.
    EXPECT_LT(high - low, 0.02 * hertz);
}

TEST(Contact, ActionEqualsReaction) {
    BoxOptions options;
    options.material = skin();
    options.material.friction = 0.3;
    options.heat = false;
    options.size_m = Vec3(0.004, 0.004, 0.002);
    options.cells = {8, 8, 4};
    options.tool = stiff_probe();
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    press(scene, state, 0.0001, 0.1);
    const ToolFeedback f = hold(scene, state, Vec3(0.00002, 0, -0.0001), 2.0);
    Vec3 carried = Vec3::Zero();
    for (int v = 0; v < scene.body.vertex_count(); ++v) {
        if (state.body.x[v].w > 0) carried += elastic_force(scene.body, state.body, v);
    }
    // At rest, what the elements carry is what the tool feels. Positions are floats of some mm: one
    // unit in the last place (2e-10 m) on vertices of 1e3 N/m is 2e-7 N, or 1e-5 of this force.
    EXPECT_GT(f.force_n.norm(), 0.001);
    EXPECT_LT((carried - f.force_n).norm(), 1e-4 * f.force_n.norm());
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
    // Courant number 0.16: the XPBD block itself is too soft by some 2 % there.
    EXPECT_NEAR(force[1], force[0], 0.05 * force[0]);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
