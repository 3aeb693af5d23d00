// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metric_quality.h"

#include <gmock/gmock.h>

#include "assessment/rank_tests.h"
#include "assessment/reliability.h"

using namespace placode::assessment;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

/// Novices take about 100 s, experts about 50 s, everybody within 2 s of the own mean.
std::vector<Repeats> sound() {
    return {{0, {96, 95}}, {0, {105, 104}}, {0, {110, 111}}, {0, {100, 98}},
            {1, {50, 51}}, {1, {55, 54}},   {1, {45, 46}},   {1, {52, 50}}};
}

TEST(MetricQuality, AMetricThatSeparatesAndRepeatsHasEvidence) {
    const auto quality = metric_quality("task_time_s", Direction::kLowerIsBetter, sound(), 2);
    EXPECT_EQ(quality.novices, 4);
    EXPECT_EQ(quality.experts, 4);
    // The same numbers as the tests they come from.
    const std::vector<double> novices{-95.5, -104.5, -110.5, -99},
        experts{-50.5, -54.5, -45.5, -51};
    EXPECT_DOUBLE_EQ(*quality.g, mann_whitney(experts, novices).hedges_g);
    EXPECT_GT(*quality.g, 5);
    EXPECT_DOUBLE_EQ(*quality.cliff_delta, 1);
    Scores rows;
    for (const auto& person : sound()) rows.push_back(person.values);
    EXPECT_DOUBLE_EQ(*quality.icc, intraclass_correlation(rows).icc2.icc);
    EXPECT_DOUBLE_EQ(*quality.ceiling_percent, 100.0 / 16);
    EXPECT_TRUE(quality.evidence);
    EXPECT_THAT(quality.why, IsEmpty());
}

TEST(MetricQuality, TheBetterSideDecidesTheSign) {
    const auto higher = metric_quality("x", Direction::kHigherIsBetter, sound(), 2);
    EXPECT_LT(*higher.g, -5);
    EXPECT_FALSE(higher.evidence);
    EXPECT_THAT(higher.why, HasSubstr("levels do not differ"));
}

TEST(MetricQuality, EveryWeaknessIsSaid) {
    auto scattered = sound();
    for (size_t i = 0; i < scattered.size(); ++i) scattered[i].values = {i % 2 ? 10.0 : 90.0, 50};
    const auto poor = metric_quality("x", Direction::kLowerIsBetter, scattered, 2);
    EXPECT_FALSE(poor.repeatable);
    EXPECT_THAT(poor.why, HasSubstr("repeats of the same person"));

    const std::vector<Repeats> flat{{0, {0, 0}}, {0, {0, 1}}, {1, {0, 0}}, {1, {0, 0}}};
    const auto ceiling = metric_quality("x", Direction::kLowerIsBetter, flat, 2);
    EXPECT_TRUE(ceiling.ceiling);
    EXPECT_DOUBLE_EQ(*ceiling.ceiling_percent, 87.5);
    EXPECT_THAT(ceiling.why, HasSubstr("at the best one"));

    const auto same = metric_quality("x", Direction::kLowerIsBetter,
                                     {{0, {3, 3}}, {0, {3, 3}}, {1, {3, 3}}, {1, {3, 3}}}, 2);
    EXPECT_FALSE(same.evidence);
    EXPECT_FALSE(same.g);
    EXPECT_FALSE(same.icc);

    const auto perfect = metric_quality("x", Direction::kLowerIsBetter,
                                        {{0, {3, 3}}, {0, {4, 4}}, {1, {1, 1}}, {1, {2, 2}}}, 2);
    EXPECT_EQ(perfect.icc, 1) << "everybody repeats exactly";

    const auto few = metric_quality("x", Direction::kLowerIsBetter, {{0, {1}}, {1, {2}}}, 2);
    EXPECT_THAT(few.why, HasSubstr("fewer than 2 novices or experts"));
    EXPECT_THAT(few.why, HasSubstr("enough repeats"));
    EXPECT_THAT(metric_quality("x", Direction::kLowerIsBetter, {}, 2).why, HasSubstr("fewer"));
}

}  // namespace THIS_TEST
