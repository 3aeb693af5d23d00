// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/dataset.h"

#include <QDateTime>
#include <QLocale>
#include <QUrl>
#include <QUuid>
#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/dataset_forms.h"
#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

using curriculum::ItemKind;
using curriculum::QuestionnaireItem;

/// Longest name that every format takes: REDCap asks for 26 characters at most.
constexpr size_t kLongestName = 26;

/// Names that are unique in the whole data set: REDCap has one name space.
class Names {
 public:
    std::string make(const std::string& form, const std::string& id) {
        std::string name = plain_name(form.substr(0, 8) + "_" + id).substr(0, kLongestName);
        for (int i = 2; !used_.insert(name).second; ++i) {
            const std::string tail = "_" + std::to_string(i);
            name = name.substr(0, kLongestName - tail.size()) + tail;
        }
        return name;
    }

 private:
    std::set<std::string> used_{"record_id"};
};

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

void add_questionnaires(db::Store& store, const DatasetOptions& options, Dataset& data) {
    std::map<std::pair<std::string, int>, std::vector<const db::AnswerRecord*>> groups;
    std::map<std::string, int> versions;
    for (const db::AnswerRecord& record : data.answers) {
        auto& group = groups[{record.questionnaire_id, record.questionnaire_version}];
        if (group.empty()) ++versions[record.questionnaire_id];
        group.push_back(&record);
    }
    int visits = 1;
    for (const db::AnswerRecord& record : data.answers) visits = std::max(visits, record.visit);
    for (const auto& [key, records] : groups) {
        const auto questionnaire = questionnaire_of(store, key.first, key.second);
        Form form = questionnaire_form(questionnaire, options);
        if (versions[key.first] > 1) form.name += "_v" + std::to_string(key.second);
        for (const db::AnswerRecord* record : records)
            form.rows.push_back(answer_row(questionnaire, form, *record));
        if (visits > 1) {
            size_t next = 0;  // The rows stand in the order of the records still.
            add_visits(form, visits, [&](const Row&) { return records[next++]->visit; });
        }
        number_rows(form);
        data.questionnaire_json[key.first + "_v" + std::to_string(key.second)] = questionnaire.json;
        data.forms.push_back(std::move(form));
    }
}

/// From the first entry of the audit trail: the making of the store.
std::string identity_of(db::Store& store) {
    static const QUuid space(QStringLiteral("{c4a0bb0e-52a6-5f2d-8d11-7c3a9e0f4b21}"));
    std::string first;
    if (const auto made = store.audit().first())
        for (const std::string& part : {made->at_utc, made->actor, made->action, made->object})
            first += part + "|";
    return QUuid::createUuidV5(space, QString::fromStdString(first))
        .toString(QUuid::WithoutBraces)
        .toStdString();
}

void finish(db::Store& store, const DatasetOptions& options, Dataset& data) {
    data.origin = identity_of(store);
    data.base_uri = checked_base_uri(options.base_uri);
    data.created_utc = QDateTime::currentDateTimeUtc()
                           .toString(QStringLiteral("yyyy-MM-ddTHH:mm:ssZ"))
                           .toStdString();
    data.software = std::string("Placode ") + PLACODE_VERSION;
    Names names;
    for (Form& form : data.forms) {
        for (Field& field : form.fields) field.name = names.make(form.name, field.id);
        for (const Row& row : form.rows)
            data.demonstration = data.demonstration || row.demonstration;
    }
}

}  // namespace

std::string address_of(const Dataset& data, const std::string& thing) {
    if (!data.base_uri.empty()) return data.base_uri + "/" + thing;
    const QUuid space = QUuid::fromString(QString::fromStdString(data.origin));
    return "urn:uuid:" + QUuid::createUuidV5(space, QString::fromStdString(thing))
                             .toString(QUuid::WithoutBraces)
                             .toStdString();
}

std::string checked_base_uri(const std::string& text) {
    if (text.empty()) return {};
    const QUrl url(QString::fromStdString(text), QUrl::StrictMode);
    const bool web =
        url.scheme() == QLatin1String("https") || url.scheme() == QLatin1String("http");
    if (!url.isValid() || !web || url.host().isEmpty() || url.hasQuery() || url.hasFragment())
        throw ReportError("found \"" + text +
                          "\"; expected an address that the centre owns, such as "
                          "https://fhir.hospital.org/placode");
    std::string base = text;
    while (base.ends_with('/')) base.pop_back();
    return base;
}

int Field::not_applicable_code() const {
    int code = 99, highest = 0;
    for (const Code& each : codes) highest = std::max(highest, each.value);
    while (code <= highest) code = 10 * code + 9;
    return code;
}

const Field* Form::field(const std::string& field_id) const {
    for (const Field& candidate : fields)
        if (candidate.id == field_id) return &candidate;
    return nullptr;
}

const Form* Dataset::form(const std::string& form_id) const {
    for (const Form& candidate : forms)
        if (candidate.id == form_id || candidate.name == form_id) return &candidate;
    return nullptr;
}

std::string plain_name(const std::string& text) {
    std::string name;
    for (const char c : text) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        const bool digit = c >= '0' && c <= '9';
        if (letter)
            name += static_cast<char>(c | 0x20);
        else
            name += digit ? c : '_';
    }
    if (name.empty() || name[0] == '_' || (name[0] >= '0' && name[0] <= '9')) name = "x" + name;
    return name;
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

