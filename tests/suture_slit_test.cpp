// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of closing a slit: whole attempts, and what is left of the gap.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assessment/closure.h"
#include "assessment/scoring.h"
#include "curriculum/replay.h"
#include "sim/contact/slit_gap.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

/// Through the open slit: Torricelli, 0.6 of an ellipse of 12 x 1 mm less the 50 um that contact
/// keeps walls apart and that count as shut.
double open_leak_ml_min() {
    const double area_m2 = 0.25 * std::numbers::pi * 12e-3 * 1e-3 - 12e-3 * 50e-6;
    return 6e7 * 0.6 * area_m2 * std::sqrt(2 * assessment::kLeakPa / 1005);
}

struct Outcome {
    sim::Recording recording;
    assessment::MetricSet metrics;
    assessment::Score score;
    [[nodiscard]] double value(const char* id) const { return metrics.find(id).value_or(-1); }
};

Outcome judged(const Task& task, sim::Recording recording) {
    Outcome out;
    out.recording = std::move(recording);
    out.metrics = assessment::compute_metrics(out.recording);
    out.score = assessment::score_attempt(task.rubric, out.metrics, out.recording);
    return out;
}

Outcome perform(const std::string& level, uint64_t seed) {
    const Task task = load_task("suture_slit");
    Outcome out = judged(task, test::recorded(task, seed, test::scripted(level)));
    for (const assessment::Metric& metric : out.metrics.values)
        ::testing::Test::RecordProperty(level + "_" + metric.id, std::to_string(metric.value));
    ::testing::Test::RecordProperty(level + "_points", std::to_string(out.score.points));
    return out;
}

/// One attempt of the expert, for all tests of this file.
const Outcome& expert() {
    static const Outcome outcome = perform("expert", 1);
    return outcome;
}

TEST(SutureSlit, AnExpertShutsTheSlit) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_EQ(run.value("bites_done"), 3);
    EXPECT_EQ(run.value("needle_entries"), 3);
    EXPECT_EQ(run.value("thread_cuts"), 0);
    EXPECT_EQ(run.value("torn_volume_mm3"), 0);
    // Open it gapes by 0.95 mm, 0.7 in the mean.
    EXPECT_GT(run.value("slit_shut_percent"), 75);
    EXPECT_LT(run.value("slit_gap_widest_mm"), 0.4);
    EXPECT_LT(run.value("slit_gap_mean_mm"), 0.2);
    EXPECT_LT(run.value("slit_leak_ml_min"), 0.15 * open_leak_ml_min());
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
}

// Neither gets through all three bites: their points end up close to each other.
TEST(SutureSlit, WhoSewsBadlyLeavesItOpenAndScoresFarLess) {
    for (const char* level : {"intermediate", "novice"}) {
        const Outcome bad = perform(level, 1);
        EXPECT_LT(bad.score.points, expert().score.points - 30) << level;
        EXPECT_NE(bad.score.verdict, assessment::Verdict::kPassed) << level;
        EXPECT_GT(bad.value("slit_gap_mean_mm"), 2 * expert().value("slit_gap_mean_mm")) << level;
        EXPECT_LT(bad.value("slit_shut_percent"), 60) << level;
        EXPECT_EQ(bad.value("over_force_count"), 0) << level << " tears nothing by brute force";
    }
}

TEST(SutureSlit, WhoDoesNothingLeavesItOpen) {
    Task task = load_task("suture_slit");
    task.time_limit_s = 0.5;
    const Outcome outcome = judged(task, test::recorded(task, 1, test::scripted("expert")));
    EXPECT_EQ(outcome.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(outcome.score.points, 0);
    EXPECT_NEAR(outcome.value("slit_gap_widest_mm"), 0.95, 0.03);
    // Some 3 % less: fluid rubs on the walls as well.
    EXPECT_LT(outcome.value("slit_leak_ml_min"), open_leak_ml_min());
    EXPECT_GT(outcome.value("slit_leak_ml_min"), 0.95 * open_leak_ml_min());
}

TEST(SutureSlit, IsReplayedBitForBitOnOtherNumbersOfThreadsAndItsWallsNeverPassEachOther) {
    Replay replay(expert().recording, 2);
    const sim::Scene& scene = replay.scene();
    double deepest = 0;
    while (replay.step()) {
        const sim::State& state = replay.state();
        if (state.frame % 20 != 0) continue;
        for (const sim::Slit::Station& s : scene.slit.stations) {
            for (size_t level = 0; level < 2; ++level) {
                // Along +y: the left wall lies at smaller x.
                const double apart = (sim::position(state.body, s.right[level]) -
                                      sim::position(state.body, s.left[level]))
                                         .x();
                deepest = std::max(deepest, -apart);
            }
        }
    }
    EXPECT_TRUE(replay.result().identical) << replay.result().message;
    EXPECT_EQ(replay.result().frames, std::ssize(expert().recording.inputs));
    EXPECT_LT(deepest, 1e-4);
    RecordProperty("deepest_um", std::to_string(1e6 * deepest));
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
