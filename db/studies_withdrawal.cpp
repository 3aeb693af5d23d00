// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Withdrawal, with the erasure that a participant may ask for, and erasure when the time is over
// for which records were to be kept.

#include <algorithm>
#include <iterator>
#include <vector>

#include "curriculum/utc_time.h"
#include "db/store_context.h"
#include "db/studies.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

}  // namespace

std::optional<WithdrawalMode> withdrawal_mode_named(std::string_view name) noexcept {
    const auto* const found = std::ranges::find(kWithdrawalModeNames, name);
    if (found == std::end(kWithdrawalModeNames)) return std::nullopt;
    return static_cast<WithdrawalMode>(found - std::begin(kWithdrawalModeNames));
}

std::string withdrawal_mode_name(WithdrawalMode mode) {
    return std::string(kWithdrawalModeNames[static_cast<size_t>(mode)]);
}

void Studies::erase_participant(const std::string& study_id, const std::string& code) {
    std::vector<int64_t> attempts;
    {
        // Whatever a step names: what is not the participant's stays whose it is.
        // The last condition is that of the index.
        Statement query(connection_,
                        "SELECT id FROM attempts WHERE study = ? AND participant = ? AND study <> "
                        "''");
        query.run(study_id, code);
        while (query.next()) attempts.push_back(query.integer(0));
    }
    for (const int64_t id : attempts) context_.delete_attempt(id);
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
    // That a record was locked and signed stays, as the withdrawal does; what was said of it goes.
    Statement(connection_,
              "UPDATE record_events SET remark = '' WHERE study_id = ? AND code = ? AND remark <> "
              "''")
        .run(study_id, code);
}

void Studies::withdraw(const std::string& study_id, const std::string& code, WithdrawalMode mode,
                       const std::string& reason) {
    connection_.begin_operation("withdraw " + code + " from the study \"" + study_id + "\" in");
    context_.need(Action::kRunQuestionnaire);
    if (reason.empty())
        connection_.fail(Kind::kRefused,
                         Said::that("a withdrawal needs a reason; \"not given\" is one"));
    UnitOfWork work(connection_);
    Statement query(connection_,
                    "SELECT w.mode FROM participants p LEFT JOIN withdrawals w ON w.study_id = "
                    "p.study_id AND w.code = p.code WHERE p.study_id = ? AND p.code = ?");
    if (!query.run(study_id, code).next())
        connection_.fail(Kind::kNotFound,
                         Said::that("there is no such participant; check the code"));
    const std::string before = query.text(0);
    // Who has withdrawn may still ask for less use of the data, never for more.
    const auto now = withdrawal_mode_named(before);
    const bool less = now == WithdrawalMode::kKeep
                          ? mode != WithdrawalMode::kKeep
                          : now == WithdrawalMode::kStop && mode == WithdrawalMode::kErase;
    if (!before.empty() && !less)
        connection_.fail(Kind::kConflict,
                         Said::that("the participant has withdrawn already (%1)").with(before));
    context_.touch("participant", {study_id, code});
    const std::string name = withdrawal_mode_name(mode);
    if (before.empty())
        Statement(connection_,
                  "INSERT INTO withdrawals (study_id, code, mode, reason, withdrawn_by, "
                  "withdrawn_utc) VALUES (?, ?, ?, ?, ?, ?)")
            .run(study_id, code, name, reason, context_.actor.name, utc_now());
    else
        Statement(connection_,
                  "UPDATE withdrawals SET mode = ?, reason = ?, withdrawn_by = ?, withdrawn_utc = "
                  "? WHERE study_id = ? AND code = ?")
            .run(name, reason, context_.actor.name, utc_now(), study_id, code);
    if (mode == WithdrawalMode::kErase) erase_participant(study_id, code);
    // The reason stands in `withdrawals`: what somebody said of a participant is nothing for a
    // trail that nobody can redact.
    context_.append_audit("study.withdraw", study_id + " " + code, name);
    work.commit();
}

void Studies::erase_kept(const std::string& study_id, const std::string& code,
                         const std::string& until_utc) {
    connection_.begin_operation("erase the records of " + code + " in the study \"" + study_id +
                                "\" in");
    context_.need(Action::kRunQuestionnaire);
    UnitOfWork work(connection_);
    Statement query(connection_, "SELECT code FROM participants WHERE study_id = ? AND code = ?");
    if (!query.run(study_id, code).next())
        connection_.fail(Kind::kNotFound,
                         Said::that("there is no such participant; check the code"));
    if (until_utc > curriculum::utc_text(context_.now_ms() / 1000))
        connection_.fail(Kind::kRefused,
                         Said::that("its records are kept until %1").with(until_utc));
    context_.touch("participant", {study_id, code});
    erase_participant(study_id, code);
    context_.append_audit("study.retention", study_id + " " + code, "kept until " + until_utc);
    work.commit();
}

}  // namespace placode::db
