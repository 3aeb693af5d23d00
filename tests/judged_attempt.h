// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A whole attempt with its metrics and its score.

#include <string>
#include <utility>

#include "assessment/scoring.h"
#include "curriculum/task.h"
#include "sim/step/recording.h"

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

}  // namespace placode::test
