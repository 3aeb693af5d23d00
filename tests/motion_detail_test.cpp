// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/motion_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace placode::assessment {
namespace THIS_TEST {

constexpr double kPi = std::numbers::pi;

Quat turn(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); }

TEST(MotionDetail, RollIsTheTwistAboutTheShaftAlone) {
    std::vector<Quat> roll, tilt, both;
    for (int k = 0; k <= 100; ++k) {
        const double a = 0.01 * k;
        roll.push_back(turn(a, Vec3::UnitZ()));
        tilt.push_back(turn(a, Vec3::UnitX()));
        both.push_back(turn(a / 2, Vec3::UnitX()) * turn(2 * a, Vec3::UnitZ()));
    }
    EXPECT_NEAR(roll_path(roll), 1, 1e-12);
    EXPECT_NEAR(roll_path(tilt), 0, 1e-12);
    // Rolling by 0.02 rad in steps while tilting by 0.005: to second order the twist is the roll.
    EXPECT_NEAR(roll_path(both), 2, 1e-4);
}

TEST(MotionDetail, PitchAndYawAreChangesOfTheShaftsDirection) {
    std::vector<Quat> pitch, yaw;
    const Quat start = turn(0.7, Vec3(1, 2, 3).normalized());
    for (int k = 0; k <= 50; ++k) {
        const double a = 0.02 * (k <= 25 ? k : 50 - k);  // There and back: 0.5 each way.
        pitch.push_back(start * turn(a, Vec3::UnitX()));
        yaw.push_back(start * turn(a, Vec3::UnitY()));
    }
    EXPECT_NEAR(pivot_paths(pitch).pitch_rad, 1, 1e-12);
    EXPECT_NEAR(pivot_paths(pitch).yaw_rad, 0, 1e-12);
    EXPECT_NEAR(pivot_paths(yaw).yaw_rad, 1, 1e-12);
    EXPECT_NEAR(pivot_paths(yaw).pitch_rad, 0, 1e-12);
    EXPECT_EQ(pivot_paths({}).yaw_rad, 0);
}

/// Velocity of a minimum-jerk movement of length d in t seconds, 100 Hz.
std::vector<Vec3> minimum_jerk(double d, double t, double rate_hz = 100) {
    std::vector<Vec3> velocity;
    const int n = static_cast<int>(t * rate_hz);
    for (int k = 0; k <= n; ++k) {
        const double u = static_cast<double>(k) / n;
        velocity.emplace_back(30 * d / t * (u * u - 2 * u * u * u + u * u * u * u), 0, 0);
    }
    return velocity;
}

TEST(MotionDetail, NormalisedJerkOfAMinimumJerkMovementDependsOnNothing) {
    // Integral of jerk^2 = 720 d^2 / t^5, so the root of half of it: 18.9737. The jerk is greatest
    // at both ends, where differences are one-sided: 4 % too little with 100 samples, falling with
    // their number.
    for (const auto& [d, t] : {std::pair{100.0, 1.0}, {5.0, 1.0}, {100.0, 4.0}})
        EXPECT_NEAR(*normalised_jerk(minimum_jerk(d, t), 100), std::sqrt(360.0), 0.8)
            << d << ' ' << t;
    EXPECT_NEAR(*normalised_jerk(minimum_jerk(100, 1, 1000), 1000), std::sqrt(360.0), 0.08)
        << "ten times the rate, a tenth of the error";
    EXPECT_FALSE(normalised_jerk(std::vector<Vec3>(100, Vec3::Zero()), 100));
    EXPECT_FALSE(normalised_jerk(minimum_jerk(1, 0.03), 100)) << "too short";
}

TEST(MotionDetail, PeaksAreStrictMaximaAboveTheThreshold) {
    EXPECT_EQ(speed_peaks(std::vector<double>{0, 30, 0, 30, 30, 0, 10, 0, 50}, 20), 1);
    EXPECT_EQ(speed_peaks(std::vector<double>{0, 30, 10, 25, 0}, 20), 2);
    EXPECT_EQ(speed_peaks({}, 20), 0);
}

