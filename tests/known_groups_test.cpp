// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/known_groups.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace placode::assessment {
namespace THIS_TEST {

TEST(KnownGroups, AnAreaIsTheShareOfPairsThatTheExpertWins) {
    const std::vector<double> novices{10, 20, 90}, experts{80, 95, 100}, between{50, 60, 70};
    const KnownGroups groups = known_groups(novices, between, experts);
    EXPECT_NEAR(groups.expert_novice.auc, 8.0 / 9, 1e-12);
    EXPECT_FALSE(groups.expert_novice.perfect);
    EXPECT_LT(groups.expert_novice.ci95.low, 8.0 / 9);
    EXPECT_NEAR(groups.intermediate_novice->auc, 6.0 / 9, 1e-12);
    EXPECT_EQ(groups.expert_intermediate->auc, 1);
    EXPECT_EQ(groups.novice_median, 20);
    EXPECT_EQ(groups.intermediate_median, 60);
    EXPECT_EQ(groups.between, true);
}

TEST(KnownGroups, WhereAllAreApartTheIntervalIsNotAPoint) {
    const std::vector<double> low(30, 40), high(30, 90);
    const Separation apart = known_groups(low, {}, high).expert_novice;
    EXPECT_TRUE(apart.perfect);
    EXPECT_NEAR(apart.ci95.low, 0.8843, 1e-4);  // Clopper & Pearson, 30 of 30
    EXPECT_EQ(apart.ci95.high, 1);
}

TEST(KnownGroups, AGroupAboveTheExpertsIsNotBetween) {
    const std::vector<double> low{1, 2}, high{5, 6}, odd{8, 9};
    EXPECT_EQ(known_groups(low, odd, high).between, false);
    EXPECT_FALSE(known_groups(low, {}, high).between.has_value());
    EXPECT_THROW((void)known_groups({}, odd, high), std::invalid_argument);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
