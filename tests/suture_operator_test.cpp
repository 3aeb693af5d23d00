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

TEST(SutureOperator, WhoDoesNothingHasNotAttemptedIt) {
    const Outcome outcome = perform("expert", 0.5);  // still looking
    EXPECT_EQ(outcome.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(outcome.score.points, 0);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
