// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Invitations: a code in place of an account that somebody else makes.

#include "curriculum/utc_time.h"
#include "db/accounts.h"
#include "db/packing.h"
#include "db/password.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

/// In groups of six: 119 bits.
std::string new_code() {
    std::string code = random_letters(6);
    for (int i = 0; i < 3; ++i) code.append("-").append(random_letters(6));
    return code;
}

}  // namespace

std::string Accounts::invite(const InvitationRecord& invitation) {
    connection_.begin_operation("invite somebody to");
    context_.need(Action::kManageUsers);
    need_accounts();
    if (invitation.roles == 0)
        connection_.fail(Kind::kRefused, Said::that("the invitation has no role"));
    if (const auto problem = hidden_letters_problem(invitation.note))
        connection_.fail(Kind::kRefused, *problem);
    if (!curriculum::utc_seconds(invitation.expires_utc))
        connection_.fail(
            Kind::kRefused,
            Said::that("found the date \"%1\"; an invitation needs a last day, such as %2")
                .with(invitation.expires_utc)
                .with("2026-11-21"));
    UnitOfWork work(connection_);
    if (invitation.group_id != 0) context_.need_group(invitation.group_id);
    std::string code = new_code();
    Statement insert(connection_,
                     "INSERT INTO invitations (code_hash, roles, group_id, note, invited_by, "
                     "made_utc, expires_utc, used_utc) VALUES (?, ?, ?, ?, ?, ?, ?, '') RETURNING "
                     "id");
    insert.run(checksum_hex(code), int{invitation.roles}, OrNull{invitation.group_id},
               invitation.note, context_.actor.name, utc_now(), invitation.expires_utc);
    const int64_t id = insert.returned_id();
    context_.made("invitation", id);
    context_.append_audit("user.invite", "invitation " + std::to_string(id),
                          "roles " + std::to_string(invitation.roles));
    work.commit();
    return code;
}

std::vector<InvitationRecord> Accounts::invitations() {
    connection_.begin_operation("list invitations of");
    context_.need(Action::kManageUsers);
    // Once somebody has accepted it, it is known for whom it was.
    Statement query(connection_,
                    "SELECT i.id, i.roles, COALESCE(i.group_id, 0) AS group_id, COALESCE(CASE WHEN "
                    "i.used_utc = '' THEN i.note ELSE (SELECT t.object FROM audit t WHERE t.action "
                    "= 'user.invited' AND t.detail = 'invitation ' || CAST(i.id AS TEXT) ORDER BY "
                    "t.id LIMIT 1) END, '') AS note, i.invited_by, i.made_utc, i.expires_utc, "
                    "i.used_utc FROM invitations i ORDER BY i.id");
    query.run();
    std::vector<InvitationRecord> found;
    while (query.next())
        found.push_back({query.integer("id"), static_cast<Roles>(query.integer("roles")),
                         query.integer("group_id"), query.text("note"), query.text("invited_by"),
                         query.text("made_utc"), query.text("expires_utc"),
                         query.text("used_utc")});
    context_.show_names(found, &InvitationRecord::invited_by);
    for (InvitationRecord& each : found)
        if (!each.used_utc.empty()) each.note = context_.shown_name(each.note);
    return found;
}

int64_t Accounts::accept_invitation(const std::string& code, const NewUser& user) {
    connection_.begin_operation("accept an invitation to");
    NewUser invited = user;
    invited.roles = static_cast<Roles>(Role::kTrainee);  // Until the code has said which.
    const std::string hash = check_new_user(invited);
    UnitOfWork work(connection_);
    connection_.lock_table("invitations");
    int64_t id = 0, group = 0;
    std::string expires;
    {
        Statement query(connection_,
                        context_.server.guards()
                            ? "SELECT id, roles, group_id, expires_utc FROM "
                              "placode_guard.invitation_by(?)"
                            : "SELECT id, roles, COALESCE(group_id, 0) AS group_id, expires_utc "
                              "FROM invitations WHERE code_hash = ? AND used_utc = ''");
        if (!query.run(checksum_hex(code)).next())
            connection_.fail(Kind::kRefused,
                             Said::that("the code is wrong or was used; ask for another one"));
        id = query.integer("id");
        invited.roles = static_cast<Roles>(query.integer("roles"));
        group = query.integer("group_id");
        expires = query.text("expires_utc");
    }
    // The last day is a day to its end.
    const int64_t last = curriculum::utc_seconds(expires).value_or(0) +
                         (expires.size() == 10 ? int64_t{86400} : int64_t{0});
    if (context_.now_ms() / 1000 >= last)
        connection_.fail(
            Kind::kRefused,
            Said::that("the invitation ended on %1; ask for another one").with(expires));
    int64_t user_id = 0;
    if (context_.server.guards()) {
        context_.touch("invitation", id);
        if (group != 0) context_.touch("group", group);
        const std::string key = login_key(invited.login);
        need_free_login(key);
        user_id = context_.server.accept_invitation(
            code, {hash, invited.roles, invited.demonstration, false, utc_now(), invited.login, key,
                   invited.display_name});
        context_.made("user", user_id);
        context_.append_audit("user.create", user_object(user_id),
                              "roles " + std::to_string(invited.roles));
    } else {
        user_id = insert_user(invited, hash);
        context_.touch("invitation", id);
        if (group != 0) context_.touch("group", group);
        if (group != 0)
            Statement(connection_,
                      "INSERT INTO group_members (group_id, account_id, teaches) VALUES (?, ?, 0)")
                .run(group, user_id);
        // For whom it was has served: the account says it now, and erasure would miss it here.
        Statement(connection_, "UPDATE invitations SET used_utc = ?, note = '' WHERE id = ?")
            .run(utc_now(), id);
    }
    context_.append_audit_as(user_object(user_id), "user.invited", user_object(user_id),
                             "invitation " + std::to_string(id));
    work.commit();
    return user_id;
}

}  // namespace placode::db
