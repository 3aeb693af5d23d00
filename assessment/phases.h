// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An attempt part by part: the metrics of each phase. A phase that is entered again
// (the check finds more to cut) is a part of its own.

#include <vector>

#include "assessment/metrics.h"

namespace placode::assessment {

struct PhasePart {
    sim::Phase phase = sim::Phase::kInspect;
    double from_s = 0, to_s = 0;
    MetricSet metrics;  ///< Of this part alone.
};

/// In order of time. Parts shorter than 0.1 s are left out: nothing can be measured in them.
[[nodiscard]] std::vector<PhasePart> compute_phase_metrics(const sim::Recording& recording);

}  // namespace placode::assessment
