// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/bimanual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

using placode::assessment::bimanual_dexterity;

namespace THIS_TEST {

TEST(Bimanual, TwoSinesCorrelateByTheCosineOfTheirPhase) {
    std::vector<double> left, right;
    const double phase = std::numbers::pi / 3;
    for (int i = 0; i < 1000; ++i) {
        const double turn = 2 * std::numbers::pi * i / 100;
        left.push_back(40 + 20 * std::cos(turn));
        right.push_back(40 + 20 * std::cos(turn + phase));
    }
    const auto b = bimanual_dexterity(left, right, 0.01, 40);
    EXPECT_NEAR(b.pearson_r, 0.5, 1e-12);
    // Both above their mean for (pi - phase) of the turn; 100 samples a turn.
    EXPECT_NEAR(b.both, 1.0 / 3, 0.02);
    EXPECT_NEAR(b.both + b.left_only + b.right_only + b.neither, 1, 1e-12);
    EXPECT_NEAR(b.balance, 1, 0.002);
}

TEST(Bimanual, AHandAtRestDoesNotDivideByZero) {
    const std::vector<double> moving{10, 20, 30}, still{0, 0, 0};
    const auto b = bimanual_dexterity(moving, still, 0.01, 5);
    EXPECT_EQ(b.pearson_r, 0);
    EXPECT_EQ(b.path_ratio, 0);
    EXPECT_EQ(b.balance, 0);
    EXPECT_EQ(b.left_only, 1);
}

}  // namespace THIS_TEST
