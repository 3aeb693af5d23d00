// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/dataset_forms.h"

#include <algorithm>
#include <cmath>

#include "db/attempt_counting.h"
#include "reports/report.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {

Field text_field(const std::string& id, const std::string& label) {
    Field field;
    field.id = id;
    field.label = label;
    return field;
}

/// Counts the rows of each participant; a form with a second row repeats.
void number_rows(Form& form) {
    std::stable_sort(form.rows.begin(), form.rows.end(),
                     [](const Row& a, const Row& b) { return a.participant < b.participant; });
    std::map<std::string, int> count;
    for (Row& row : form.rows) {
        row.instance = ++count[row.participant];
        form.repeating = form.repeating || row.instance > 1;
    }
}

Field code_field(const std::string& id, const std::string& label, std::vector<Code> codes) {
    Field field;
    field.id = id;
    field.label = label;
    field.kind = FieldKind::kCode;
    field.codes = std::move(codes);
    return field;
}

void add_visits(Form& form, int visits, const std::function<int(const Row&)>& visit_of) {
    std::vector<Code> codes;
    for (int visit = 1; visit <= visits; ++visit)
        codes.push_back({visit, "visit " + std::to_string(visit)});
    const std::string id = form.field("visit") == nullptr ? "visit" : "visit_number";
    form.fields.insert(form.fields.begin(), code_field(id, "Visit", std::move(codes)));
    for (Row& row : form.rows) row.values[id] = std::to_string(visit_of(row));
}

namespace {

void add_attempt_fields(Form& form) {
    for (const auto& [id, label] : std::initializer_list<std::pair<const char*, const char*>>{
             {"task_id", "Task"},
             {"started_utc", "Started (UTC)"},
             {"device", "Device"},
             {"end", "How it ended"},
             {"verdict", "Verdict"},
             {"rubric_id", "Rubric"},
             {"haptic_grade", "Haptic certificate"},
             {"void_reason", "Void for cause, because"},
             {"build", "Program version and kernel"}})
        form.fields.push_back(text_field(id, label));
    form.fields.push_back(code_field("counts", "Counts in analyses", {{0, "no"}, {1, "yes"}}));
    const auto add_number = [&](const std::string& id, const std::string& label,
                                const std::string& unit) {
        Field field = text_field(id, label);
        field.kind = FieldKind::kDecimal;
        field.unit = unit;
        form.fields.push_back(field);
    };
    add_number("attempt_id", "Number of the attempt in the store", "");
    add_number("task_version", "Version of the task", "");
    add_number("duration_s", "Duration", "s");
    add_number("points", "Score", "points of 100");
    add_number("rubric_version", "Version of the rubric", "");
    add_number("metric_set_version", "Version of the metric set", "");
    for (const auto& definition : assessment::metric_definitions())
        add_number(std::string(definition.id), std::string(definition.name),
                   std::string(definition.unit));
}

Row attempt_row(const db::AttemptDetail& attempt, const std::string& owner) {
    const db::AttemptRecord& record = attempt.record;
    Row row;
    row.participant = owner;
    row.at_utc = record.started_utc;
    row.demonstration = record.demonstration;
    row.attempt_id = record.id;
    row.counts = db::counts(record);
    row.waits = record.replay == db::ReplayState::kWaiting;
    row.values = {{"counts", row.counts ? "1" : "0"},
                  {"attempt_id", std::to_string(record.id)},
                  {"task_version", std::to_string(record.task_version)},
                  {"duration_s", shortest_text(record.duration_s)},
                  {"end", end_word(record.end).toStdString()},
                  {"points", shortest_text(record.points)},
                  {"verdict", verdict_word(record.verdict).toStdString()},
                  {"rubric_version", std::to_string(record.rubric_version)},
                  {"metric_set_version", std::to_string(record.metric_set_version)}};
    for (const auto& [id, text] : {std::pair{"task_id", record.task_id},
                                   {"started_utc", record.started_utc},
                                   {"device", record.device},
                                   {"rubric_id", record.rubric_id},
                                   {"haptic_grade", record.haptic_grade},
                                   {"void_reason", record.void_reason},
                                   {"build", record.build}})
        if (!text.empty()) row.values[id] = text;
    for (const auto& definition : assessment::metric_definitions())
        if (const auto value = attempt.metrics.find(definition.id))
            if (std::isfinite(*value))
                row.values[std::string(definition.id)] = shortest_text(*value);
    return row;
}

}  // namespace

