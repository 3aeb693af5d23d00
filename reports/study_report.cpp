// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study_report.h"

#include <algorithm>
#include <set>

#include "reports/paper.h"
#include "reports/study_report_parts.h"

namespace placode::reports {

namespace {

/// Of the attempts that count.
PassMarks marks_of(db::Store& store, const Dataset& data) {
    std::vector<JudgedAttempt> judged;
    const Form* form = data.form("attempts");
    const size_t n = form == nullptr ? 0 : std::min(form->rows.size(), data.attempts.size());
    for (size_t i = 0; i < n; ++i) {
        const db::AttemptRecord& record = data.attempts[i].record;
        if (form->rows[i].counts)
            judged.push_back({record.task_id, record.task_version, record.started_utc});
    }
    return pass_marks_of(store, judged);
}

/// Whether the flow of participants shows how many did the step.
bool in_the_flow(const curriculum::StudyStep& step) {
    return step.kind == curriculum::StepKind::kQuestionnaire ||
           step.kind == curriculum::StepKind::kProcedure;
}

std::vector<const curriculum::StudyStep*> flow_steps(const Protocols& protocols) {
    std::vector<const curriculum::StudyStep*> list;
    for (const curriculum::StudyProtocol* protocol : protocols.in_use()) {
        auto behind = list.begin();
        for (const curriculum::StudyStep& step : protocol->steps) {
            if (!in_the_flow(step)) continue;
            const auto same = std::ranges::find(list, step.id, &curriculum::StudyStep::id);
            behind = same == list.end() ? list.insert(behind, &step) : same;
            ++behind;
        }
    }
    return list;
}

/// How many did each step, by what it is in their own version; the consent is counted as "".
std::map<std::string, int> people_by_step(const StudyReport& report) {
    std::map<std::string, std::set<std::string>> done;
    for (const db::StepRecord& record : report.steps)
        if (record.state == db::StepState::kDone && !record.superseded())
            done[record.participant].insert(record.step);
    std::map<std::string, int> people;
    for (const db::ParticipantRecord& each : report.everybody) {
        const curriculum::StudyProtocol* protocol = report.protocols.of(each.code);
        if (protocol == nullptr) continue;
        bool consented = false;
        for (const curriculum::StudyStep& step : protocol->steps) {
            if (!done[each.code].contains(step.id)) continue;
            if (in_the_flow(step)) ++people[step.id];
            consented = consented || step.kind == curriculum::StepKind::kConsent;
        }
        if (consented) ++people[""];
    }
    return people;
}

}  // namespace

StudyReport read_study_report(db::Store& store, const std::string& study_id,
                              const std::string& language) {
    StudyReport report;
    report.data = study_dataset(store, study_id, {false, language});
    for (const Form& form : report.data.forms)
        if (is_questionnaire(form))
            report.instruments.push_back(questionnaire_of(store, form.id, form.version));
    report.everybody = store.studies().participants(study_id);
    report.protocols = Protocols(store, study_id, report.everybody);
    report.steps = store.studies().steps(study_id);
    for (auto& version : store.definitions().list("study"))
        if (version.id == study_id) report.versions.push_back(std::move(version));
    report.record_events = store.records().events(study_id);
    report.record_states = store.records().states(study_id);
    report.corrections = store.records().corrections(study_id);
    report.ratings = store.reviews().ratings("osats");
    report.pass_marks = marks_of(store, report.data);
    return report;
}

FlowNumbers flow_numbers(const StudyReport& report, const std::string& language) {
    FlowNumbers flow;
    flow.enrolled = static_cast<int>(report.everybody.size());
    for (const auto& each : report.everybody) {
        if (!each.withdrawal) continue;
        if (*each.withdrawal == db::WithdrawalMode::kKeep) ++flow.kept;
        if (*each.withdrawal == db::WithdrawalMode::kStop) ++flow.stopped;
        if (*each.withdrawal == db::WithdrawalMode::kErase) ++flow.erased;
    }
    std::set<std::string> answered;
    for (const auto& record : report.data.answers) answered.insert(record.participant);
    // An attempt that does not count is in no analysis.
    if (const Form* attempts = report.data.form("attempts"))
        for (const Row& row : attempts->rows)
            if (row.counts) answered.insert(row.participant);
    std::set<std::string> usable;
    for (const auto& each : report.data.participants) usable.insert(each.code);
    flow.analysed = static_cast<int>(
        std::count_if(answered.begin(), answered.end(),
                      [&](const std::string& code) { return usable.contains(code); }));
    std::map<std::string, int> people = people_by_step(report);
    const auto versions = report.protocols.in_use();
    const bool asked = std::ranges::any_of(
        versions, [](const curriculum::StudyProtocol* each) { return each->needs_consent(); });
    flow.consented = asked ? people[""] : -1;
    for (const curriculum::StudyStep* step : flow_steps(report.protocols))
        flow.reached.emplace_back(step->title.en.empty() ? step->id : step->title.in(language),
                                  people[step->id]);
    return flow;
}

void write_study_pdf(const StudyReport& report, const std::string& path, const ExportPace& pace) {
    const auto tell = [&](const std::string& what) { pace.next({what}); };
    tell("numbers");
    const StudyNumbers numbers = study_numbers(report.data, report.instruments);
    tell("figures");
    const std::vector<Figure> figures = study_figures(report, numbers);
    const auto draw = [&](Paper& paper, const std::string& beginning, const std::string& group) {
        for (const Figure& figure : figures)
            if (figure.group == group && figure.id.rfind(beginning, 0) == 0) paper.figure(figure);
    };
    QString footer = "Placode study " + QString::fromStdString(report.data.id);
    if (report.data.demonstration) footer += " - DEMONSTRATION, simulated data";
    Paper paper(path, QString::fromStdString(report.data.title),
                QString::fromStdString(report.data.software), footer);
    write_title(paper, report);
    write_methods(paper, report);
    paper.heading("Participants");
    draw(paper, "flow", "");
    write_deviations(paper, report);
    for (const FormNumbers& form : numbers.forms) {
        tell(form.form->title);
        paper.heading(QString::fromStdString(form.form->title));
        write_choices(paper, form);
        write_items(paper, form);
        for (const char* kind : {"likert_", "scales_", "strip_"}) {
            draw(paper, kind, form.form->name);
            if (std::string(kind) == "likert_") write_scales(paper, form);
        }
    }
    if (numbers.comparison) {
        paper.heading("Comparison of groups");
        write_comparison(paper, numbers);
        draw(paper, "forest_", "");
    }
    if (!report.data.attempts.empty()) {
        tell("performance");
        paper.heading("Performance");
        write_analyses(paper, report);
    }
    paper.heading("What this sample can carry");
    QString cautions;
    for (const std::string& each : numbers.cautions) cautions += "<li>" + safe(each) + "</li>";
    if (cautions.isEmpty()) cautions = "<li>No statistic shown here needs a caution.</li>";
    paper.html("<ul>" + cautions + "</ul>");
    write_data_care(paper, report);
    write_versions(paper, report);
    tell("pages");
    paper.finish();
}

}  // namespace placode::reports
