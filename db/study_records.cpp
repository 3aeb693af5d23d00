// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Lock and signature of a participant's record. The events are never changed, but for what was
// remarked, which an erasure blanks; where a record stands follows from them.

#include "db/study_records.h"

#include <array>

#include "db/accounts.h"
#include "db/packing.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr std::array<const char*, 3> kEvents{"locked", "signed", "unlocked"};

/// What a signature is for, in the order in which its checksum takes it.
struct RecordPart {
    const char *code, *select, *order;
    bool only_if_any = false;  ///< A record signed before there were such things stays right.
};

constexpr std::array kRecordParts{
    RecordPart{"code", "created_utc FROM participants WHERE study_id = ?", "code"},
    RecordPart{"code",
               "id, visit, step, state, attempt_id, answer_id, detail, at_utc FROM study_steps "
               "WHERE study_id = ?",
               "id"},
    RecordPart{"participant",
               "id, questionnaire_id, questionnaire_version, answered_utc, language, visit FROM "
               "answers WHERE study_id = ?",
               "id"},
    RecordPart{"a.participant",
               "i.answer_id, i.item, i.answer FROM answer_items i JOIN answers a ON a.id = "
               "i.answer_id WHERE a.study_id = ?",
               "i.answer_id, i.item"},
    RecordPart{"s.code",
               "t.id, t.task_id, t.points, t.verdict, t.duration_s FROM attempts t JOIN "
               "study_steps s ON s.attempt_id = t.id WHERE s.study_id = ?",
               "t.id"},
    RecordPart{"s.code",
               "u.step_id, u.reason, u.superseded_utc FROM superseded_steps u JOIN study_steps s "
               "ON s.id = u.step_id WHERE s.study_id = ?",
               "u.step_id", true},
    RecordPart{"code", "id, visit, step, note, at_utc FROM step_notes WHERE study_id = ?", "id",
               true},
};

RecordEvent event_of(const std::string& study_id, const std::string& code, RecordEventKind kind,
                     const std::string& login) {
    RecordEvent event;
    event.study_id = study_id;
    event.code = code;
    event.kind = kind;
    event.login = event.name = login;
    return event;
}

}  // namespace

StudyRecords::StudyRecords(StoreContext& context)
    : context_(context), connection_(context.connection) {}

std::map<std::string, std::string> StudyRecords::checksums_of(const std::string& study_id,
                                                              const std::set<std::string>& codes) {
    std::map<std::string, std::string> texts;
    for (const RecordPart& part : kRecordParts) {
        std::map<std::string, std::string> rows;
        const std::string of_one =
            codes.size() == 1 ? std::string(" AND ") + part.code + " = ?" : std::string();
        Statement query(connection_, std::string("SELECT ") + part.code + ", " + part.select +
                                         of_one + " ORDER BY " + part.order);
        of_one.empty() ? query.run(study_id) : query.run(study_id, *codes.begin());
        while (query.next()) {
            std::string& row = rows[query.text(0)];
            for (int i = 1; i < query.columns(); ++i) add_text(row, query.text(i));
            row += '\n';
        }
        for (const std::string& code : codes)
            if (const auto found = rows.find(code); found != rows.end())
                texts[code] += found->second + '\n';
            else if (!part.only_if_any)
                texts[code] += '\n';
    }
    for (auto& [code, text] : texts) text = checksum_hex(text);
    return texts;
}

std::string StudyRecords::checksum_of(const std::string& study_id, const std::string& code) {
    return checksums_of(study_id, {code}).at(code);
}

void StudyRecords::insert_event(RecordEvent event) {
    event.at_utc = utc_now();
    context_.touch("participant", {event.study_id, event.code});
    const std::string kind = kEvents[static_cast<size_t>(event.kind)];
    Statement insert(connection_,
                     "INSERT INTO record_events (study_id, code, event, remark, checksum, "
                     "by_login, by_name, at_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?) RETURNING id");
    insert.run(event.study_id, event.code, kind, event.remark, event.checksum, event.login,
               event.name, event.at_utc);
    // The remark stands in the row, where an erasure blanks it; the trail stays.
    context_.append_audit_as(
        event.login, "study.record." + kind, event.study_id + " " + event.code,
        "event " + std::to_string(insert.returned_id()) + "; record " + event.checksum);
}

void StudyRecords::lock(const std::string& study_id, const std::string& code) {
    connection_.begin_operation("lock the record of " + code + " in");
    context_.need(Action::kRunQuestionnaire);
    UnitOfWork work(connection_);
    context_.need_participant(study_id, code);
    if (context_.is_locked(study_id, code))
        connection_.fail(Kind::kConflict, Said::that("it is locked already"));
    RecordEvent event = event_of(study_id, code, RecordEventKind::kLocked, context_.actor.name);
    event.checksum = checksum_of(study_id, code);
    insert_event(event);
    work.commit();
}

