// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of undermining skin beside a wound: whole attempts, what a bad hand tears, replay.
#include <gtest/gtest.h>

#include "assessment/scoring.h"
#include "tests/judged_attempt.h"

namespace placode::curriculum {
namespace THIS_TEST {

using test::Outcome;
using test::performed;

Outcome perform(const Task& task, const std::string& level, uint64_t seed = 1) {
    return performed(task, level, seed, {"undermine_", "closing_", "torn_"});
}

/// One attempt of the expert, for all tests of this file.
const Outcome& expert() {
    static const Outcome outcome = perform(load_task("undermine"), "expert");
    return outcome;
}

TEST(UndermineTask, AnExpertFreesBothSidesAndTheWoundClosesMoreEasily) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_GE(run.value("undermine_left_percent"), 60);
    EXPECT_GE(run.value("undermine_right_percent"), 60);
    EXPECT_LT(run.value("torn_skin_mm3"), 3);
    EXPECT_LT(run.value("undermine_fascia_mm3"), 3);
    EXPECT_LT(run.value("closing_percent"), 92);
    EXPECT_EQ(run.value("placode_contacts"), 0);
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
}

TEST(UndermineTask, LevelsDifferByWhatTearsAndWhatComesFree) {
    const Task task = load_task("undermine");
    const Outcome middle = perform(task, "intermediate"), bad = perform(task, "novice");
    EXPECT_GT(expert().score.points, middle.score.points);
    EXPECT_GT(middle.score.points, bad.score.points + 5);
    EXPECT_NE(bad.score.verdict, assessment::Verdict::kPassed) << bad.score.points;
    EXPECT_GT(bad.value("torn_skin_mm3"), expert().value("torn_skin_mm3"));
}

TEST(UndermineTask, WhoDoesNothingIsNotJudged) {
    Task task = load_task("undermine");
    task.time_limit_s = 0.5;
    const Outcome nothing = perform(task, "expert");
    EXPECT_EQ(nothing.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(nothing.score.points, 0);
    EXPECT_EQ(nothing.value("undermine_left_percent"), 0);
    EXPECT_NEAR(nothing.value("closing_percent"), 100, 1);
}

TEST(UndermineTask, IsReplayedBitForBitOnOtherNumbersOfThreads) {
    test::expect_replays_alike(expert().recording, {2, 3, 1});
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
