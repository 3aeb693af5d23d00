// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How a patch moves as a whole, against closed forms; when it sleeps; how it meets itself.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sim/contact/patch_contact.h"
#include "sim/contact/patch_modes.h"
#include "sim/core/event.h"
#include "tests/patch_pad.h"

namespace placode::sim {
namespace THIS_TEST {

using test::Lying;

constexpr double kG = 9.81;

/// A patch of 8 x 6 mm over a flat pad that gravity pulls at by an angle of `degrees` from its
/// normal, towards +x. Without damping.
OperativeFieldSpec slope(double degrees) {
    OperativeFieldSpec spec = test::patch_pad();
    const double a = degrees * 3.14159265358979 / 180;
    spec.solver.gravity_m_s2 = kG * Vec3(std::sin(a), 0, -std::cos(a));
    spec.patch->material.damping_per_s = 0;
    return spec;
}

// Implicit Euler makes g h^2 n (n + 1) / 2 of g t^2 / 2: 0.5 % more after 200 substeps.
TEST(PatchModes, FallsFreely) {
    OperativeFieldSpec spec = slope(0);
    spec.patch->height_m = 0.02;
    Lying run(spec);
    const double before = run.middle().z();
    run.frames(50);
    const double fallen = before - run.middle().z(), t = 0.050;
    RecordProperty("fallen_um", static_cast<int>(1e6 * fallen));
    EXPECT_NEAR(fallen, kG * t * t / 2 * (1 + 1.0 / 200), 0.001 * fallen);
}

// From its velocity at one time and what gravity and friction make of it. Patch and tissue are
// elastic and its edges curl by micrometres: hence a tolerance of 2 %.
TEST(PatchModes, SlidesDownASlopeAsCoulombSays) {
    for (const double degrees : {20.0, 25.0, 35.0}) {
        OperativeFieldSpec spec = slope(degrees);
        spec.patch->centre_m = Vec2(-0.003, 0);
        Lying run(spec);
        run.frames(30);
        const double x0 = run.middle().x(), v0 = run.speed().x();
        constexpr double kT = 0.050;
        run.frames(50);
        const double slid = run.middle().x() - x0, a = degrees * 3.14159265358979 / 180;
        const double wanted = v0 * kT + kG * (std::sin(a) - 0.3 * std::cos(a)) * kT * kT / 2;
        RecordProperty("off_ppm_" + std::to_string(static_cast<int>(degrees)),
                       static_cast<int>(1e6 * (slid / wanted - 1)));
        EXPECT_NEAR(slid, wanted, 0.02 * wanted) << degrees << " degrees";
        EXPECT_GT(wanted, 0.0005);
    }
}

// With the fluid's damping c: a / c^2 (c t - 1 + exp(-c t)) from rest, in the air.
TEST(PatchModes, FallsThroughFluidAsItsDampingSays) {
    OperativeFieldSpec spec = slope(0);
    spec.patch->height_m = 0.02;
    spec.patch->material.damping_per_s = 20;
    Lying run(spec);
    const double before = run.middle().z(), c = 20, t = 0.060;
    run.frames(60);
    const double fallen = before - run.middle().z();
    const double wanted = kG / (c * c) * (c * t - 1 + std::exp(-c * t));
    // First order in the substep: h / t = 0.4 % late and h c = 0.5 % before it is damped.
    EXPECT_NEAR(fallen, wanted, 0.01 * wanted);
}

// About its normal, about an axis in its plane and about one between them: a free body that is
// stiff keeps its spin about a principal axis, and its angular momentum about any.
TEST(PatchModes, SpinsFreely) {
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
        OperativeFieldSpec spec = test::patch_pad();
        spec.solver.gravity_m_s2 = Vec3::Zero();
        spec.patch->material.damping_per_s = 0;
        spec.patch->bending = 1;
        spec.patch->height_m = 0.01;
        Lying run(spec);
        const Vec3 centre = run.middle();
        constexpr double kSpin = 10;  // rad/s
        for (int i = 0; i < run.patch().vertex_count; ++i) {
            const Vec3 v = kSpin * axis.cross(run.at(i) - centre);
            Float4& to = run.state.body.v[static_cast<size_t>(run.patch().first_vertex + i)];
            to = {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
                  0};
        }
        const std::vector<Vec3> before = run.places();
        run.frames(157);
        double turned = 0, weight = 0;
        for (int i = 0; i < run.patch().vertex_count; ++i) {
            Vec3 from = before[static_cast<size_t>(i)] - centre, to = run.at(i) - run.middle();
            from -= axis * axis.dot(from);
            to -= axis * axis.dot(to);
            const double w = from.squaredNorm();
            if (w < 1e-8) continue;
            turned += w * std::atan2(axis.dot(from.cross(to)), from.dot(to));
            weight += w;
        }
        turned /= weight;
        RecordProperty("turned_mrad_" + std::to_string(static_cast<int>(axis.x() + 2 * axis.y())),
                       static_cast<int>(1e3 * turned));
        EXPECT_NEAR(turned, 1.57, 0.01 * 1.57) << axis.transpose();
        EXPECT_LT((run.middle() - centre).norm(), 1e-5);
    }
}

TEST(PatchModes, SleepsWithTheTissueBelowAndWakesWhenItIsTouched) {
    Lying run(test::patch_pad());
    run.frames(4000);
    ASSERT_TRUE(patch_sleeps(*run.scene, run.state));
    const std::vector<Vec3> before = run.places();
    run.frames(500);
    EXPECT_EQ(run.farthest(before), 0);
    // The grasper comes down beside its middle and presses on it.
    run.go(Vec3(0.001, 0, 0.003), 0.6, 200);
    run.go(Vec3(0.001, 0, -0.0003), 0.6, 200);
    EXPECT_FALSE(patch_sleeps(*run.scene, run.state));
    EXPECT_GT(run.farthest(before), 1e-4);
    run.go(Vec3(0.001, 0, 0.01), 0.6, 200);
    run.frames(4000);
    EXPECT_TRUE(patch_sleeps(*run.scene, run.state));
    EXPECT_LT(run.overlap(), 4e-6);
}

TEST(PatchModes, WakesWithTheTissueBelow) {
    Lying run(test::patch_pad());
    run.frames(4000);
    ASSERT_TRUE(patch_sleeps(*run.scene, run.state));
    const int32_t tet = run.state.patch.touch[0].tet;
    ASSERT_GE(tet, 0);
    rouse(run.state.body, corners(run.scene->body, run.state.body, tet)[0]);
    run.frames(1);
    EXPECT_FALSE(patch_sleeps(*run.scene, run.state));
}

/// Folded over on itself, a column of triangles upright in the bend, so that no edge changes its
/// length; above the pad.
void fold(Lying& run) {
    for (int i = 0; i < run.patch().vertex_count; ++i) {
        const auto v = static_cast<size_t>(run.patch().first_vertex + i);
        Float4& x = run.state.body.x[v];
        if (x.x > -0.0005F) x.z += 0.001F;
        if (x.x > -0.0005F) x.x = -0.001F - x.x;
        run.state.body.x_start[v] = x;
    }
}

/// Between a vertex and what is no neighbour of it at rest: the least distance [m].
double least_between_layers(const Lying& run) {
    const auto& rest = run.scene->body.mesh().rest;
    double least = 1;
    for (int i = 0; i < run.patch().vertex_count; ++i) {
        const Vec3 p = run.at(i), p_rest = rest[static_cast<size_t>(run.patch().first_vertex + i)];
        for (const SurfaceTriangle& t : run.patch().triangles) {
            Triangle x;
            Vec3 middle = Vec3::Zero();
            for (size_t k = 0; k < 3; ++k) {
                x[k] = position(run.state.body, t.vertex[k]);
                middle += rest[static_cast<size_t>(t.vertex[k])] / 3;
            }
            if ((middle - p_rest).norm() < 0.003) continue;
            const Vec3 w = closest_on_triangle(p, x);
            least = std::min(least, (p - w.x() * x[0] - w.y() * x[1] - w.z() * x[2]).norm());
        }
    }
    return least;
}

OperativeFieldSpec limp() {
    OperativeFieldSpec spec = test::patch_pad();
    spec.patch->bending = 0.0002;  // its weight keeps it folded
    spec.tools[0] = {};
    spec.tools[0].kind = ToolKind::kProbe;
    spec.tools[0].tip_radius_m = 0.001;
    spec.tools[0].tip_length_m = 0.0025;
    return spec;
}

// By its own weight, and under a probe that presses both layers into the tissue.
TEST(PatchModes, FoldedItKeepsItsThicknessApart) {
    Lying run(limp());
    fold(run);
    run.frames(2000);
    RecordProperty("apart_nm", static_cast<int>(1e9 * least_between_layers(run)));
    EXPECT_GT(least_between_layers(run), 0.9 * run.patch().thickness_m) << "at rest";
    EXPECT_GT(run.highest(), 1.4 * run.patch().thickness_m) << "one layer on the other";
    run.go(Vec3(-0.002, 0, 0.004), 0, 100);
    run.go(Vec3(-0.002, 0, 0), 0, 300);
    double least = 1;
    for (int i = 0; i < 20; ++i) {
        run.frames(20);
        least = std::min(least, least_between_layers(run));
    }
    EXPECT_GT(run.state.tools[0].force_n.norm(), 0.002);
    RecordProperty("pressed_nm", static_cast<int>(1e9 * least));
    EXPECT_GT(least, 0.5 * run.patch().thickness_m) << "pressed";
    EXPECT_EQ(run.state.body.flags & kNotFinite, 0U);
}

TEST(PatchModes, FoldedAndSlidingItHasTheSameBitsOnOneTwoAndThreeThreads) {
    std::array<uint64_t, 3> hash{};
    for (int threads = 1; threads <= 3; ++threads) {
        OperativeFieldSpec spec = limp();
        spec.solver.gravity_m_s2 = kG * Vec3(0.4, 0.1, -0.9);
        Lying run(spec, threads);
        fold(run);
        run.go(Vec3(-0.002, 0, 0.004), 0, 100);
        run.go(Vec3(-0.002, 0, 0.0002), 0, 200);
        hash[static_cast<size_t>(threads - 1)] = state_hash(run.state);
    }
    EXPECT_EQ(hash[0], hash[1]);
    EXPECT_EQ(hash[0], hash[2]);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