void StudyRecords::sign(const std::string& study_id, const std::string& code,
                        const std::string& login, const std::string& password,
                        const std::string& meaning) {
    const std::string operation = "sign the record of " + code + " in";
    connection_.begin_operation(operation);
    context_.need(Action::kRunQuestionnaire);
    if (meaning.empty())
        connection_.fail(
            Kind::kRefused,
            Said::that("a signature needs its meaning, such as \"%1\"").with("reviewed"));
    // As every sign-in: counted, and slowed down after wrong ones.
    const SignIn who = Accounts(context_).confirm(login, password);
    connection_.begin_operation(operation);
    if (who.outcome != SignInOutcome::kOk) {
        connection_.fail(
            Kind::kRefused,
            who.outcome == SignInOutcome::kThrottled
                ? Said::that("too many wrong passwords; try again in %1 s").with(who.wait_s)
                : Said::that("login or password is wrong; nothing was signed"));
    }
    UnitOfWork work(connection_);
    if (!context_.is_locked(study_id, code))
        connection_.fail(Kind::kRefused,
                         Said::that("lock the record first: what is signed must not change"));
    const auto all = states(study_id);
    if (const auto found = all.find(code); found != all.end() && found->second.signature)
        connection_.fail(
            Kind::kConflict,
            Said::that("it is signed already, by %1").with(found->second.signature->name));
    RecordEvent event =
        event_of(study_id, code, RecordEventKind::kSigned, user_object(who.user->id));
    event.name = event.login;  // The number: the name goes with the person.
    event.remark = meaning;
    event.checksum = checksum_of(study_id, code);
    insert_event(event);
    work.commit();
}

void StudyRecords::unlock(const std::string& study_id, const std::string& code,
                          const std::string& reason) {
    connection_.begin_operation("unlock the record of " + code + " in");
    context_.need(Action::kRunQuestionnaire);
    if (reason.empty()) connection_.fail(Kind::kRefused, Said::that("unlocking needs a reason"));
    UnitOfWork work(connection_);
    if (!context_.is_locked(study_id, code))
        connection_.fail(Kind::kConflict, Said::that("it is not locked"));
    RecordEvent event = event_of(study_id, code, RecordEventKind::kUnlocked, context_.actor.name);
    event.remark = reason;
    event.checksum = checksum_of(study_id, code);
    insert_event(event);
    work.commit();
}

std::vector<RecordEvent> StudyRecords::events(const std::string& study_id) {
    connection_.begin_operation("read locks and signatures from");
    context_.need_any({Action::kRunQuestionnaire, Action::kExportStudy});
    Statement query(connection_,
                    "SELECT id, code, event, remark, checksum, by_login, by_name, at_utc FROM "
                    "record_events WHERE study_id = ? ORDER BY id");
    query.run(study_id);
    std::vector<RecordEvent> found;
    while (query.next()) {
        RecordEvent event;
        event.id = query.integer("id");
        event.study_id = study_id;
        event.code = query.text("code");
        const std::string kind = query.text("event");
        for (size_t i = 0; i < kEvents.size(); ++i)
            if (kind == kEvents[i]) event.kind = static_cast<RecordEventKind>(i);
        event.remark = query.text("remark");
        event.checksum = query.text("checksum");
        event.login = query.text("by_login");
        event.name = query.text("by_name");
        event.at_utc = query.text("at_utc");
        found.push_back(std::move(event));
    }
    context_.show_names(found, &RecordEvent::login);
    std::map<std::string, std::string> shown;
    for (RecordEvent& event : found) {
        const auto [at, first] = shown.try_emplace(event.name);
        if (first) at->second = context_.shown_display_name(at->first);
        event.name = at->second;
    }
    return found;
}

std::map<std::string, RecordState> StudyRecords::states(const std::string& study_id) {
    std::map<std::string, RecordState> found;
    for (RecordEvent& event : events(study_id)) {
        RecordState& state = found[event.code];
        state.locked = event.kind != RecordEventKind::kUnlocked;
        if (event.kind == RecordEventKind::kSigned)
            state.signature = std::move(event);
        else
            state.signature.reset();
    }
    std::set<std::string> signed_codes;
    for (const auto& [code, state] : found)
        if (state.signature) signed_codes.insert(code);
    if (signed_codes.empty()) return found;
    for (const auto& [code, checksum] : checksums_of(study_id, signed_codes)) {
        RecordState& state = found[code];
        state.signature_fits = state.signature->checksum == checksum;
    }
    return found;
}

}  // namespace placode::db
