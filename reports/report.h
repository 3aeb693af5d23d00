// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Paper for people: PDF and plots. Every one says when its data is a demonstration, and its file is
// for its owner alone (mode 0600). Files for other programs: reports/export.h.

#include <stdexcept>
#include <string>
#include <vector>

#include "db/records.h"
#include "db/store.h"

class QPainter;
class QRectF;

namespace placode::reports {

/// Operation, file and way out.
class ReportError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// What stands at the head of a report beside the attempt itself. What is empty is not printed.
struct ReportHead {
    std::string centre;        ///< Under which the centre signs its norms.
    std::string course_title;  ///< Of the course that the exam belongs to.
};

/// PDF of one attempt on A4: who, what and under which rules, verdict, reasons, pictures, metrics
/// in groups, what it can be checked by, and a place to sign. Needs a QApplication: the charts are
/// QCustomPlot.
/// @param head what the store knows and the attempt does not.
void write_attempt_pdf(const db::AttemptDetail& attempt, const sim::Recording& recording,
                       const std::vector<db::AttemptRecord>& history, const std::string& path,
                       const ReportHead& head = {});
[[nodiscard]] ReportHead report_head(db::Store& store, const db::AttemptRecord& attempt);

/// Colours and sizes of a chart, so that window (both themes) and paper share the code.
struct ChartStyle {
    unsigned text = 0xff1c1e21, muted = 0xff5f666e, line = 0xffe3e2dc, accent = 0xff0b6e77,
             surface = 0xffffffff, good = 0xff2f7d4f, warn = 0xffa86400,
             critical = 0xffb3261e;  ///< ARGB
    double font_px = 12;
    bool plan = true;  ///< The planned line is part of the task (task_scope.h).
};

/// Score over attempts, oldest first, with the pass line.
void draw_history(QPainter& painter, const QRectF& where,
                  const std::vector<db::AttemptRecord>& attempts, double pass_points,
                  const ChartStyle& style);

/// The field from above: placode, skin edge, planned contour, what was cut, the needle's path and
/// the ledger's events.
void draw_incision(QPainter& painter, const QRectF& where, const sim::Recording& recording,
                   const ChartStyle& style);

/// One line of a chart.
struct Curve {
    std::string name;
    std::vector<double> x, y;
};

/// Several curves over one axis. Values that a logarithmic axis cannot show are left out.
struct CurveChart {
    std::string title, x_label, y_label;
    bool log_x = true, log_y = true;
    std::vector<Curve> curves;
    std::vector<std::pair<std::string, double>> levels;  ///< Dashed horizontal lines: targets.
};

/// 900 x 560 pixels. @throws ReportError when the file cannot be written. Needs a QApplication.
void write_chart_png(const CurveChart& chart, const std::string& path);

}  // namespace placode::reports
