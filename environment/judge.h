// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The score of an episode, finished or not: the same metrics and the same rubric as for a person's
// attempt. The reward is the change of this score.

#include <span>

#include "assessment/metrics.h"
#include "assessment/scoring.h"

namespace placode::environment {

struct Judgement {
    double at_s = 0;
    assessment::Score score;
    assessment::MetricSet metrics;
};

/// What `recording` would score if the attempt had ended at `time_s` with `closing` as its last
/// entries. `recording` is as before afterwards.
/// @param all every metric, else those that `rubric` looks at: a fraction of the time.
[[nodiscard]] Judgement judge_unfinished(const assessment::Rubric& rubric,
                                         sim::Recording& recording,
                                         std::span<const sim::Event> closing, double time_s,
                                         bool all);

/// Of a recording that has its end.
[[nodiscard]] Judgement judge_finished(const assessment::Rubric& rubric,
                                       const sim::Recording& recording);

}  // namespace placode::environment
