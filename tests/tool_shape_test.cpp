// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to instruments against brute force: a round cone is a union of spheres by definition.

#include "sim/core/tool_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace placode::sim {
namespace THIS_TEST {

ToolSpec needle() { return {}; }

/// Smallest distance to 20,001 spheres of the part: within 1e-9 m of the true one outside, because
/// the error is quadratic in the spacing of the spheres.
double brute_distance(const RoundCone& part, const Vec3& p) {
    double best = 1e9;
    const int n = 20000;
    for (int i = 0; i <= n; ++i) {
        const double s = static_cast<double>(i) / n;
        const double at = part.near_m + s * (part.far_m - part.near_m);
        const double r = part.near_radius_m + s * (part.far_radius_m - part.near_radius_m);
        best = std::min(best, (p - Vec3(0, 0, -at)).norm() - r);
    }
    return best;
}

TEST(ToolShape, DistanceIsThatOfTheUnionOfSpheres) {
    const RoundCone cone{0.0025, 0.0045, 0.00025, 0.0015};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(-0.004, 0.004);
    int outside = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 p(u(random), u(random), -0.0035 + u(random));
        const double expected = brute_distance(cone, p);
        if (expected <= 0) continue;
        ++outside;
        // 0.1 um spacing of spheres, nearest approach off by its square over the distance: < 1e-8.
        EXPECT_NEAR(signed_distance(cone, p).value_m, expected, 1e-8);
    }
    EXPECT_GT(outside, 150);
}

TEST(ToolShape, GradientIsTheDerivativeOfTheDistance) {
    const ToolShape shape = make_tool_shape(needle());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> u(-0.003, 0.003);
    const double e = 1e-7;
    for (int i = 0; i < 500; ++i) {
        const Vec3 p(u(random), u(random), -0.002 + u(random));
        const Distance d = signed_distance(shape, p);
        EXPECT_EQ(distance_value(shape, p), d.value_m);
        EXPECT_NEAR(d.gradient.norm(), 1, 1e-12);
        if (d.value_m < 1e-4) continue;  // kinks lie inside and on the seams
        Vec3 numeric;
        for (int k = 0; k < 3; ++k) {
            const Vec3 step = e * Vec3::Unit(k);
            numeric[k] = (signed_distance(shape, p + step).value_m -
                          signed_distance(shape, p - step).value_m) /
                         (2 * e);
        }
        // Central difference: error e^2 f'''/6, with f''' of the order 1/d^2 = 1e8: below 1e-5.
        EXPECT_LT((numeric - d.gradient).norm(), 1e-4) << p.transpose();
    }
}

TEST(ToolShape, TipIsTheOriginAndTheShaftLiesBehindIt) {
    const ToolShape shape = make_tool_shape(needle());
    EXPECT_NEAR(signed_distance(shape, Vec3::Zero()).value_m, 0, 1e-15);
    EXPECT_NEAR(signed_distance(shape, Vec3(0, 0, 0.001)).value_m, 0.001, 1e-15);
    EXPECT_NEAR(signed_distance(shape, Vec3(0, 0.002, -0.05)).value_m, 0.0005, 1e-15);
    EXPECT_NEAR(signed_distance(shape, Vec3(0.00025, 0, -0.001)).value_m, 0, 1e-15);
    EXPECT_LT(signed_distance(shape, Vec3(0, 0, -0.1)).value_m, -0.0014);
}

TEST(ToolShape, NearestPointOfATriangleBeatsEverySampleOfIt) {
    const ToolShape shape = make_tool_shape(needle());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-0.0012, 0.0012);
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec3 centre(2 * u(random), 2 * u(random), -0.002 + 3 * u(random));
        Triangle tri;
        for (Vec3& x : tri) x = centre + Vec3(u(random), u(random), u(random)) * 0.5;
        const TriangleDistance found = nearest_on_triangle(shape, tri, 1);
        ASSERT_GE(found.part, 0);
        EXPECT_NEAR(found.weight.sum(), 1, 1e-9);
        EXPECT_GE(found.weight.minCoeff(), -1e-9);
        if (found.pierced || found.value_m < 0) continue;
        double best = 1;
        const int n = 60;
        for (int a = 0; a <= n; ++a) {
            for (int b = 0; b <= n - a; ++b) {
                const Vec3 x = (a * tri[0] + b * tri[1] + (n - a - b) * tri[2]) / n;
                best = std::min(best, signed_distance(shape, x).value_m);
            }
        }
        ++compared;
        // Samples can only be farther; 2 um is what eight turns may leave on the shoulder's cone.
        EXPECT_LE(found.value_m, best + 2e-6);
        const Vec3 at =
            found.weight.x() * tri[0] + found.weight.y() * tri[1] + found.weight.z() * tri[2];
        EXPECT_NEAR(signed_distance(shape, at).value_m, found.value_m, 1e-9);
    }
    EXPECT_GT(compared, 150);
}

TEST(ToolShape, ATriangleWithoutASideIsASegment) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), p(0.5, 0, 1);
    for (const Triangle& t : {Triangle{a, a, b}, Triangle{a, b, a}, Triangle{b, a, a},
                              Triangle{a, b, b}, Triangle{b, a, b}, Triangle{b, b, a}}) {
        const Vec3 w = closest_on_triangle(p, t);
        EXPECT_NEAR((w.x() * t[0] + w.y() * t[1] + w.z() * t[2] - p).norm(), 1, 1e-12);
    }
    const Vec3 w = closest_on_triangle(p, Triangle{a, a, a});
    EXPECT_NEAR(w.sum(), 1, 1e-12);
}

