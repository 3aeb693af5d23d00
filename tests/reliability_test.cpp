// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Against psych 2.2.9 and lavaan 0.6.14 (tests/data/statistics/README.md).

#include "assessment/reliability.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "statistics_reference.h"

using namespace placode::assessment;
using placode::tests::expected;
using placode::tests::read_table;

namespace THIS_TEST {

Scores bfi(bool reverse) {
    const auto table = read_table("likert_bfi.csv");
    Scores scores(table.rows());
    for (const std::string& name : table.header) {
        const auto column = table.numbers(name);
        for (size_t i = 0; i < column.size(); ++i) {
            scores[i].push_back(reverse && name == "A1" ? reversed(column[i], 1, 6) : column[i]);
        }
    }
    return scores;
}

void compare(const IccForm& got, const nlohmann::json& want) {
    EXPECT_NEAR(got.icc, want["icc"].get<double>(), 1e-9);
    EXPECT_NEAR(got.f, want["F"].get<double>(), 1e-9);
    EXPECT_NEAR(got.p, want["p"].get<double>(), 1e-6);
    EXPECT_NEAR(got.ci95.low, want["lo"].get<double>(), 1e-6);
    EXPECT_NEAR(got.ci95.high, want["hi"].get<double>(), 1e-6);
}

TEST(Reliability, AlphaIsPsychs) {
    const auto want = expected("likert_expected.json")["alpha"];
    const Alpha got = cronbach_alpha(bfi(true));
    EXPECT_NEAR(got.raw, want["raw"].get<double>(), 1e-9);
    EXPECT_NEAR(got.standardized, want["standardized"].get<double>(), 1e-9);
    EXPECT_NEAR(*got.g6, want["G6"].get<double>(), 1e-9);
    EXPECT_NEAR(got.mean_interitem_r, want["mean_interitem_r"].get<double>(), 1e-9);
    EXPECT_NEAR(got.ase, want["ase"].get<double>(), 1e-9);
    EXPECT_NEAR(got.feldt_ci95.low, want["feldt_ci95"][0].get<double>(), 1e-9);
    EXPECT_NEAR(got.feldt_ci95.high, want["feldt_ci95"][1].get<double>(), 1e-9);
    EXPECT_NEAR(got.duhachek_ci95.low, want["duhachek_ci95"][0].get<double>(), 1e-4);
    const char* items[] = {"A1", "A2", "A3", "A4", "A5"};
    for (size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(got.alpha_if_dropped[i], want["alpha_if_dropped"][items[i]].get<double>(),
                    1e-9);
        EXPECT_NEAR(got.corrected_item_total_r[i],
                    want["corrected_item_total_r"][items[i]].get<double>(), 1e-9);
    }
    EXPECT_NEAR(cronbach_alpha(bfi(false)).raw, want["raw_without_reversal"].get<double>(), 1e-9);
}

TEST(Reliability, OmegaIsLavaansAndPsychs) {
    const auto want = expected("likert_expected.json");
    const Omega got = mcdonald_omega(bfi(true));
    ASSERT_TRUE(got.converged);
    EXPECT_NEAR(got.total_ml, want["omega_total_cfa"]["value"].get<double>(), 1e-4);
    EXPECT_NEAR(got.total_minres, want["omega_total_minres"]["value"].get<double>(), 1e-4);
    const char* items[] = {"A1", "A2", "A3", "A4", "A5"};
    for (size_t i = 0; i < 5; ++i) {
        // lavaan divides by n, we by n - 1; loadings differ by sqrt(80/79), omega not at all.
        EXPECT_NEAR(
            got.loadings[i],
            want["omega_total_cfa"]["loadings"][items[i]].get<double>() * std::sqrt(80.0 / 79.0),
            1e-3);
    }
}

TEST(Reliability, AllSixIccFormsArePsychs) {
    const auto table = read_table("icc_ratings.csv");
    const auto want = expected("icc_expected.json");
    Scores ratings(table.rows());
    for (const std::string& name : table.header) {
        const auto column = table.numbers(name);
        for (size_t i = 0; i < column.size(); ++i) ratings[i].push_back(column[i]);
    }
    const Icc got = intraclass_correlation(ratings);
    compare(got.icc1, want["results"]["ICC1"]);
    compare(got.icc2, want["results"]["ICC2"]);
    compare(got.icc3, want["results"]["ICC3"]);
    compare(got.icc1k, want["results"]["ICC1k"]);
    compare(got.icc2k, want["results"]["ICC2k"]);
    compare(got.icc3k, want["results"]["ICC3k"]);
    EXPECT_NEAR(got.sem_agreement, want["anova"]["SEM_agreement"].get<double>(), 1e-9);
    EXPECT_NEAR(got.sem_consistency, want["anova"]["SEM_consistency"].get<double>(), 1e-9);
}

TEST(Reliability, AConstantItemIsNamed) {
    EXPECT_THROW((void)cronbach_alpha({{1, 3}, {2, 3}, {4, 3}}), std::invalid_argument);
    EXPECT_THROW((void)intraclass_correlation({{1, 2}}), std::invalid_argument);
}

}  // namespace THIS_TEST
