// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl study answer | import | demo: answers to questionnaires, typed, from a table,
// simulated.

#include <algorithm>
#include <set>

#include "assessment/csv_reader.h"
#include "db/participant.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "reports/csv_table.h"
#include "reports/export.h"
#include "reports/report.h"
#include "ui/cli/study_options.h"

namespace placode::cli {

Session coordinator(const Context& context, Missing missing) {
    Session session(context, missing);
    session.need(db::Action::kRunQuestionnaire, db::Scope::kOther);
    return session;
}

std::string need_code(const std::string& code) {
    if (!db::valid_participant_code(code))
        throw InputError("participant: found \"" + code +
                         "\", whose check letter does not fit; expected a code such as P001-C");
    return code;
}

curriculum::Questionnaire questionnaire_named(Session& session, const std::string& id) {
    if (id.find('/') == std::string::npos && !id.ends_with(".json"))
        if (const auto published = session.store().definitions().find("questionnaire", id))
            return curriculum::load_questionnaire_text(published->json, "questionnaire " + id);
    return curriculum::load_questionnaire(id);
}

std::vector<std::string> required_statements(Session& session, const std::string& study,
                                             const std::string& code) {
    std::vector<std::string> ids;
    if (const auto protocol = db::protocol_of(session.store(), study, code))
        for (const auto& statement : protocol->consent.statements)
            if (statement.required) ids.push_back(statement.id);
    return ids;
}

namespace {

bool is_demonstration(Session& session, const std::string& study, const std::string& code) {
    for (const auto& each : session.store().studies().participants(study))
        if (each.code == code) return each.demonstration;
    return false;
}

/// One row of a table as answers; an empty cell is no answer.
db::AnswerRecord row_answers(const curriculum::Questionnaire& questionnaire,
                             const std::vector<std::string>& head,
                             const std::vector<std::string>& row, const std::string& place) {
    if (row.size() != head.size())
        throw InputError(place + ": found " + std::to_string(row.size()) + " cells; expected " +
                         std::to_string(head.size()));
    db::AnswerRecord record;
    record.questionnaire_id = questionnaire.id;
    record.questionnaire_version = questionnaire.version;
    for (size_t c = 0; c < head.size(); ++c)
        if (questionnaire.item(head[c]) != nullptr && !row[c].empty())
            record.answers[head[c]] = reports::as_typed(row[c]);
    if (const auto problem = curriculum::check_answers(questionnaire, record.answers))
        throw InputError(place + ": " + problem->english());
    return record;
}

/// The table of a file, with at least one row below its head.
std::vector<assessment::CsvRow> table_of(const std::string& file) {
    std::vector<assessment::CsvRow> rows;
    try {
        rows = assessment::read_csv(reports::read_file(file));
    } catch (const assessment::CsvError& error) {
        throw InputError(file + ": " + error.what());
    }
    if (rows.size() < 2) throw InputError(file + ": holds no rows");
    const auto& head = rows[0].cells;
    if (head.size() == 1 && head[0].find(';') != std::string::npos)
        throw InputError(file +
                         ":1: found semicolons between the names; expected commas: save it as "
                         "CSV with commas");
    return rows;
}

/// Throws InputError unless the participant is there and takes part.
void need_active(Session& session, const std::string& study, const std::string& code,
                 const std::string& place) {
    for (const auto& each : session.store().studies().participants(study)) {
        if (each.code != code) continue;
        if (each.withdrawal) throw InputError(place + ": " + code + " has withdrawn");
        if (session.store().records().states(study)[code].locked)
            throw InputError(place + ": the record of " + code + " is locked");
        return;
    }
    throw InputError(place + ": the study " + study + " has no participant " + code);
}

}  // namespace

int study_answer(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    const auto questionnaire = questionnaire_named(session, options.questionnaire);
    db::AnswerRecord record;
    record.study_id = options.id;
    record.participant = need_code(options.code);
    record.questionnaire_id = questionnaire.id;
    record.questionnaire_version = questionnaire.version;
    record.language = options.language;
    record.visit = options.visit;
    record.demonstration = is_demonstration(session, options.id, options.code);
    for (const std::string& pair : options.answers) {
        const size_t at = pair.find('=');
        if (at == std::string::npos || at == 0)
            throw InputError("answer: found \"" + pair + "\"; expected ITEM=VALUE");
        record.answers[pair.substr(0, at)] = pair.substr(at + 1);
    }
    const int64_t id =
        as_input([&] { return db::submit_answers(session.store(), questionnaire, record); });
    Json json{{"participant", options.code}, {"questionnaire", questionnaire.id}, {"answers", id}};
    std::string text = options.code + ": answers to " + questionnaire.id + " saved";
    for (const auto& score : curriculum::scale_scores(questionnaire, record.answers)) {
        json["scores"][score.id] = score.value ? Json(*score.value) : Json();
        text += "\n" + score.id + ": " + (score.value ? shortest(*score.value) : "too few answers");
    }
    print(context, json, text);
    return 0;
}

/// Answers from a table: one row a participant, one column an item; the column "participant" says
/// whose they are. Everything is checked before anything is saved.
int study_import(const Context& context, const StudyOptions& options) {
    Session session = coordinator(context);
    const auto questionnaire = questionnaire_named(session, options.questionnaire);
    const auto rows = table_of(options.file);
    const auto& head = rows[0].cells;
    const auto whose = std::find(head.begin(), head.end(), "participant");
    if (whose == head.end())
        throw InputError(options.file + ":1: there is no column \"participant\"");
    if (std::none_of(head.begin(), head.end(),
                     [&](const auto& name) { return questionnaire.item(name) != nullptr; }))
        throw InputError(options.file + ":1: there is no column of " + questionnaire.id +
                         "; its items are called " + questionnaire.items.front().id + ", ...");
    std::vector<db::AnswerRecord> records;
    std::set<std::string> seen;
    for (size_t r = 1; r < rows.size(); ++r) {
        const std::string place = options.file + ":" + std::to_string(rows[r].line);
        const auto& cells = rows[r].cells;
        db::AnswerRecord record = row_answers(questionnaire, head, cells, place);
        record.participant = need_code(cells[static_cast<size_t>(whose - head.begin())]);
        if (!seen.insert(record.participant).second)
            throw InputError(place + ": " + record.participant + " has a row above already");
        need_active(session, options.id, record.participant, place);
        record.study_id = options.id;
        record.language = options.language;
        record.visit = options.visit;
        record.demonstration = is_demonstration(session, options.id, record.participant);
        records.push_back(std::move(record));
    }
    for (const auto& record : records)
        as_input([&] { return db::submit_answers(session.store(), questionnaire, record); });
    print(context, {{"study", options.id}, {"rows", records.size()}},
          std::to_string(records.size()) + " sets of answers to " + questionnaire.id + " saved");
    return 0;
}

/// The paper's study with 14 simulated participants: every code, answer and export says so.
int study_demo(const Context& context) {
    Session session = coordinator(context, Missing::kCreate);
    const auto study = curriculum::load_study("face_content_validity");
    if (!session.store().studies().participants(study.id).empty())
        throw InputError("study demo: " + study.id + " has participants in " +
                         session.store().url() + "; expected an empty study");
    for (const char* id : {"demographics", "face_validity"})
        db::publish_on_first_use(session.store(), curriculum::load_questionnaire(id));
    db::DefinitionRecord definition;
    definition.kind = "study";
    definition.id = study.id;
    definition.version = study.version;
    definition.json = study.json;
    definition.reason = study.reason;
    session.store().definitions().publish(definition);
    const std::string file =
        (curriculum::data_folder() / "studies" / "face_content_validity_simulated.csv").string();
    const auto rows = table_of(file);
    for (size_t r = 1; r < rows.size(); ++r) {
        const std::string code = session.store().studies().new_participant(study.id, true);
        db::record_consent(session.store(), study.id, code, "en",
                           required_statements(session, study.id, code));
        for (const char* id : {"demographics", "face_validity"}) {
            const auto questionnaire = curriculum::load_questionnaire(id);
            db::AnswerRecord record = row_answers(questionnaire, rows[0].cells, rows[r].cells,
                                                  file + ":" + std::to_string(rows[r].line));
            record.study_id = study.id;
            record.participant = code;
            record.demonstration = true;
            db::submit_answers(session.store(), questionnaire, record);
        }
    }
    print(context,
          {{"study", study.id}, {"participants", rows.size() - 1}, {"demonstration", true}},
          study.id + ": " + std::to_string(rows.size() - 1) +
              " SIMULATED participants (demonstration); answers fit the figures that the paper "
              "prints and are nobody's");
    return 0;
}

}  // namespace placode::cli
