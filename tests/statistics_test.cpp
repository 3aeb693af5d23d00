// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics.h"

#include <gtest/gtest.h>

#include "tests/reference_data.h"

namespace placode::assessment {
namespace THIS_TEST {

using namespace testing_data;

TEST(Statistics, ReproducesTheSeedPapersItems) {
    auto columns = table("statistics/seed_face_validity.csv");
    const size_t rows = columns["item"].size();
    ASSERT_GE(rows, 6u);
    for (size_t row = 0; row < rows; ++row) {
        std::vector<std::optional<int>> answers;
        for (int value = 1; value <= 5; ++value) {
            const auto count = number(columns[std::string("n").append(std::to_string(value))][row]);
            answers.insert(answers.end(), static_cast<size_t>(count), value);
        }
        const LikertSummary s = summarise_likert(answers);
        EXPECT_EQ(s.n, 14);
        EXPECT_EQ(s.missing, 0);
        // The file keeps ten decimals (six of the percentage).
        EXPECT_NEAR(*s.mean, number(columns["mean"][row]), 1e-10);
        EXPECT_NEAR(*s.sd, number(columns["sd_sample"][row]), 1e-10);
        EXPECT_NEAR(*s.median, number(columns["median"][row]), 0);
        EXPECT_NEAR(*s.top2_percent, number(columns["top2_percent"][row]), 1e-6);
    }
}

TEST(Statistics, LongAnswersGiveTheSameAsTheCounts) {
    auto columns = table("statistics/seed_face_validity_long.csv");
    std::vector<std::optional<int>> overall;
    for (size_t i = 0; i < columns["item"].size(); ++i) {
        if (columns["item"][i] == "F")
            overall.push_back(static_cast<int>(number(columns["response"][i])));
    }
    const LikertSummary s = summarise_likert(overall);
    EXPECT_EQ(s.n, 14);
    EXPECT_EQ(s.counts, (std::vector<int>{0, 0, 1, 11, 2}));
    EXPECT_NEAR(*s.mean, 57.0 / 14, 1e-12);
}

TEST(Statistics, TheMedianIsTheMiddleOrBetweenTheTwoInTheMiddle) {
    EXPECT_EQ(median_of(std::vector<double>{5, 1, 3}), 3);
    EXPECT_EQ(median_of(std::vector<double>{8, 1, 2, 4}), 3);
    EXPECT_EQ(median_of(std::vector<double>{7}), 7);
}

TEST(Statistics, MissingAndImpossibleAnswersAreCountedApart) {
    const std::vector<std::optional<int>> answers{1, std::nullopt, 5, 9, 4};
    const LikertSummary s = summarise_likert(answers);
    EXPECT_EQ(s.n, 3);
    EXPECT_EQ(s.missing, 2);
    EXPECT_NEAR(*s.mean, 10.0 / 3, 1e-12);
    EXPECT_NEAR(*s.top2_percent, 200.0 / 3, 1e-9);
    const LikertSummary none = summarise_likert({});
    EXPECT_EQ(none.n, 0);
    EXPECT_FALSE(none.mean || none.sd || none.median || none.top2_percent);
    const std::vector<std::optional<int>> one{3};
    EXPECT_FALSE(summarise_likert(one).sd);
}

TEST(Statistics, QuantilesAreType7) {
    const std::vector<double> values{1, 2, 3, 4};
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);  // R: quantile(1:4, .25)
    EXPECT_DOUBLE_EQ(quantile(values, 1), 4);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
