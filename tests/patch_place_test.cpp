// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of laying a patch: whole attempts, how it lies, what a bad hand loses.
#include <gtest/gtest.h>

#include "assessment/scoring.h"
#include "tests/attempt_fixture.h"
#include "tests/judged_attempt.h"

namespace placode::curriculum {
namespace THIS_TEST {

using test::judged;
using test::Outcome;
using test::performed;

Outcome perform(const std::string& level, uint64_t seed) {
    return performed(load_task("patch_place"), level, seed, {"patch_"});
}

/// One attempt of the expert, for all tests of this file.
const Outcome& expert() {
    static const Outcome outcome = perform("expert", 1);
    return outcome;
}

TEST(PatchPlace, AnExpertLaysItFlatFiveMillimetresBeyondTheEdge) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_EQ(run.value("patch_overlap_percent"), 100);
    EXPECT_GE(run.value("patch_overlap_least_mm"), 5);
    EXPECT_EQ(run.value("patch_uncovered_percent"), 0);
    EXPECT_LT(run.value("patch_folded_percent"), 0.5);
    EXPECT_EQ(run.value("placode_contacts"), 0);
    EXPECT_EQ(run.value("torn_volume_mm3"), 0);
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
}

TEST(PatchPlace, LevelsDifferByHowItLies) {
    const Outcome middle = perform("intermediate", 1), bad = perform("novice", 1);
    EXPECT_GT(expert().score.points, middle.score.points);
    EXPECT_GT(middle.score.points, bad.score.points + 5);
    EXPECT_GT(middle.value("patch_overlap_least_mm"), bad.value("patch_overlap_least_mm"));
    EXPECT_LT(bad.value("patch_overlap_least_mm"), 4.5) << "left short of its place";
    EXPECT_LT(bad.value("patch_overlap_percent"), 90);
    EXPECT_NE(bad.score.verdict, assessment::Verdict::kPassed) << bad.score.points;
}

/// The end of the attempt is not the end of the patch's way: hands off, it lies where it lies.
TEST(PatchPlace, WhoDoesNothingIsNotJudgedAndWhoLeavesItHalfwayEarnsLittle) {
    Task task = load_task("patch_place");
    task.time_limit_s = 0.5;
    const Outcome nothing = judged(task, test::recorded(task, 1, test::scripted("expert")));
    EXPECT_EQ(nothing.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(nothing.score.points, 0);
    EXPECT_EQ(nothing.value("patch_overlap_least_mm"), 0);
    EXPECT_EQ(nothing.value("patch_uncovered_percent"), 100);
    EXPECT_EQ(nothing.value("patch_folded_percent"), 0);
    // Lifted, and the attempt is over.
    const double taken_s = [] {
        for (const sim::Event& e : expert().recording.events)
            if (e.kind == sim::EventKind::kGrasped) return e.time_s;
        return 0.0;
    }();
    ASSERT_GT(taken_s, 1);
    task.time_limit_s = taken_s + 0.5;
    const Outcome taken = judged(task, test::recorded(task, 1, test::scripted("expert")));
    EXPECT_EQ(taken.value("patch_grasps"), 1);
    EXPECT_NE(taken.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_NE(taken.score.verdict, assessment::Verdict::kPassed);
    EXPECT_LT(taken.score.points, 5);
}

TEST(PatchPlace, IsReplayedBitForBitOnOtherNumbersOfThreads) {
    test::expect_replays_alike(expert().recording, {2, 3, 1});
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