Dataset study_dataset(db::Store& store, const std::string& study_id,
                      const DatasetOptions& options) {
    Dataset data;
    data.id = study_id;
    data.title = study_id;
    std::optional<curriculum::StudyProtocol> protocol;
    if (const auto published = store.definitions().find("study", study_id)) {
        protocol = curriculum::load_study_text(published->json, "study " + study_id);
        data.title = protocol->title.in(options.language);
        data.description = protocol->description.in(options.language);
        data.version = published->version;
        data.definition_json = published->json;
    }
    const auto all = store.studies().participants(study_id);
    if (all.empty())
        throw ReportError("read the study \"" + study_id + "\": it has no participants in " +
                          store.url() + "; `placodectl study list` shows what there is");
    std::set<std::string> usable;
    for (const auto& each : all) {
        if (each.usable()) {
            usable.insert(each.code);
            data.participants.push_back(each);
        } else {
            ++data.participants_left_out;
        }
    }
    auto steps = store.studies().steps(study_id);
    data.forms.push_back(participants_form(all, store.records().states(study_id),
                                           db::given_consents(steps), protocol, options));
    for (auto& record : store.studies().answers(study_id))
        if (usable.contains(record.participant)) data.answers.push_back(std::move(record));
    add_questionnaires(store, options, data);
    std::vector<std::string> owners;
    std::set<int64_t> seen;
    std::map<int64_t, const db::StepRecord*> step_of;
    int visits = 1;
    std::stable_sort(steps.begin(), steps.end(),
                     [](const auto& a, const auto& b) { return a.participant < b.participant; });
    for (const auto& step : steps) {
        if (step.attempt_id == 0 || !usable.contains(step.participant)) continue;
        if (!seen.insert(step.attempt_id).second) continue;
        // Getting used to the instruments is no data.
        const auto* asked = protocol ? protocol->step(step.step) : nullptr;
        if (asked != nullptr && asked->kind == curriculum::StepKind::kFamiliarisation) continue;
        data.attempts.push_back(store.attempts().detail(step.attempt_id));
        owners.push_back(step.participant);
        step_of[step.attempt_id] = &step;
        visits = std::max(visits, step.visit);
    }
    if (!data.attempts.empty()) {
        Form form = attempts_form(data.attempts, owners);
        add_study_fields(form, step_of, store.records().step_notes(study_id), options);
        if (visits > 1)
            add_visits(form, visits,
                       [&](const Row& row) { return step_of.at(row.attempt_id)->visit; });
        data.forms.push_back(std::move(form));
    }
    for (auto& each : db::study_deviations(store, study_id))
        if (usable.contains(each.participant)) data.deviations.push_back(std::move(each));
    if (!data.deviations.empty()) data.forms.push_back(deviations_form(data.deviations, options));
    finish(store, options, data);
    return data;
}

Dataset user_dataset(db::Store& store, const db::UserRecord& user, const DatasetOptions& options) {
    Dataset data;
    data.id = "user_" + std::to_string(user.id);
    data.title = "Attempts of account " + std::to_string(user.id);
    const std::string code = "U" + std::to_string(user.id);
    if (options.identifying) {
        Form person;
        person.id = person.name = "person";
        person.title = "Person";
        for (const auto& [id, label, value] : {std::tuple{"login", "Login", user.login},
                                               {"display_name", "Name", user.display_name}}) {
            person.fields.push_back(text_field(id, label));
            person.fields.back().identifying = true;
            if (person.rows.empty()) person.rows.emplace_back();
            person.rows.back().participant = code;
            person.rows.back().values[id] = value;
        }
        person.rows.back().demonstration = user.demonstration;
        data.forms.push_back(std::move(person));
    }
    for (const auto& record : store.attempts().list(user.id))
        data.attempts.push_back(store.attempts().detail(record.id));
    data.forms.push_back(
        attempts_form(data.attempts, std::vector<std::string>(data.attempts.size(), code)));
    finish(store, options, data);
    return data;
}

std::string cell_key(const Form& form, const Row& row, const Field& field) {
    return form.name + "|" + row.participant + "|" + std::to_string(row.instance) + "|" + field.id;
}

Cells cells_of(const Dataset& data) {
    Cells cells;
    for (const Form& form : data.forms) {
        for (const Row& row : form.rows) {
            for (const Field& field : form.fields) {
                const auto found = row.values.find(field.id);
                if (found != row.values.end()) cells[cell_key(form, row, field)] = found->second;
            }
        }
    }
    return cells;
}

void compare_cells(const Cells& expected, const Cells& found, const std::string& what) {
    const auto fail = [&](const std::string& key, const std::string& problem) {
        throw ReportError(what + ": read back, " + key + " (form|participant|instance|field) " +
                          problem + "; nothing was handed out");
    };
    for (const auto& [key, value] : expected) {
        const auto other = found.find(key);
        if (other == found.end()) fail(key, "is missing");
        if (other->second == value) continue;
        const auto a = curriculum::answer_number(value);
        const auto b = curriculum::answer_number(other->second);
        if (a && b && *a == *b) continue;
        fail(key, "is \"" + other->second + "\"; the store has \"" + value + "\"");
    }
    for (const auto& [key, value] : found)
        if (!expected.contains(key)) fail(key, "is \"" + value + "\"; the store has nothing there");
}

}  // namespace placode::reports
