// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Participants and their answers. Pseudonymous: nothing here knows an account.

#include "db/participant.h"
#include "db/sql_store.h"

namespace placode::db {

using Kind = StoreError::Kind;

std::string SqlStore::new_participant(const std::string& study_id) {
    connection_.begin_operation("add a participant to the study \"" + study_id + "\" in");
    if (study_id.empty()) connection_.fail(Kind::kRefused, "the study has no id");
    UnitOfWork work(connection_);
    connection_.lock_table("participants");
    Statement last(connection_,
                   "SELECT COALESCE(MAX(number), 0) FROM participants WHERE study_id = ?");
    last.run(study_id);
    const int number = last.next() ? static_cast<int>(last.integer(0)) + 1 : 1;
    const std::string code = participant_code(number);
    Statement(connection_,
              "INSERT INTO participants (study_id, code, number, created_utc) VALUES (?, ?, ?, ?)")
        .run(study_id, code, number, utc_now());
    append_audit(actor_, "study.participant", study_id + " " + code, "");
    work.commit();
    return code;
}

int64_t SqlStore::save_answers(const AnswerRecord& answers) {
    connection_.begin_operation("save answers in");
    UnitOfWork work(connection_);
    Statement participant(connection_,
                          "SELECT code FROM participants WHERE study_id = ? AND code = ?");
    if (!participant.run(answers.study_id, answers.participant).next())
        connection_.fail(Kind::kNotFound, "the study \"" + answers.study_id +
                                              "\" has no participant \"" + answers.participant +
                                              "\"; check the code");
    Statement insert(
        connection_,
        "INSERT INTO answers (study_id, participant, questionnaire_id, "
        "questionnaire_version, answered_utc, demonstration) VALUES (?, ?, ?, ?, ?, ?) "
        "RETURNING id");
    insert.run(answers.study_id, answers.participant, answers.questionnaire_id,
               answers.questionnaire_version,
               answers.answered_utc.empty() ? utc_now() : answers.answered_utc,
               answers.demonstration);
    const int64_t id = insert.returned_id();
    Statement item(connection_,
                   "INSERT INTO answer_items (answer_id, item, answer) VALUES (?, ?, ?)");
    for (const auto& [name, value] : answers.answers) item.run(id, name, value);
    append_audit(
        actor_, "study.answers", answers.study_id + " " + answers.participant,
        answers.questionnaire_id + " version " + std::to_string(answers.questionnaire_version));
    work.commit();
    return id;
}

std::vector<AnswerRecord> SqlStore::answers(const std::string& study_id) {
    connection_.begin_operation("read answers from");
    Statement query(
        connection_,
        "SELECT a.id, a.study_id, a.participant, a.questionnaire_id, "
        "a.questionnaire_version, a.answered_utc, a.demonstration, i.item, i.answer "
        "FROM answers a LEFT JOIN answer_items i ON i.answer_id = a.id WHERE a.study_id "
        "= ? ORDER BY a.id, i.item");
    query.run(study_id);
    std::vector<AnswerRecord> found;
    while (query.next()) {
        if (found.empty() || found.back().id != query.integer(0)) {
            AnswerRecord record;
            record.id = query.integer(0);
            record.study_id = query.text(1);
            record.participant = query.text(2);
            record.questionnaire_id = query.text(3);
            record.questionnaire_version = static_cast<int>(query.integer(4));
            record.answered_utc = query.text(5);
            record.demonstration = query.integer(6) != 0;
            found.push_back(std::move(record));
        }
        if (const std::string item = query.text(7); !item.empty())
            found.back().answers[item] = query.text(8);
    }
    return found;
}

}  // namespace placode::db
