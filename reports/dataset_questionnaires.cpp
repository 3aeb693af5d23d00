// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Questionnaires as forms of a data set: fields of their items, scale scores, answers as rows.

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "reports/dataset_forms.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

using curriculum::ItemKind;
using curriculum::QuestionnaireItem;

void fill_codes(Field& field, const QuestionnaireItem& item, const std::string& language) {
    if (item.kind == ItemKind::kLikert) {
        for (int value = item.scale_min; value <= item.scale_max; ++value) {
            const auto at = static_cast<size_t>(value - item.scale_min);
            std::string label;
            if (!item.point_labels.empty())
                label = item.point_labels[at].in(language);
            else if (value == item.scale_min)
                label = item.anchor_low.in(language);
            else if (value == item.scale_max)
                label = item.anchor_high.in(language);
            field.codes.push_back({value, label});
        }
        return;
    }
    for (size_t i = 0; i < item.choices.size(); ++i)
        field.codes.push_back({static_cast<int>(i), item.choices[i].in(language)});
}

Field field_of(const curriculum::Questionnaire& questionnaire, const QuestionnaireItem& item,
               const std::string& language) {
    Field field;
    field.id = item.id;
    field.label = item.text.in(language);
    for (const auto& section : questionnaire.sections)
        if (section.id == item.section) field.section = section.title.in(language);
    field.unit = item.unit;
    field.required = item.required;
    field.reverse = item.reverse;
    field.not_applicable = item.not_applicable;
    field.identifying = item.identifying;
    field.show_if = item.show_if;
    fill_codes(field, item, language);
    switch (item.kind) {
        case ItemKind::kLikert:
            field.ordinal = true;
            [[fallthrough]];
        case ItemKind::kChoice:
            field.kind = FieldKind::kCode;
            break;
        case ItemKind::kMultiple:
            field.kind = FieldKind::kMultiple;
            break;
        case ItemKind::kVisualAnalogue:
            field.analogue = true;
            field.anchor_low = item.anchor_low.in(language);
            field.anchor_high = item.anchor_high.in(language);
            [[fallthrough]];
        case ItemKind::kNumber:
            field.kind = FieldKind::kDecimal;
            field.minimum = item.number_min;
            field.maximum = item.number_max;
            break;
        case ItemKind::kDate:
            field.kind = FieldKind::kDate;
            break;
        case ItemKind::kText:
            field.kind = FieldKind::kText;
            break;
    }
    return field;
}

std::string rule_of(const curriculum::ScaleScore& scale) {
    std::string rule = scale.mean ? "mean of" : "sum of";
    for (const std::string& item : scale.items) rule += " " + item;
    if (scale.factor != 1) rule = shortest_text(scale.factor) + " * " + rule;
    if (scale.offset != 0) rule += " + " + shortest_text(scale.offset);
    return rule;
}

Form questionnaire_form(const curriculum::Questionnaire& questionnaire,
                        const DatasetOptions& options) {
    Form form;
    form.id = form.name = questionnaire.id;
    form.version = questionnaire.version;
    form.title = questionnaire.title.in(options.language);
    form.introduction = questionnaire.introduction.in(options.language);
    form.source = questionnaire.source;
    form.licence = questionnaire.licence;
    for (const QuestionnaireItem& item : questionnaire.items)
        if (options.identifying || !item.identifying)
            form.fields.push_back(field_of(questionnaire, item, options.language));
    for (const auto& scale : questionnaire.scales) {
        Field field;
        field.id = scale.id;
        field.label = scale.title.in(options.language);
        field.kind = FieldKind::kDecimal;
        field.derived = true;
        field.rule = rule_of(scale);
        form.fields.push_back(field);
    }
    return form;
}

Row answer_row(const curriculum::Questionnaire& questionnaire, const Form& form,
               const db::AnswerRecord& record) {
    Row row;
    row.participant = record.participant;
    row.answer_id = record.id;
    row.at_utc = record.answered_utc;
    row.language = record.language;
    row.demonstration = record.demonstration;
    for (const auto& [id, answer] : record.answers)
        if (form.field(id) != nullptr && !answer.empty()) row.values[id] = answer;
    for (const QuestionnaireItem& item : questionnaire.items)
        if (!is_shown(questionnaire, item, record.answers)) row.not_asked.insert(item.id);
    for (const auto& score : scale_scores(questionnaire, record.answers))
        if (score.value) row.values[score.id] = shortest_text(*score.value);
    return row;
}

