// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/frame_costs.h"

#include <gtest/gtest.h>

namespace THIS_TEST {

using placode::curriculum::FrameCosts;
using namespace std::chrono_literals;

constexpr double kFrameS = 0.001;

/// A machine where every substep takes `substep`; returns the substeps after `frames` frames.
int run(FrameCosts& costs, std::chrono::microseconds substep, int substeps, int wanted,
        int frames) {
    FrameCosts::Clock::time_point now{};
    for (int i = 0; i < frames; ++i) {
        const auto cost = substep * substeps;
        now += cost;
        costs.add(cost, now);
        substeps = costs.adapted(substeps, wanted, kFrameS);
    }
    return substeps;
}

TEST(FrameCosts, KeepsTheNumberOfSubstepsWhileTheyFit) {
    FrameCosts costs;
    EXPECT_EQ(run(costs, 200us, 4, 4, 10000), 4);
    EXPECT_NEAR(costs.smoothed_s(), 8e-4, 1e-6);
}

TEST(FrameCosts, FewerUnderLoadAndNeverBelowTwo) {
    FrameCosts costs;
    EXPECT_EQ(run(costs, 300us, 4, 4, 10000), 3);  // 0.9 ms fits, 1.2 does not
    EXPECT_EQ(run(costs, 2ms, 3, 4, 10000), 2);
    EXPECT_EQ(run(costs, 2ms, 1, 1, 10000), 1);  // a scene that asks for one has one
}

TEST(FrameCosts, AShortHiccupChangesNothing) {
    FrameCosts costs;
    EXPECT_EQ(run(costs, 100us, 4, 4, 5000), 4);
    EXPECT_EQ(run(costs, 500us, 4, 4, 150), 4);
    EXPECT_EQ(run(costs, 100us, 4, 4, 5000), 4);
}

TEST(FrameCosts, MoreAgainWhenThereIsRoomAndNoSwinging) {
    FrameCosts costs;
    int substeps = run(costs, 1ms, 4, 4, 10000);
    ASSERT_EQ(substeps, 2);
    substeps = run(costs, 100us, substeps, 4, 10000);
    EXPECT_EQ(substeps, 4);
    // Four take 1.2 ms and three 0.9: with three there is no room for a fourth, for good.
    substeps = run(costs, 300us, substeps, 4, 1000);
    EXPECT_EQ(substeps, 3);
    EXPECT_EQ(run(costs, 300us, substeps, 4, 20000), 3);
}

TEST(FrameCosts, RateAndPercentileOfTheLastSecond) {
    FrameCosts costs;
    FrameCosts::Clock::time_point now{};
    costs.start(now);
    for (int i = 0; i < 1000; ++i) {
        now += 1ms;
        costs.add(i % 50 == 7 ? 3ms : 200us, now);
    }
    EXPECT_NEAR(costs.frames_per_s(), 1000, 1e-9);
    EXPECT_NEAR(costs.p99_ms(), 3.0, 1e-6);  // 2 % are slow
}

}  // namespace THIS_TEST
