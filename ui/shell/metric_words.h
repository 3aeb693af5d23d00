// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Names, units and explanations of metrics, in the program's language.

#include <QString>
#include <string_view>

#include "assessment/metrics.h"

namespace placode::ui {

[[nodiscard]] QString metric_name(std::string_view english);
/// "mm3" as it is printed: "mm³"; "C" as "°C".
[[nodiscard]] QString unit_sign(std::string_view unit);
/// What it measures, which way is better, unit and source: a line of text.
[[nodiscard]] QString metric_explanation(const assessment::MetricDefinition& metric);

}  // namespace placode::ui
