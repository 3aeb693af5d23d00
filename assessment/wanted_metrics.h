// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Metrics for a score that is asked for again and again while the attempt goes on.

#include <span>
#include <string_view>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/scoring.h"

namespace placode::assessment {

/// Every metric that a score by this rubric looks at.
[[nodiscard]] std::vector<std::string_view> metrics_of(const Rubric& rubric);

/// The values of compute_metrics() for what `wanted` names; others may be there or not. What comes
/// from filtered tracks (paths, smoothness, tremor), and with it most of the time, is computed only
/// where one of it is wanted.
[[nodiscard]] MetricSet compute_metrics(const sim::Recording& recording,
                                        std::span<const std::string_view> wanted);

}  // namespace placode::assessment