Form attempts_form(const std::vector<db::AttemptDetail>& attempts,
                   const std::vector<std::string>& owners) {
    Form form;
    form.id = form.name = "attempts";
    form.title = "Attempts with scores and metrics";
    add_attempt_fields(form);
    for (size_t i = 0; i < attempts.size(); ++i)
        form.rows.push_back(attempt_row(attempts[i], owners[i]));
    number_rows(form);
    return form;
}

void add_study_fields(Form& form, const std::map<int64_t, const db::StepRecord*>& steps,
                      const std::vector<db::StepNote>& notes, const DatasetOptions& options) {
    form.fields.insert(form.fields.begin(), text_field("step", "Step of the protocol"));
    form.fields.push_back(text_field("not_done", "Why the step was still to be done after it"));
    form.fields.push_back(
        code_field("superseded", "Done again: another attempt counts", {{0, "no"}, {1, "yes"}}));
    form.fields.push_back(text_field("superseded_reason", "Done again, because"));
    form.fields.push_back(text_field("superseded_utc", "Marked as done again (UTC)"));
    if (options.identifying) {
        form.fields.push_back(text_field("superseded_by", "Marked as done again by"));
        form.fields.back().identifying = true;
    }
    form.fields.push_back(text_field("note", "Notes of the coordinator"));
    for (Row& row : form.rows) {
        const db::StepRecord& step = *steps.at(row.attempt_id);
        const auto fill = [&](const char* id, const std::string& text) {
            if (!text.empty()) row.values[id] = text;
        };
        fill("step", step.step);
        if (step.state == db::StepState::kStarted) fill("not_done", step.detail);
        fill("superseded", step.superseded() ? "1" : "0");
        fill("superseded_reason", step.superseded_reason);
        fill("superseded_utc", step.superseded_utc);
        if (options.identifying) fill("superseded_by", step.superseded_by);
        std::string said;
        for (const db::StepNote& note : notes)
            if (note.code == step.participant && note.visit == step.visit && note.step == step.step)
                said += (said.empty() ? "" : "; ") + note.note;
        fill("note", said);
        row.counts = row.counts && !step.superseded() && step.state == db::StepState::kDone;
        row.values["counts"] = row.counts ? "1" : "0";
    }
}

Form deviations_form(const std::vector<db::Deviation>& deviations, const DatasetOptions& options) {
    Form form;
    form.id = form.name = "deviations";
    form.title = "Deviations from the protocol";
    std::vector<Code> kinds;
    for (int i = 0; i < db::kDeviationKinds; ++i)
        kinds.push_back({i, db::deviation_name(static_cast<db::DeviationKind>(i))});
    form.fields = {text_field("step", "Step of the protocol"),
                   code_field("kind", "Kind", std::move(kinds)),
                   text_field("what", "What happened"), text_field("at_utc", "Recorded (UTC)")};
    for (const auto& [id, label, unit] : {std::tuple{"visit", "Visit", ""},
                                          {"attempt_id", "Number of the attempt in the store", ""},
                                          {"count", "How many times", ""},
                                          {"seconds", "Duration", "s"}}) {
        Field field = text_field(id, label);
        field.kind = FieldKind::kDecimal;
        field.unit = unit;
        form.fields.push_back(field);
    }
    if (options.identifying) {
        form.fields.push_back(text_field("by", "Decided or noted by"));
        form.fields.back().identifying = true;
    }
    for (const db::Deviation& each : deviations) {
        Row row;
        row.participant = each.participant;
        row.at_utc = each.at_utc;
        row.values = {{"step", each.step},
                      {"kind", std::to_string(static_cast<int>(each.kind))},
                      {"what", deviation_words(each, Language::kEnglish).toStdString()},
                      {"at_utc", each.at_utc},
                      {"visit", std::to_string(each.visit)}};
        if (each.attempt_id != 0) row.values["attempt_id"] = std::to_string(each.attempt_id);
        if (each.count > 0) row.values["count"] = std::to_string(each.count);
        if (each.seconds > 0) row.values["seconds"] = shortest_text(each.seconds);
        if (options.identifying && !each.by.empty()) row.values["by"] = each.by;
        form.rows.push_back(std::move(row));
    }
    number_rows(form);
    return form;
}

}  // namespace placode::reports