/// By set of answers: the step of the protocol that asked for them.
using StepOfAnswers = std::map<int64_t, std::string>;

/// Questionnaires that were answered at several steps, as before and after a training.
std::set<std::string> asked_at_several(const Dataset& data, const StepOfAnswers& step_of) {
    std::map<std::string, std::set<std::string>> asked;
    for (const db::AnswerRecord& record : data.answers)
        if (const auto found = step_of.find(record.id); found != step_of.end())
            asked[record.questionnaire_id].insert(found->second);
    std::set<std::string> several;
    for (const auto& [id, at] : asked)
        if (at.size() > 1) several.insert(id);
    return several;
}

/// By participant and visit: the first answers are those of the first visit, whenever they were
/// entered. Those of one visit stay in the order of saving.
void sort_by_visit(std::vector<const db::AnswerRecord*>& records) {
    std::sort(records.begin(), records.end(), [](const auto* a, const auto* b) {
        return std::tie(a->participant, a->visit, a->id) <
               std::tie(b->participant, b->visit, b->id);
    });
}

/// Puts the step in front of a form's fields: "step", or "study_step" where an item is called so.
void add_steps(Form& form, const StepOfAnswers& step_of) {
    const std::string id = form.field("step") == nullptr ? "step" : "study_step";
    form.fields.insert(form.fields.begin(), text_field(id, "Step of the protocol"));
    for (Row& row : form.rows)
        if (const auto found = step_of.find(row.answer_id); found != step_of.end())
            row.values[id] = found->second;
}

}  // namespace

void add_questionnaires(db::Store& store, const std::vector<db::StepRecord>& steps,
                        const DatasetOptions& options, Dataset& data) {
    StepOfAnswers step_of;
    for (const db::StepRecord& step : steps)
        if (step.answer_id != 0) step_of[step.answer_id] = step.step;
    const std::set<std::string> several = asked_at_several(data, step_of);
    std::map<std::pair<std::string, int>, std::vector<const db::AnswerRecord*>> groups;
    std::map<std::string, int> versions;
    for (const db::AnswerRecord& record : data.answers) {
        auto& group = groups[{record.questionnaire_id, record.questionnaire_version}];
        if (group.empty()) ++versions[record.questionnaire_id];
        group.push_back(&record);
    }
    int visits = 1;
    for (const db::AnswerRecord& record : data.answers) visits = std::max(visits, record.visit);
    for (auto& [key, records] : groups) {
        sort_by_visit(records);
        const auto questionnaire = questionnaire_of(store, key.first, key.second);
        Form form = questionnaire_form(questionnaire, options);
        if (versions[key.first] > 1) form.name += "_v" + std::to_string(key.second);
        for (const db::AnswerRecord* record : records)
            form.rows.push_back(answer_row(questionnaire, form, *record));
        if (several.contains(key.first)) add_steps(form, step_of);
        if (visits > 1) {
            size_t next = 0;  // The rows stand in the order of the records still.
            add_visits(form, visits, [&](const Row&) { return records[next++]->visit; });
        }
        number_rows(form);
        data.questionnaire_json[key.first + "_v" + std::to_string(key.second)] = questionnaire.json;
        data.forms.push_back(std::move(form));
    }
}

curriculum::Questionnaire questionnaire_of(db::Store& store, const std::string& id, int version) {
    const std::string name = id + " version " + std::to_string(version);
    if (const auto published = store.definitions().find("questionnaire", id, version))
        return curriculum::load_questionnaire_text(published->json, "questionnaire " + name);
    const auto known = curriculum::list_definitions("questionnaires");
    if (std::find(known.begin(), known.end(), id) != known.end()) {
        auto shipped = curriculum::load_questionnaire(id);
        if (shipped.version == version) return shipped;
    }
    throw ReportError("read the questionnaire " + name +
                      ": it is neither published in the store nor shipped with this program; "
                      "publish its file with `placodectl questionnaire publish`");
}

}  // namespace placode::reports
