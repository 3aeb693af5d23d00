// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/judge.h"

namespace placode::environment {

Judgement judge_finished(const assessment::Rubric& rubric, const sim::Recording& recording) {
    Judgement judgement;
    judgement.at_s = recording.end.duration_s;
    judgement.metrics = assessment::compute_metrics(recording);
    judgement.score = assessment::score_attempt(rubric, judgement.metrics, recording);
    return judgement;
}

Judgement judge_unfinished(const assessment::Rubric& rubric, sim::Recording& recording,
                           std::span<const sim::Event> closing, double time_s) {
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
        Judgement judgement = judge_finished(rubric, recording);
        restore();
        return judgement;
    } catch (...) {
        restore();
        throw;
    }
}

}  // namespace placode::environment