TEST(MotionDetail, AnActionLastsAndIsPrecededByRest) {
    const auto speed = [](std::vector<std::pair<int, double>> parts) {
        std::vector<double> all;
        for (const auto& [n, v] : parts) all.insert(all.end(), static_cast<size_t>(n), v);
        return all;
    };
    const auto count = [&](std::vector<std::pair<int, double>> parts) {
        return action_count(speed(std::move(parts)), 0.01, 50);
    };
    EXPECT_EQ(count({{50, 0}, {50, 100}, {50, 0}, {50, 100}, {50, 0}}), 2);
    EXPECT_EQ(count({{50, 0}, {15, 100}, {50, 0}}), 0) << "too short";
    EXPECT_EQ(count({{50, 0}, {50, 100}, {15, 0}, {50, 100}}), 1) << "a short stop is none";
    EXPECT_EQ(count({{50, 100}}), 1) << "moving from the start";
}

TEST(MotionDetail, TheBoxAroundAWay) {
    EXPECT_EQ(extent(std::vector<Vec3>{{1, 2, 3}, {4, 0, 3}}), Vec3(3, 2, 0));
    EXPECT_EQ(extent({}), Vec3::Zero());
}

/// A right-hand needle that moves at 10 mm/s, a left-hand grasper at 5 mm/s, 10 s; the needle
/// shakes with 0.1 mm at 10 Hz.
sim::Recording two_hands() {
    sim::Recording recording;
    recording.header.sample_s = 0.01;
    recording.header.tools.resize(2);
    recording.header.tools[0].kind = sim::ToolKind::kNeedle;
    recording.header.tools[1].kind = sim::ToolKind::kGrasper;
    recording.header.tools[1].hand = sim::Hand::kLeft;
    for (int k = 0; k <= 1000; ++k) {
        sim::Sample sample;
        sample.time_s = 0.01 * k;
        const double t = sample.time_s;
        sample.tools[0].tip_m = {static_cast<float>(0.01 * t),
                                 static_cast<float>(1e-4 * std::sin(2 * kPi * 10 * t)), 0};
        sample.tools[1].tip_m = {0, static_cast<float>(0.006 * t), 0};
        sample.tools[1].in_view = k >= 200 && k < 400 ? 0 : 1;
        recording.samples.push_back(sample);
    }
    recording.end.duration_s = 10;
    return recording;
}

TEST(MotionDetail, HandsTremorAndViewOfARecording) {
    const MetricSet m = compute_metrics(two_hands());
    // The way of the shaking needle is a little longer than its 100 mm.
    EXPECT_NEAR(*m.find("path_length_right_mm"), 100, 25);
    EXPECT_GT(*m.find("path_length_right_mm"), 100);
    EXPECT_NEAR(*m.find("path_length_left_mm"), 60, 0.1);
    EXPECT_NEAR(*m.find("bimanual_balance"),
                *m.find("path_length_left_mm") / *m.find("path_length_right_mm"), 1e-12);
    EXPECT_GT(*m.find("both_moving_percent"), 95);
    // A sine of amplitude 0.1 mm has RMS 0.0707; Welch's window spreads little of it out of the
    // band.
    EXPECT_NEAR(*m.find("tremor_rms_mm"), 0.1 / std::sqrt(2.0), 0.002);
    EXPECT_EQ(*m.find("out_of_view_count"), 1);
    EXPECT_NEAR(*m.find("out_of_view_percent"), 100 * 200.0 / 2002, 1e-9);
    EXPECT_EQ(*m.find("roll_path_deg"), 0);
}

TEST(MotionDetail, OneHandHasNoBalance) {
    sim::Recording recording = two_hands();
    recording.header.tools.resize(1);
    const MetricSet m = compute_metrics(recording);
    EXPECT_FALSE(m.find("bimanual_balance"));
    EXPECT_TRUE(m.find("economy_of_volume"));
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
