// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/benchmark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace THIS_TEST {

using namespace placode::assessment;

TEST(Benchmark, IsMeanAndSampleSdOfTheExperts) {
    const std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};  // SD (n - 1) = sqrt(32 / 7)
    const auto made = make_benchmark(values, false, 3);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->n, 8);
    EXPECT_DOUBLE_EQ(made->mean, 5);
    EXPECT_DOUBLE_EQ(made->sd, std::sqrt(32.0 / 7));
    EXPECT_DOUBLE_EQ(made->q50, 4.5);
    EXPECT_TRUE(made->left_out.empty());
}

TEST(Benchmark, LeavesOutWhoIsFurtherThanTheRuleOnce) {
    // Mean 5, SD 2.138: 9 is at z 1.871, 10 instead makes z 2.017 about mean 5.125, SD 2.416.
    const auto in = make_benchmark(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9}, false);
    EXPECT_TRUE(in->left_out.empty());
    const auto out = make_benchmark(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 10}, false);
    EXPECT_EQ(out->left_out, std::vector<size_t>{7});
    EXPECT_EQ(out->n, 7);
    EXPECT_NEAR(out->mean, 31.0 / 7, 1e-12);
}

TEST(Benchmark, SkewedMetricsAreTakenOfTheirLogarithm) {
    const auto made = make_benchmark(std::vector<double>{1, std::exp(1.0), std::exp(2.0)}, true);
    EXPECT_TRUE(made->log);
    EXPECT_NEAR(made->mean, 1, 1e-12);
    EXPECT_NEAR(made->sd, 1, 1e-12);
    EXPECT_NEAR(made->q50, std::exp(1.0), 1e-12) << "quartiles are of the values themselves";
    EXPECT_FALSE(make_benchmark(std::vector<double>{0, 1, 2}, true)->log) << "0 has no logarithm";
    EXPECT_TRUE(is_log_metric("task_time_s"));
    EXPECT_FALSE(is_log_metric("placode_contacts"));
}

TEST(Benchmark, TooFewValuesGiveNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(make_benchmark(std::vector<double>{1, 2}, false));
    EXPECT_FALSE(make_benchmark(std::vector<double>{1, 2, nan}, false));
    EXPECT_EQ(make_benchmark(std::vector<double>{1, nan, 2, 3}, false)->n, 3);
}

TEST(Benchmark, ZIsPositiveForTheBetterSideAndScoresFromNoneToHundred) {
    const auto made = make_benchmark(std::vector<double>{9, 10, 11}, false);
    EXPECT_DOUBLE_EQ(*benchmark_z(*made, 12, Direction::kLowerIsBetter), -2);
    EXPECT_DOUBLE_EQ(*benchmark_z(*made, 12, Direction::kHigherIsBetter), 2);
    EXPECT_FALSE(benchmark_z(*made, 12, Direction::kNeutral));
    EXPECT_FALSE(benchmark_z(*make_benchmark(std::vector<double>{1, 1, 1}, false), 1,
                             Direction::kLowerIsBetter));
    struct Case {
        double z, score;
    };
    for (const Case& each : {Case{0, 100}, {1, 100}, {-1, 75}, {-2, 50}, {-4, 0}, {-9, 0}})
        EXPECT_DOUBLE_EQ(item_score(each.z), each.score);
}

}  // namespace THIS_TEST
