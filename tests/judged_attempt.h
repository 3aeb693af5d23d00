// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A whole attempt with its metrics and its score.

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assessment/scoring.h"
#include "curriculum/replay.h"
#include "curriculum/task.h"
#include "sim/step/recording.h"
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

/// The recording replays to the end, bit for bit, with each of these numbers of threads.
inline void expect_replays_alike(const sim::Recording& recording,
                                 std::initializer_list<int> threads) {
    for (const int count : threads) {
        curriculum::Replay replay(recording, count);
        while (replay.step()) {
        }
        EXPECT_TRUE(replay.result().identical) << count << ": " << replay.result().message;
        EXPECT_EQ(replay.result().frames, std::ssize(recording.inputs)) << count;
    }
}

}  // namespace placode::test
