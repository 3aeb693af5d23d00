// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted operators at the task of one bite: the levels score in order, and who does nothing has
// not attempted it.
#include "haptics/operators/suture_operator.h"

#include <gtest/gtest.h>

#include "assessment/scoring.h"
#include "curriculum/replay.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

struct Outcome {
    sim::Recording recording;
    assessment::MetricSet metrics;
    assessment::Score score;
};

Outcome perform(const std::string& level, double end_s = 0) {
    Task task = load_task("suture_bite");
    if (end_s > 0) task.time_limit_s = end_s;
    Outcome out;
    out.recording = test::scripted_attempt(task, level);
    out.metrics = assessment::compute_metrics(out.recording);
    out.score = assessment::score_attempt(task.rubric, out.metrics, out.recording);
    for (const char* id : {"bite_entry_offset_mm", "bite_exit_offset_mm", "bite_depth_mm",
                           "bite_angle_deg", "needle_entries", "needle_regrasps", "peak_force_mn",
                           "steps_done_percent", "torn_volume_mm3", "task_time_s"})
        ::testing::Test::RecordProperty(level + "_" + id,
                                        std::to_string(out.metrics.find(id).value_or(-1)));
    ::testing::Test::RecordProperty(level + "_points", std::to_string(out.score.points));
    return out;
}

TEST(SutureOperator, TheLevelsScoreInOrderAndTheExpertPasses) {
    const Outcome expert = perform("expert"), intermediate = perform("intermediate"),
                  novice = perform("novice");
    EXPECT_EQ(expert.score.verdict, assessment::Verdict::kPassed) << expert.score.points;
    EXPECT_EQ(*expert.metrics.find("steps_done_percent"), 100);
    EXPECT_EQ(expert.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_LT(*expert.metrics.find("bite_entry_offset_mm"), 0.8);
    EXPECT_EQ(*expert.metrics.find("needle_entries"), 1);
    EXPECT_EQ(*expert.metrics.find("torn_volume_mm3"), 0);
    EXPECT_GT(expert.score.points, intermediate.score.points);
    EXPECT_GT(intermediate.score.points, novice.score.points);
    // The recording proves itself.
    Replay replay(expert.recording, 2);
    while (replay.step()) {
    }
    EXPECT_TRUE(replay.result().identical) << replay.result().message;
}

// Let go in this bite, with little friction, the needle once went round its circle by itself: its
// steps did not converge where the walls slip one way and the other (13 points).
TEST(SutureOperator, ANeedleThatIsLetGoStaysInItsBite) {
    const Task task = load_task("suture_bite");
    const sim::Recording recording = test::recorded(task, 28, test::scripted("expert"));
    double released_s = -1, through_s = -1, taken_again_s = -1;
    for (const sim::Event& event : recording.events) {
        if (event.kind == sim::EventKind::kNeedleReleased && released_s < 0)
            released_s = event.time_s;
        if (event.kind == sim::EventKind::kNeedleTaken && released_s > 0)
            taken_again_s = event.time_s;
        if (event.kind == sim::EventKind::kNeedleThrough) through_s = event.time_s;
    }
    ASSERT_GT(released_s, 0);
    EXPECT_GT(taken_again_s, released_s);
    EXPECT_GT(through_s, taken_again_s + 1) << "it is drawn through by a hand";
}

TEST(SutureOperator, WhoDoesNothingHasNotAttemptedIt) {
    const Outcome outcome = perform("expert", 0.5);  // still looking
    EXPECT_EQ(outcome.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(outcome.score.points, 0);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
