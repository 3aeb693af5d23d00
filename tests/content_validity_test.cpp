// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of tests/data/statistics/cvi_expected.json.

#include "assessment/content_validity.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "statistics_reference.h"

namespace THIS_TEST {

using namespace placode::assessment;
using placode::tests::expected;
using placode::tests::read_table;

TEST(ContentValidity, IndicesAreTheClosedForms) {
    const auto table = read_table("cvi_ratings.csv");
    const auto want = expected("cvi_expected.json");
    std::vector<std::vector<int>> ratings(table.rows());
    for (const std::string& name : table.header) {
        if (name == "item") continue;
        const auto column = table.numbers(name);
        for (size_t i = 0; i < column.size(); ++i)
            ratings[i].push_back(static_cast<int>(column[i]));
    }
    const ContentValidity got = content_validity(table.column("item"), ratings);
    for (size_t i = 0; i < got.items.size(); ++i) {
        const auto& item = want["items"][i];
        EXPECT_EQ(got.items[i].agree, item["agree"].get<int>());
        EXPECT_NEAR(got.items[i].i_cvi, item["i_cvi"].get<double>(), 1e-9);
        EXPECT_NEAR(got.items[i].pc, item["pc"].get<double>(), 1e-9);
        EXPECT_NEAR(got.items[i].modified_kappa, item["modified_kappa"].get<double>(), 1e-9);
        EXPECT_NEAR(got.items[i].cvr_lawshe, item["cvr_lawshe"].get<double>(), 1e-9);
    }
    EXPECT_NEAR(got.s_cvi_ave, want["s_cvi_ave"].get<double>(), 1e-9);
    EXPECT_NEAR(got.s_cvi_ua, want["s_cvi_ua"].get<double>(), 1e-9);
    EXPECT_NEAR(got.mean_cvr, want["mean_cvr"].get<double>(), 1e-9);
    for (const auto& [experts, critical] :
         want["lawshe_exact_binomial_critical_alpha0.05_one_tailed"].items()) {
        const CriticalCvr c = critical_cvr(std::stoi(experts));
        EXPECT_EQ(c.n_critical, critical["n_critical"].get<int>()) << experts;
        EXPECT_NEAR(c.cvr_critical, critical["cvr_critical"].get<double>(), 1e-9);
        EXPECT_NEAR(c.one_tailed_p, critical["one_tailed_p"].get<double>(), 1e-9);
    }
}

TEST(ContentValidity, ARatingOffTheScaleIsNamed) {
    EXPECT_THROW((void)content_validity({"q1"}, {{4, 5}}), std::invalid_argument);
    EXPECT_EQ(critical_cvr(4).n_critical, 0) << "four experts cannot be significant at 5 %";
}

}  // namespace THIS_TEST
