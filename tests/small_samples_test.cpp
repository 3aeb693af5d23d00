// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What small or awkward samples give, beside R: fewer cases than items, a single value, three
// pairs, a predictor worse than chance, ties of decimals. Every case is one in which a comparison
// of thousands of random tables with R had found a difference or a refusal.

#include <gmock/gmock.h>

#include <cmath>

#include "assessment/correlation.h"
#include "assessment/learning_curve.h"
#include "assessment/reliability.h"
#include "assessment/roc.h"
#include "tests/statistics_reference.h"

using namespace placode::assessment;
using nlohmann::json;
using placode::tests::expected;

namespace THIS_TEST {

constexpr double kR = 1e-6;       ///< p-values of R.
constexpr double kClosed = 1e-9;  ///< Closed forms.

json wanted(const char* name) { return expected("small_cases_expected.json")[name]; }

double number(const json& value) { return value.get<double>(); }

std::vector<double> numbers(const json& value) { return value.get<std::vector<double>>(); }

TEST(SmallSamples, AlphaIsDefinedWithFewerCasesThanItems) {
    const json want = wanted("alpha_fewer_cases_than_items");
    const Alpha got = cronbach_alpha(want["items"].get<Scores>());
    EXPECT_NEAR(got.raw, number(want["raw"]), kClosed);
    EXPECT_NEAR(got.standardized, number(want["standardized"]), kClosed);
    EXPECT_NEAR(got.mean_interitem_r, number(want["mean_interitem_r"]), kClosed);
    EXPECT_NEAR(got.ase, number(want["ase"]), kClosed);
    EXPECT_FALSE(got.g6) << "the correlations have no inverse";
}

TEST(SmallSamples, AGroupOfOneValueIsTestedByRanks) {
    const json want = wanted("mann_whitney_one_value");
    const auto one = numbers(want["group1"]), many = numbers(want["group2"]);
    const MannWhitney got = mann_whitney(one, many);
    EXPECT_EQ(got.u1, number(want["U1"]));
    EXPECT_NEAR(got.p_asymptotic_cc, number(want["p_cc"]), kR);
    EXPECT_NEAR(got.p_asymptotic_nocc, number(want["p_nocc"]), kR);
    EXPECT_NEAR(*got.p_exact, number(want["p_exact"]), kR);
    EXPECT_NEAR(got.hodges_lehmann, number(want["hodges_lehmann"]), 1e-4);
    EXPECT_NEAR(got.cohens_d, number(want["cohens_d"]), kClosed);
    EXPECT_NEAR(got.hedges_g, number(want["hedges_g"]), kClosed);
    // effectsize finds the noncentrality by a search that stops at about four digits.
    EXPECT_NEAR(got.cohens_d_ci95.low, number(want["cohens_d_ci95"][0]), 1e-3);
    EXPECT_NEAR(got.cohens_d_ci95.high, number(want["cohens_d_ci95"][1]), 1e-3);
    EXPECT_TRUE(std::isnan(got.sd1) && std::isnan(got.welch_p)) << "one value has no spread";
    const MannWhitney same = mann_whitney(std::vector{2.0, 2.0}, std::vector{2.0, 2.0});
    EXPECT_TRUE(std::isnan(same.p_asymptotic_cc) && std::isnan(same.cohens_d));
}

TEST(SmallSamples, TheIntervalOfAnEnormousEffectGrowsWithIt) {
    // One degree of freedom: the far end is d sqrt(chi2(0.975; 1)) in the limit, where R's pt (good
    // up to a noncentrality of 37.6) and a search within a fixed distance of t both fall short.
    for (const double far : {60.0, 300.0, 600.0, 1e9}) {
        const MannWhitney got = mann_whitney(std::vector{0.0, 1.0}, std::vector{-far});
        EXPECT_NEAR(got.cohens_d_ci95.high / got.cohens_d, 2.2414, 0.01) << far;
        const MannWhitney turned = mann_whitney(std::vector{-far}, std::vector{0.0, 1.0});
        EXPECT_NEAR(turned.cohens_d_ci95.low, -got.cohens_d_ci95.high,
                    1e-9 * got.cohens_d_ci95.high);
    }
    // The near end, too: P(T <= t) as the integral of Phi(t s - nc) over the distribution of
    // s = sqrt(chi2 / df), by Simpson's rule with 40,000 steps, is 0.975 and 0.025 at these bounds.
    const MannWhitney three =
        mann_whitney(std::vector{90.0, 91.0, 92.0}, std::vector{10.0, 11.0, 12.0});  // t 98.0, df 4
    EXPECT_NEAR(three.hedges_g, 63.8307648642, 1e-9);
    EXPECT_NEAR(three.hedges_g_ci95.low, 22.1891386637, 1e-6);
    EXPECT_NEAR(three.hedges_g_ci95.high, 106.5547493632, 1e-6);
    EXPECT_NEAR(three.cohens_d_ci95.low, 27.8099611821, 1e-6);
    const MannWhitney two =
        mann_whitney(std::vector{85.0, 87.0}, std::vector{10.0, 12.0});  // t 53.0, df 2
    EXPECT_NEAR(two.hedges_g_ci95.low, 4.7289930383, 1e-6);
    EXPECT_NEAR(two.hedges_g_ci95.high, 57.4846641572, 1e-6);
}

TEST(SmallSamples, ThreePairsCorrelateWithoutAnInterval) {
    const json want = wanted("correlation_three_pairs");
    const Correlation got = correlation(numbers(want["x"]), numbers(want["y"]));
    EXPECT_NEAR(got.spearman, number(want["spearman"]), kClosed);
    EXPECT_NEAR(got.spearman_p_t_approx, number(want["spearman_p"]), kR);
    EXPECT_NEAR(got.kendall_tau_b, number(want["kendall"]), kClosed);
    EXPECT_NEAR(got.kendall_p, number(want["kendall_p"]), kR);
    EXPECT_NEAR(got.pearson, number(want["pearson"]), kClosed);
    EXPECT_NEAR(got.pearson_p, number(want["pearson_p"]), kR);
    EXPECT_TRUE(std::isnan(got.pearson_ci95.low) && std::isnan(got.spearman_ci95.high));
}

TEST(SmallSamples, APredictorWorseThanChanceHasNoUsefulThreshold) {
    const json want = wanted("roc_worse_than_chance");
    std::vector<bool> positive;
    for (const double each : numbers(want["positive"])) positive.push_back(each > 0);
    const Roc got = roc(numbers(want["values"]), positive);
    EXPECT_NEAR(got.auc, number(want["auc"]), kClosed);
    EXPECT_EQ(got.youden_threshold, -INFINITY) << "R names -Inf and Inf, both with J = 0";
    EXPECT_EQ(got.sensitivity, 1);
    EXPECT_EQ(got.specificity, 0);
}

TEST(SmallSamples, FourTrialsCarryACurve) {
    const json want = wanted("learning_curve_four_trials");
    const LearningCurve got = learning_curve(numbers(want["scores"]));
    ASSERT_TRUE(got.exponential);
    // nls parameters 1e-3 relative.
    EXPECT_NEAR(got.exponential->asymptote / number(want["asymptote"]), 1, 1e-3);
    EXPECT_NEAR(got.exponential->gain / number(want["gain"]), 1, 1e-3);
    EXPECT_NEAR(got.exponential->tau_trials / number(want["tau"]), 1, 1e-3);
    EXPECT_NEAR(got.exponential->rss / number(want["rss"]), 1, 1e-3);
}

TEST(SmallSamples, TiesOfDecimalsAreExactAsInRUnlessDigitsAreGiven) {
    const json want = wanted("wilcoxon_decimal_ties");
    const auto before = numbers(want["before"]), after = numbers(want["after"]);
    const WilcoxonPaired exact = wilcoxon_paired(before, after);
    EXPECT_EQ(exact.v, number(want["V_exact"]));
    EXPECT_NEAR(exact.p_cc, number(want["p_cc_exact"]), kR);
    const WilcoxonPaired rounded = wilcoxon_paired(before, after, 6);
    EXPECT_EQ(rounded.v, number(want["V_digits"]));
    EXPECT_NEAR(rounded.p_cc, number(want["p_cc_digits"]), kR);
    EXPECT_NE(exact.v, rounded.v) << "1.3 - 1.0 and 3.3 - 3.0 are a tie on paper only";
}

TEST(SmallSamples, RatersWhoAgreeEntirelyHaveAnIccOfOne) {
    const Icc same = intraclass_correlation({{1, 1}, {3, 3}, {4, 4}});
    for (const IccForm* form : {&same.icc1, &same.icc2, &same.icc3, &same.icc1k, &same.icc3k}) {
        EXPECT_NEAR(form->icc, 1, kClosed);
        EXPECT_EQ(form->p, 0);
        EXPECT_NEAR(form->ci95.low, 1, kClosed);
    }
    // One rater a point higher throughout: consistent, but not in agreement.
    const Icc shifted = intraclass_correlation({{1, 2}, {3, 4}, {4, 5}});
    EXPECT_NEAR(shifted.icc3.icc, 1, kClosed);
    EXPECT_LT(shifted.icc2.icc, 1);
    // Subjects whose means are all equal: the raters tell nothing about them.
    EXPECT_NEAR(intraclass_correlation({{1, 3}, {3, 1}, {2, 2}}).icc1.icc, -1, kClosed);
    EXPECT_THROW((void)intraclass_correlation({{2, 2}, {2, 2}}), std::invalid_argument);
}

}  // namespace THIS_TEST
