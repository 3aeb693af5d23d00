// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers and words as they stand in reports: the same in every locale.

#include <QColor>
#include <QString>
#include <string>
#include <string_view>

#include "db/records.h"
#include "reports/report.h"

namespace placode::reports {

/// `value` with `decimals` places and '.', never "-0.0".
[[nodiscard]] QString number(double value, int decimals);
/// The shortest text that reads back as the same number, without exponent where it is not needed:
/// one function for all exports, because their cells are compared as texts.
[[nodiscard]] std::string shortest_text(double value);
/// Enough places for the metric's size: 0.034, 3.42, 34.2, 342.
[[nodiscard]] QString metric_number(double value);
/// "34 s", "1:05 min": a length of time as people read it, whole seconds.
[[nodiscard]] QString duration_words(double seconds);
/// A whole number without a unit, which is shown without places. More than 1e5 is a dose.
[[nodiscard]] bool is_count(const assessment::MetricDefinition& metric, double value);
/// The largest that the measure says: the true value is this or more, shown as "≥ 1,000,000".
[[nodiscard]] bool is_ceiling(const assessment::MetricDefinition& metric, double value);
/// A time of a minute or more: written "9:08" with the unit "min", as every length of time.
[[nodiscard]] bool in_minutes(const assessment::MetricDefinition& metric, double value);
/// The value of a metric as report and portal print it; its unit is "min" where in_minutes().
[[nodiscard]] QString metric_text(const assessment::MetricDefinition& metric, double value);
/// "mm3" as it is printed: "mm³"; "C" as "°C".
[[nodiscard]] QString unit_sign(std::string_view unit);
/// "Passed", "Not yet", "Failed".
[[nodiscard]] QString verdict_word(assessment::Verdict verdict);
/// "finished", "time limit", "closed", "interrupted".
[[nodiscard]] QString end_word(sim::EndReason reason);
[[nodiscard]] QColor verdict_colour(assessment::Verdict verdict, const ChartStyle& style);
[[nodiscard]] inline QColor colour(unsigned argb) { return QColor::fromRgba(argb); }

}  // namespace placode::reports
