// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Which raters and attempts an agreement is computed of, against groups that are all tried.

#include "assessment/rating_block.h"

#include <gmock/gmock.h>

#include <random>

using namespace placode::assessment;
using testing::ElementsAre;
using testing::IsEmpty;

namespace THIS_TEST {

void judge(RatingTable& table, int64_t rater, int64_t from, int64_t to) {
    for (int64_t attempt = from; attempt <= to; ++attempt)
        table[attempt][rater] = static_cast<double>(10 * attempt + rater);
}

TEST(RatingBlock, APairThatSharesAttemptsIsFoundBesideOneWhoJudgedMore) {
    RatingTable table;
    judge(table, 1, 1, 10);
    judge(table, 2, 11, 19);
    judge(table, 3, 1, 8);
    const RatingBlock block = complete_block(table, 3);
    EXPECT_THAT(block.raters, ElementsAre(1, 3));
    ASSERT_EQ(block.scores.size(), 8u);
    EXPECT_THAT(block.scores.at(1), ElementsAre(21, 23)) << "by attempt and rater";
}

TEST(RatingBlock, ATripleOfFourRatersIsFound) {
    RatingTable table;
    for (const int64_t rater : {1, 2, 4}) judge(table, rater, 1, 6);
    judge(table, 3, 6, 9);
    judge(table, 1, 7, 8);
    const RatingBlock block = complete_block(table, 3);
    EXPECT_THAT(block.raters, ElementsAre(1, 2, 4));
    EXPECT_EQ(block.scores.size(), 6u);
}

TEST(RatingBlock, OfAsManyValuesTheMoreAttemptsAreTakenAndThenTheOrderOfRaters) {
    RatingTable table;
    for (const int64_t rater : {1, 2, 3}) judge(table, rater, 1, 4);
    for (const int64_t rater : {4, 5}) judge(table, rater, 11, 16);
    EXPECT_THAT(complete_block(table, 3).raters, ElementsAre(4, 5)) << "2 x 6 and 3 x 4";
    for (const int64_t rater : {6, 7}) judge(table, rater, 21, 26);
    EXPECT_THAT(complete_block(table, 3).raters, ElementsAre(4, 5));
}

TEST(RatingBlock, FewerAttemptsThanNeededAreNone) {
    RatingTable table;
    // Five raters of one attempt are more values than two raters of two.
    for (const int64_t rater : {1, 2, 3, 4, 5}) judge(table, rater, 1, 1);
    for (const int64_t rater : {1, 2}) judge(table, rater, 2, 2);
    EXPECT_THAT(complete_block(table, 3).scores, IsEmpty());
    EXPECT_THAT(complete_block(table, 3).raters, IsEmpty());
    EXPECT_THAT(complete_block(table, 2).raters, ElementsAre(1, 2));
    EXPECT_THAT(complete_block({}, 2).scores, IsEmpty());
    RatingTable alone;
    judge(alone, 1, 1, 9);
    EXPECT_THAT(complete_block(alone, 3).scores, IsEmpty());
}

TEST(RatingBlock, ManyRatersAreGrownFromPairs) {
    RatingTable table;
    for (int64_t rater = 1; rater <= 30; ++rater) judge(table, rater, 10 * rater, 10 * rater + 3);
    for (const int64_t rater : {7, 12, 19, 28}) judge(table, rater, 1001, 1070);
    const RatingBlock block = complete_block(table, 3);
    EXPECT_THAT(block.raters, ElementsAre(7, 12, 19, 28));
    EXPECT_EQ(block.scores.size(), 70u);
}

/// The most values that any group of raters gives.
size_t most_values(const RatingTable& table, int64_t raters, size_t least) {
    size_t most = 0;
    for (unsigned group = 0; group < 1u << raters; ++group) {
        size_t attempts = 0, size = 0;
        for (int64_t r = 0; r < raters; ++r) size += group >> r & 1u;
        for (const auto& [attempt, values] : table) {
            size_t there = 0;
            for (const auto& [rater, value] : values) there += group >> rater & 1u;
            attempts += there == size ? 1 : 0;
        }
        if (size >= 2 && attempts >= least) most = std::max(most, size * attempts);
    }
    return most;
}

TEST(RatingBlock, NoGroupGivesMoreValues) {
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        RatingTable table;
        const auto raters = static_cast<int64_t>(2 + random() % 6);
        for (int64_t attempt = 0; attempt < 12; ++attempt)
            for (int64_t rater = 0; rater < raters; ++rater)
                if (random() % 3 != 0) table[attempt][rater] = 1;
        const RatingBlock block = complete_block(table, 3);
        EXPECT_EQ(block.raters.size() * block.scores.size(), most_values(table, raters, 3));
    }
}

}  // namespace THIS_TEST
