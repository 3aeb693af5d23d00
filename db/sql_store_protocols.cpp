// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Published definitions, steps of a protocol, withdrawal.

#include <sodium.h>

#include <algorithm>
#include <array>

#include "curriculum/course.h"
#include "curriculum/standard.h"
#include "curriculum/study.h"
#include "db/consent_seal.h"
#include "db/packing.h"
#include "db/sql_store.h"

namespace placode::db {

using Kind = StoreError::Kind;

namespace {

constexpr std::array<const char*, 3> kModes{"keep", "stop", "erase"};
constexpr std::array<std::string_view, 6> kKinds{"questionnaire", "study",    "course",
                                                 "rubric",        "standard", "consent_seal"};
constexpr std::array<const char*, 3> kStates{"started", "done", "skipped"};

/// Throws DefinitionError: only what can be read again is published.
void check_content(const DefinitionRecord& definition) {
    const std::string origin = definition.kind + " " + definition.id;
    std::string id;
    int version = 0;
    if (definition.kind == "questionnaire") {
        const auto read = curriculum::load_questionnaire_text(definition.json, origin);
        id = read.id, version = read.version;
    } else if (definition.kind == "course") {
        const auto read = curriculum::load_course_text(definition.json, origin);
        id = read.id, version = read.version;
    } else if (definition.kind == "rubric") {
        const auto read = curriculum::load_rubric_text(definition.json, origin);
        id = definition.id.substr(0, definition.id.find('/') + 1) + read.id, version = read.version;
    } else if (definition.kind == "standard") {
        const auto read = curriculum::load_standard_text(definition.json, origin);
        id = read.task_id, version = read.version;
    } else if (definition.kind == "consent_seal") {
        const auto read = seal_of(definition.json);
        id = read.study_id, version = read.version;
    } else {
        const auto read = curriculum::load_study_text(definition.json, origin);
        id = read.id, version = read.version;
    }
    if (id != definition.id || version != definition.version)
        throw curriculum::DefinitionError(origin, "/id",
                                          "is " + id + " version " + std::to_string(version) +
                                              "; expected version " +
                                              std::to_string(definition.version));
}

/// What stands in clear is sealed; what was sealed for an earlier key stays as it is.
void seal_signatures(Connection& connection, const DefinitionRecord& definition) {
    const std::string key = seal_of(definition.json).public_key;
    std::vector<std::pair<std::string, std::string>> clear;
    Statement query(connection, "SELECT code, path FROM consent_signatures WHERE study_id = ?");
    query.run(definition.id);
    while (query.next())
        if (!is_sealed(query.text("path")))
            clear.emplace_back(query.text("code"), query.text("path"));
    for (const auto& [code, path] : clear)
        Statement(connection,
                  "UPDATE consent_signatures SET path = ? WHERE study_id = ? AND code = ?")
            .run(sealed(path, key), definition.id, code);
}

}  // namespace

void SqlStore::publish(const DefinitionRecord& definition) {
    const std::string name =
        definition.kind + " " + definition.id + " version " + std::to_string(definition.version);
    connection_.begin_operation("publish " + name + " in");
    if (std::find(kKinds.begin(), kKinds.end(), definition.kind) == kKinds.end())
        connection_.fail(Kind::kRefused,
                         "only questionnaires, studies, courses, rubrics, standards and seals "
                         "of consents are published");
    check_content(definition);
    UnitOfWork work(connection_);
    connection_.lock_table("definitions");
    if (const auto there = find_definition(definition.kind, definition.id, definition.version)) {
        if (there->json == definition.json) return;
        connection_.fail(Kind::kConflict, name +
                                              " is published with another text, which is never "
                                              "changed; give your text the next version");
    }
    const auto newest = find_definition(definition.kind, definition.id, 0);
    if (newest && newest->version > definition.version)
        connection_.fail(Kind::kConflict, "version " + std::to_string(newest->version) +
                                              " is published already; give your text a higher "
                                              "version");
    if (newest && definition.reason.empty())
        connection_.fail(Kind::kRefused, "an amendment needs a reason");
    Statement(connection_,
              "INSERT INTO definitions (kind, id, version, content, checksum, reason, "
              "published_by, published_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
        .run(definition.kind, definition.id, definition.version, definition.json,
             checksum_hex(definition.json), definition.reason, actor_, utc_now());
    if (definition.kind == "study" && !newest) {
        uint64_t seed = 0;
        randombytes_buf(&seed, sizeof seed);
        Statement(connection_, "INSERT INTO study_allocations (study_id, seed) VALUES (?, ?)")
            .run(definition.id, std::to_string(seed));
    }
    if (definition.kind == "consent_seal") seal_signatures(connection_, definition);
    append_audit(actor_, definition.kind + ".publish",
                 definition.id + " version " + std::to_string(definition.version),
                 definition.reason);
    work.commit();
}

namespace {

constexpr const char* kDefinitionColumns =
    "SELECT kind, id, version, content, checksum, reason, published_by, published_utc FROM "
    "definitions ";

DefinitionRecord read_definition(const Statement& row) {
    return {row.text("kind"),
            row.text("id"),
            static_cast<int>(row.integer("version")),
            row.text("content"),
            row.text("checksum"),
            row.text("reason"),
            row.text("published_by"),
            row.text("published_utc")};
}

}  // namespace

std::optional<DefinitionRecord> SqlStore::find_definition(const std::string& kind,
                                                          const std::string& id, int version) {
    Statement query(connection_, std::string(kDefinitionColumns) +
                                     "WHERE kind = ? AND id = ? AND (? = 0 OR version = ?) ORDER "
                                     "BY version DESC LIMIT 1");
    query.run(kind, id, version, version);
    if (!query.next()) return std::nullopt;
    return read_definition(query);
}

std::optional<DefinitionRecord> SqlStore::definition(const std::string& kind, const std::string& id,
                                                     int version) {
    connection_.begin_operation("read the " + kind + " " + id + " from");
    return find_definition(kind, id, version);
}

std::vector<DefinitionRecord> SqlStore::definitions(const std::string& kind) {
    connection_.begin_operation("list published definitions of");
    Statement query(connection_,
                    std::string(kDefinitionColumns) + "WHERE kind = ? ORDER BY id, version");
    query.run(kind);
    std::vector<DefinitionRecord> found;
    while (query.next()) found.push_back(read_definition(query));
    return found;
}

void SqlStore::need_active_participant(const std::string& study_id, const std::string& code,
                                       const std::string& step) {
    Statement participant(
        connection_,
        "SELECT COALESCE(s.protocol_version, 0) AS version, w.mode FROM participants p "
        "LEFT JOIN participant_states s ON s.study_id = p.study_id AND s.code = "
        "p.code LEFT JOIN withdrawals w ON w.study_id = p.study_id AND w.code = "
        "p.code WHERE p.study_id = ? AND p.code = ?");
    if (!participant.run(study_id, code).next())
        connection_.fail(Kind::kNotFound, "the study \"" + study_id + "\" has no participant \"" +
                                              code + "\"; check the code");
    const int version = static_cast<int>(participant.integer("version"));
    if (const std::string mode = participant.text("mode"); !mode.empty())
        connection_.fail(Kind::kRefused,
                         code + " has withdrawn (" + mode + "); nothing more is recorded");
    need_unlocked(study_id, code);
    if (version == 0) return;
    const auto published = find_definition("study", study_id, version);
    if (!published) return;
    const auto protocol = curriculum::load_study_text(published->json, "study " + study_id);
    if (!protocol.needs_consent()) return;
    if (const auto* asked = protocol.step(step);
        asked != nullptr && asked->kind == curriculum::StepKind::kConsent)
        return;
    for (const auto& each : protocol.steps) {
        if (each.kind != curriculum::StepKind::kConsent) continue;
        Statement consent(connection_,
                          "SELECT id FROM study_steps WHERE study_id = ? AND code = ? AND step = ? "
                          "AND state = 'done'");
        if (!consent.run(study_id, code, each.id).next())
            connection_.fail(Kind::kRefused, code + " has not consented; record the step \"" +
                                                 each.id + "\" first");
    }
}

int64_t SqlStore::insert_step(const StepRecord& step) {
    Statement insert(connection_,
                     "INSERT INTO study_steps (study_id, code, visit, step, state, attempt_id, "
                     "answer_id, detail, at_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) RETURNING id");
    insert.run(step.study_id, step.participant, step.visit, step.step,
               kStates[static_cast<size_t>(step.state)], step.attempt_id, step.answer_id,
               step.detail, step.at_utc.empty() ? utc_now() : step.at_utc);
    const int64_t id = insert.returned_id();
    // Whoever was signed in: it is the participant's from now on.
    if (step.attempt_id != 0)
        Statement(connection_,
                  "UPDATE attempts SET study = ?, participant = ? WHERE id = ? AND study = ''")
            .run(step.study_id, step.participant, step.attempt_id);
    return id;
}

int64_t SqlStore::record_step(const StepRecord& step) {
    connection_.begin_operation("record the step \"" + step.step + "\" in");
    if (step.step.empty()) connection_.fail(Kind::kRefused, "the step has no id");
    UnitOfWork work(connection_);
    need_active_participant(step.study_id, step.participant, step.step);
    Statement owner(connection_, "SELECT study, participant FROM attempts WHERE id = ?");
    if (owner.run(step.attempt_id).next()) {
        const std::string study = owner.text("study"), participant = owner.text("participant");
        if (!study.empty() && (study != step.study_id || participant != step.participant))
            connection_.fail(Kind::kRefused, "attempt " + std::to_string(step.attempt_id) +
                                                 " belongs to " + participant + " of the study \"" +
                                                 study + "\"");
    }
    const int64_t id = insert_step(step);
    append_audit(actor_, "study.step", step.study_id + " " + step.participant,
                 step.step + " " + kStates[static_cast<size_t>(step.state)] +
                     (step.detail.empty() ? "" : ": " + step.detail));
    work.commit();
    return id;
}

std::vector<StepRecord> SqlStore::steps(const std::string& study_id) {
    connection_.begin_operation("read the steps of a study from");
    Statement query(connection_,
                    "SELECT s.id, s.code, s.visit, s.step, s.state, s.attempt_id, s.answer_id, "
                    "s.detail, s.at_utc, COALESCE(u.reason, '') AS superseded_reason, "
                    "COALESCE(u.superseded_by, '') AS superseded_by, COALESCE(u.superseded_utc, "
                    "'') AS superseded_utc FROM study_steps s LEFT JOIN superseded_steps u ON "
                    "u.step_id = s.id WHERE s.study_id = ? ORDER BY s.id");
    query.run(study_id);
    std::vector<StepRecord> found;
    while (query.next()) {
        StepRecord step;
        step.id = query.integer("id");
        step.study_id = study_id;
        step.participant = query.text("code");
        step.visit = static_cast<int>(query.integer("visit"));
        step.step = query.text("step");
        const std::string state = query.text("state");
        for (size_t i = 0; i < kStates.size(); ++i)
            if (state == kStates[i]) step.state = static_cast<StepState>(i);
        step.attempt_id = query.integer("attempt_id");
        step.answer_id = query.integer("answer_id");
        step.detail = query.text("detail");
        step.at_utc = query.text("at_utc");
        step.superseded_reason = query.text("superseded_reason");
        step.superseded_by = query.text("superseded_by");
        step.superseded_utc = query.text("superseded_utc");
        found.push_back(std::move(step));
    }
    return found;
}

void SqlStore::erase_participant(const std::string& study_id, const std::string& code) {
    std::vector<int64_t> attempts;
    {
        Statement query(connection_,
                        "SELECT DISTINCT attempt_id FROM study_steps WHERE study_id = ? AND code = "
                        "? AND attempt_id > 0 UNION SELECT id FROM attempts WHERE study = ? AND "
                        "participant = ?");
        query.run(study_id, code, study_id, code);
        while (query.next()) attempts.push_back(query.integer(0));
    }
    for (const int64_t id : attempts) delete_attempt(id);
    Statement(connection_,
              "DELETE FROM superseded_steps WHERE step_id IN (SELECT id FROM study_steps WHERE "
              "study_id = ? AND code = ?)")
        .run(study_id, code);
    for (const char* table : {"step_notes", "participant_devices"})
        Statement(connection_,
                  std::string("DELETE FROM ") + table + " WHERE study_id = ? AND code = ?")
            .run(study_id, code);
    const std::string mine =
        " WHERE answer_id IN (SELECT id FROM answers WHERE study_id = ? AND participant = ?)";
    for (const char* table :
         {"answer_changes", "answer_corrections", "second_entry_items", "second_entries"})
        Statement(connection_, std::string("DELETE FROM ") + table + mine).run(study_id, code);
    Statement(connection_, "DELETE FROM consent_signatures WHERE study_id = ? AND code = ?")
        .run(study_id, code);
    Statement(connection_, "DELETE FROM answer_items" + mine).run(study_id, code);
    Statement(connection_, "DELETE FROM answers WHERE study_id = ? AND participant = ?")
        .run(study_id, code);
    Statement(connection_, "DELETE FROM study_steps WHERE study_id = ? AND code = ?")
        .run(study_id, code);
}

void SqlStore::withdraw(const std::string& study_id, const std::string& code, WithdrawalMode mode,
                        const std::string& reason) {
    connection_.begin_operation("withdraw " + code + " from the study \"" + study_id + "\" in");
    if (reason.empty())
        connection_.fail(Kind::kRefused, "a withdrawal needs a reason; \"not given\" is one");
    UnitOfWork work(connection_);
    Statement query(connection_,
                    "SELECT w.mode FROM participants p LEFT JOIN withdrawals w ON w.study_id = "
                    "p.study_id AND w.code = p.code WHERE p.study_id = ? AND p.code = ?");
    if (!query.run(study_id, code).next())
        connection_.fail(Kind::kNotFound, "there is no such participant; check the code");
    const std::string before = query.text(0);
    // Who has withdrawn may still ask for less use of the data, never for more.
    const bool less = before == "keep" ? mode != WithdrawalMode::kKeep
                                       : before == "stop" && mode == WithdrawalMode::kErase;
    if (!before.empty() && !less)
        connection_.fail(Kind::kConflict, "the participant has withdrawn already (" + before + ")");
    if (before.empty())
        Statement(connection_,
                  "INSERT INTO withdrawals (study_id, code, mode, reason, withdrawn_by, "
                  "withdrawn_utc) VALUES (?, ?, ?, ?, ?, ?)")
            .run(study_id, code, kModes[static_cast<size_t>(mode)], reason, actor_, utc_now());
    else
        Statement(connection_,
                  "UPDATE withdrawals SET mode = ?, reason = ?, withdrawn_by = ?, withdrawn_utc = "
                  "? WHERE study_id = ? AND code = ?")
            .run(kModes[static_cast<size_t>(mode)], reason, actor_, utc_now(), study_id, code);
    if (mode == WithdrawalMode::kErase) erase_participant(study_id, code);
    append_audit(actor_, "study.withdraw", study_id + " " + code,
                 std::string(kModes[static_cast<size_t>(mode)]) + ": " + reason);
    work.commit();
}

}  // namespace placode::db
