// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/signal.h"

#include <gtest/gtest.h>

#include "tests/reference_data.h"

namespace placode::assessment {
namespace THIS_TEST {

using namespace testing_data;

TEST(Signal, ButterworthCoefficientsAreThoseOfScipy) {
    const auto expected = json("motion/butterworth_fs100_expected.json");
    const Biquad f = butterworth_low_pass(10, 100);
    for (size_t i = 0; i < 3; ++i) {
        // Closed forms: rounding only.
        EXPECT_NEAR(f.b[i], expected["b"][i].get<double>(), 1e-14);
        EXPECT_NEAR(f.a[i], expected["a"][i].get<double>(), 1e-14);
    }
}

TEST(Signal, ForwardBackwardFilterAndDerivativeAreThoseOfScipyAndNumpy) {
    const std::string file = "motion/butterworth_fs100.csv";
    const std::vector<double> raw = column(file, "x_raw_mm");
    const std::vector<double> filtered =
        filter_forward_backward(butterworth_low_pass(10, 100), raw);
    const std::vector<double> expected = column(file, "x_filtfilt_fc10_mm");
    const std::vector<double> speed = column(file, "v_central_diff_of_filtered_mm_s");
    const std::vector<double> slope = derivative(filtered, 0.01);
    ASSERT_EQ(filtered.size(), expected.size());
    for (size_t k = 0; k < raw.size(); ++k) {
        // Same arithmetic in another order: rounding of numbers up to 50.
        EXPECT_NEAR(filtered[k], expected[k], 1e-11) << k;
        EXPECT_NEAR(slope[k], speed[k], 1e-9) << k;
    }
}

TEST(Signal, ShortSignalsComeBackUnchanged) {
    const std::vector<double> nine(9, 3.0);
    EXPECT_EQ(filter_forward_backward(butterworth_low_pass(10, 100), nine), nine);
}

TEST(Signal, AClockThatJumpsByYearsDoesNotFillTheMemory) {
    const std::vector<double> time{0, 0.01, 0.02, 1e9, 1e300, 0.03};
    const std::vector<Vec3> position(time.size(), Vec3(1, 2, 3));
    const Track track = make_track(time, position, {});
    EXPECT_EQ(track.position_m.size(), 4u);  // 0 to 0.03 s
}

TEST(Signal, NoiseAboveTheAnalysisRateDoesNotFoldIntoTheMovement) {
    // A shake of 0.1 mm at 93 Hz, sampled at 1 kHz: taken at 100 Hz without a low pass before, it
    // would look like one of 7 Hz and lengthen the way by about 2 mm.
    std::vector<double> time;
    std::vector<Vec3> position;
    for (int k = 0; k <= 2000; ++k) {
        time.push_back(k * 0.001);
        position.emplace_back(0.025 * time.back() + 1e-4 * std::sin(186 * M_PI * time.back()), 0,
                              0);
    }
    const Track track = make_track(time, position, {});
    ASSERT_EQ(track.position_m.size(), 201u);
    for (size_t k = 20; k < 180; ++k)  // Run twice, the filter leaves 1 / (1 + 9.3^4) = 1.3e-4.
        EXPECT_NEAR(track.position_m[k].x(), 0.025 * track.time_s(k), 1e-7) << k;
}

TEST(Signal, TrackResamplesAndDropsOddSamples) {
    std::vector<double> time;
    std::vector<Vec3> position;
    std::vector<Quat> turn;
    for (int k = 0; k <= 50; ++k) {  // 50 Hz, straight line at 10 mm/s, one turn about z in 1 s
        time.push_back(k * 0.02);
        position.emplace_back(k * 0.0002, 0, 0);
        turn.emplace_back(Eigen::AngleAxisd(k * 0.02, Vec3::UnitZ()));
    }
    time.insert(time.begin() + 10, {time[9], NAN});
    position.insert(position.begin() + 10, {Vec3(9, 9, 9), Vec3::Zero()});
    turn.insert(turn.begin() + 10, {Quat::Identity(), Quat::Identity()});
    const Track track = make_track(time, position, turn);
    ASSERT_EQ(track.position_m.size(), 101u);
    for (size_t k = 0; k < track.speed_m_s.size(); ++k) {
        // The start state is that of a constant, not of a slope: a ripple that the filter's poles
        // (radius 0.64) take down to 1e-6 of itself within 30 samples.
        const bool inside = k >= 30 && k <= 70;
        EXPECT_NEAR(track.position_m[k].x(), 0.01 * track.time_s(k), inside ? 1e-10 : 2e-6) << k;
        EXPECT_NEAR(track.speed_m_s[k], 0.01, inside ? 1e-8 : 2e-4) << k;
        EXPECT_NEAR(track.orientation[k].angularDistance(
                        Quat(Eigen::AngleAxisd(track.time_s(k), Vec3::UnitZ()))),
                    0, 1e-7);
    }
    EXPECT_TRUE(make_track({}, {}, {}).empty());
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
