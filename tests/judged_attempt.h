// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A whole attempt with its metrics and its score.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assessment/scoring.h"
#include "curriculum/task.h"
#include "sim/anatomy/operative_field.h"
#include "sim/core/as_index.h"
#include "sim/step/recording.h"
#include "sim/world/saved_state.h"
#include "tests/attempt_fixture.h"

namespace placode::test {

struct Outcome {
    sim::Recording recording;
    assessment::MetricSet metrics;
    assessment::Score score;
    [[nodiscard]] double value(const char* id) const { return metrics.find(id).value_or(-1); }
};

inline Outcome judged(const curriculum::Task& task, sim::Recording recording) {
    Outcome out;
    out.recording = std::move(recording);
    out.metrics = assessment::compute_metrics(out.recording);
    out.score = assessment::score_attempt(task.rubric, out.metrics, out.recording);
    return out;
}

/// A whole attempt of the scripted operator. Points, and metrics that begin like one of `noted`,
/// stand in the test's report.
inline Outcome performed(const curriculum::Task& task, const std::string& level, uint64_t seed,
                         const std::vector<std::string_view>& noted) {
    Outcome out = judged(task, recorded(task, seed, scripted(level)));
    for (const assessment::Metric& metric : out.metrics.values)
        if (std::any_of(noted.begin(), noted.end(),
                        [&](std::string_view each) { return metric.id.starts_with(each); }))
            testing::Test::RecordProperty(level + "_" + metric.id, std::to_string(metric.value));
    testing::Test::RecordProperty(level + "_points", std::to_string(out.score.points));
    return out;
}

/// The recording replays to the end, bit for bit, while numbers of threads take turns: every five
/// seconds of it the state is saved, and goes on with the next number. One pass for all of them.
inline void expect_replays_alike(const sim::Recording& recording,
                                 std::initializer_list<int> threads) {
    constexpr int64_t kTurn = 5000;
    curriculum::Task task = curriculum::load_task_text(recording.header.task_json, "recording");
    task.scene.seed = recording.header.seed;
    const auto scene = sim::build_operative_field(task.scene);
    auto state = std::make_unique<sim::State>(*scene, *threads.begin());
    sim::settle(*scene, *state, task.settle_s);
    auto event = recording.events.begin();
    int64_t compared = 0;
    for (const sim::Input& input : recording.inputs) {
        if (state->frame % kTurn == kTurn - 1) {
            const auto turn = sim::as_index(state->frame / kTurn + 1) % threads.size();
            const std::vector<uint8_t> saved = sim::save_state(*scene, *state);
            state = std::make_unique<sim::State>(*scene, *(threads.begin() + turn));
            sim::load_state(*scene, *state, saved);
        }
        step_with(*scene, *state, input);
        for (; event != recording.events.end() &&
               event->time_s < state->time_s + 0.5 * task.scene.solver.frame_s;
             ++event) {
            if (event->kind != sim::EventKind::kStateHash) continue;
            ++compared;
            ASSERT_EQ(sim::state_hash(*state), event->hash) << event->time_s << " s";
        }
    }
    EXPECT_EQ(sim::state_hash(*state), recording.end.final_hash);
    EXPECT_EQ(state->frame, std::ssize(recording.inputs));
    EXPECT_GE(compared, std::floor(recording.end.duration_s)) << "states that were compared";
}

}  // namespace placode::test
