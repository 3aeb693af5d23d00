// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/cutting/attempt_progress.h"

namespace placode::assessment {
namespace THIS_TEST {

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

TEST(Scoring, WhatBeganAtAStageHasNoPoints) {
    Rubric rubric;
    rubric.id = "r";
    rubric.version = 3;
    rubric.items = {item("dwell", "dwell_s", "x")};
    rubric.items[0].points_per_unit = 1;
    sim::Recording recording;
    recording.header.stage = 2;
    const Score score = score_attempt(rubric, {1, {{"dwell_s", 0}}}, recording);
    EXPECT_EQ(score.points, 0);
    EXPECT_EQ(score.verdict, Verdict::kNotYet);
    EXPECT_EQ(score.rubric_id, "r");
    EXPECT_EQ(score.rubric_version, 3);
    ASSERT_EQ(score.reasons.size(), 1U);
    EXPECT_EQ(score.reasons[0].item, kGivenItem);
    EXPECT_EQ(score.reasons[0].points, 0);
    EXPECT_EQ(score.reasons[0].text, "Not scored: begun at stage 2, what came before was given.");
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

TEST(Scoring, AMetricThatIsMissingCostsTheMostOfItsLine) {
    Rubric rubric;
    rubric.items = {item("a", "sparc", "a"), item("b", "target_error_mm", "b")};
    rubric.items[0].below = true;
    rubric.items[0].points_fixed = 50;
    rubric.items[1].points_per_unit = 20;
    rubric.items[1].max_points = 12;
    const Score score = score_attempt(rubric, {}, {});
    EXPECT_DOUBLE_EQ(score.points, 38);
    ASSERT_EQ(score.reasons.size(), 2u);
    EXPECT_EQ(score.reasons[1].text,
              "It could not be measured and counts in full: Distance from targets.");
}

TEST(Scoring, WhatWasNotRecordedIsSaidAndIsNoPass) {
    Rubric rubric;
    rubric.items = {item("buried", "buried_s", "b")};
    rubric.items[0].points_per_unit = 2;
    const Score score = score_attempt(rubric, {}, {});  // without the ledger's mark
    EXPECT_DOUBLE_EQ(score.points, 100);
    EXPECT_EQ(score.verdict, Verdict::kNotYet);
    ASSERT_EQ(score.reasons.size(), 1u);
    EXPECT_EQ(score.reasons[0].text, "Not recorded, so this is no pass: Tip stuck in tissue.");
}

TEST(Scoring, PointsAreEarnedByTheShareThatWasDone) {
    Rubric rubric;
    rubric.items = {item("free", "released_deg", "{value}"),
                    item("out", "resected_percent", "{value}"),
                    item("touched", "placode_contacts", "{value}")};
    rubric.items[0].threshold = 360;
    rubric.items[1].threshold = 90;
    rubric.items[0].earns = 3;
    rubric.items[1].earns = 1;
    rubric.items[0].below = rubric.items[1].below = true;
    rubric.items[2].points_per_unit = 2;
    const auto score = [&](double free, double out, double touched) {
        return score_attempt(
            rubric,
            {1, {{"released_deg", free}, {"resected_percent", out}, {"placode_contacts", touched}}},
            {});
    };
    EXPECT_NEAR(score(360, 90, 0).points, 100, 1e-9);
    EXPECT_NEAR(score(180, 45, 0).points, 50, 1e-9);
    EXPECT_NEAR(score(360, 0, 0).points, 75, 1e-9);
    EXPECT_NEAR(score(0, 0, 0).points, 0, 1e-9);
    EXPECT_NEAR(score(180, 45, 5).points, 40, 1e-9);
    double lost = 0;
    for (const Reason& reason : score(180, 45, 5).reasons) lost += reason.points;
    EXPECT_NEAR(lost, 60, 1e-9) << "every lost point has its reason";
}

TEST(Scoring, AnAttemptInWhichNothingWasDoneIsNotAttempted) {
    Rubric rubric;
    rubric.items = {item("touched", "placode_contacts", "{value}")};
    rubric.items[0].points_per_unit = 2;
    rubric.attempted_by = {"energy_j", "placode_contacts"};
    const Score idle = score_attempt(rubric, {1, {{"energy_j", 0}, {"placode_contacts", 0}}}, {});
    EXPECT_EQ(idle.verdict, Verdict::kNotAttempted);
    EXPECT_EQ(idle.points, 0);
    ASSERT_EQ(idle.reasons.size(), 1u);
    EXPECT_EQ(idle.reasons[0].text, "Nothing was done: this attempt does not count.");
    EXPECT_EQ(score_attempt(rubric, {}, {}).verdict, Verdict::kNotAttempted);
    EXPECT_EQ(score_attempt(rubric, {1, {{"energy_j", 0.1}, {"placode_contacts", 0}}}, {}).verdict,
              Verdict::kPassed);
    EXPECT_STREQ(verdict_name(Verdict::kNotAttempted), "not attempted");
}

TEST(Scoring, NumbersOfAnySizeArePrintedWhole) {
    Rubric rubric;
    rubric.items = {item("pressed", "placode_peak_force_mn", "{value} mN")};
    rubric.items[0].points_per_unit = 1;
    const auto text = [&](double mn) {
        return score_attempt(rubric, {1, {{"placode_peak_force_mn", mn}}}, {}).reasons[0].text;
    };
    EXPECT_EQ(text(1e300), "1e+300 mN");
    EXPECT_EQ(text(2.5e6), "2.5e+06 mN");
    EXPECT_EQ(text(123456), "123456 mN");
    EXPECT_EQ(text(0.25), "0.25 mN");
}

TEST(Scoring, TheLargestGapIsShownAtItsPlace) {
    Rubric rubric;
    rubric.items = {item("gap", "ring_completeness_percent", "open{where}")};
    rubric.items[0].below = true;
    rubric.items[0].threshold = 100;
    rubric.items[0].points_fixed = 1;
    sim::Recording recording;
    recording.samples.resize(1);
    recording.samples[0].cut_fraction = 0.83F;
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

TEST(Scoring, TheLedgersOwnGapComesFirst) {
    Rubric rubric;
    rubric.items = {item("gap", "ring_completeness_percent", "{value} %, open{where}")};
    rubric.items[0].below = true;
    rubric.items[0].threshold = 100;
    rubric.items[0].points_per_unit = 1;
    sim::Recording recording;
    recording.samples.resize(1);
    recording.header.geometry.planned_contour = {{0.006, 0, 0}, {0, 0.006, 0}, {-0.006, 0, 0}};
    recording.events = {event(sim::EventKind::kRingGap, 9, 2, 0.75F, 0, 0),
                        event(sim::EventKind::kRingGap, 9, 0.001F, 0, 0.006F, 0),
                        event(sim::EventKind::kRingGap, 9, 0.003F, 0, 0, 0.006F)};
    recording.events[1].element = 1;
    recording.events[2].element = 2;
    const MetricSet metrics = compute_metrics(recording);
    EXPECT_NEAR(*metrics.find("largest_gap_mm"), 3, 1e-6);
    EXPECT_EQ(metrics.find("gap_count"), 2);
    EXPECT_EQ(score_attempt(rubric, metrics, recording).reasons[0].text, "75 %, open at 9 o'clock");
}

TEST(Scoring, WhatStillHoldsAndWhatIsLeftAreShownWhereTheyAre) {
    Rubric rubric;
    rubric.items = {item("held", "released_deg", "{value}{where}"),
                    item("left", "resected_percent", "{value}{where}")};
    for (RubricItem& each : rubric.items) {
        each.below = true;
        each.threshold = 360;
        each.points_per_unit = 0.1;
    }
    sim::Recording recording;
    recording.samples.resize(1);
    recording.header.tools.resize(1);
    recording.header.tools[0].kind = sim::ToolKind::kScissors;
    recording.header.geometry.planned_contour = {{0.006, 0, 0}, {0, 0.006, 0}, {-0.006, 0, 0}};
    // Sectors count from 12 o'clock towards 9; all but those around 6 o'clock are free.
    for (int s = 0; s < 72; ++s)
        if (s < 33 || s > 38)
            recording.events.push_back(
                event(sim::EventKind::kSectorFree, 1 + s, static_cast<float>(s), 0, 0, 0));
    recording.events.push_back(event(sim::EventKind::kTakenOut, 80, 1e-9F, 0.625F, 0, -0.005F));
    const MetricSet metrics = compute_metrics(recording);
    EXPECT_NEAR(*metrics.find("resected_percent"), 62.5, 1e-4);
    const Score score = score_attempt(rubric, metrics, recording);
    ASSERT_EQ(score.reasons.size(), 2u);
    EXPECT_EQ(score.reasons[0].text, "62.5 at 3 o'clock");
    EXPECT_EQ(score.reasons[1].text, "330 at 6 o'clock");
}

TEST(Scoring, WhatNeverHungIsNotReleased) {
    sim::Recording recording;
    recording.samples.resize(1);
    recording.header.geometry.planned_contour = {{0.006, 0, 0}, {0, 0.006, 0}, {-0.006, 0, 0}};
    const auto released = [&recording](int first, int end, double time_s) {
        for (int s = first; s < end; ++s)
            recording.events.push_back(
                event(sim::EventKind::kSectorFree, time_s, static_cast<float>(s), 0, 0, 0));
        return *compute_metrics(recording).find("released_deg");
    };
    // Every sector is looked at once in the first 72 frames, before anything can be cut.
    EXPECT_EQ(released(0, 12, 0.072), 0);
    EXPECT_EQ(released(12, 42, 9), 180) << "30 of the 60 that hung";
    EXPECT_EQ(released(42, 72, 10), 360);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
