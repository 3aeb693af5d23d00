// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The needle's geometry against integrals and searches; specs that cannot be.
#include "sim/suture/needle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/refused_field.h"

namespace placode::sim {
namespace THIS_TEST {

using placode::test::refused;

constexpr double kPi = std::numbers::pi;

NeedleSpec of_arc(double arc_m) {
    NeedleSpec spec;
    spec.arc_m = arc_m;
    return spec;
}

TEST(Needle, IsAHalfCircleOfItsArc) {
    for (const double arc : {13e-3, 17e-3}) {
        const Needle needle(of_arc(arc));
        EXPECT_DOUBLE_EQ(needle.radius_m() * kPi, arc);
        EXPECT_LT((needle.at(0).place_m - needle.tip_m()).norm(), 1e-17);
        EXPECT_LT((needle.at(arc).place_m + needle.tip_m()).norm(), 1e-17);
        EXPECT_LT((needle.at(arc / 2).place_m - Vec3(0, needle.radius_m(), 0)).norm(), 1e-17);
        // The needle goes where its point looks.
        EXPECT_LT((needle.at(0).back + Needle::forward()).norm(), 1e-15);
    }
}

TEST(Needle, TangentIsTheDerivativeOfThePlaceAndSpansSpaceWithTheNormalPlane) {
    const Needle needle(of_arc(17e-3));
    for (int i = 0; i <= 40; ++i) {
        const double s = needle.arc_m() * i / 40, d = 1e-7;
        const ArcPoint at = needle.at(s);
        const Vec3 slope = (needle.at(s + d).place_m - needle.at(s - d).place_m) / (2 * d);
        EXPECT_LT((slope - at.back).norm(), 1e-8);
        Mat3 frame;
        frame << at.radial, at.back, Vec3::UnitZ();
        EXPECT_LT((frame.transpose() * frame - Mat3::Identity()).norm(), 1e-14);
        EXPECT_GT(frame.determinant(), 0);
    }
}

// Places off the wire in the normal plane have the coordinate of its foot: to rounding, all around
// the circle, ahead of the point and behind the swage as well.
TEST(Needle, FootIsFoundInClosedForm) {
    const Needle needle(of_arc(13e-3));
    const double r = needle.radius_m();
    for (int i = -49; i <= 149; ++i) {
        const double s = needle.arc_m() * i / 100;
        for (const double radial : {-0.9 * r, -0.1e-3, 0.0, 0.3e-3, 2 * r}) {
            for (const double across : {-1e-3, 0.0, 0.4e-3}) {
                const ArcPoint at = needle.at(s);
                const ArcFoot foot =
                    needle.foot(at.place_m + radial * at.radial + across * Vec3::UnitZ());
                EXPECT_NEAR(foot.s_m, s, 1e-15) << i;
                EXPECT_NEAR(foot.radial_m, radial, 1e-17);
                EXPECT_EQ(foot.across_m, across);
                EXPECT_LT((foot.back - at.back).norm(), 1e-12);
                EXPECT_LT((foot.radial - at.radial).norm(), 1e-12);
            }
        }
    }
}

TEST(Needle, FootFromAPlaceNearByIsTheSame) {
    const Needle needle{NeedleSpec{}};
    for (int i = 0; i <= 300; ++i) {
        const double from = needle.arc_m() * i / 300;
        // Up to 0.2 radians away: beyond 0.1 it is found anew.
        for (int k = -20; k <= 20; ++k) {
            const ArcPoint at = needle.at(from + 0.01 * k * needle.radius_m());
            const Vec3 p = at.place_m + 0.2e-3 * at.radial + 0.1e-3 * Vec3::UnitZ();
            const ArcFoot exact = needle.foot(p);
            const ArcFoot near = needle.foot_near(p, needle.at(from).radial, from);
            EXPECT_NEAR(near.s_m, exact.s_m, 2e-15) << i << ' ' << k;
            EXPECT_EQ(near.radial_m, exact.radial_m);
            EXPECT_EQ(near.back, exact.back);
        }
        EXPECT_EQ(needle.foot_near(needle.at(from).place_m, Vec3::Zero(), 0).s_m,
                  needle.foot(needle.at(from).place_m).s_m);
    }
}

TEST(Needle, TheFootIsTheNearestOfManyPlaces) {
    const Needle needle(of_arc(17e-3));
    for (int i = 0; i < 400; ++i) {
        // A lattice without symmetry, 12 mm around the centre.
        const Vec3 p(12e-3 * std::sin(1.7 * i), 12e-3 * std::sin(2.3 * i + 1),
                     4e-3 * std::sin(3.1 * i + 2));
        const double s = std::clamp(needle.foot(p).s_m, 0.0, needle.arc_m()),
                     distance = (needle.at(s).place_m - p).norm();
        ASSERT_GE(s, 0);
        ASSERT_LE(s, needle.arc_m());
        for (int k = 0; k <= 500; ++k) {
            const double other = (needle.at(needle.arc_m() * k / 500).place_m - p).norm();
            ASSERT_LE(distance, other + 1e-12) << i;
        }
    }
}

TEST(Needle, PlacesWithoutANearestHaveOneAllTheSame) {
    const Needle needle(of_arc(17e-3));
    EXPECT_EQ(needle.foot(Vec3::Zero()).s_m, 0);
    const double opposite = needle.foot(Vec3(0, -needle.radius_m(), 0)).s_m;
    EXPECT_TRUE(std::isfinite(opposite));
    EXPECT_NEAR(std::abs(opposite - needle.arc_m() / 2), needle.arc_m(), 1e-9);
}

// Midpoints of 20,000 pieces of wire: their error falls with the square, 1e-8.
TEST(Needle, MassAndInertiaAreThoseOfItsPieces) {
    const Needle needle(of_arc(17e-3));
    constexpr int kPieces = 20000;
    const double dm = needle.mass_kg() / kPieces;
    Vec3 centre = Vec3::Zero(), inertia = Vec3::Zero();
    for (int i = 0; i < kPieces; ++i) {
        const Vec3 p = needle.at((i + 0.5) * needle.arc_m() / kPieces).place_m;
        centre += p / kPieces;
        const Vec3 d = p - needle.centre_m();
        inertia += dm * Vec3(d.y() * d.y() + d.z() * d.z(), d.x() * d.x() + d.z() * d.z(),
                             d.x() * d.x() + d.y() * d.y());
    }
    EXPECT_LT((centre - needle.centre_m()).norm(), 1e-10);
    EXPECT_LT((inertia - needle.inertia_kg_m2()).norm(), 1e-7 * inertia.norm());
    // Half circles of 13 to 17 mm weigh 13 to 17 mg.
    EXPECT_NEAR(needle.mass_kg(), 1.7e-5, 0.05e-5);
    EXPECT_NEAR(Needle(of_arc(13e-3)).mass_kg(), 1.3e-5, 0.05e-5);
}

TEST(Needle, WhatCannotBeIsRefusedByFieldValueAndRange) {
    EXPECT_EQ(refused([] { return Needle(of_arc(17e-3)); }), "taken");
    EXPECT_EQ(refused([] { return Needle(of_arc(4e-3)); }),
              "needle.arc_m|needle.arc_m: found 0.004; expected a number from 0.005 to 0.04");
    NeedleSpec thick;
    thick.arc_m = 6e-3;
    thick.wire_radius_m = 0.25e-3;
    EXPECT_EQ(refused([&] { return Needle(thick); }).rfind("needle.wire_radius_m|", 0), 0U);
    NeedleSpec nothing;
    nothing.density_kg_m3 = std::nan("");
    EXPECT_NE(refused([&] { return Needle(nothing); }).find("found nan"), std::string::npos);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
