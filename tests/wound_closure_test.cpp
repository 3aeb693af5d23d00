// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of closing a wide wound: whole attempts, from the freeing of the skin to the leak test.
#include <gtest/gtest.h>

#include "assessment/scoring.h"
#include "tests/judged_attempt.h"

namespace placode::curriculum {
namespace THIS_TEST {

using test::Outcome;

Outcome perform(const Task& task, const std::string& level) {
    return test::performed(task, level, 1,
                           {"undermine_", "closing_", "torn_", "slit_", "bite", "draw_", "peak_"});
}

/// One attempt of the expert, for all tests of this file.
const Outcome& expert() {
    static const Outcome outcome = perform(load_task("wound_closure"), "expert");
    return outcome;
}

TEST(WoundClosure, AnExpertFreesTheSkinAndClosesTheWoundWatertight) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_GE(run.value("undermine_left_percent"), 65);
    EXPECT_GE(run.value("undermine_right_percent"), 65);
    EXPECT_EQ(run.value("bites_done"), 3);
    EXPECT_EQ(run.value("needle_entries"), 6) << "into either edge, three times";
    EXPECT_LT(run.value("bite_entry_worst_mm"), 0.6) << "the left hand holds the edge";
    EXPECT_LT(run.value("bite_exit_worst_mm"), 0.6);
    EXPECT_EQ(run.value("thread_cuts"), 0);
    EXPECT_LT(run.value("torn_skin_mm3"), 0.5);
    EXPECT_GT(run.value("slit_burst_cmh2o"), 12.5);
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
}

TEST(WoundClosure, WhoDoesNotUndermineNeedsMorePull) {
    Task firm = load_task("wound_closure");
    while (firm.steps.front().goal.kind != sim::PracticeKind::kNeedleIn)
        firm.steps.erase(firm.steps.begin());
    const Outcome run = perform(firm, "expert");
    EXPECT_LT(run.value("undermine_left_percent"), 40);
    EXPECT_GT(run.value("closing_after_n_m"), 1.1 * expert().value("closing_after_n_m"));
    EXPECT_GT(run.value("peak_force_mn"), 0);
    EXPECT_NE(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
}

TEST(WoundClosure, ANoviceDoesNotPass) {
    const Outcome bad = perform(load_task("wound_closure"), "novice");
    EXPECT_NE(bad.score.verdict, assessment::Verdict::kPassed) << bad.score.points;
    EXPECT_LT(bad.score.points, expert().score.points - 30);
    EXPECT_LT(bad.value("slit_burst_cmh2o"), 6);
}

TEST(WoundClosure, WhoDoesNothingIsNotJudged) {
    Task task = load_task("wound_closure");
    task.time_limit_s = 0.5;
    const Outcome nothing = perform(task, "expert");
    EXPECT_EQ(nothing.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(nothing.score.points, 0);
    EXPECT_EQ(nothing.value("slit_burst_cmh2o"), 0);
    EXPECT_NEAR(nothing.value("closing_percent"), 100, 1);
}

TEST(WoundClosure, IsReplayedBitForBitOnOtherNumbersOfThreads) {
    test::expect_replays_alike(expert().recording, {2, 3, 1});
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
