// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Against the exact bootstrap distribution (tests/data/statistics/bootstrap_expected.json).

#include "assessment/bootstrap.h"
#include "assessment/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "statistics_reference.h"

using namespace placode::assessment;
using placode::tests::expected;
using placode::tests::read_table;

namespace THIS_TEST {

double mean(std::span<const double> v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

double median(std::span<const double> v) {
    std::vector<double> sorted(v.begin(), v.end());
    std::sort(sorted.begin(), sorted.end());
    return quantile(sorted, 0.5);
}

TEST(Bootstrap, SevenValuesAreEnumerated) {
    const auto want = expected("bootstrap_expected.json");
    const std::vector<double> x = read_table("bootstrap_small.csv").numbers("x");
    const Bootstrap of_mean = bootstrap(x, mean);
    EXPECT_TRUE(of_mean.exact);
    EXPECT_EQ(of_mean.resamples, want["enumerated"].get<int64_t>());
    EXPECT_NEAR(of_mean.percentile95.low, want["mean_pctl_025"].get<double>(), 1e-9);
    EXPECT_NEAR(of_mean.percentile95.high, want["mean_pctl_975"].get<double>(), 1e-9);
    EXPECT_NEAR(of_mean.boot_sd, want["closed_form_boot_sd"].get<double>(), 1e-9);
    EXPECT_NEAR(of_mean.bca_z0, want["bca_z0_exact_strict"].get<double>(), 1e-6);
    EXPECT_NEAR(of_mean.bca_a, want["bca_a"].get<double>(), 1e-9);
    const Bootstrap of_median = bootstrap(x, median);
    EXPECT_NEAR(of_median.percentile95.low, want["median_pctl_025"].get<double>(), 1e-9);
    EXPECT_NEAR(of_median.percentile95.high, want["median_pctl_975"].get<double>(), 1e-9);
}

TEST(Bootstrap, MonteCarloIsSeededAndNearTheNormalInterval) {
    std::vector<double> x;
    for (int i = 0; i < 50; ++i) x.push_back(i % 10);
    const Bootstrap a = bootstrap(x, mean, 20000, 7), b = bootstrap(x, mean, 20000, 7),
                    c = bootstrap(x, mean, 20000, 8);
    EXPECT_FALSE(a.exact);
    EXPECT_EQ(a.percentile95.low, b.percentile95.low);
    EXPECT_NE(a.boot_sd, c.boot_sd);
    // Population SD 2.8723 / sqrt(50) = 0.4062; the Monte-Carlo error of an SD is 1/sqrt(2 R) = 0.5
    // %.
    EXPECT_NEAR(a.boot_sd, 0.4062, 0.01);
}

TEST(Bootstrap, OneValueIsRefused) {
    const std::vector<double> x{1};
    EXPECT_THROW((void)bootstrap(x, mean), std::invalid_argument);
}

}  // namespace THIS_TEST
