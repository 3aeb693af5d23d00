// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Metrics as a report shows them: in groups, and only those that the task has.

#include <string_view>
#include <vector>

#include "assessment/metrics.h"
#include "reports/task_scope.h"

namespace placode::reports {

enum class MetricGroup : uint8_t {
    kTime,
    kIncision,
    kPlacode,
    kTissue,
    kResection,
    kEnergy,
    kForce,
    kMotion,
    kHands,
    kPractice,
    kSuture,
    kClosure
};

/// English heading: "Time and view", "Incision", ...
[[nodiscard]] const char* group_title(MetricGroup group) noexcept;
[[nodiscard]] MetricGroup group_of_metric(std::string_view id) noexcept;

/// True when one of these metrics (what a score looks at) is about the incision around the placode:
/// where none is, ring and phase say nothing.
[[nodiscard]] bool looks_at_ring(const std::vector<std::string>& scored) noexcept;

/// Too slow for any movement to be counted: the counts are 0 beside a way that is not, and left out
/// of a report.
[[nodiscard]] bool nothing_moved_fast(const assessment::MetricSet& metrics);

struct GroupedMetrics {
    MetricGroup group = MetricGroup::kTime;
    std::vector<assessment::MetricDefinition> metrics;
};

/// Of the metrics that were measured those that belong to the task (task_scope.h). Of two measures
/// of the same (idle share, no hand moving) the first. In the order of MetricGroup; none is empty.
/// What the score looks at always stands in it.
[[nodiscard]] std::vector<GroupedMetrics> grouped_metrics(const assessment::MetricSet& metrics,
                                                          const TaskScope& scope);

}  // namespace placode::reports
