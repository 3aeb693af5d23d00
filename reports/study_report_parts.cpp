// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_report_parts.h"

#include <algorithm>
#include <set>

#include "curriculum/study.h"
#include "reports/study_analysis.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

constexpr const char* kRatersForm = "osats";

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
    paper.table("<b>" + safe(analysis.title) + ".</b> " + safe(analysis.method) +
                    (analysis.caution.empty() ? "" : " " + safe(analysis.caution)),
                head, QString("l") + QString(static_cast<int>(analysis.head.size()) - 1, 'r'),
                rows);
    for (const Figure& figure : analysis.figures) paper.figure(figure);
}

/// What the step is called on the participant's screen, or its id.
std::string step_title(const StudyReport& report, const db::Deviation& deviation) {
    const curriculum::StudyProtocol* protocol = report.protocols.of(deviation.participant);
    const auto* step = protocol == nullptr ? nullptr : protocol->step(deviation.step);
    return step == nullptr || step->title.en.empty() ? deviation.step : step->title.en;
}

}  // namespace

void write_analyses(Paper& paper, const StudyReport& report) {
    write_analysis_table(paper, learning_curves(report));
    write_analysis_table(paper, construct_validity(report, {}));
    write_analysis_table(paper, test_retest(report));
    write_analysis_table(paper, rater_agreement(report, report.ratings,
                                                curriculum::load_questionnaire(kRatersForm)));
}

void write_deviations(Paper& paper, const StudyReport& report) {
    paper.heading("Deviations from the protocol");
    std::vector<QStringList> counts, list;
    for (int i = 0; i < db::kDeviationKinds; ++i) {
        const auto kind = static_cast<db::DeviationKind>(i);
        std::set<std::string> people;
        int times = 0;
        for (const db::Deviation& each : report.data.deviations) {
            if (each.kind != kind) continue;
            people.insert(each.participant);
            ++times;
        }
        if (times > 0)
            counts.push_back({deviation_title(kind, Language::kEnglish), QString::number(times),
                              QString::number(people.size())});
    }
    if (counts.empty()) {
        paper.html("<p>None was recorded.</p>");
        return;
    }
    paper.table(
        "Deviations from the protocol by kind: how many, and in how many participants. Pauses and "
        "slow spells are those of one procedure together. Notes are remarks of the coordinator and "
        "no deviations. Attempts that were done again, were broken off, ended too early or are "
        "void "
        "are in no analysis.",
        {"kind", "n", "participants"}, "lrr", counts);
    for (const db::Deviation& each : report.data.deviations)
        list.push_back({safe(each.participant), safe(step_title(report, each)),
                        deviation_title(each.kind, Language::kEnglish),
                        deviation_words(each, Language::kEnglish).toHtmlEscaped()});
    paper.table("Every deviation, by code.", {"code", "step", "kind", "what happened"}, "llll",
                list);
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
