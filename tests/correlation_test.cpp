// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Against values of R 4.2.2 (tests/data/statistics/README.md).

#include "assessment/correlation.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "statistics_reference.h"

namespace THIS_TEST {

using namespace placode::assessment;
using placode::tests::expected;
using placode::tests::read_table;

TEST(Correlation, IsRs) {
    const auto table = read_table("correlation.csv");
    const auto want = expected("correlation_expected.json");
    const Correlation got = correlation(table.numbers("x"), table.numbers("y"));
    EXPECT_EQ(got.n, want["n"].get<int>());
    EXPECT_NEAR(got.spearman, want["spearman"].get<double>(), 1e-9);
    EXPECT_NEAR(got.spearman_p_t_approx, want["spearman_p_t_approx"].get<double>(), 1e-15);
    EXPECT_NEAR(got.spearman_s, want["spearman_S"].get<double>(), 1e-6);
    EXPECT_NEAR(got.spearman_ci95.low, want["spearman_ci95_bonett_wright"][0].get<double>(), 1e-9);
    EXPECT_NEAR(got.spearman_ci95.high, want["spearman_ci95_bonett_wright"][1].get<double>(), 1e-9);
    EXPECT_NEAR(got.kendall_tau_b, want["kendall_tau_b"].get<double>(), 1e-9);
    EXPECT_NEAR(got.kendall_p, want["kendall_p"].get<double>(), 1e-14);
    EXPECT_NEAR(got.pearson, want["pearson"].get<double>(), 1e-9);
    EXPECT_NEAR(got.pearson_p, want["pearson_p"].get<double>(), 1e-12);
    EXPECT_NEAR(got.pearson_ci95.low, want["pearson_ci95"][0].get<double>(), 1e-9);
    EXPECT_NEAR(got.pearson_ci95.high, want["pearson_ci95"][1].get<double>(), 1e-9);
}

TEST(Correlation, RefusesAConstantColumn) {
    const std::vector<double> x{1, 2, 3, 4, 5}, y{2, 2, 2, 2, 2};
    EXPECT_THROW((void)correlation(x, y), std::invalid_argument);
}

}  // namespace THIS_TEST
