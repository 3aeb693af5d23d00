// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/themes.h"

#include <gtest/gtest.h>

namespace placode::assessment {
namespace THIS_TEST {

using Judgement = ThemeResult::Judgement;

RubricItem item(const std::string& id, const std::string& metric) {
    RubricItem one;
    one.id = id;
    one.metric = metric;
    return one;
}

Reason lost(const std::string& id, double points, bool critical = false) {
    Reason one;
    one.item = id;
    one.points = points;
    one.critical = critical;
    return one;
}

Rubric rubric() {
    Rubric one;
    one.items = {item("touched", "placode_contacts"),
                 item("near", "toward_placode_mm"),
                 item("open", "ring_completeness_percent"),
                 item("air", "energy_in_air_count"),
                 item("time", "task_time_s"),
                 item("torn", "torn_skin_mm3")};
    return one;
}

const ThemeResult& of(const std::vector<ThemeResult>& results, Theme theme) {
    for (const auto& each : results)
        if (each.theme == theme) return each;
    throw std::runtime_error("theme is missing");
}

TEST(Themes, KnowWhatAMetricIsAbout) {
    EXPECT_EQ(theme_of("placode_contact_s"), Theme::kPlacode);
    EXPECT_EQ(theme_of("toward_placode_mm"), Theme::kIncision);
    EXPECT_EQ(theme_of("energy_near_placode_s"), Theme::kEnergy);
    EXPECT_EQ(theme_of("crush_count"), Theme::kTissue);
    EXPECT_EQ(theme_of("lift_hold_s"), Theme::kRelease);
    EXPECT_EQ(theme_of("task_time_s"), Theme::kTime);
    EXPECT_EQ(theme_of("trace_error_p95_mm"), Theme::kPrecision);
    EXPECT_EQ(theme_of("steps_done_percent"), Theme::kSteps);
}

TEST(Themes, SumsTheLinesOfATheme) {
    const auto results =
        judge_themes(rubric(), {lost("near", 3), lost("open", 4), lost("air", 1)}, {});
    EXPECT_DOUBLE_EQ(of(results, Theme::kIncision).lost, 7);
    EXPECT_EQ(of(results, Theme::kIncision).judgement, Judgement::kWeakness);
    EXPECT_EQ(of(results, Theme::kEnergy).judgement, Judgement::kNeither);
    EXPECT_EQ(of(results, Theme::kPlacode).judgement, Judgement::kStrength);
    EXPECT_FALSE(of(results, Theme::kPlacode).before.has_value());
    EXPECT_EQ(results.front().theme, Theme::kIncision) << "what to work on comes first";
}

TEST(Themes, ACriticalErrorIsAWeaknessWhateverItCosts) {
    const auto results = judge_themes(rubric(), {lost("touched", 0, true), lost("open", 40)}, {});
    EXPECT_EQ(results.front().theme, Theme::kPlacode);
    EXPECT_TRUE(results.front().critical);
}

TEST(Themes, LosingLessThanBeforeIsAStrength) {
    const auto results =
        judge_themes(rubric(), {lost("air", 2)}, {{lost("air", 4)}, {lost("air", 6)}});
    EXPECT_DOUBLE_EQ(of(results, Theme::kEnergy).before.value(), 5);
    EXPECT_EQ(of(results, Theme::kEnergy).judgement, Judgement::kStrength);
}

TEST(Themes, WhatTheRubricDoesNotAskForIsNotJudged) {
    const auto results = judge_themes(rubric(), {}, {});
    for (const auto& each : results) EXPECT_NE(each.theme, Theme::kRelease);
    EXPECT_EQ(results.size(), 5U);
}

TEST(Themes, WhereNothingWasDoneNothingWasDoneWell) {
    EXPECT_TRUE(judge_themes(rubric(), {lost(std::string(kNotAttemptedItem), 100)}, {}).empty());
}

TEST(Themes, ABuriedTipAndTornTissueAreAboutGentleness) {
    for (const char* metric : {"buried_s", "buried_count", "torn_volume_mm3", "over_stretch_mm3_s"})
        EXPECT_EQ(theme_of(metric), Theme::kTissue) << metric;
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
