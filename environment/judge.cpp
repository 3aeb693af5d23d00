// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/judge.h"

#include <utility>

#include "assessment/wanted_metrics.h"

namespace placode::environment {
namespace {

Judgement judge(const assessment::Rubric& rubric, const sim::Recording& recording,
                assessment::MetricSet metrics) {
    Judgement judgement;
    judgement.at_s = recording.end.duration_s;
    judgement.metrics = std::move(metrics);
    judgement.score = assessment::score_attempt(rubric, judgement.metrics, recording);
    return judgement;
}

}  // namespace

Judgement judge_finished(const assessment::Rubric& rubric, const sim::Recording& recording) {
    return judge(rubric, recording, assessment::compute_metrics(recording));
}

Judgement judge_unfinished(const assessment::Rubric& rubric, sim::Recording& recording,
                           std::span<const sim::Event> closing, double time_s, bool all) {
    const size_t events = recording.events.size();
    const sim::RecordingEnd end = recording.end;
    const auto restore = [&] {
        recording.events.resize(events);
        recording.end = end;
    };
    try {
        recording.events.insert(recording.events.end(), closing.begin(), closing.end());
        recording.end.reason = sim::EndReason::kFinished;
        recording.end.duration_s = time_s;
        Judgement judgement =
            judge(rubric, recording,
                  all ? assessment::compute_metrics(recording)
                      : assessment::compute_metrics(recording, assessment::metrics_of(rubric)));
        restore();
        return judgement;
    } catch (...) {
        restore();
        throw;
    }
}

}  // namespace placode::environment
