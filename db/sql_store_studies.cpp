// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Participants and their answers. Pseudonymous: nothing here knows an account.

#include <charconv>

#include "curriculum/study.h"
#include "db/participant.h"
#include "db/sql_store.h"

namespace placode::db {

using Kind = StoreError::Kind;

namespace {

/// Arm of the next participant. The seed stands in the store alone.
int next_arm(Connection& connection, const std::string& study_id, const curriculum::Arms& arms,
             int number) {
    Statement query(connection, "SELECT seed FROM study_allocations WHERE study_id = ?");
    query.run(study_id);
    if (!query.next()) return -1;
    const std::string text = query.text(0);
    uint64_t seed = 0;
    std::from_chars(text.data(), text.data() + text.size(), seed);
    return curriculum::allocated_arm(arms, seed, number);
}

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

std::string SqlStore::new_participant(const std::string& study_id, bool demonstration) {
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
    int version = 0, arm = -1;
    if (const auto published = find_definition("study", study_id, 0)) {
        version = published->version;
        const curriculum::StudyProtocol protocol =
            curriculum::load_study_text(published->json, "study " + study_id);
        if (protocol.arms) arm = next_arm(connection_, study_id, *protocol.arms, number);
    }
    Statement(connection_,
              "INSERT INTO participant_states (study_id, code, protocol_version, arm, "
              "demonstration) VALUES (?, ?, ?, ?, ?)")
        .run(study_id, code, version, arm, demonstration);
    append_audit(actor_, "study.participant", study_id + " " + code,
                 version == 0 ? "" : "protocol version " + std::to_string(version));
    work.commit();
    return code;
}

void SqlStore::set_participant_device(const std::string& study_id, const std::string& code,
                                      const std::string& device) {
    connection_.begin_operation("choose the device of " + code + " in");
    if (device.empty()) connection_.fail(Kind::kRefused, "no device is named");
    UnitOfWork work(connection_);
    need_participant(study_id, code);
    Statement before(connection_,
                     "SELECT device FROM participant_devices WHERE study_id = ? AND code = ?");
    const std::string old = before.run(study_id, code).next() ? before.text(0) : std::string();
    if (old == device) return;
    Statement(connection_,
              "INSERT INTO participant_devices (study_id, code, device, chosen_by, chosen_utc) "
              "VALUES (?, ?, ?, ?, ?) ON CONFLICT (study_id, code) DO UPDATE SET device = "
              "excluded.device, chosen_by = excluded.chosen_by, chosen_utc = excluded.chosen_utc")
        .run(study_id, code, device, actor_, utc_now());
    append_audit(actor_, "study.device", study_id + " " + code,
                 old.empty() ? device : device + ", before: " + old);
    work.commit();
}

std::vector<ParticipantRecord> SqlStore::participants(const std::string& study_id) {
    connection_.begin_operation("read participants from");
    Statement query(
        connection_,
        "SELECT p.code, p.number, p.created_utc, COALESCE(s.protocol_version, 0) AS "
        "protocol_version, COALESCE(s.arm, -1) AS arm, COALESCE(s.demonstration, 0) AS "
        "demonstration, COALESCE(d.device, '') AS device, w.mode, w.reason, w.withdrawn_utc FROM "
        "participants p "
        "LEFT JOIN participant_devices d ON d.study_id = p.study_id AND d.code = p.code "
        "LEFT JOIN participant_states s ON s.study_id = p.study_id AND s.code = p.code "
        "LEFT JOIN withdrawals w ON w.study_id = p.study_id AND w.code = p.code "
        "WHERE p.study_id = ? ORDER BY p.number");
    query.run(study_id);
    std::vector<ParticipantRecord> found;
    while (query.next()) {
        ParticipantRecord record;
        record.study_id = study_id;
        record.code = query.text("code");
        record.number = static_cast<int>(query.integer("number"));
        record.enrolled_utc = query.text("created_utc");
        record.protocol_version = static_cast<int>(query.integer("protocol_version"));
        record.arm = static_cast<int>(query.integer("arm"));
        record.demonstration = query.integer("demonstration") != 0;
        record.device = query.text("device");
        if (const std::string mode = query.text("mode"); !mode.empty()) {
            record.withdrawal = mode == "keep"   ? WithdrawalMode::kKeep
                                : mode == "stop" ? WithdrawalMode::kStop
                                                 : WithdrawalMode::kErase;
            record.withdrawal_reason = query.text("reason");
            record.withdrawn_utc = query.text("withdrawn_utc");
        }
        found.push_back(std::move(record));
    }
    return found;
}

std::vector<std::string> SqlStore::study_ids() {
    connection_.begin_operation("list studies of");
    Statement query(connection_,
                    "SELECT DISTINCT study_id FROM participants UNION SELECT DISTINCT id FROM "
                    "definitions WHERE kind = 'study' ORDER BY 1");
    query.run();
    std::vector<std::string> ids;
    while (query.next()) ids.push_back(query.text(0));
    return ids;
}

int64_t SqlStore::save_answers(const AnswerRecord& answers) {
    connection_.begin_operation("save answers in");
    UnitOfWork work(connection_);
    need_active_participant(answers.study_id, answers.participant, "");
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
