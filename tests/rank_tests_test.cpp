// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Against values of R 4.2.2 (tests/data/statistics/README.md says which packages and tolerances).

#include "assessment/rank_tests.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "statistics_reference.h"

using namespace placode::assessment;
using placode::tests::expected;
using placode::tests::read_table;

namespace THIS_TEST {

constexpr double kClosedForm = 1e-9;  // relative: same formula, other order of operations
constexpr double kPValue = 1e-6;      // R's own accuracy of printed p-values
constexpr double kUniroot = 1e-4;     // R finds the Hodges-Lehmann root with tol 1e-4
constexpr double kOptimised = 1e-6;   // effectsize finds the noncentrality with optim()

void compare(const char* csv, const char* json) {
    const auto table = read_table(csv);
    const auto want = expected(json);
    const MannWhitney got = mann_whitney(table.group("value", "group", want["group1"]),
                                         table.group("value", "group", want["group2"]));
    EXPECT_EQ(got.n1, want["n1"].get<int>());
    EXPECT_EQ(got.u1, want["U1"].get<double>());
    EXPECT_EQ(got.u2, want["U2"].get<double>());
    EXPECT_NEAR(got.p_asymptotic_cc, want["p_asymptotic_cc"].get<double>(), kPValue);
    EXPECT_NEAR(got.p_asymptotic_nocc, want["p_asymptotic_nocc"].get<double>(), kPValue);
    ASSERT_TRUE(got.p_exact);
    EXPECT_NEAR(*got.p_exact, want["p_exact_permutation_with_ties_coin"].get<double>(), kPValue);
    EXPECT_NEAR(got.z, want["z_nocc"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.r, want["r_abs_z_over_sqrtN"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.a12, want["A12"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.cliffs_delta, want["cliffs_delta"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.hodges_lehmann, want["hodges_lehmann"].get<double>(), kUniroot);
    EXPECT_NEAR(got.hodges_lehmann_ci95.low, want["hl_ci95"][0].get<double>(), kUniroot);
    EXPECT_NEAR(got.hodges_lehmann_ci95.high, want["hl_ci95"][1].get<double>(), kUniroot);
    EXPECT_NEAR(got.cohens_d, want["cohens_d"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.cohens_d_ci95.low, want["cohens_d_ci95"][0].get<double>(), kOptimised);
    EXPECT_NEAR(got.cohens_d_ci95.high, want["cohens_d_ci95"][1].get<double>(), kOptimised);
    EXPECT_NEAR(got.hedges_g, want["hedges_g"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.hedges_g_ci95.high, want["hedges_g_ci95"][1].get<double>(), kOptimised);
    EXPECT_NEAR(got.glass_delta, want["glass_delta_sd_group2"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.welch_t, want["welch_t"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.welch_df, want["welch_df"].get<double>(), 1e-7);
    EXPECT_NEAR(got.welch_p, want["welch_p"].get<double>(), kPValue);
}

TEST(RankTests, MannWhitneyWithTiesIsRs) {
    compare("mannwhitney.csv", "mannwhitney_expected.json");
}

TEST(RankTests, MannWhitneyWithoutTiesIsRs) {
    compare("mannwhitney_exact.csv", "mannwhitney_exact_expected.json");
}

TEST(RankTests, WilcoxonPairedIsRs) {
    const auto table = read_table("wilcoxon_paired.csv");
    const auto want = expected("wilcoxon_paired_expected.json");
    const WilcoxonPaired got = wilcoxon_paired(table.numbers("before"), table.numbers("after"));
    EXPECT_EQ(got.v, want["V"].get<double>());
    EXPECT_EQ(got.n_nonzero, want["n_nonzero"].get<int>());
    EXPECT_NEAR(got.p_cc, want["p_cc"].get<double>(), kPValue);
    EXPECT_NEAR(got.p_nocc, want["p_nocc"].get<double>(), kPValue);
    EXPECT_NEAR(got.z, want["z_wilcoxon_zero"].get<double>(), kClosedForm);
    ASSERT_TRUE(got.p_exact);
    EXPECT_NEAR(*got.p_exact, want["p_exact_wilcoxon_zero"].get<double>(), kPValue);
    EXPECT_NEAR(got.z_pratt, want["z_pratt"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.p_pratt, want["p_pratt"].get<double>(), kPValue);
    EXPECT_NEAR(got.matched_rank_biserial, want["matched_rank_biserial"].get<double>(),
                kClosedForm);
    EXPECT_NEAR(got.r, want["r_abs_z_over_sqrt_nonzero"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.cohens_dz, want["cohens_dz"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.paired_t, want["paired_t"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.paired_t_p, want["paired_t_p"].get<double>(), kPValue);
}

TEST(RankTests, KruskalAndDunnAreRs) {
    const auto table = read_table("kruskal.csv");
    const auto want = expected("kruskal_expected.json");
    std::vector<NamedGroup> groups;
    for (const std::string& name : table.names_in("group"))
        groups.push_back({name, table.group("value", "group", name)});
    const KruskalWallis got = kruskal_wallis(groups);
    EXPECT_NEAR(got.h, want["H"].get<double>(), 1e-9);
    EXPECT_EQ(got.df, want["df"].get<int>());
    EXPECT_NEAR(got.p, want["p"].get<double>(), kPValue);
    EXPECT_NEAR(got.epsilon2, want["epsilon2"].get<double>(), kClosedForm);
    EXPECT_NEAR(got.eta2_h, want["eta2_H"].get<double>(), kClosedForm);
    ASSERT_EQ(got.dunn.size(), want["dunn"].size());
    for (size_t i = 0; i < got.dunn.size(); ++i) {
        const auto& pair = want["dunn"][i];
        EXPECT_EQ(got.dunn[i].group1, pair["g1"].get<std::string>());
        EXPECT_NEAR(got.dunn[i].z, pair["z"].get<double>(), 1e-9);
        EXPECT_NEAR(got.dunn[i].p, pair["p"].get<double>(), kPValue);
        EXPECT_NEAR(got.dunn[i].p_holm, pair["p_holm"].get<double>(), kPValue);
        EXPECT_NEAR(got.dunn[i].p_bonferroni, pair["p_bonferroni"].get<double>(), kPValue);
    }
}

TEST(RankTests, FriedmanIsRs) {
    const auto table = read_table("likert_bfi.csv");
    const auto want = expected("likert_expected.json")["friedman"];
    std::vector<std::vector<double>> rows;
    for (size_t i = 0; i < table.rows(); ++i) {
        rows.push_back({7 - table.numbers("A1")[i], table.numbers("A2")[i], table.numbers("A3")[i],
                        table.numbers("A4")[i], table.numbers("A5")[i]});
    }
    const Friedman got = friedman(rows);
    EXPECT_NEAR(got.chi_square, want["chisq"].get<double>(), 1e-9);
    EXPECT_NEAR(got.p, want["p"].get<double>(), kPValue);
    EXPECT_NEAR(got.kendall_w, want["kendall_W"].get<double>(), kClosedForm);
}

TEST(RankTests, ExactPOfASmallSampleIsCountedByHand) {
    // {1,2} against {3,4,5}: U1 = 0; 2 of the 10 choices are as extreme.
    const std::vector<double> a{1, 2}, b{3, 4, 5};
    EXPECT_NEAR(*mann_whitney(a, b).p_exact, 0.2, 1e-12);
}

TEST(RankTests, WhatCannotBeTestedIsRefused) {
    const std::vector<double> none, two{1, 2}, same{3, 3};
    EXPECT_THROW((void)mann_whitney(none, two), std::invalid_argument);
    EXPECT_THROW((void)wilcoxon_paired(same, same), std::invalid_argument);
    EXPECT_THROW((void)kruskal_wallis(std::vector<NamedGroup>{{"a", {1.0}}, {"b", {}}}),
                 std::invalid_argument);
}

}  // namespace THIS_TEST
