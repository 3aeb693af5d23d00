// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pull of a thread through a channel, against the rope on a drum.
#include "sim/suture/capstan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace placode::sim {
namespace THIS_TEST {

constexpr double kPi = std::numbers::pi;

/// Passages every 0.3 mm on a circle of 1.2 mm, `turns` of it, with straight thread before and
/// behind: bends are found from the chords, as in a channel.
std::vector<ChannelPiece> drum(double turns) {
    const double radius = 1.2e-3, whole = 2 * kPi * turns;
    const int n = static_cast<int>(std::ceil(whole * radius / 0.3e-3));
    const auto place = [&](int i) {
        const double a = whole * i / n;
        return Vec3(radius * std::cos(a), radius * std::sin(a), 0.005e-3 * i);
    };
    std::vector<ChannelPiece> pieces;
    Vec3 before(0, 1, 0);  // the tangents at the ends
    for (int i = 0; i < n; ++i) {
        const Vec3 offset = place(i + 1) - place(i);
        pieces.push_back({angle_between(before, offset), offset.norm()});
        before = offset;
    }
    const Vec3 behind(-std::sin(whole), std::cos(whole), 0);
    pieces.push_back({angle_between(before, behind), 0});
    return pieces;
}

ThreadFriction smooth(double friction, double drag_n_m = 0, double barb_n_m = 0) {
    return {friction, drag_n_m, barb_n_m};
}

TEST(Capstan, ExponentialAndAngleAreThoseOfTheLibrary) {
    for (double x = -6; x <= 6; x += 0.37) EXPECT_NEAR(exponential(x) / std::exp(x), 1, 1e-13) << x;
    for (int i = 0; i <= 200; ++i) {
        const double a = kPi * i / 200;
        const Vec3 u = 3e-4 * Vec3(0.36, 0.48, 0.8), v = u.cross(Vec3(0.2, -0.7, 0.4));
        const Vec3 w = std::cos(a) * u.normalized() + std::sin(a) * v.normalized();
        EXPECT_NEAR(angle_between(u, w), a, 1e-14) << i;
    }
    EXPECT_EQ(angle_between(Vec3::Zero(), Vec3::UnitX()), 0);
}

// e^(mu phi) from half a turn to three. The thread climbs by 5 um a passage, so that its turns lie
// side by side; 3 % is what a bite's passages may be off.
TEST(Capstan, PullGrowsAsOnADrum) {
    for (const double friction : {0.1, 0.15, 0.2, 0.3}) {
        for (const double turns : {0.5, 1.0, 2.0, 3.0}) {
            const auto pieces = drum(turns);
            const double exact = std::exp(friction * 2 * kPi * turns);
            const CapstanLaw law = capstan_law(smooth(friction), pieces, true);
            EXPECT_NEAR(law.gain / exact, 1, 0.03) << friction << ' ' << turns;
            EXPECT_EQ(law.drag_n, 0);
            // Alike in both ways, as it has no barbs.
            EXPECT_NEAR(capstan_law(smooth(friction), pieces, false).gain / law.gain, 1, 1e-12);
        }
    }
    // The table of a bite of half a circle: 1.37, 1.60, 1.87, 2.57.
    EXPECT_NEAR(capstan_law(smooth(0.15), drum(0.5), true).gain, 1.60, 0.03 * 1.60);
}

// On a drum with drag t per length: T_out = T_in g + t L (g - 1) / (mu phi). The passages are
// pieces: their sum is off by half of a piece's bend.
TEST(Capstan, DragAddsToItAsTheIntegralSays) {
    const auto pieces = drum(1);
    double bend = 0, length = 0;
    for (const ChannelPiece& p : pieces) {
        bend += p.bend_rad;
        length += p.length_m;
    }
    const double mu = 0.2, drag = 30;
    const CapstanLaw law = capstan_law(smooth(mu, drag), pieces, true);
    const double exact = drag * length * (std::exp(mu * bend) - 1) / (mu * bend);
    EXPECT_NEAR(law.drag_n / exact, 1, 0.03);
}

// By hand: uneven pieces, so that the order in which bends and walls come shows. A piece is a bend
// and then its wall; on the way back the wall of the last one comes first.
TEST(Capstan, BendsAndWallsComeInTheirOrderEitherWay) {
    const std::vector<ChannelPiece> pieces{{0.5, 1e-3}, {1.1, 3e-3}};
    const double mu = 0.2, drag = 30, pull = 0.1;
    const double g1 = std::exp(mu * 0.5), g2 = std::exp(mu * 1.1), w1 = drag * 1e-3, w2 = 3 * w1;
    const CapstanLaw out = capstan_law(smooth(mu, drag), pieces, true);
    EXPECT_NEAR(out.gain * pull + out.drag_n, (pull * g1 + w1) * g2 + w2, 1e-13);
    const CapstanLaw back = capstan_law(smooth(mu, drag), pieces, false);
    EXPECT_NEAR(back.gain * pull + back.drag_n, ((pull + w2) * g2 + w1) * g1, 1e-13);
}

TEST(Capstan, ThreadSticksBetweenTheBoundsAndSlidesToThem) {
    const auto pieces = drum(0.5);
    const ThreadFriction friction = smooth(0.15, 20);
    const CapstanLaw out = capstan_law(friction, pieces, true),
                     back = capstan_law(friction, pieces, false);
    const double in_n_m = 400, out_n_m = 900;
    for (double out_n = 0; out_n < 1; out_n += 0.013) {
        const double in_n = 0.2;
        const ThreadSlide s = slide_thread(out, back, in_n, out_n, in_n_m, out_n_m);
        const double high = out.gain * in_n + out.drag_n, low = (in_n - back.drag_n) / back.gain;
        if (out_n > high) {
            EXPECT_GT(s.slid_m, 0);
            EXPECT_NEAR(s.out_n, out.gain * s.in_n + out.drag_n, 1e-12);
        } else if (out_n < low) {
            EXPECT_LT(s.slid_m, 0);
            EXPECT_NEAR(s.in_n, back.gain * s.out_n + back.drag_n, 1e-12);
        } else {
            EXPECT_EQ(s.slid_m, 0);
            EXPECT_EQ(s.out_n, out_n);
        }
        EXPECT_GE(s.lost_j, 0);
        // Springs at the ends: energy before = energy after + what the wall took.
        const double before = in_n * in_n / in_n_m + out_n * out_n / out_n_m;
        const double after = s.in_n * s.in_n / in_n_m + s.out_n * s.out_n / out_n_m;
        EXPECT_NEAR((before - after) / 2, s.lost_j, 1e-15);
    }
}

TEST(Capstan, BarbsCloseTheWayBack) {
    const auto pieces = drum(0.5);
    const ThreadFriction barbed = smooth(0.15, 0, 200);  // 0.2 N a millimetre
    const CapstanLaw out = capstan_law(barbed, pieces, true),
                     back = capstan_law(barbed, pieces, false);
    EXPECT_EQ(out.drag_n, 0);
    EXPECT_GT(back.drag_n, 200 * 3.7e-3);
    EXPECT_EQ(slide_thread(out, back, 0.7, 0, 400, 400).slid_m, 0);
    EXPECT_LT(slide_thread(out, back, 2.0, 0, 400, 400).slid_m, 0);
    EXPECT_GT(slide_thread(out, back, 0.1, 0.7, 400, 400).slid_m, 0);
}

TEST(Capstan, PullAlongAChannelEndsWithThePullAtItsExit) {
    const auto pieces = drum(1);
    const ThreadFriction friction = smooth(0.2, 10);
    const CapstanLaw out = capstan_law(friction, pieces, true);
    std::vector<double> pull(pieces.size());
    for (const double out_n : {0.05, 0.1, 0.2, out.gain * 0.1 + out.drag_n}) {
        pull_along(friction, pieces, 0.1, out_n, pull);
        EXPECT_NEAR(pull.back(), out_n, 1e-12);
        // Nowhere does the wall take more than it can.
        double before = 0.1;
        for (size_t i = 0; i < pull.size(); ++i) {
            const std::span<const ChannelPiece> piece(&pieces[i], 1);
            const CapstanLaw on = capstan_law(friction, piece, true),
                             off = capstan_law(friction, piece, false);
            EXPECT_LE(pull[i], on.gain * before + on.drag_n + 1e-12) << i;
            EXPECT_LE(before, off.gain * pull[i] + off.drag_n + 1e-12) << i;
            before = pull[i];
        }
    }
}

TEST(Capstan, WhatCannotBeIsRefused) {
    EXPECT_NO_THROW(check(ThreadFriction{}));
    EXPECT_THROW(check(smooth(-0.1)), SutureError);
    EXPECT_THROW(check(smooth(0.1, -1)), SutureError);
    EXPECT_THROW(check(smooth(0.1, 0, std::nan(""))), SutureError);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
