// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Answers of participants, with what was changed before they were submitted.

#include "db/store_context.h"
#include "db/studies.h"

namespace placode::db {
namespace {

/// Adds the changes to answers that are sorted by id.
void read_changes(Connection& connection, const std::string& study_id,
                  std::vector<AnswerRecord>& answers) {
    Statement query(connection,
                    "SELECT c.answer_id, c.item, c.old_answer, c.new_answer, c.at_utc FROM "
                    "answer_changes c JOIN answers a ON a.id = c.answer_id WHERE a.study_id = ? "
                    "ORDER BY c.answer_id, c.position");
    query.run(study_id);
    size_t at = 0;
    while (query.next()) {
        const int64_t answer_id = query.integer("answer_id");
        while (at < answers.size() && answers[at].id < answer_id) ++at;
        if (at == answers.size()) return;
        answers[at].changes.push_back({query.text("item"), query.text("old_answer"),
                                       query.text("new_answer"), query.text("at_utc")});
    }
}

AnswerRecord read_answers(const Statement& row) {
    AnswerRecord record;
    record.id = row.integer("id");
    record.study_id = row.text("study_id");
    record.participant = row.text("participant");
    record.questionnaire_id = row.text("questionnaire_id");
    record.questionnaire_version = static_cast<int>(row.integer("questionnaire_version"));
    record.answered_utc = row.text("answered_utc");
    record.demonstration = row.integer("demonstration") != 0;
    record.language = row.text("language");
    record.visit = static_cast<int>(row.integer("visit"));
    return record;
}

}  // namespace

int64_t Studies::save_answers(const AnswerRecord& answers) {
    connection_.begin_operation("save answers in");
    context_.need(Action::kRunQuestionnaire);
    UnitOfWork work(connection_);
    context_.need_active_participant(answers.study_id, answers.participant, "");
    context_.touch("participant", {answers.study_id, answers.participant});
    Statement insert(
        connection_,
        "INSERT INTO answers (study_id, participant, questionnaire_id, "
        "questionnaire_version, answered_utc, demonstration, language, visit) VALUES (?, ?, ?, ?, "
        "?, ?, ?, ?) RETURNING id");
    insert.run(answers.study_id, answers.participant, answers.questionnaire_id,
               answers.questionnaire_version,
               answers.answered_utc.empty() ? utc_now() : answers.answered_utc,
               answers.demonstration, answers.language, answers.visit);
    const int64_t id = insert.returned_id();
    Statement item(connection_,
                   "INSERT INTO answer_items (answer_id, item, answer) VALUES (?, ?, ?)");
    for (const auto& [name, value] : answers.answers) item.run(id, name, value);
    Statement change(connection_,
                     "INSERT INTO answer_changes (answer_id, position, item, old_answer, "
                     "new_answer, at_utc) VALUES (?, ?, ?, ?, ?, ?)");
    int position = 0;
    for (const AnswerChange& each : answers.changes)
        change.run(id, position++, each.item, each.old_answer, each.new_answer, each.at_utc);
    context_.append_audit(
        "study.answers", answers.study_id + " " + answers.participant,
        answers.questionnaire_id + " version " + std::to_string(answers.questionnaire_version));
    work.commit();
    return id;
}

std::vector<AnswerRecord> Studies::answers(const std::string& study_id) {
    connection_.begin_operation("read answers from");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
    Statement query(
        connection_,
        "SELECT a.id, a.study_id, a.participant, a.questionnaire_id, "
        "a.questionnaire_version, a.answered_utc, a.demonstration, a.language, a.visit, i.item, "
        "i.answer "
        "FROM answers a LEFT JOIN answer_items i ON i.answer_id = a.id WHERE a.study_id "
        "= ? ORDER BY a.id, i.item");
    query.run(study_id);
    std::vector<AnswerRecord> found;
    while (query.next()) {
        if (found.empty() || found.back().id != query.integer("id"))
            found.push_back(read_answers(query));
        if (const std::string item = query.text("item"); !item.empty())
            found.back().answers[item] = query.text("answer");
    }
    read_changes(connection_, study_id, found);
    return found;
}

}  // namespace placode::db
