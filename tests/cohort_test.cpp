// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/cohort.h"

#include <gtest/gtest.h>

#include <vector>

namespace placode::assessment {
namespace THIS_TEST {

/// Passed from 70 points on.
CohortCell judge(const std::vector<double>& points) {
    std::vector<TrialOutcome> outcomes;
    for (const double each : points) outcomes.push_back({each, each >= 70});
    return judge_standing(outcomes);
}

TEST(Cohort, NobodyIsStuckBeforeFiveAttempts) {
    EXPECT_EQ(judge({}).standing, Standing::kNotTried);
    EXPECT_EQ(judge({40, 40, 40, 40}).standing, Standing::kLearning);
    EXPECT_EQ(judge({40, 40, 40, 40, 40}).standing, Standing::kStuck);
}

TEST(Cohort, WhoGetsBetterIsLearningHoweverLong) {
    EXPECT_EQ(judge({30, 35, 40, 45, 50, 55, 60}).standing, Standing::kLearning);
    EXPECT_EQ(judge({60, 59, 58, 61, 62}).standing, Standing::kStuck);
}

TEST(Cohort, OneBadDayIsNoRegression) {
    EXPECT_EQ(judge({80, 60}).standing, Standing::kLearning);
    EXPECT_EQ(judge({80, 60, 60}).standing, Standing::kRegressed);
    EXPECT_EQ(judge({80, 60, 60, 75}).standing, Standing::kPassing);
}

TEST(Cohort, MeansTheLastThreeAndNamesTheStanding) {
    EXPECT_DOUBLE_EQ(judge({}).recent, 0);
    EXPECT_DOUBLE_EQ(judge({50, 60}).recent, 55);
    EXPECT_DOUBLE_EQ(judge({10, 70, 80, 90}).recent, 80);
    EXPECT_STREQ(standing_name(judge({80, 60, 60}).standing), "regressed");
    EXPECT_STREQ(standing_name(judge({40, 40, 40, 40, 40}).standing), "stuck");
    EXPECT_STREQ(standing_name(judge({}).standing), "not tried");
}

TEST(Cohort, CountsTheStreakUpToNow) {
    const CohortCell cell = judge({80, 60, 75, 90});
    EXPECT_EQ(cell.streak, 2);
    EXPECT_EQ(cell.attempts, 4);
    EXPECT_DOUBLE_EQ(cell.best, 90);
    EXPECT_DOUBLE_EQ(cell.last, 90);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
