// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Fits against curves whose parameters are known.

#include "assessment/learning_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace THIS_TEST {

using namespace placode::assessment;

TEST(LearningCurve, RecoversTheParametersOfAnExactCurve) {
    std::vector<double> y;
    for (int i = 0; i < 60; ++i) y.push_back(82 - 45 * std::exp(-i / 11.0) + 1e-3 * std::sin(i));
    const LearningCurve got = learning_curve(y);
    ASSERT_TRUE(got.exponential);
    EXPECT_TRUE(got.exponential->converged);
    EXPECT_NEAR(got.exponential->asymptote, 82, 1e-3);
    EXPECT_NEAR(got.exponential->gain, 45, 1e-2);
    EXPECT_NEAR(got.exponential->tau_trials, 11, 1e-2);
    EXPECT_NEAR(got.exponential->trial_to_95pct_of_gain, 1 + 11 * std::log(20.0), 0.03);
    EXPECT_GT(got.exponential->r2, 0.999999);
}

TEST(LearningCurve, TheFitIsALeastSquaresMinimum) {
    std::vector<double> y;
    for (int i = 0; i < 40; ++i) y.push_back(70 - 30 * std::exp(-i / 6.0) + 4 * std::sin(1.7 * i));
    const LearningCurve got = learning_curve(y);
    ASSERT_TRUE(got.exponential);
    const auto rss = [&](double a, double b, double tau) {
        double sum = 0;
        for (int i = 0; i < 40; ++i)
            sum += std::pow(y[static_cast<size_t>(i)] - a + b * std::exp(-i / tau), 2);
        return sum;
    };
    const auto& fit = *got.exponential;
    const double best = rss(fit.asymptote, fit.gain, fit.tau_trials);
    EXPECT_NEAR(best, fit.rss, 1e-9 * best);
    for (const double step : {-0.01, 0.01}) {
        EXPECT_GT(rss(fit.asymptote + step, fit.gain, fit.tau_trials), best);
        EXPECT_GT(rss(fit.asymptote, fit.gain + step, fit.tau_trials), best);
        EXPECT_GT(rss(fit.asymptote, fit.gain, fit.tau_trials + step), best);
    }
}

TEST(LearningCurve, PowerLawIsExactAndLeavesZerosOut) {
    std::vector<double> y{0};
    for (int i = 2; i <= 30; ++i) y.push_back(20 * std::pow(i, 0.3));
    const LearningCurve got = learning_curve(y);
    ASSERT_TRUE(got.power);
    EXPECT_EQ(got.power->n_positive, 29);
    EXPECT_NEAR(got.power->b, 0.3, 1e-9);
    EXPECT_NEAR(got.power->log_a, std::log(20.0), 1e-9);
}

TEST(LearningCurve, AFewTrialsGiveNoExponential) {
    const std::vector<double> y{10, 20, 30};
    const LearningCurve got = learning_curve(y);
    EXPECT_FALSE(got.exponential);
    EXPECT_FALSE(got.plateau);
}

TEST(LearningCurve, EqualScoresAreConstantAndNotScattered) {
    const LearningCurve got = learning_curve(std::vector{80.0, 80.0, 80.0, 80.0, 80.0, 80.0});
    EXPECT_TRUE(got.constant);
    EXPECT_FALSE(got.exponential);
    EXPECT_FALSE(learning_curve(std::vector{80.0, 80.0, 80.0, 80.0, 80.0, 81.0}).constant);
}

TEST(LearningCurve, TheSlopeOfOneOrTwoScoresHasNoInterval) {
    EXPECT_FALSE(learning_curve(std::vector{80.0}).last10_slope_ci95);
    EXPECT_FALSE(learning_curve(std::vector{80.0, 90.0}).last10_slope_ci95);
    // 1, 2, 4: slope 1.5 with a standard error of sqrt(1 / 12); t(0.975; 1) = 12.7062.
    const auto slope = learning_curve(std::vector{1.0, 2.0, 4.0}).last10_slope_ci95;
    ASSERT_TRUE(slope);
    EXPECT_NEAR(slope->low, 1.5 - 12.7062047 * std::sqrt(1.0 / 12), 1e-6);
    EXPECT_NEAR(slope->high, 1.5 + 12.7062047 * std::sqrt(1.0 / 12), 1e-6);
}

}  // namespace THIS_TEST
