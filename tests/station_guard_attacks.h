// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// SQL of somebody who has a station's log-in and is not administrator, educator or coordinator; and
// how such a person signs in by SQL.

#include <QCryptographicHash>
#include <array>
#include <string>

#include "db/password.h"
#include "tests/store_fixture.h"

namespace placode::test {

// A row of attempts, of account 2 (anna, whose first attempt is 1), with further columns.
#define PLACODE_FORGED_BY(account, demonstration, columns, values)                              \
    "INSERT INTO attempts (account_id, task_id, task_version, started_utc, saved_utc, "         \
    "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, points, " \
    "verdict, rubric_id, rubric_version, metric_set_version" columns ") VALUES (" account       \
    ", 'diathermy_ring', 2, '2026-01-01T00:00:00Z', '', 60, 'mouse', '1', '', 1, '7', "         \
    "0, " demonstration ", 100, 0, 'ring', 4, 15" values ")"
#define PLACODE_FORGED(columns, values) PLACODE_FORGED_BY("2", "0", columns, values)

inline constexpr std::array kGuardAttacks{
    // Become somebody, or somebody else.
    "UPDATE accounts SET roles = 15",
    "UPDATE accounts SET roles = 8 WHERE id = 2",
    "UPDATE accounts SET active = 0 WHERE id = 1",
    "UPDATE accounts SET password_hash = (SELECT password_hash FROM accounts WHERE id = 2)",
    "UPDATE accounts SET password_hash = '' WHERE id = 2",
    "UPDATE accounts SET password_given = 0",
    "INSERT INTO accounts (password_hash, roles, active, demonstration, created_utc) VALUES ('', "
    "15, 1, 0, '2026-01-01T00:00:00.000Z')",
    "INSERT INTO persons (account_id, login, login_key, display_name) VALUES (1, 'me', 'me', 'Me')",
    "INSERT INTO account_pins (account_id, pin_hash, failures) VALUES (1, '', 0)",
    "UPDATE account_pins SET failures = 0",
    "INSERT INTO invitations (code_hash, roles, note, invited_by, made_utc, expires_utc, used_utc) "
    "VALUES ('', 15, '', '', '', '2099-01-01', '')",
    "UPDATE invitations SET used_utc = ''",
    // Read what proves who somebody is.
    "SELECT password_hash FROM accounts",
    "SELECT * FROM accounts",
    "SELECT a.password_hash FROM persons p JOIN accounts a ON a.id = p.account_id",
    "SELECT pin_hash FROM account_pins",
    "COPY accounts TO STDOUT",
    "SELECT row_to_json(a) FROM accounts a",
    "SELECT * FROM placode_guard.sessions",
    "SELECT * FROM placode_guard.channels",
    "SELECT * FROM placode_guard.salt_key",
    // Say who one is, instead of proving it.
    "INSERT INTO placode_guard.sessions VALUES ('mine', 1, now(), false)",
    "UPDATE placode_guard.sessions SET account = 1",
    "INSERT INTO placode_guard.channels VALUES (pg_backend_pid(), '', now())",
    "SET placode.session = 'mine'; UPDATE accounts SET roles = 15",
    "SELECT placode_guard.begin_session(1, now())",
    "SELECT placode_guard.insert_account('', 15, 0, 0, '', 'me', 'me', 'Me')",
    "SELECT placode_guard.take_channel()",
    "SELECT placode_guard.trusted()",
    "SELECT placode_guard.unmasked('', 1, '')",
    "SELECT placode_guard.enter('keeper', repeat('0', 64), true)",
    "SELECT placode_guard.resume(1, repeat('0', 64))",
    "SELECT placode_guard.enter_by_pin(2, '', '', 3)",
    "SELECT placode_guard.set_password(1, '', 0)",
    "SELECT placode_guard.add_account('', 15, 0, 0, '', 'me', 'me', 'Me')",
    "SELECT placode_guard.open_channel(); SELECT placode_guard.add_account('', 15, 0, 0, '', 'me', "
    "'me', 'Me')",
    "SELECT placode_guard.open_channel(); SELECT placode_guard.set_password(1, '', 0)",
    "SELECT placode_guard.open_channel(); SELECT placode_guard.set_pin(1, '')",
    "SELECT placode_guard.open_channel(); SELECT placode_guard.accept_invitation('', '', 0, '', "
    "'me', 'me', 'Me')",
    // Take the rules away, or put others in their place.
    "ALTER TABLE accounts DISABLE ROW LEVEL SECURITY",
    "ALTER TABLE accounts NO FORCE ROW LEVEL SECURITY",
    "DROP POLICY station_changes ON accounts",
    "ALTER POLICY station_changes ON accounts USING (true)",
    "CREATE POLICY mine ON accounts USING (true)",
    "SET row_security = off; UPDATE accounts SET roles = 15",
    "CREATE OR REPLACE FUNCTION placode_guard.need(mask BIGINT, own BIGINT DEFAULT 0) RETURNS "
    "BOOLEAN LANGUAGE sql AS 'SELECT true'",
    "CREATE FUNCTION placode_guard.need(mask INT) RETURNS BOOLEAN LANGUAGE sql AS 'SELECT true'",
    "ALTER FUNCTION placode_guard.me() SECURITY INVOKER",
    "ALTER FUNCTION placode_guard.me() RESET search_path",
    "DROP SCHEMA placode_guard CASCADE",
    "GRANT EXECUTE ON FUNCTION placode_guard.begin_session(BIGINT, TIMESTAMPTZ) TO theatre; SELECT "
    "placode_guard.begin_session(1, now())",
    // Other roles, other names in front.
    "SET ROLE placode_service",
    "GRANT placode_service TO theatre",
    "ALTER ROLE theatre BYPASSRLS",
    "SELECT set_config('role', 'placode', false)",
    "CREATE TEMPORARY TABLE sessions AS SELECT 1",
    "SET search_path = pg_temp, public; UPDATE accounts SET roles = 15",
    "SET search_path = public, placode_guard; UPDATE accounts SET roles = 15",
    // Remove people and their work.
    "DELETE FROM persons",
    "DELETE FROM accounts",
    "DELETE FROM attempts",
    "DELETE FROM attempt_metrics",
    "DELETE FROM attempt_reasons",
    "DELETE FROM attempt_events",
    "DELETE FROM group_members",
    "DELETE FROM account_pins WHERE account_id <> 2",
    // Courses, studies, keys of the centre.
    "INSERT INTO training_groups (name, name_key, created_utc) VALUES ('Mine', 'mine', '')",
    "INSERT INTO group_members (group_id, account_id, teaches) VALUES (1, 3, 1)",
    "INSERT INTO course_assignments (course_id, course_version, account_id, starts_utc, due_utc, "
    "assigned_by, assigned_utc, ended_utc) VALUES ('first_steps', 1, 2, '', '', '', '', '')",
    "INSERT INTO course_grants (account_id, course_id, stage_id, attempts, reason, granted_by, "
    "granted_utc) VALUES (2, 'first_steps', 'one', 9, '', '', '')",
    "INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, issued_utc, "
    "issued_by, code) VALUES (3, 'first_steps', 1, '', '', '', 'X')",
    "INSERT INTO erasure_requests (account_id, reason, asked_utc, done_utc) VALUES (3, '', '', '')",
    "INSERT INTO participants (study_id, code, number, created_utc) VALUES ('pilot', 'P1', 1, '')",
    "INSERT INTO withdrawals (study_id, code, mode, reason, withdrawn_by, withdrawn_utc) VALUES "
    "('pilot', 'P1', 'erase', '', '', '')",
    "INSERT INTO consent_signatures (study_id, code, path, at_utc) VALUES ('pilot', 'P1', '', '')",
    "INSERT INTO record_events (study_id, code, event, remark, checksum, by_login, by_name, "
    "at_utc) "
    "VALUES ('pilot', 'P1', 'signed', '', '', '', '', '')",
    "INSERT INTO trusted_centres (public_key, centre, added_by, added_utc) VALUES ('x', '', '', "
    "'')",
    "INSERT INTO centre_key (id, centre, public_key, secret_key, made_utc) VALUES (1, '', '', '', "
    "'')",
    "INSERT INTO norm_packs (task_id, centre, content, signature, public_key, in_use, added_by, "
    "added_utc) VALUES ('x', '', '', '', '', 1, '', '')",
    // Attempts that were never performed, or are said to have been simulated again.
    PLACODE_FORGED("", ""),
    PLACODE_FORGED(", replay", ", 2"),
    PLACODE_FORGED(", replay, replayed_utc", ", 2, '2026-01-01T00:00:00Z'"),
    PLACODE_FORGED(", exam_course, exam_course_version, exam_stage, replay", ", 'x', 1, 'y', 2"),
    PLACODE_FORGED(", exam_course, exam_course_version, exam_stage", ", 'x', 1, 'y'"),
    PLACODE_FORGED(", exam_course, exam_course_version, exam_stage, replay", ", 'x', 1, 'y', 1"),
    PLACODE_FORGED(", exam_course, exam_course_version, exam_stage, proctor, replay",
                   ", 'x', 1, 'y', 'user 1', 2"),
    PLACODE_FORGED(", generated_from", ", 1"),
    "INSERT INTO attempts (id, account_id) VALUES (1000, 2)",
    PLACODE_FORGED(", study, participant, replay", ", 'pilot', 'P1', 1"),
    PLACODE_FORGED_BY("3", "0", "", ""),
    PLACODE_FORGED_BY("2", "1", ", replay", ", 2"),
    PLACODE_FORGED_BY("2", "1", ", exam_course, exam_course_version, exam_stage", ", 'x', 1, 'y'"),
    // Exams that nobody began.
    PLACODE_FORGED_BY("2", "1", ", exam_course, exam_course_version, exam_stage, replay",
                      ", 'x', 1, 'y', 1"),
    PLACODE_FORGED_BY("2", "1",
                      ", exam_course, exam_course_version, exam_stage, exam_begin, replay",
                      ", 'x', 1, 'y', 1, 1"),
    PLACODE_FORGED_BY("2", "1", ", exam_course, exam_course_version, exam_stage, proctor, replay",
                      ", 'x', 1, 'y', 'user 1', 1"),
    // Ones that were begun, taken back.
    PLACODE_FORGED_BY(
        "2", "0", ", exam_course, exam_course_version, exam_stage, exam_begin, void_reason",
        ", 'x', 1, 'y', 1, 'The computer was too slow: 1 picture a second, 20 are needed'"),
    "BEGIN; SET CONSTRAINTS ALL DEFERRED; " PLACODE_FORGED("", "") "; COMMIT",
    "BEGIN; " PLACODE_FORGED_BY("2", "1", "", "") "; UPDATE attempts SET replay = 2",
    "BEGIN; " PLACODE_FORGED_BY("2", "1", "", "") "; UPDATE attempts SET demonstration = 0",
    "BEGIN; " PLACODE_FORGED_BY("2", "1", "", "") "; UPDATE attempts SET exam_course = 'x'",
    // What somebody who may has found, said in their place.
    "UPDATE attempts SET replay = 2",
    "UPDATE attempts SET replay = 0 WHERE id = 1",
    "UPDATE attempts SET replay = replay",
    "UPDATE attempts SET replayed_utc = '2026-01-01T00:00:00Z'",
    "UPDATE attempts SET void_reason = ''",
    "UPDATE attempts SET void_reason = '', void_meaning = '', replay = 2",
    "UPDATE attempts SET void_reason = 'The computer was too slow: 1 picture a second, 20 are "
    "needed' WHERE id = 1",
    "UPDATE attempts SET void_meaning = '[]'",
    "UPDATE attempts SET study = 'pilot', participant = 'P1'",
    "UPDATE attempts SET study = 'pilot', participant = 'P1', replay = 1 WHERE id = 1",
    "UPDATE attempts SET participant = 'P1'",
    "WITH done AS (UPDATE attempts SET replay = 2 RETURNING id) SELECT * FROM done",
    "MERGE INTO attempts a USING (SELECT 1 AS id) b ON a.id = b.id WHEN MATCHED THEN UPDATE SET "
    "replay = 2",
    "UPDATE attempts SET points = 100",
    "UPDATE attempts SET verdict = 0",
    "UPDATE attempts SET account_id = 2",
    "UPDATE attempts SET exam_course = 'x', exam_stage = 'y'",
    "UPDATE attempts SET started_utc = '2020-01-01T00:00:00Z'",
    "UPDATE attempts SET metric_set_version = 99",
    // More of an attempt that is kept, or other points beside it.
    "INSERT INTO attempt_metrics VALUES (1, 999, 'x', 1)",
    "INSERT INTO attempt_reasons (attempt_id, position, item, reason, points, time_s, critical) "
    "VALUES (1, 999, 'x', '', 1, 1, 0)",
    "INSERT INTO attempt_events (attempt_id, position, time_s, kind, tool, tissue, element) VALUES "
    "(1, 999, 1, 1, 1, 1, 1)",
    "INSERT INTO recordings (attempt_id, size_bytes, checksum, content) VALUES (1, 1, 'x', '')",
    "UPDATE recordings SET content = ''",
    "DELETE FROM recordings",
    "INSERT INTO attempt_scores (attempt_id, points, verdict, rubric_id, rubric_version, "
    "metric_set_version, preprocessing_version, scored_utc, scored_by) VALUES (1, 100, 0, 'ring', "
    "5, 15, 1, '', '')",
    // Take away what asks.
    "ALTER TABLE attempts DISABLE TRIGGER watch_attempt",
    "ALTER TABLE attempts DISABLE TRIGGER ALL",
    "DROP TRIGGER watch_attempt ON attempts",
    "DROP TRIGGER need_recording ON attempts",
    "SET session_replication_role = replica; UPDATE attempts SET replay = 2",
    "CREATE OR REPLACE FUNCTION placode_guard.verifies(of_account BIGINT, of_study TEXT) RETURNS "
    "BOOLEAN LANGUAGE sql AS 'SELECT true'",
    "DROP FUNCTION placode_guard.watch_attempt() CASCADE",
    "SELECT placode_guard.watch_attempt()",
};
#undef PLACODE_FORGED
#undef PLACODE_FORGED_BY

/// What one statement got: rows that it saw or changed, or why it was refused.
struct Outcome {
    int rows = 0;
    std::string refusal;  ///< Empty: it was not.
    [[nodiscard]] bool got_anything() const { return refusal.empty() && rows > 0; }
};

inline Outcome outcome_of(RawConnection& raw, const std::string& sql) {
    QSqlQuery query(raw.handle());
    if (!query.exec(QString::fromStdString(sql)))
        return {0, query.lastError().text().toStdString() + " "};
    return {query.isSelect() ? query.size() : query.numRowsAffected(), ""};
}

/// Signs in by SQL as the programs do, written down a second time.
class Intruder {
 public:
    explicit Intruder(RawConnection& raw) : raw_(raw) {}
    [[nodiscard]] QByteArray channel() {
        return QByteArray::fromHex(
            QByteArray::fromStdString(raw_.value("SELECT placode_guard.open_channel()")));
    }
    static std::string proof(const QByteArray& channel, const std::string& what) {
        return QCryptographicHash::hash(channel + QByteArray::fromStdString(what),
                                        QCryptographicHash::Sha256)
            .toHex()
            .toStdString();
    }
    static std::string masked(const QByteArray& channel, const std::string& text) {
        QByteArray bytes = QByteArray::fromStdString(text), pad;
        for (int i = 0; i < bytes.size(); ++i) {
            if (i % 32 == 0)
                pad = QCryptographicHash::hash(
                    channel + QByteArray::fromHex("00000001000000") + char(i / 32),
                    QCryptographicHash::Sha256);
            bytes[i] = static_cast<char>(bytes[i] ^ pad[i % 32]);
        }
        return bytes.toHex().toStdString();
    }
    [[nodiscard]] std::string key_of(const std::string& login, const std::string& password) {
        return db::hash_password_as(raw_.value("SELECT placode_guard.salt_of('" + login + "')"),
                                    password);
    }
    std::string enter(const std::string& login, const std::string& password) {
        const std::string key = key_of(login, password);
        return enter_with(login, proof(channel(), key));
    }
    std::string enter_with(const std::string& login, const std::string& with) {
        // "" where the server refuses to look at all.
        return raw_.value("SELECT coalesce((SELECT id FROM placode_guard.enter('" + login + "', '" +
                          with + "', true)), 0)");
    }
    std::string resume(const std::string& account, const std::string& token) {
        return raw_.value("SELECT placode_guard.resume(" + account + ", '" +
                          proof(channel(), token) + "')");
    }
    [[nodiscard]] std::string me() { return raw_.value("SELECT placode_guard.me()"); }
    [[nodiscard]] std::string token() {
        return raw_.value("SELECT current_setting('placode.session', true)");
    }

 private:
    RawConnection& raw_;
};

}  // namespace placode::test
