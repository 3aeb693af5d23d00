// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/label_rows.h"

#include <gtest/gtest.h>

namespace placode::view {
namespace THIS_TEST {

constexpr double kTop = 0, kBottom = 800, kGap = 2;

double row(const std::vector<LabelBox>& placed, const LabelBox& wanted) {
    return free_row(placed, wanted, kTop, kBottom, kGap);
}

bool apart(const LabelBox& a, const LabelBox& b) {
    return a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.h <= b.y || b.y + b.h <= a.y;
}

TEST(LabelRows, WhatIsFreeStaysWhereItIs) {
    EXPECT_EQ(row({}, {10, 100, 60, 20}), 100);
    EXPECT_EQ(row({{10, 100, 60, 20}}, {70, 100, 60, 20}), 100);  // side by side
    EXPECT_EQ(row({{10, 100, 60, 20}}, {10, 120, 60, 20}), 120);  // one below the other
}

// The tip's "0.7 mm" and the ring's "straight down", as they were seen.
TEST(LabelRows, ALabelGoesBesideTheOneInItsWay) {
    const LabelBox ring{682, 470, 84, 20};
    LabelBox gauge{636, 453, 52, 20};
    gauge.y = row({ring}, gauge);
    EXPECT_TRUE(apart(ring, gauge));
    EXPECT_EQ(gauge.y, 470 - 20 - kGap);  // above is nearer
}

TEST(LabelRows, ManyAtOneSpotAreAllReadable) {
    std::vector<LabelBox> placed;
    for (int i = 0; i < 5; ++i) {
        LabelBox label{100, 200, 50, 18};
        label.y = row(placed, label);
        for (const LabelBox& other : placed) EXPECT_TRUE(apart(label, other)) << i;
        placed.push_back(label);
    }
}

TEST(LabelRows, NothingLeavesTheWindow) {
    EXPECT_EQ(row({{0, 780, 50, 18}}, {0, 782, 50, 18}), 780 - 18 - kGap);
    EXPECT_EQ(row({{0, 0, 50, 18}}, {0, 2, 50, 18}), 18 + kGap);
}

TEST(LabelRows, AGaugeStandsOverNoRing) {
    const std::vector<LabelBox> rings{{100, 100, 40, 40}};
    const LabelBox over{110, 60, 12, 60}, beside{150, 60, 12, 60};
    EXPECT_EQ(first_free(rings, {over, beside}).x, beside.x);
    EXPECT_EQ(first_free({}, {over, beside}).x, over.x);
    EXPECT_EQ(first_free(rings, {over, over}).x, over.x) << "it has to stand somewhere";
}

}  // namespace THIS_TEST
}  // namespace placode::view
