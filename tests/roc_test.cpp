// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Against pROC 1.18.0 (tests/data/statistics/README.md).

#include "assessment/roc.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "statistics_reference.h"

using namespace placode::assessment;
using placode::tests::expected;
using placode::tests::read_table;

namespace THIS_TEST {

Roc of(const placode::tests::Table& table, const char* column) {
    std::vector<bool> poor;
    for (const std::string& word : table.column("response")) poor.push_back(word == "Poor");
    return roc(table.numbers(column), poor);
}

void compare(const Roc& got, const nlohmann::json& want) {
    EXPECT_NEAR(got.auc, want["auc"].get<double>(), 1e-9);
    EXPECT_NEAR(got.delong_se, want["delong_se"].get<double>(), 1e-9);
    EXPECT_NEAR(got.delong_ci95.low, want["delong_ci95"][0].get<double>(), 1e-9);
    EXPECT_NEAR(got.delong_ci95.high, want["delong_ci95"][1].get<double>(), 1e-9);
    EXPECT_NEAR(got.youden_threshold, want["youden_threshold"].get<double>(), 1e-9);
    EXPECT_NEAR(got.sensitivity, want["sens"].get<double>(), 1e-9);
    EXPECT_NEAR(got.specificity, want["spec"].get<double>(), 1e-9);
}

TEST(Roc, AreaVarianceThresholdAndPairedTestArePRocs) {
    const auto table = read_table("roc.csv");
    const auto want = expected("roc_expected.json");
    const Roc s100b = of(table, "s100b"), ndka = of(table, "ndka");
    compare(s100b, want["s100b"]);
    compare(ndka, want["ndka"]);
    const RocComparison paired = compare_paired(s100b, ndka);
    EXPECT_NEAR(paired.z, want["paired_delong_1_vs_2"]["z"].get<double>(), 1e-9);
    EXPECT_NEAR(paired.p, want["paired_delong_1_vs_2"]["p"].get<double>(), 1e-6);
}

TEST(Roc, PerfectSeparationHasNoDeLongVariance) {
    const std::vector<double> values{1, 2, 3, 10, 11};
    const Roc result = roc(values, {false, false, false, true, true});
    EXPECT_EQ(result.auc, 1.0);
    EXPECT_EQ(result.delong_se, 0.0);
    EXPECT_EQ(result.youden_threshold, 6.5);
}

TEST(Roc, NeedsBothClasses) {
    const std::vector<double> values{1, 2};
    EXPECT_THROW((void)roc(values, {true, true}), std::invalid_argument);
}

}  // namespace THIS_TEST
