// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/intervals.h"

#include <gtest/gtest.h>

#include <vector>

namespace placode::assessment {
namespace THIS_TEST {

// Closed forms and published values; 1e-4 is the precision of the published ones.
TEST(Intervals, WilsonIsThatOfTheLiterature) {
    // Newcombe 1998, Statistics in Medicine 17:857, table I, method 3.
    const Interval a = wilson_interval(81, 263);
    EXPECT_NEAR(a.low, 0.2553, 1e-4);
    EXPECT_NEAR(a.high, 0.3662, 1e-4);
    const Interval b = wilson_interval(0, 20);
    EXPECT_EQ(b.low, 0);
    EXPECT_NEAR(b.high, 0.1611, 1e-4);
    const Interval c = wilson_interval(1, 29);
    EXPECT_NEAR(c.low, 0.0061, 1e-4);
    EXPECT_NEAR(c.high, 0.1718, 1e-4);
    EXPECT_EQ(wilson_interval(7, 7).high, 1);
}

TEST(Intervals, TheMeansIsStudents) {
    // n = 4, mean 2.5, sd sqrt(5/3), t(0.975; 3) = 3.182446.
    const std::vector<double> values{1, 2, 3, 4};
    const auto interval = mean_interval(values);
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, 0.4457397, 1e-6);
    EXPECT_NEAR(interval->high, 4.5542603, 1e-6);
    EXPECT_FALSE(mean_interval(std::vector<double>{1}));
}

TEST(Intervals, CliffsDeltaCountsPairsAndKnowsSeparation) {
    const std::vector<double> a{1, 2, 3}, b{2, 3, 4}, far{10, 11};
    // 9 pairs: one above, six below, two ties.
    EXPECT_NEAR(cliffs_delta(a, b).delta, (1.0 - 6.0) / 9, 1e-12);
    EXPECT_LE(cliffs_delta(a, b).ci95.low, cliffs_delta(a, b).delta);
    EXPECT_FALSE(cliffs_delta(a, b).separated);
    EXPECT_EQ(cliffs_delta(far, a).delta, 1);
    EXPECT_TRUE(cliffs_delta(far, a).separated);
    EXPECT_THROW((void)cliffs_delta(std::vector<double>{1}, a), std::invalid_argument);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
