// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms and published constants.

#include "assessment/standard_setting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace THIS_TEST {

using namespace placode::assessment;

TEST(StandardSetting, EqualSpreadPutsTheCutInTheMiddle) {
    const std::vector<double> novices{40, 50, 60}, experts{70, 80, 90};
    const ContrastingGroups got = contrasting_groups(novices, experts);
    ASSERT_EQ(got.roots.size(), 1u);
    EXPECT_NEAR(got.cut_score, 65, 1e-9);
    EXPECT_NEAR(got.theoretical_false_positive, 0.5 * std::erfc(1.5 / std::sqrt(2.0)), 1e-12);
    EXPECT_NEAR(got.theoretical_false_negative, got.theoretical_false_positive, 1e-12);
    EXPECT_EQ(got.observed_false_positive, 0);
    EXPECT_EQ(got.auc, 1);
}

TEST(StandardSetting, AtTheCutBothDensitiesAreEqual) {
    const std::vector<double> novices{30, 55, 61, 42, 70}, experts{80, 84, 91, 79, 88, 60};
    const ContrastingGroups got = contrasting_groups(novices, experts);
    const auto density = [](double x, double m, double s) {
        return std::exp(-0.5 * (x - m) * (x - m) / (s * s)) / s;
    };
    EXPECT_NEAR(density(got.cut_score, got.mean_novice, got.sd_novice),
                density(got.cut_score, got.mean_expert, got.sd_expert), 1e-12);
    EXPECT_GT(got.cut_score, got.mean_novice);
    EXPECT_LT(got.cut_score, got.mean_expert);
}

TEST(StandardSetting, ExpertsBelowNovicesAreRefused) {
    const std::vector<double> low{1, 2, 3}, high{7, 8, 9};
    EXPECT_THROW((void)contrasting_groups(high, low), std::invalid_argument);
}

TEST(StandardSetting, AngoffIsTheMeanOfTheJudges) {
    const Angoff got = angoff({{0.6, 0.7, 0.5, 0.9, 0.8},
                               {0.5, 0.8, 0.4, 0.85, 0.7},
                               {0.7, 0.75, 0.6, 0.9, 0.9},
                               {0.55, 0.65, 0.5, 0.95, 0.75}});
    EXPECT_NEAR(got.cut_score_items, 3.5, 1e-12);
    EXPECT_NEAR(got.cut_percent, 70, 1e-10);
    EXPECT_NEAR(got.sd_judges, 0.25495097567963904, 1e-12);
    EXPECT_NEAR(got.se_cut, 0.12747548783981952, 1e-12);
    EXPECT_THROW((void)angoff({{0.5}, {1.5}}), std::invalid_argument);
    EXPECT_NEAR(got.se_percent, 100 * got.se_cut / 5, 1e-12);
}

TEST(StandardSetting, AnItemOfAngoffCountsByItsWeight) {
    // (0.5 * 30 + 1 * 10) / 40 and (0.7 * 30 + 0 * 10) / 40.
    const std::vector<double> weights{30, 10};
    const Angoff got = angoff({{0.5, 1.0}, {0.7, 0.0}}, weights);
    EXPECT_NEAR(got.cut_percent, (62.5 + 52.5) / 2, 1e-12);
    EXPECT_NEAR(got.sd_percent, 10 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(got.cut_score_items, 1.1, 1e-12) << "items count alike here";
    const std::vector<double> few{1}, none{1, 0};
    EXPECT_THROW((void)angoff({{0.5, 1.0}, {0.7, 0.0}}, few), std::invalid_argument);
    EXPECT_THROW((void)angoff({{0.5, 1.0}, {0.7, 0.0}}, none), std::invalid_argument);
}

TEST(StandardSetting, CusumConstantsAreThePublishedOnes) {
    // Bolsin & Colson with p0 .05, p1 .10, alpha .05, beta .20: s .07, h0 -2.09, h1 3.71.
    const CusumLimits limits = cusum_limits(0.05, 0.10, 0.05, 0.20);
    EXPECT_NEAR(limits.s, 0.0723583768431711, 1e-12);
    EXPECT_NEAR(limits.h0_lower, -2.0852711273097, 1e-10);
    EXPECT_NEAR(limits.h1_upper, 3.71056649262732, 1e-10);
    const Cusum path = cusum({true, true, true, true, true, false}, limits);
    EXPECT_EQ(path.failures, 5);
    // With these rates four failures, 4 (1 - s), meet the limit h1 exactly; "above" begins with the
    // fifth.
    EXPECT_EQ(path.first_above_h1, 5);
    EXPECT_NEAR(path.path.back(), 5 - 6 * limits.s, 1e-12);
    EXPECT_THROW((void)cusum_limits(0.1, 0.05, 0.05, 0.2), std::invalid_argument);
}

TEST(StandardSetting, LearningCusumNeverFallsBelowZeroAndSignalsOnce) {
    std::vector<bool> failed(12, false);
    failed[0] = true;
    const LcCusum got = lc_cusum(failed, 0.1, 0.3, 2);
    EXPECT_NEAR(got.w_failure, -1.09861228866811, 1e-12);
    EXPECT_NEAR(got.w_success, 0.251314428280906, 1e-12);
    EXPECT_EQ(got.path[0], 0);
    EXPECT_EQ(got.first_reach_h, 9) << "8 successes of 0.2513 reach 2.01 at trial 9";
}

}  // namespace THIS_TEST
