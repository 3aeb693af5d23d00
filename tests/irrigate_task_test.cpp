// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of washing a lesion: whole attempts, what a bad hand loses, replay.
#include <gtest/gtest.h>

#include "assessment/scoring.h"
#include "tests/judged_attempt.h"

namespace placode::curriculum {
namespace THIS_TEST {

using test::Outcome;
using test::performed;

Outcome perform(const Task& task, const std::string& level, uint64_t seed = 1) {
    return performed(task, level, seed, {"wash_"});
}

/// One attempt of the expert, for all tests of this file.
const Outcome& expert() {
    static const Outcome outcome = perform(load_task("irrigate"), "expert");
    return outcome;
}

TEST(IrrigateTask, AnExpertLeavesAClearDryFieldAndSparesThePlacode) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_EQ(run.value("wash_cleared_percent"), 100);
    EXPECT_LT(run.value("wash_jet_peak_pa"), 500);
    EXPECT_EQ(run.value("wash_jet_over_s"), 0);
    EXPECT_LT(run.value("wash_fluid_left_mm3"), 25);
    EXPECT_LT(run.value("wash_hidden_percent"), 10);
    EXPECT_EQ(run.value("placode_contacts"), 0);
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
}

TEST(IrrigateTask, LevelsDifferByWhatJetAndSuctionDo) {
    const Task task = load_task("irrigate");
    const Outcome middle = perform(task, "intermediate"), bad = perform(task, "novice");
    EXPECT_GT(expert().score.points, middle.score.points);
    EXPECT_GT(middle.score.points, bad.score.points + 5);
    EXPECT_NE(bad.score.verdict, assessment::Verdict::kPassed) << bad.score.points;
    EXPECT_GT(bad.value("wash_jet_peak_pa"), expert().value("wash_jet_peak_pa"));
    EXPECT_GT(bad.value("wash_suction_held_s"), expert().value("wash_suction_held_s"));
}

TEST(IrrigateTask, WhoDoesNothingIsNotJudged) {
    Task task = load_task("irrigate");
    task.time_limit_s = 0.5;
    const Outcome nothing = perform(task, "expert");
    EXPECT_EQ(nothing.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(nothing.score.points, 0);
    EXPECT_EQ(nothing.value("wash_cleared_percent"), 0);
}

TEST(IrrigateTask, IsReplayedBitForBitOnOtherNumbersOfThreads) {
    test::expect_replays_alike(expert().recording, {2, 3, 1});
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
