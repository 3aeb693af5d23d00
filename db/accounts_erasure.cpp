// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Erasure: asked for by somebody, done by an administrator.

#include <vector>

#include "db/accounts.h"
#include "db/password.h"
#include "db/store_context.h"

namespace placode::db {

using Kind = StoreError::Kind;

namespace {

/// @param of what the question asks about: an account's number, or how the trail names it.
template <class Of>
std::vector<int64_t> ids_of(Connection& connection, const char* sql, const Of& of) {
    Statement query(connection, sql);
    query.run(of);
    std::vector<int64_t> ids;
    while (query.next()) ids.push_back(query.integer(0));
    return ids;
}

/// An earlier version wrote out who signed a participant's record.
void forget_signatures_name(StoreContext& context, int64_t user_id) {
    const std::string kept = user_object(user_id);
    std::vector<std::pair<std::string, std::string>> records;
    {
        Statement query(context.connection,
                        "SELECT DISTINCT study_id, code FROM record_events WHERE by_login = ? AND "
                        "by_name <> by_login");
        query.run(kept);
        while (query.next()) records.emplace_back(query.text(0), query.text(1));
    }
    if (records.empty()) return;
    for (const auto& [study, code] : records) context.touch("participant", {study, code});
    Statement(context.connection, "UPDATE record_events SET by_name = by_login WHERE by_login = ?")
        .run(kept);
}

/// An earlier version kept "for whom" of an invitation after somebody had accepted it.
void forget_whom_it_was_for(StoreContext& context, int64_t user_id) {
    for (const int64_t id : ids_of(
             context.connection,
             "SELECT i.id FROM invitations i JOIN audit t ON t.action = 'user.invited' AND "
             "t.detail = 'invitation ' || CAST(i.id AS TEXT) WHERE t.object = ? AND i.note <> ''",
             user_object(user_id))) {
        context.touch("invitation", id);
        Statement(context.connection, "UPDATE invitations SET note = '' WHERE id = ?").run(id);
    }
}

}  // namespace

void Accounts::request_erasure(int64_t user_id, const std::string& reason) {
    connection_.begin_operation("ask for erasure in");
    context_.need_for(Action::kRequestErasure, user_id);
    UnitOfWork work(connection_);
    (void)context_.need_user(user_id);
    Statement there(connection_, "SELECT account_id FROM erasure_requests WHERE account_id = ?");
    if (there.run(user_id).next())
        connection_.fail(Kind::kConflict, Said::that("erasure was asked for already"));
    context_.touch("user", user_id);
    Statement(connection_,
              "INSERT INTO erasure_requests (account_id, reason, asked_utc, done_utc) VALUES (?, "
              "?, ?, '')")
        .run(user_id, reason, utc_now());
    context_.append_audit("user.ask_erasure", user_object(user_id), "");
    work.commit();
}

std::vector<ErasureRecord> Accounts::erasure_requests() {
    connection_.begin_operation("list requests for erasure of");
    const bool all = context_.may(Action::kManageUsers);
    if (!all) context_.need(Action::kUseStore);
    Statement query(connection_,
                    "SELECT account_id, reason, asked_utc, done_utc FROM erasure_requests ORDER BY "
                    "asked_utc, account_id");
    query.run();
    std::vector<ErasureRecord> found;
    while (query.next())
        if (all || context_.is_self(query.integer("account_id")))
            found.push_back({query.integer("account_id"), query.text("reason"),
                             query.text("asked_utc"), query.text("done_utc")});
    return found;
}

void Accounts::erase(int64_t user_id, bool with_attempts) {
    connection_.begin_operation("erase a person in");
    context_.need_for(Action::kErase, user_id);
    UnitOfWork work(connection_);
    connection_.lock_table("accounts");
    const UserRecord user = context_.need_user(user_id);
    need_another_administrator(user);
    if (with_attempts)
        for (const int64_t id :
             ids_of(connection_, "SELECT id FROM attempts WHERE account_id = ? AND study = ''",
                    user_id))
            context_.delete_attempt(id);
    context_.touch("user", user_id);
    for (const int64_t id :
         ids_of(connection_, "SELECT group_id FROM group_members WHERE account_id = ?", user_id))
        context_.touch("group", id);
    for (const int64_t id :
         ids_of(connection_, "SELECT id FROM course_assignments WHERE account_id = ?", user_id))
        context_.touch("assignment", id);
    forget_signatures_name(context_, user_id);
    forget_whom_it_was_for(context_, user_id);
    Statement(connection_, "DELETE FROM sign_in_failures WHERE login_key IN (?, ?)")
        .run(failures_key(user.login), failures_key(user.login, true));
    for (const char* table : {"persons", "account_pins", "group_members", "course_assignments",
                              "course_grants", "certificates", "exam_begins"})
        Statement(connection_, std::string("DELETE FROM ") + table + " WHERE account_id = ?")
            .run(user_id);
    if (context_.server.guards())
        context_.server.set_password(user_id, "", user.password_given);
    else
        Statement(connection_, "UPDATE accounts SET password_hash = '' WHERE id = ?").run(user_id);
    Statement(connection_, "UPDATE accounts SET active = 0, roles = 0 WHERE id = ?").run(user_id);
    Statement(connection_,
              "INSERT INTO erasure_requests (account_id, reason, asked_utc, done_utc) VALUES (?, "
              "'', ?, ?) ON CONFLICT (account_id) DO UPDATE SET reason = '', done_utc = "
              "excluded.done_utc")
        .run(user_id, utc_now(), utc_now());
    context_.append_audit("user.erase", user_object(user_id),
                          with_attempts ? "with attempts" : "attempts stay without a name");
    work.commit();
}

}  // namespace placode::db
