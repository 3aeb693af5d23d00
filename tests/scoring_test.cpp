// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring.h"

#include <gtest/gtest.h>

#include <cmath>

namespace placode::assessment {
namespace {

RubricItem item(const char* id, const char* metric, const char* reason) {
    RubricItem i;
    i.id = id;
    i.metric = metric;
    i.reason = reason;
    return i;
}

sim::Event event(sim::EventKind kind, double time_s, float value, float value2, float x, float y) {
    sim::Event e;
    e.kind = kind;
    e.time_s = time_s;
    e.value = value;
    e.value2 = value2;
    e.rest_position_m = {x, y, 0};
    return e;
}

TEST(Scoring, TheClockHasCranialAtTwelveAndTheFetusRightAtThree) {
    EXPECT_EQ(clock_hour(1, 0), 12);
    EXPECT_EQ(clock_hour(0, -1), 3);
    EXPECT_EQ(clock_hour(-1, 0), 6);
    EXPECT_EQ(clock_hour(0, 1), 9);
    EXPECT_EQ(clock_hour(-0.5, -0.866), 4);
    EXPECT_EQ(clock_hour(1, 0.01), 12);
}

TEST(Scoring, NothingWrongLeavesAllPoints) {
    Rubric rubric;
    rubric.items = {item("dwell", "dwell_s", "x")};
    rubric.items[0].points_per_unit = 1;
    const Score score = score_attempt(rubric, {1, {{"dwell_s", 0}}}, {});
    EXPECT_DOUBLE_EQ(score.points, 100);
    EXPECT_EQ(score.verdict, Verdict::kPassed);
    EXPECT_TRUE(score.reasons.empty());
}

TEST(Scoring, AReasonNamesValuePlaceAndTime) {
    Rubric rubric;
    rubric.id = "r";
    rubric.version = 7;
    rubric.items = {
        item("dwell", "dwell_s", "The needle rested {value} {unit} on one spot{where}.")};
    rubric.items[0].points_per_unit = 1;
    sim::Recording recording;
    recording.events = {event(sim::EventKind::kDwell, 20, 1.2f, 0, 0.01f, 0),
                        event(sim::EventKind::kDwell, 30, 2.0f, 0, -0.005f, -0.00866f)};
    const Score score = score_attempt(rubric, {1, {{"dwell_s", 3.2}}}, recording);
    ASSERT_EQ(score.reasons.size(), 1u);
    EXPECT_EQ(score.reasons[0].text, "The needle rested 3.2 s on one spot at 4 o'clock.");
    EXPECT_DOUBLE_EQ(score.reasons[0].points, 3.2);
    EXPECT_NEAR(score.reasons[0].time_s, 28, 1e-9);  // the start of the longest one
    EXPECT_NEAR(score.points, 96.8, 1e-12);
    EXPECT_EQ(score.rubric_id, "r");
    EXPECT_EQ(score.rubric_version, 7);
}

TEST(Scoring, ThresholdFixedPointsAndCapAddUp) {
    Rubric rubric;
    rubric.items = {item("pressed", "placode_peak_force_mn", "{value} mN, {points} points")};
    RubricItem& pressed = rubric.items[0];
    pressed.threshold = 20;
    pressed.points_fixed = 10;
    pressed.points_per_unit = 0.5;
    pressed.max_points = 20;
    const auto lost = [&](double mn) {
        return 100 - score_attempt(rubric, {1, {{"placode_peak_force_mn", mn}}}, {}).points;
    };
    EXPECT_DOUBLE_EQ(lost(20), 0);
    EXPECT_DOUBLE_EQ(lost(24), 12);
    EXPECT_DOUBLE_EQ(lost(500), 20);
    EXPECT_EQ(score_attempt(rubric, {1, {{"placode_peak_force_mn", 24}}}, {}).reasons[0].text,
              "24 mN, 12 points");
}

TEST(Scoring, BelowTheThresholdCostsWhereMoreIsBetter) {
    Rubric rubric;
    rubric.items = {item("incomplete", "ring_completeness_percent", "{value} %")};
    rubric.items[0].below = true;
    rubric.items[0].threshold = 99;
    rubric.items[0].points_per_unit = 0.72;
    EXPECT_NEAR(score_attempt(rubric, {1, {{"ring_completeness_percent", 89}}}, {}).points,
                100 - 7.2, 1e-9);
    EXPECT_DOUBLE_EQ(score_attempt(rubric, {1, {{"ring_completeness_percent", 99.5}}}, {}).points,
                     100);
}

TEST(Scoring, ACriticalErrorFailsWhateverTheScore) {
    Rubric rubric;
    rubric.items = {item("cut", "placode_cut_mm3", "cut {times}{where}")};
    rubric.items[0].critical = true;
    sim::Recording recording;
    recording.events = {event(sim::EventKind::kVaporised, 4, 1e-10f, 0.0003f, 0, 0.002f)};
    recording.events[0].tissue = sim::Tissue::kPlacode;
    const Score score = score_attempt(rubric, {1, {{"placode_cut_mm3", 0.1}}}, recording);
    EXPECT_DOUBLE_EQ(score.points, 100);
    EXPECT_EQ(score.verdict, Verdict::kFailed);
    ASSERT_EQ(score.reasons.size(), 1u);
    EXPECT_TRUE(score.reasons[0].critical);
    EXPECT_EQ(score.reasons[0].text, "cut once at 9 o'clock");
    EXPECT_DOUBLE_EQ(score.reasons[0].time_s, 4);
}

TEST(Scoring, ReasonsComeMostCostlyFirstAndPointsStopAtZero) {
    Rubric rubric;
    rubric.items = {item("a", "dwell_s", "a"), item("b", "over_force_count", "b")};
    rubric.items[0].points_per_unit = 1;
    rubric.items[1].points_per_unit = 90;
    const Score score = score_attempt(rubric, {1, {{"dwell_s", 15}, {"over_force_count", 5}}}, {});
    ASSERT_EQ(score.reasons.size(), 2u);
    EXPECT_EQ(score.reasons[0].item, "b");
    EXPECT_DOUBLE_EQ(score.reasons[0].points, 100);
    EXPECT_DOUBLE_EQ(score.points, 0);
    EXPECT_EQ(score.verdict, Verdict::kNotYet);
}

TEST(Scoring, AMetricThatIsNotKnownCostsNothing) {
    Rubric rubric;
    rubric.items = {item("a", "sparc", "a")};
    rubric.items[0].below = true;
    rubric.items[0].points_fixed = 50;
    EXPECT_DOUBLE_EQ(score_attempt(rubric, {}, {}).points, 100);
}

TEST(Scoring, TheLargestGapIsShownAtItsPlace) {
    Rubric rubric;
    rubric.items = {item("gap", "ring_completeness_percent", "open{where}")};
    rubric.items[0].below = true;
    rubric.items[0].threshold = 100;
    rubric.items[0].points_fixed = 1;
    sim::Recording recording;
    for (int i = 0; i < 360; ++i) {
        const double a = i * M_PI / 180;
        recording.header.geometry.planned_contour.emplace_back(0.006 * std::cos(a),
                                                               0.006 * std::sin(a), 0);
        // Everything but 240 to 300 degrees (fetus' right side, 3 o'clock) is cut.
        if (i % 2 == 0 && (i < 240 || i > 300)) {
            recording.events.push_back(event(sim::EventKind::kVaporised, i, 0.009e-9f, 0.0004f,
                                             static_cast<float>(0.006 * std::cos(a)),
                                             static_cast<float>(0.006 * std::sin(a))));
        }
    }
    const MetricSet metrics = compute_metrics(recording);
    const Score score = score_attempt(rubric, metrics, recording);
    ASSERT_EQ(score.reasons.size(), 1u);
    EXPECT_EQ(score.reasons[0].text, "open at 3 o'clock");
}

}  // namespace
}  // namespace placode::assessment
