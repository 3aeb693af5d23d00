// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/motion_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/reference_data.h"

namespace placode::assessment {
namespace THIS_TEST {

using namespace testing_data;

TEST(MotionMetrics, SmoothnessIsThatOfTheAuthorsCode) {
    const auto expected = json("motion/smoothness_expected.json")["signals"];
    int checked = 0;
    for (const auto& [name, values] : expected.items()) {
        const std::string file = values["file"];
        if (!std::ifstream(path(file))) continue;  // only the small signals were copied
        const auto columns = table(file);
        const std::vector<double> speed =
            column(file, columns.contains("speed") ? "speed" : "speed_mm_s");
        const double rate = values["fs_hz"];
        // 1e-9: the inputs are written with 17 digits; only the order of sums differs.
        EXPECT_NEAR(sparc(speed, rate).value(), values["sparc"].get<double>(), 1e-9) << name;
        EXPECT_NEAR(ldlj_speed(speed, rate).value(), values["ldlj"].get<double>(), 1e-9) << name;
        ++checked;
    }
    EXPECT_GE(checked, 10);
}

TEST(MotionMetrics, SmoothnessNeedsMovement) {
    const std::vector<double> still(100, 0.0);
    EXPECT_FALSE(sparc(still, 100));
    EXPECT_FALSE(ldlj_speed(still, 100));
    EXPECT_FALSE(ldlj_vector(std::vector<Vec3>(100, Vec3::Zero()), 100));
    EXPECT_FALSE(sparc({}, 100));
}

TEST(MotionMetrics, PathsOfTheHelixAreItsClosedForms) {
    const auto expected = json("motion/helix_expected.json");
    const std::string file = "motion/helix_pose.csv";
    const auto x = column(file, "x_mm"), y = column(file, "y_mm"), z = column(file, "z_mm");
    const auto qw = column(file, "qw"), qx = column(file, "qx"), qy = column(file, "qy"),
               qz = column(file, "qz");
    std::vector<Vec3> position;
    std::vector<Quat> turn, upright;
    for (size_t k = 0; k < x.size(); ++k) {
        position.emplace_back(x[k], y[k], z[k]);
        turn.emplace_back(qw[k], qx[k], qy[k], qz[k]);
        upright.push_back(Quat::Identity());
    }
    EXPECT_NEAR(path_length(position), expected["path_length_polyline_mm"].get<double>(), 1e-9);
    // Turns about z only, so the shaft keeps pointing along z.
    EXPECT_NEAR(depth_path(position, upright), expected["depth_path_along_z_mm"].get<double>(),
                1e-9);
    EXPECT_NEAR(angular_path(turn) * 180 / std::numbers::pi,
                expected["angular_path_total_deg"].get<double>(), 1e-9);
    std::vector<Vec3> velocity;
    for (size_t k = 1; k < position.size(); ++k)
        velocity.push_back((position[k] - position[k - 1]) * 100);
    EXPECT_NEAR(ldlj_vector(velocity, 100).value(),
                expected["ldlj_vector_monalysa_on_finite_diff_velocity"].get<double>(), 1e-8);
}

TEST(MotionMetrics, CountsMovementsAndIdleTime) {
    const auto expected = json("motion/movements_expected.json");
    const auto columns = table("motion/movements_speed.csv");
    const std::vector<double> speed = column("motion/movements_speed.csv", "speed_mm_s");
    EXPECT_EQ(movement_count(speed, expected["threshold_mm_s"]),
              expected["n_upcrossings"].get<int>());
    EXPECT_NEAR(idle_time(speed, 0.01, expected["idle_threshold_mm_s"]),
                expected["idle_time_s_sample_rule"].get<double>(), 1e-9);
    // Two of the five movements overlap: they are one segment at a low threshold.
    for (const auto& [first, last] : movement_segments(speed, 0.01, 5, 0.3)) {
        EXPECT_LT(first, last);
        EXPECT_GE(speed[first], 5);
    }
    EXPECT_EQ(movement_segments(speed, 0.01, 5, 0.3).size(),
              movement_segments(speed, 0.01, 5, 0.0).size());
    EXPECT_TRUE(movement_segments(speed, 0.01, 5, 100).empty());
}

TEST(MotionMetrics, ARecordingOfOneStraightMovement) {
    sim::Recording recording;
    recording.header.tools.resize(2);
    recording.header.tools[1].kind = sim::ToolKind::kScope;
    // 1 s rest, minimum jerk of 40 mm along x in 1 s, 1 s rest; out of view for the first 0.5 s.
    for (int k = 0; k <= 300; ++k) {
        sim::Sample sample;
        sample.time_s = k * 0.01;
        const double u = std::clamp(sample.time_s - 1, 0.0, 1.0);
        const double s = u * u * u * (10 + u * (-15 + 6 * u));
        sample.tools[0].tip_m = {static_cast<float>(0.040 * s), 0, 0};
        sample.tools[0].in_view = k >= 50;
        sample.tools[1].in_view = 1;
        recording.samples.push_back(sample);
    }
    recording.end.duration_s = 3;
    std::vector<Metric> metrics;
    ToolTracks tracks(recording);
    add_motion_metrics(tracks, metrics);
    const auto value = [&](const char* id) {
        for (const Metric& metric : metrics) {
            if (metric.id == id) return metric.value;
        }
        ADD_FAILURE() << id << " is missing";
        return 0.0;
    };
    EXPECT_NEAR(value("task_time_s"), 2.5, 1e-9);
    EXPECT_NEAR(value("out_of_view_s"), 0.5, 1e-9);
    // The filter smears the ends a little; the way stays the same.
    EXPECT_NEAR(value("path_length_mm"), 40, 0.02);
    EXPECT_NEAR(value("movements"), 1, 0);
    EXPECT_NEAR(value("mean_speed_mm_s"), 16, 0.01);
    // Below 1 mm/s: the rests and the feet of the bell.
    EXPECT_NEAR(value("idle_time_s"), 2.1, 0.15);
    // Cut at 5 mm/s the bell keeps its shape: near the -1.41 of a whole one.
    EXPECT_NEAR(value("sparc"), -1.41, 0.03);
    EXPECT_LT(value("ldlj_vector"), -4);
}

TEST(MotionMetrics, ConstantSpeedHasNoJerkToMeasure) {
    // 1e-14 of the speed is what filters and differences leave of rounding.
    std::vector<double> speed(200, 30.0);
    for (size_t k = 0; k < speed.size(); k += 3) speed[k] *= 1 + 1e-14;
    EXPECT_FALSE(ldlj_speed(speed, 100).has_value());
    EXPECT_TRUE(sparc(speed, 100).has_value());
    for (size_t k = 0; k < speed.size(); ++k) speed[k] = std::sin(0.0001 * static_cast<double>(k));
    EXPECT_TRUE(ldlj_speed(speed, 100).has_value()) << "slow is not constant";
}

TEST(MotionMetrics, OddRecordingsDoNotThrow) {
    std::vector<Metric> metrics;
    sim::Recording recording;
    ToolTracks nothing(recording);
    add_motion_metrics(nothing, metrics);
    EXPECT_TRUE(metrics.empty());
    recording.header.tools.resize(1);
    recording.samples.resize(3);
    recording.samples[1].tools[0].tip_m = {NAN, NAN, NAN};
    ToolTracks odd(recording);
    add_motion_metrics(odd, metrics);
    EXPECT_FALSE(metrics.empty());
}

TEST(MotionMetrics, ATrackIsMadeOnceForWhoeverAsks) {
    sim::Recording recording;
    recording.header.tools.resize(2);
    for (int k = 0; k < 50; ++k) {
        sim::Sample sample;
        sample.time_s = 0.01 * k;
        sample.tools[1].tip_m[0] = 1e-4F * static_cast<float>(k);
        recording.samples.push_back(sample);
    }
    ToolTracks tracks(recording);
    const Track& second = tracks.of(1);
    EXPECT_EQ(second.position_m, tool_track(recording, 1).position_m);
    EXPECT_NE(second.position_m, tracks.of(0).position_m);
    EXPECT_EQ(&second, &tracks.of(1));
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
