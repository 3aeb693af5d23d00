// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Going back in a replay: from a kept moment on everything comes out as it was.

#include "curriculum/replay.h"

#include <gtest/gtest.h>

#include "sim/step/live_tuning.h"
#include "sim/world/saved_state.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

sim::Recording recording_of(double seconds) {
    Task task = load_task("touch_targets");
    task.time_limit_s = seconds;
    return test::scripted_attempt(task, "expert");
}

TEST(Replay, GoesBackToAKeptMomentAndComesOutTheSame) {
    const sim::Recording recording = recording_of(7);
    Replay replay(recording, 1, size_t{100} << 20);
    uint64_t at_six = 0;
    while (replay.step()) {
        if (replay.state().frame == 6000) at_six = sim::whole_hash(replay.state());
    }
    ASSERT_TRUE(replay.result().identical) << replay.result().message;
    replay.back_to(6.2);
    EXPECT_DOUBLE_EQ(replay.state().time_s, 5) << "not from the beginning";
    while (replay.state().frame < 6000) ASSERT_TRUE(replay.step());
    EXPECT_EQ(sim::whole_hash(replay.state()), at_six);
    while (replay.step()) {
    }
    EXPECT_TRUE(replay.result().identical) << replay.result().message;
    EXPECT_EQ(replay.result().frames, std::ssize(recording.inputs));
    replay.back_to(1);
    EXPECT_EQ(replay.state().frame, 0) << "before the first kept moment lies the beginning";
    ASSERT_TRUE(replay.step());
}

TEST(Replay, KnowsTheStepThatThePersonWasAt) {
    const sim::Recording recording = recording_of(9);
    Replay replay(recording, 1, size_t{100} << 20);
    EXPECT_EQ(replay.practice().count, 8);
    EXPECT_EQ(replay.practice().index, 0);
    EXPECT_EQ(replay.practice().targets, 1);
    sim::PracticeGoal at_seven;
    while (replay.step()) {
        if (replay.state().frame == 7000) at_seven = replay.practice();
    }
    const auto done = std::count_if(
        recording.events.begin(), recording.events.end(),
        [](const sim::Event& event) { return event.kind == sim::EventKind::kStepDone; });
    ASSERT_GE(done, 2);
    EXPECT_EQ(replay.practice().index, done);
    replay.back_to(6);
    while (replay.state().frame < 7000) ASSERT_TRUE(replay.step());
    EXPECT_EQ(replay.practice().index, at_seven.index);
    EXPECT_EQ(replay.practice().progress, at_seven.progress);
    EXPECT_EQ(replay.practice().target_m[0], at_seven.target_m[0]);
    replay.back_to(1);
    EXPECT_EQ(replay.practice().index, 0);
}

TEST(Replay, KeepsMomentsInBoundedMemoryAndThinsThem) {
    const sim::Recording recording = recording_of(0.2);
    Replay replay(recording, 1);
    ASSERT_TRUE(replay.step());
    const auto one = sim::save_state(replay.scene(), replay.state()).size();
    KeyFrames keys(4 * one + one / 2);
    sim::State state(replay.scene(), 1);
    for (int i = 1; i <= 40; ++i) {
        state.time_s = i * 2.5;
        keys.offer(replay.scene(), state);
        EXPECT_LE(keys.bytes(), 4 * one + one / 2);
    }
    EXPECT_GE(keys.count(), 2U);
    EXPECT_EQ(keys.before(4), nullptr);
    // The last kept moment is never farther away than the present interval.
    ASSERT_NE(keys.before(100), nullptr);
    sim::State kept(replay.scene(), 1);
    sim::load_state(replay.scene(), kept, *keys.before(100));
    EXPECT_GE(kept.time_s, 40);
    KeyFrames none(0);
    none.offer(replay.scene(), state);
    EXPECT_EQ(none.count(), 0U);
}

TEST(Replay, GoingBackBeforeATuningUndoesIt) {
    sim::Recording recording = recording_of(6.5);
    sim::Event tuned;  // as if the panel had been used: what follows differs from the record
    tuned.kind = sim::EventKind::kTuned;
    tuned.element = static_cast<int32_t>(sim::TuneParameter::kFriction);
    tuned.tissue = sim::Tissue::kSkin;
    tuned.value = 0.5F;
    tuned.hash = 6000;
    recording.events.push_back(tuned);
    std::erase_if(recording.events,
                  [](const sim::Event& e) { return e.kind == sim::EventKind::kStateHash; });
    Replay replay(recording, 1, size_t{100} << 20);
    while (replay.step()) {
    }
    const uint64_t end = sim::state_hash(replay.state());
    const auto friction = [&] {
        return sim::tuned_value(replay.scene(), sim::TuneParameter::kFriction, sim::Tissue::kSkin);
    };
    EXPECT_NEAR(friction(), 0.5, 1e-6);
    replay.back_to(5.5);
    EXPECT_LT(friction(), 0.2);
    while (replay.step()) {
    }
    EXPECT_NEAR(friction(), 0.5, 1e-6);
    EXPECT_EQ(sim::state_hash(replay.state()), end);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