TEST(ToolShape, AThinTipIsFoundInTheMiddleOfALargeTriangle) {
    const ToolShape shape = make_tool_shape(needle());
    // Corners 5 mm away, the tip 0.05 mm above the middle: no vertex is anywhere near.
    const Triangle tri{Vec3(0.005, 0, 0.00005), Vec3(-0.003, 0.004, 0.00005),
                       Vec3(-0.003, -0.004, 0.00005)};
    const TriangleDistance found = nearest_on_triangle(shape, tri, 0.0002);
    ASSERT_EQ(found.part, 0);
    EXPECT_NEAR(found.value_m, 0.00005, 1e-12);
    EXPECT_NEAR(found.gradient.z(), 1, 1e-12);
}

TEST(ToolShape, ANeedleThroughATriangleIsReportedAsPiercing) {
    const ToolShape shape = make_tool_shape(needle());
    const Triangle tri{Vec3(0.001, 0, -0.001), Vec3(-0.001, 0.001, -0.001),
                       Vec3(-0.001, -0.001, -0.001)};
    const TriangleDistance found = nearest_on_triangle(shape, tri, 0.0002);
    EXPECT_TRUE(found.pierced);
    EXPECT_LT(found.value_m, 0);
}

ToolShape spread_grasper(double jaw_rad) {
    ToolSpec spec;
    spec.kind = ToolKind::kGrasper;
    spec.shaft_radius_m = 0.001;
    spec.tip_radius_m = 0.0006;
    spec.tip_length_m = 0.012;
    ToolShape shape = make_tool_shape(spec);
    shape.spread_jaws(jaw_rad);
    return shape;
}

/// Jaws that stand apart are two capsules from the hinge, each turned by half of the angle.
TEST(ToolShape, SpreadJawsAreTwoTurnedCapsules) {
    const double half = 0.3;
    const ToolShape shape = spread_grasper(2 * half);
    ASSERT_TRUE(shape.spread());
    const Vec3 hinge(0, 0, -0.012);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-0.006, 0.006);
    for (int i = 0; i < 400; ++i) {
        const Vec3 p(u(random), u(random), -0.004 + u(random));
        double expected = 1;
        for (const double side : {1.0, -1.0}) {
            const Vec3 offset(0, side * std::sin(half), std::cos(half));
            const double along = std::clamp((p - hinge).dot(offset), 0.0, 0.012 - 0.0006);
            expected = std::min(expected, (p - hinge - along * offset).norm() - 0.0006);
        }
        for (int part = 1; part < shape.count; ++part)
            expected = std::min(expected, signed_distance(shape.parts[part], p).value_m);
        const Distance d = signed_distance(shape, p);
        EXPECT_NEAR(d.value_m, expected, 1e-8);
        EXPECT_EQ(distance_value(shape, p), d.value_m);
        EXPECT_NEAR(d.gradient.norm(), 1, 1e-9);
        if (d.value_m < 1e-4 || std::abs(p.y()) < 1e-4) continue;
        const double e = 1e-7;
        EXPECT_NEAR(signed_distance(shape, p + e * d.gradient).value_m, d.value_m + e, 1e-10);
    }
}

TEST(ToolShape, ATriangleIsTouchedByTheNearerJawAndShutJawsAreAsEver) {
    const Triangle beside{Vec3(-0.001, 0.0045, -0.002), Vec3(0.001, 0.0045, -0.002),
                          Vec3(0, 0.0045, 0.002)};
    const TriangleDistance shut = nearest_on_triangle(spread_grasper(0), beside, 1);
    EXPECT_NEAR(shut.value_m, 0.0045 - 0.0006, 1e-9);
    // The tip's centre stands 11.4 mm from the hinge.
    const double half = 0.3, tip = 0.0114 * std::sin(half);
    const TriangleDistance open = nearest_on_triangle(spread_grasper(2 * half), beside, 1);
    EXPECT_NEAR(open.value_m, 0.0045 - tip - 0.0006, 1e-6);
    EXPECT_NEAR(open.gradient.y(), 1, 1e-3) << "away from the jaw, towards the triangle";
    Triangle other = beside;
    for (Vec3& x : other) x.y() = -x.y();
    EXPECT_NEAR(nearest_on_triangle(spread_grasper(2 * half), other, 1).value_m, open.value_m,
                1e-12);
    EXPECT_NEAR(nearest_on_triangle(spread_grasper(2 * half), other, 1).gradient.y(), -1, 1e-3);
    const ToolShape plain = make_tool_shape(needle());
    ToolShape closed = plain;
    closed.spread_jaws(0);
    EXPECT_FALSE(closed.spread());
    EXPECT_EQ(nearest_on_triangle(plain, beside, 1).value_m,
              nearest_on_triangle(closed, beside, 1).value_m);
}

TEST(ToolShape, TheScopeIsAPlainCapsule) {
    ToolSpec scope;
    scope.kind = ToolKind::kScope;
    scope.shaft_radius_m = 0.002;
    const ToolShape shape = make_tool_shape(scope);
    EXPECT_EQ(shape.count, 1);
    EXPECT_NEAR(signed_distance(shape, Vec3(0.003, 0, -0.01)).value_m, 0.001, 1e-15);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
