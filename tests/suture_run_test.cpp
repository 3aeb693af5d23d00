// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The task of a running suture: whole attempts with one thread through three channels.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "assessment/bites.h"
#include "assessment/scoring.h"
#include "curriculum/replay.h"
#include "sim/world/saved_state.h"
#include "tests/count_allocations.h"
#include "tests/judged_attempt.h"
#include "tests/live_attempt.h"

namespace placode::curriculum {
namespace THIS_TEST {

using test::Outcome;

Outcome judged(const Task& task, sim::Recording recording, const std::string& level) {
    Outcome out = test::judged(task, std::move(recording));
    for (const assessment::Metric& metric : out.metrics.values)
        if (metric.id.substr(0, 4) == "bite" || metric.id.substr(0, 6) == "needle")
            ::testing::Test::RecordProperty(level + "_" + metric.id, std::to_string(metric.value));
    ::testing::Test::RecordProperty(level + "_points", std::to_string(out.score.points));
    return out;
}

Outcome perform(const Task& task, const std::string& level, uint64_t seed) {
    return judged(task, test::recorded(task, seed, test::scripted(level)), level);
}

/// When an event of this kind came, counted from 0; -1 = not yet.
double time_of(const std::vector<sim::Event>& events, sim::EventKind kind, int number) {
    for (const sim::Event& event : events)
        if (event.kind == kind && number-- == 0) return event.time_s;
    return -1;
}

/// A state saved in the middle of the second bite, which goes on beside the attempt for two
/// seconds.
class Copy {
 public:
    static constexpr double kAfterEntryS = 0.5, kForS = 2;

    /// After every frame of the attempt.
    void follow(test::LiveAttempt& attempt) {
        if (entered_s_ < 0)
            entered_s_ = time_of(attempt.events(), sim::EventKind::kNeedleEntered, 1);
        const sim::State& state = attempt.state();
        if (entered_s_ < 0 || state.time_s < entered_s_ + kAfterEntryS) return;
        if (!state_) return save(attempt);
        if (state.time_s > entered_s_ + kAfterEntryS + kForS) return;
        test::step_with(attempt.scene(), *state_, attempt.input());
        ++frames;
        if (state.frame % 20 == 0 && differs_at < 0 &&
            sim::whole_hash(*state_) != sim::whole_hash(state))
            differs_at = state.frame;
        same_at_last = sim::state_hash(*state_) == sim::state_hash(state);
    }

    int passages = 0, channels = 0;  ///< Where it was saved.
    bool same_at_first = false, same_at_last = false;
    int64_t frames = 0, differs_at = -1;

 private:
    void save(test::LiveAttempt& attempt) {
        const sim::SutureState& needle = attempt.state().suturing.needle[0];
        passages = needle.passage_count;
        channels = needle.thread.channel_count;
        const auto saved = sim::save_state(attempt.scene(), attempt.state());
        state_ = std::make_unique<sim::State>(attempt.scene(), 2);
        sim::load_state(attempt.scene(), *state_, saved);
        same_at_first = sim::whole_hash(*state_) == sim::whole_hash(attempt.state());
    }

    double entered_s_ = -1;
    std::unique_ptr<sim::State> state_;
};

/// One attempt of the expert, for all tests of this file, and what was seen in its frames.
struct Expert {
    Expert() {
        test::LiveAttempt attempt(test::coarse_suture_run());
        const sim::State& state = attempt.state();
        while (!attempt.over()) {
            attempt.look();
            const long before = test::allocations + test::locks;
            attempt.simulate();
            if (test::allocations + test::locks != before && allocated_at < 0)
                allocated_at = state.frame;
            copy.follow(attempt);
            most_channels = std::max(most_channels, state.suturing.needle[0].thread.channel_count);
        }
        frames = state.frame;
        outcome = judged(test::coarse_suture_run(), attempt.recording(), "expert");
    }
    Outcome outcome;
    Copy copy;
    int64_t frames = 0, allocated_at = -1;
    int most_channels = 0;
};

const Expert& made() {
    static const Expert expert;
    return expert;
}
const Outcome& expert() { return made().outcome; }

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
    const Task task = test::coarse_suture_run();
    const Outcome intermediate = perform(task, "intermediate", 1),
                  novice = perform(task, "novice", 1);
    EXPECT_GT(expert().score.points, intermediate.score.points);
    EXPECT_GT(intermediate.score.points, novice.score.points);
}

TEST(SutureRun, WhoDoesNothingHasNotAttemptedIt) {
    Task task = test::coarse_suture_run();
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

// Nothing is allocated from the first frame to the last, three channels and all; and what is saved
// in the middle of the second bite goes on the same, thread through two channels and all.
TEST(SutureRun, WhatIsSavedInTheSecondBiteGoesOnTheSameAndNoFrameAllocates) {
    const Copy& copy = made().copy;
    EXPECT_EQ(made().allocated_at, -1) << "frame";
    ASSERT_GT(copy.passages, 3) << "in the second bite";
    ASSERT_GE(copy.channels, 1) << "and its thread in the first";
    ASSERT_TRUE(copy.same_at_first);
    EXPECT_EQ(copy.differs_at, -1) << "frame";
    EXPECT_TRUE(copy.same_at_last);
    EXPECT_NEAR(static_cast<double>(copy.frames), 1000 * Copy::kForS, 2);
    EXPECT_GT(time_of(expert().recording.events, sim::EventKind::kThreaded, 2),
              time_of(expert().recording.events, sim::EventKind::kNeedleEntered, 1));
    EXPECT_EQ(made().most_channels, 3);
    EXPECT_EQ(made().frames, std::ssize(expert().recording.inputs));
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
