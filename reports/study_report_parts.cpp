// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_report_parts.h"

#include <algorithm>

#include "reports/study_analysis.h"

namespace placode::reports {
namespace {

constexpr const char* kRatersForm = "osats";

QString safe(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

void write_analysis_table(Paper& paper, const Analysis& analysis) {
    if (!analysis.problem.empty()) {
        paper.html("<p><b>" + safe(analysis.title) + ".</b> " + safe(analysis.problem) + "</p>");
        return;
    }
    QStringList head;
    for (const std::string& each : analysis.head) head << safe(each);
    std::vector<QStringList> rows;
    for (const auto& row : analysis.rows) {
        QStringList cells;
        for (const AnalysisCell& cell : row) cells << safe(cell.text);
        rows.push_back(cells);
    }
    paper.table("<b>" + safe(analysis.title) + ".</b> " + safe(analysis.method), head,
                QString("l") + QString(static_cast<int>(analysis.head.size()) - 1, 'r'), rows);
    for (const Figure& figure : analysis.figures) paper.figure(figure);
}

}  // namespace

void write_analyses(Paper& paper, const StudyReport& report) {
    write_analysis_table(paper, learning_curves(report));
    write_analysis_table(paper, construct_validity(report, {}));
    write_analysis_table(paper, test_retest(report));
    write_analysis_table(paper, rater_agreement(report, report.ratings,
                                                curriculum::load_questionnaire(kRatersForm)));
}

void write_data_care(Paper& paper, const StudyReport& report) {
    paper.heading("Care of the data");
    QString html;
    for (const auto& version : report.versions)
        html += "<li>Protocol version " + QString::number(version.version) + ", published " +
                safe(version.published_utc) + " by " + safe(version.published_by) +
                (version.reason.empty() ? "" : ": " + safe(version.reason)) + "</li>";
    const auto locked = std::count_if(report.record_states.begin(), report.record_states.end(),
                                      [](const auto& entry) { return entry.second.locked; });
    html += "<li>Records locked: " + QString::number(locked) + " of " +
            QString::number(report.everybody.size()) +
            "; answers corrected after they were submitted: " +
            QString::number(report.corrections.size()) + ".</li>";
    for (const auto& [code, state] : report.record_states) {
        if (!state.signature) continue;
        html += "<li>" + safe(code) + ": signed by " + safe(state.signature->name) + ", " +
                safe(state.signature->at_utc) + ", meaning: " + safe(state.signature->remark) +
                ", record " + safe(state.signature->checksum.substr(0, 16)) + "..." +
                (state.signature_fits ? "" : " <b>The record was changed after this.</b>") +
                "</li>";
    }
    paper.html("<ul>" + html + "</ul>");
}

}  // namespace placode::reports
