// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a metric means, in the program's language.

#include <QString>

#include "assessment/metrics.h"

namespace placode::ui {

/// What it measures, which way is better, unit and source: a line of text.
[[nodiscard]] QString metric_explanation(const assessment::MetricDefinition& metric);

}  // namespace placode::ui
