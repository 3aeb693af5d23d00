// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scripted operators differ by what they do to the tissue, and the score sees it: whole
// attempts on the warm-up field, simulated, measured and scored.

#include <gtest/gtest.h>

#include <future>
#include <memory>

#include "assessment/scoring.h"
#include "curriculum/attempt_runner.h"
#include "tests/attempt_fixture.h"

using namespace placode;

namespace {

struct Attempt {
    sim::Recording recording;
    assessment::MetricSet metrics;
    assessment::Score score;
};

Attempt perform(const std::string& level) {
    const curriculum::Task task = curriculum::load_task("diathermy_ring_small");
    Attempt attempt;
    attempt.recording = test::scripted_attempt(task, level);
    attempt.metrics = assessment::compute_metrics(attempt.recording);
    attempt.score = assessment::score_attempt(task.rubric, attempt.metrics, attempt.recording);
    return attempt;
}

/// A reason with a time must be there in the recording: some event of the ledger close to it.
bool stands_in_recording(const assessment::Reason& reason, const sim::Recording& recording) {
    if (reason.time_s < 0) return true;  // about the whole attempt
    for (const sim::Event& event : recording.events) {
        if (std::abs(event.time_s - reason.time_s) < 1.0) return true;
    }
    return false;
}

}  // namespace

TEST(OperatorLevels, ExpertAboveIntermediateAboveNoviceWithReasonsInTheRecording) {
    auto later = std::async(std::launch::async, [] { return perform("novice"); });
    const Attempt expert = perform("expert"), intermediate = perform("intermediate"),
                  novice = later.get();
    EXPECT_EQ(expert.score.verdict, assessment::Verdict::kPassed) << expert.score.points;
    EXPECT_GE(*expert.metrics.find("ring_completeness_percent"), 99);
    EXPECT_EQ(*expert.metrics.find("placode_burned_percent"), 0);
    EXPECT_GT(expert.score.points, intermediate.score.points);
    EXPECT_GT(intermediate.score.points, novice.score.points);
    for (const Attempt* attempt : {&expert, &intermediate, &novice}) {
        EXPECT_EQ(attempt->recording.end.dropped, 0);
        ASSERT_FALSE(attempt->score.reasons.empty());
        for (const auto& reason : attempt->score.reasons) {
            EXPECT_TRUE(stands_in_recording(reason, attempt->recording)) << reason.text;
        }
    }
}
