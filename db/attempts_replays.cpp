// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Which attempts are still to be simulated again, and what that gave.

#include "curriculum/attempt_runner.h"
#include "db/attempt_doubts.h"
#include "db/attempts.h"
#include "db/store_context.h"
#include "db/void_reason.h"

namespace placode::db {
namespace {

std::vector<int64_t> ids_of(Statement& query) {
    std::vector<int64_t> found;
    while (query.next()) found.push_back(query.integer(0));
    return found;
}

/// Of rows of attempts "a": those of which a server takes this program's word.
std::string judged_here(StoreContext& context) {
    return context.server.guards() ? " AND placode_guard.verifies(a.account_id, a.study)" : "";
}

/// Those first that this build can simulate again: however many wait for another one, they keep
/// none from its turn.
constexpr const char* kOwnFirst =
    " ORDER BY CASE WHEN a.build = ? THEN 0 ELSE 1 END, a.started_utc, a.id";

/// What it finds by reading a recording does not depend on the processor.
std::string this_version() {
    const std::string build = curriculum::this_build();
    return build.substr(0, build.rfind(' '));
}

}  // namespace

std::vector<int64_t> Attempts::waiting_for_replay() {
    connection_.begin_operation("list what is to be replayed in");
    context_.need(Action::kUseStore);
    // The number as the index has it (db/sql/0018_searches.sql).
    static_assert(static_cast<int>(ReplayState::kWaiting) == 1);
    Statement query(connection_, "SELECT a.id FROM attempts a WHERE a.replay = 1" +
                                     judged_here(context_) + kOwnFirst);
    query.run(curriculum::this_build());
    return ids_of(query);
}

std::vector<int64_t> Attempts::never_replayed() {
    connection_.begin_operation("list what was never replayed in");
    context_.need(Action::kUseStore);
    Statement query(connection_,
                    "SELECT a.id FROM attempts a JOIN recordings r ON r.attempt_id = a.id WHERE "
                    "a.replay = ? AND a.void_reason = '' AND a.end_reason <> ?" +
                        judged_here(context_) + kOwnFirst);
    query.run(static_cast<int>(ReplayState::kNotReplayed),
              static_cast<int>(sim::EndReason::kInterrupted), curriculum::this_build());
    return ids_of(query);
}

bool Attempts::was_read(int64_t attempt_id) {
    connection_.begin_operation("ask for attempt " + std::to_string(attempt_id) + " in");
    context_.need(Action::kReplay);
    Statement query(connection_,
                    "SELECT 1 FROM attempts WHERE id = ? AND build <> ? AND read_by = ?");
    return query.run(attempt_id, curriculum::this_build(), this_version()).next();
}

void Attempts::set_read(int64_t attempt_id) {
    connection_.begin_operation("keep the reading of attempt " + std::to_string(attempt_id) +
                                " in");
    context_.need(Action::kReplay);
    UnitOfWork work(connection_);
    Statement query(connection_, "UPDATE attempts SET read_by = ? WHERE id = ?");
    if (query.run(this_version(), attempt_id).affected() == 0)
        connection_.fail(StoreError::Kind::kNotFound,
                         "there is no attempt " + std::to_string(attempt_id));
    work.commit();
}

bool Attempts::judges_replay(int64_t attempt_id) {
    connection_.begin_operation("ask for attempt " + std::to_string(attempt_id) + " in");
    context_.need(Action::kReplay);
    if (!context_.server.guards()) return true;
    Statement query(connection_, "SELECT 1 WHERE placode_guard.verifies_attempt(?)");
    return query.run(attempt_id).next();
}

std::optional<Said> Attempts::doubt_about(int64_t attempt_id, const std::string& recording_file) {
    connection_.begin_operation("look into attempt " + std::to_string(attempt_id) + " in");
    context_.need(Action::kReplay);
    return doubt_in_store(context_, attempt_id, recording_file);
}

void Attempts::set_replay(int64_t attempt_id, ReplayState state, const Said& difference) {
    connection_.begin_operation("keep the replay of attempt " + std::to_string(attempt_id) + " in");
    context_.need(Action::kReplay);
    UnitOfWork work(connection_);
    Statement query(connection_, "SELECT void_reason, void_meaning FROM attempts WHERE id = ?");
    query.run(attempt_id);
    if (!query.next())
        connection_.fail(StoreError::Kind::kNotFound,
                         "there is no attempt " + std::to_string(attempt_id));
    // One answer about the replay: that of the last.
    std::vector<VoidReason> voids;
    for (VoidReason& reason : void_reasons(query.text("void_reason"), query.text("void_meaning")))
        if (reason.cause != VoidCause::kReplayDiffers) voids.push_back(std::move(reason));
    if (state == ReplayState::kDiffers)
        voids.push_back({VoidCause::kReplayDiffers, 0, 0, difference});
    context_.touch("attempt", attempt_id);
    Statement(connection_,
              "UPDATE attempts SET replay = ?, replayed_utc = ?, void_reason = ?, void_meaning = "
              "?, read_by = '' WHERE id = ?")
        .run(static_cast<int>(state), utc_now(), void_text(voids), void_meaning(voids), attempt_id);
    const char* const what = state == ReplayState::kIdentical ? "attempt.replay"
                             : state == ReplayState::kDiffers ? "attempt.replay_differs"
                                                              : "attempt.replay_reset";
    context_.append_audit(what, "attempt " + std::to_string(attempt_id), difference.english());
    work.commit();
}

}  // namespace placode::db
