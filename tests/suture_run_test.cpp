// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of a running suture: whole attempts with one thread through three channels.
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "assessment/bites.h"
#include "assessment/scoring.h"
#include "curriculum/replay.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"
#include "sim/world/saved_state.h"
#include "tests/attempt_fixture.h"
#include "tests/count_allocations.h"

namespace placode::curriculum {
namespace THIS_TEST {

struct Outcome {
    sim::Recording recording;
    assessment::MetricSet metrics;
    assessment::Score score;
    [[nodiscard]] double value(const char* id) const { return metrics.find(id).value_or(-1); }
};

/// On a field that a test can afford.
Task coarse_run() {
    return test::changed_task(
        "suture_run",
        {{"edge_ring_m", "0.0009"}, {"edge_placode_m", "0.0009"}, {"edge_outer_m", "0.0012"}});
}

Outcome perform(const Task& task, const std::string& level, uint64_t seed) {
    Outcome out;
    out.recording = test::recorded(task, seed, test::scripted(level));
    out.metrics = assessment::compute_metrics(out.recording);
    out.score = assessment::score_attempt(task.rubric, out.metrics, out.recording);
    for (const assessment::Metric& metric : out.metrics.values)
        if (metric.id.substr(0, 4) == "bite" || metric.id.substr(0, 6) == "needle")
            ::testing::Test::RecordProperty(level + "_" + metric.id, std::to_string(metric.value));
    ::testing::Test::RecordProperty(level + "_points", std::to_string(out.score.points));
    return out;
}

/// One attempt of the expert, for all tests of this file.
const Outcome& expert() {
    static const Outcome outcome = perform(coarse_run(), "expert", 1);
    return outcome;
}

double time_of(const sim::Recording& recording, sim::EventKind kind, int number) {
    for (const sim::Event& event : recording.events)
        if (event.kind == kind && number-- == 0) return event.time_s;
    return -1;
}

/// The expert's attempt, simulated again frame by frame.
struct Again {
    Again() {
        OperativeFieldSpec spec = coarse_run().scene;
        spec.seed = recording.header.seed;
        scene = sim::build_operative_field(spec);
    }
    using OperativeFieldSpec = sim::OperativeFieldSpec;
    [[nodiscard]] std::unique_ptr<sim::State> start() const {
        auto state = std::make_unique<sim::State>(*scene, 1);
        sim::settle(*scene, *state, coarse_run().settle_s);
        return state;
    }
    void step(sim::State& state) const {
        const sim::Input& input = recording.inputs.at(static_cast<size_t>(state.frame));
        state.substeps = input.substeps;
        std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
        const size_t tools = scene->tools.size();
        (void)sim::step(*scene, state, {input.tools, tools}, {feedback.data(), tools});
    }
    const sim::Recording& recording = expert().recording;
    std::shared_ptr<const sim::Scene> scene;
};

TEST(SutureRun, TheMarksLieWhereTheTaskSays) {
    const Task task = load_task("suture_run");
    const std::vector<assessment::Bite> bites = assessment::bites_of(expert().recording);
    ASSERT_EQ(bites.size(), 3U);
    size_t bite = 0;
    for (const TaskStep& step : task.steps) {
        if (step.goal.kind != sim::PracticeKind::kNeedleIn) continue;
        const assessment::Bite& told = bites.at(bite++);
        // The pad settles by some micrometres under its own weight.
        EXPECT_LT((told.mark_in_m.head<2>() - step.goal.place_m[0]).norm(), 20e-6);
        EXPECT_LT((told.mark_out_m.head<2>() - step.goal.place_m[1]).norm(), 20e-6);
    }
}

TEST(SutureRun, AnExpertSewsARowThatIsEven) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_EQ(run.value("bites_done"), 3);
    EXPECT_EQ(run.value("needle_entries"), 3);
    EXPECT_EQ(run.value("needle_regrasps"), 5);
    EXPECT_EQ(run.value("thread_cuts"), 0);
    EXPECT_EQ(run.value("torn_volume_mm3"), 0);
    EXPECT_NEAR(run.value("bite_pitch_mm"), 4, 0.5);
    EXPECT_LT(run.value("bite_pitch_spread_mm"), 0.8);
    EXPECT_GT(run.value("bite_depth_least_mm"), 0.7);
}

TEST(SutureRun, TheLevelsScoreInOrder) {
    const Task task = coarse_run();
    const Outcome intermediate = perform(task, "intermediate", 1),
                  novice = perform(task, "novice", 1);
    EXPECT_GT(expert().score.points, intermediate.score.points);
    EXPECT_GT(intermediate.score.points, novice.score.points);
}

TEST(SutureRun, WhoDoesNothingHasNotAttemptedIt) {
    Task task = coarse_run();
    task.time_limit_s = 0.5;
    const Outcome outcome = perform(task, "expert", 1);
    EXPECT_EQ(outcome.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(outcome.score.points, 0);
}

TEST(SutureRun, ThreeChannelsAreReplayedBitForBitOnTwoThreads) {
    Replay replay(expert().recording, 2);
    while (replay.step()) {
    }
    EXPECT_TRUE(replay.result().identical) << replay.result().message;
    EXPECT_EQ(replay.result().frames, std::ssize(expert().recording.inputs));
}

// From before the second bite to the third channel: nothing allocated, and what is saved in the
// middle of the second bite goes on the same, thread through two channels and all.
TEST(SutureRun, WhatIsSavedInTheSecondBiteGoesOnTheSameAndNoFrameAllocates) {
    const Again again;
    const double second_s = time_of(again.recording, sim::EventKind::kNeedleEntered, 1),
                 third_s = time_of(again.recording, sim::EventKind::kThreaded, 2);
    ASSERT_GT(second_s, 0);
    ASSERT_GT(third_s, second_s);
    const auto state = again.start();
    const auto step = [&](sim::State& of) {
        const long before = test::allocations + test::locks;
        again.step(of);
        ASSERT_EQ(test::allocations + test::locks, before) << "frame " << of.frame;
    };
    while (state->time_s < second_s + 0.5) step(*state);
    const sim::SutureState& needle = state->suturing.needle[0];
    ASSERT_GT(needle.passage_count, 3) << "in the second bite";
    ASSERT_GE(needle.thread.channel_count, 1) << "and its thread in the first";
    const auto saved = sim::save_state(*again.scene, *state);
    sim::State copy(*again.scene, 2);
    sim::load_state(*again.scene, copy, saved);
    ASSERT_EQ(sim::whole_hash(copy), sim::whole_hash(*state));
    while (state->time_s < second_s + 2.5) {
        step(*state);
        again.step(copy);
        if (state->frame % 20 == 0) {
            ASSERT_EQ(sim::whole_hash(copy), sim::whole_hash(*state)) << state->frame;
        }
    }
    EXPECT_EQ(sim::state_hash(copy), sim::state_hash(*state));
    while (state->time_s < third_s + 0.2) step(*state);
    EXPECT_EQ(needle.thread.channel_count, 3);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
