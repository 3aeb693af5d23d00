// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the report of one attempt says, as HTML for its sheets. Private to reports: pdf_report.cpp
// lays it out.

#include <QString>
#include <string>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/scoring.h"
#include "reports/attempt_figures.h"
#include "reports/report.h"
#include "reports/task_scope.h"

namespace placode::reports {

/// What is printed.
struct ReportSubject {
    const db::AttemptDetail& attempt;
    const sim::Recording& recording;
    const std::vector<db::AttemptRecord>& history;
    const ReportHead& head;
    std::string title;
    TaskScope scope;  ///< What of it is shown.
};

/// In the zone of this computer, which the screen shows too, and says so: a paper travels.
[[nodiscard]] QString local_time(const std::string& utc);

/// Centre, verdict and points, or why the attempt does not count, and the facts about it.
[[nodiscard]] QString head_html(const ReportSubject& subject, const ChartStyle& style);

/// Rows of a table of reasons. @param scored of an attempt that does not count: what happened, and
/// no points.
[[nodiscard]] std::vector<QString> reason_rows(const assessment::Score& score, bool scored);

/// Name, value, unit and direction of a metric as a row; bold where the score looks at it.
[[nodiscard]] QString metric_row(const assessment::MetricDefinition& definition, double value,
                                 const TaskScope& scope);

/// What the score can be computed from again.
[[nodiscard]] QString provenance_html(const ReportSubject& subject);

/// Lines to sign on: the person, and who was there or taught.
[[nodiscard]] QString signature_html(const ReportSubject& subject);

}  // namespace placode::reports
