// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Names, units and explanations of metrics, in the program's language.

#include <QString>
#include <string_view>

#include "assessment/metrics.h"
#include "reports/task_scope.h"
#include "reports/text.h"

namespace placode::ui {

[[nodiscard]] QString metric_name(std::string_view english);
using reports::unit_sign;
/// A value of it as a table shows it: counts without places.
[[nodiscard]] QString metric_value(const assessment::MetricDefinition& metric, double value);
/// What it measures, which way is better, unit and source: a line of text.
[[nodiscard]] QString metric_explanation(const assessment::MetricDefinition& metric);
/// The same with the limit of force of the task's scene where it is about that.
[[nodiscard]] QString metric_explanation(const assessment::MetricDefinition& metric,
                                         const reports::TaskScope& scope);

}  // namespace placode::ui
