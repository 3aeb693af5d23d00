// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Participants of studies.

#include "db/studies.h"

#include <charconv>

#include "curriculum/study.h"
#include "db/participant.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

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

}  // namespace

Studies::Studies(StoreContext& context) : context_(context), connection_(context.connection) {}

std::vector<std::string> Studies::ids() {
    connection_.begin_operation("list studies of");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy, Action::kViewAudit});
    Statement query(connection_,
                    "SELECT DISTINCT study_id FROM participants UNION SELECT DISTINCT id FROM "
                    "definitions WHERE kind = 'study' ORDER BY 1");
    query.run();
    std::vector<std::string> ids;
    while (query.next()) ids.push_back(query.text(0));
    return ids;
}

std::vector<std::string> Studies::with_participants() {
    connection_.begin_operation("list studies of");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
    Statement query(connection_,
                    "SELECT study_id FROM participants GROUP BY study_id ORDER BY study_id");
    query.run();
    std::vector<std::string> ids;
    while (query.next()) ids.push_back(query.text(0));
    return ids;
}

std::string Studies::new_participant(const std::string& study_id, bool demonstration) {
    connection_.begin_operation("add a participant to the study \"" + study_id + "\" in");
    context_.need(Action::kRunQuestionnaire);
    if (study_id.empty()) connection_.fail(Kind::kRefused, Said::that("the study has no id"));
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
    if (const auto published = context_.find_definition("study", study_id, 0)) {
        version = published->version;
        const curriculum::StudyProtocol protocol =
            curriculum::load_study_text(published->json, "study " + study_id);
        if (protocol.arms) arm = next_arm(connection_, study_id, *protocol.arms, number);
    }
    Statement(connection_,
              "INSERT INTO participant_states (study_id, code, protocol_version, arm, "
              "demonstration) VALUES (?, ?, ?, ?, ?)")
        .run(study_id, code, version, arm, demonstration);
    context_.made("participant", {study_id, code});
    context_.append_audit("study.participant", study_id + " " + code,
                          version == 0 ? "" : "protocol version " + std::to_string(version));
    work.commit();
    return code;
}

void Studies::set_participant_device(const std::string& study_id, const std::string& code,
                                     const std::string& device) {
    connection_.begin_operation("choose the device of " + code + " in");
    context_.need(Action::kRunQuestionnaire);
    if (device.empty()) connection_.fail(Kind::kRefused, Said::that("no device is named"));
    UnitOfWork work(connection_);
    context_.need_participant(study_id, code);
    Statement before(connection_,
                     "SELECT device FROM participant_devices WHERE study_id = ? AND code = ?");
    const std::string old = before.run(study_id, code).next() ? before.text(0) : std::string();
    if (old == device) return;
    context_.touch("participant", {study_id, code});
    Statement(connection_,
              "INSERT INTO participant_devices (study_id, code, device, chosen_by, chosen_utc) "
              "VALUES (?, ?, ?, ?, ?) ON CONFLICT (study_id, code) DO UPDATE SET device = "
              "excluded.device, chosen_by = excluded.chosen_by, chosen_utc = excluded.chosen_utc")
        .run(study_id, code, device, context_.actor.name, utc_now());
    context_.append_audit("study.device", study_id + " " + code,
                          old.empty() ? device : device + ", before: " + old);
    work.commit();
}

std::vector<ParticipantRecord> Studies::participants(const std::string& study_id) {
    connection_.begin_operation("read participants from");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
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
            // A word of no mode must not let anybody use the data.
            record.withdrawal = withdrawal_mode_named(mode).value_or(WithdrawalMode::kErase);
            record.withdrawal_reason = query.text("reason");
            record.withdrawn_utc = query.text("withdrawn_utc");
        }
        found.push_back(std::move(record));
    }
    return found;
}

}  // namespace placode::db
