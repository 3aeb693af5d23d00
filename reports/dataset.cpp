// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/dataset.h"

#include <QDateTime>
#include <algorithm>
#include <set>

#include "reports/dataset_forms.h"
#include "reports/report.h"

namespace placode::reports {
namespace {

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

int Field::not_applicable_code() const {
    int code = 99, highest = 0;
    for (const Code& each : codes) highest = std::max(highest, each.value);
    while (code - 2 <= highest) code = 10 * code + 9;
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

namespace {

/// In this order. Throws where one is gone: no file leaves data out without a word.
std::vector<db::AttemptDetail> attempts_of(db::Store& store, const std::vector<int64_t>& ids) {
    auto found = store.attempts().details(ids);
    std::vector<db::AttemptDetail> attempts;
    for (const int64_t id : ids) {
        const auto at = found.find(id);
        attempts.push_back(at != found.end() ? std::move(at->second) : store.attempts().detail(id));
    }
    return attempts;
}

/// The attempts of a study, each of the step it was made for. Getting used to the instruments is no
/// data.
void add_attempts(db::Store& store, const std::string& study_id, const DatasetOptions& options,
                  const std::set<std::string>& usable, const Protocols& protocols,
                  std::vector<db::StepRecord>& steps, Dataset& data) {
    std::vector<std::string> owners;
    std::vector<int64_t> ids;
    std::set<int64_t> seen;
    std::map<int64_t, const db::StepRecord*> step_of;
    int visits = 1;
    std::stable_sort(steps.begin(), steps.end(),
                     [](const auto& a, const auto& b) { return a.participant < b.participant; });
    for (const auto& step : steps) {
        if (step.attempt_id == 0 || !usable.contains(step.participant)) continue;
        if (!seen.insert(step.attempt_id).second) continue;
        // An amendment may have dropped the step, and has no say in what it was.
        const auto* protocol = protocols.of(step.participant);
        const auto* asked = protocol != nullptr ? protocol->step(step.step) : nullptr;
        if (asked != nullptr && asked->kind == curriculum::StepKind::kFamiliarisation) continue;
        ids.push_back(step.attempt_id);
        owners.push_back(step.participant);
        step_of[step.attempt_id] = &step;
        visits = std::max(visits, step.visit);
    }
    if (ids.empty()) return;
    data.attempts = attempts_of(store, ids);
    Form form = attempts_form(data.attempts, owners);
    add_study_fields(form, step_of, store.records().step_notes(study_id), options);
    if (visits > 1)
        add_visits(form, visits, [&](const Row& row) { return step_of.at(row.attempt_id)->visit; });
    data.forms.push_back(std::move(form));
}

}  // namespace

Dataset study_dataset(db::Store& store, const std::string& study_id,
                      const DatasetOptions& options) {
    Dataset data;
    data.id = study_id;
    data.title = study_id;
    const auto all = store.studies().participants(study_id);
    const Protocols protocols(store, study_id, all);
    if (const auto* newest = protocols.newest()) {
        data.title = newest->title.in(options.language);
        data.description = newest->description.in(options.language);
        data.version = newest->version;
        data.definition_json = newest->json;
    }
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
                                           db::given_consents(steps), protocols, options));
    for (auto& record : store.studies().answers(study_id))
        if (usable.contains(record.participant)) data.answers.push_back(std::move(record));
    add_questionnaires(store, steps, options, data);
    add_attempts(store, study_id, options, usable, protocols, steps, data);
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
    std::vector<int64_t> ids;
    for (const auto& record : store.attempts().list(user.id)) ids.push_back(record.id);
    data.attempts = attempts_of(store, ids);
    data.forms.push_back(
        attempts_form(data.attempts, std::vector<std::string>(data.attempts.size(), code)));
    finish(store, options, data);
    return data;
}

}  // namespace placode::reports
