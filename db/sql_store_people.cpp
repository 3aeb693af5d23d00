// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// PIN, invitations, erasure.

#include <algorithm>
#include <array>

#include "curriculum/utc_time.h"
#include "db/packing.h"
#include "db/password.h"
#include "db/sql_store.h"

namespace placode::db {

using Kind = StoreError::Kind;

namespace {

constexpr int kPinTries = 3;

/// What is wrong with a PIN, or nothing.
std::string pin_problem(const std::string& pin) {
    if (pin.size() < 4 || pin.size() > 12 ||
        !std::all_of(pin.begin(), pin.end(), [](char c) { return c >= '0' && c <= '9'; }))
        return "a PIN has four to twelve digits";
    const auto steps = [&](int step) {
        for (size_t i = 1; i < pin.size(); ++i)
            if (pin[i] - pin[i - 1] != step) return false;
        return true;
    };
    if (steps(0) || steps(1) || steps(-1))
        return "all digits the same, or in a row, is the first that somebody tries";
    return {};
}

/// In groups of six: 119 bits.
std::string new_code() {
    std::string code = random_letters(6);
    for (int i = 0; i < 3; ++i) code.append("-").append(random_letters(6));
    return code;
}

std::string user_name_of(int64_t id) { return "user " + std::to_string(id); }

}  // namespace

void SqlStore::set_pin(int64_t user_id, const std::string& pin) {
    connection_.begin_operation("set a PIN in");
    (void)need_user(user_id);
    if (!pin.empty())
        if (const std::string problem = pin_problem(pin); !problem.empty())
            connection_.fail(Kind::kRefused, problem);
    const std::string hash =
        pin.empty() ? std::string() : hash_password(pin, options_.cheap_passwords);
    UnitOfWork work(connection_);
    Statement(connection_, "DELETE FROM account_pins WHERE account_id = ?").run(user_id);
    if (!pin.empty())
        Statement(connection_,
                  "INSERT INTO account_pins (account_id, pin_hash, failures) VALUES (?, ?, 0)")
            .run(user_id, hash);
    append_audit(actor_, pin.empty() ? "user.pin_removed" : "user.pin", user_name_of(user_id), "");
    work.commit();
}

bool SqlStore::has_pin(int64_t user_id) {
    connection_.begin_operation("look for a PIN in");
    Statement query(connection_, "SELECT account_id FROM account_pins WHERE account_id = ?");
    return query.run(user_id).next();
}

SignIn SqlStore::unlock(int64_t user_id, const std::string& pin) {
    connection_.begin_operation("unlock");
    std::string hash;
    {
        // Counted before it is looked at, so that tries in parallel count too.
        UnitOfWork work(connection_);
        connection_.lock_table("account_pins");
        Statement query(connection_,
                        "SELECT pin_hash, failures FROM account_pins WHERE account_id = ?");
        if (!query.run(user_id).next()) return {};
        hash = query.text("pin_hash");
        if (query.integer("failures") >= kPinTries) return {};
        Statement(connection_,
                  "UPDATE account_pins SET failures = failures + 1 WHERE account_id = ?")
            .run(user_id);
        work.commit();
    }
    if (!verify_password(hash, pin)) {
        UnitOfWork work(connection_);
        Statement(connection_, "DELETE FROM account_pins WHERE account_id = ? AND failures >= ?")
            .run(user_id, kPinTries);
        append_audit("unknown", "sign_in.wrong_pin", user_name_of(user_id), "");
        work.commit();
        return {};
    }
    const UserRecord user = need_user(user_id);
    UnitOfWork work(connection_);
    Statement(connection_, "UPDATE account_pins SET failures = 0 WHERE account_id = ?")
        .run(user_id);
    append_audit(user.login, user.active ? "sign_in.pin" : "sign_in.deactivated",
                 user_name_of(user_id), "");
    work.commit();
    if (!user.active) return {SignInOutcome::kDeactivated, std::nullopt, 0};
    actor_ = user.login;
    return {SignInOutcome::kOk, user, 0};
}

std::string SqlStore::invite(const InvitationRecord& invitation) {
    connection_.begin_operation("invite somebody to");
    if (invitation.roles == 0) connection_.fail(Kind::kRefused, "the invitation has no role");
    if (!curriculum::utc_seconds(invitation.expires_utc))
        connection_.fail(Kind::kRefused, "found the date \"" + invitation.expires_utc +
                                             "\"; an invitation needs a last day, such as "
                                             "2026-11-21");
    UnitOfWork work(connection_);
    if (invitation.group_id != 0) need_group(invitation.group_id);
    const std::string code = new_code();
    Statement insert(connection_,
                     "INSERT INTO invitations (code_hash, roles, group_id, note, invited_by, "
                     "made_utc, expires_utc, used_utc) VALUES (?, ?, ?, ?, ?, ?, ?, '') RETURNING "
                     "id");
    insert.run(checksum_hex(code), int{invitation.roles}, OrNull{invitation.group_id},
               invitation.note, actor_, utc_now(), invitation.expires_utc);
    const int64_t id = insert.returned_id();
    append_audit(actor_, "user.invite", "invitation " + std::to_string(id),
                 "roles " + std::to_string(invitation.roles));
    work.commit();
    return code;
}

std::vector<InvitationRecord> SqlStore::invitations() {
    connection_.begin_operation("list invitations of");
    Statement query(connection_,
                    "SELECT id, roles, COALESCE(group_id, 0) AS group_id, note, invited_by, "
                    "made_utc, expires_utc, used_utc FROM invitations ORDER BY id");
    query.run();
    std::vector<InvitationRecord> found;
    while (query.next())
        found.push_back({query.integer("id"), static_cast<Roles>(query.integer("roles")),
                         query.integer("group_id"), query.text("note"), query.text("invited_by"),
                         query.text("made_utc"), query.text("expires_utc"),
                         query.text("used_utc")});
    return found;
}

int64_t SqlStore::accept_invitation(const std::string& code, const NewUser& user) {
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
                        "SELECT id, roles, COALESCE(group_id, 0) AS group_id, expires_utc FROM "
                        "invitations "
                        "WHERE code_hash = ? AND used_utc = ''");
        if (!query.run(checksum_hex(code)).next())
            connection_.fail(Kind::kRefused, "the code is wrong or was used; ask for another one");
        id = query.integer("id");
        invited.roles = static_cast<Roles>(query.integer("roles"));
        group = query.integer("group_id");
        expires = query.text("expires_utc");
    }
    // The last day is a day to its end.
    const int64_t last = curriculum::utc_seconds(expires).value_or(0) +
                         (expires.size() == 10 ? int64_t{86400} : int64_t{0});
    if (now_ms() / 1000 >= last)
        connection_.fail(Kind::kRefused,
                         "the invitation ended on " + expires + "; ask for another one");
    const int64_t user_id = insert_user(invited, hash);
    if (group != 0)
        Statement(connection_,
                  "INSERT INTO group_members (group_id, account_id, teaches) VALUES (?, ?, 0)")
            .run(group, user_id);
    Statement(connection_, "UPDATE invitations SET used_utc = ? WHERE id = ?").run(utc_now(), id);
    append_audit(invited.login, "user.invited", user_name_of(user_id),
                 "invitation " + std::to_string(id));
    work.commit();
    return user_id;
}

void SqlStore::request_erasure(int64_t user_id, const std::string& reason) {
    connection_.begin_operation("ask for erasure in");
    UnitOfWork work(connection_);
    (void)need_user(user_id);
    Statement there(connection_, "SELECT account_id FROM erasure_requests WHERE account_id = ?");
    if (there.run(user_id).next())
        connection_.fail(Kind::kConflict, "erasure was asked for already");
    Statement(connection_,
              "INSERT INTO erasure_requests (account_id, reason, asked_utc, done_utc) VALUES (?, "
              "?, ?, '')")
        .run(user_id, reason, utc_now());
    append_audit(actor_, "user.ask_erasure", user_name_of(user_id), "");
    work.commit();
}

std::vector<ErasureRecord> SqlStore::erasure_requests() {
    connection_.begin_operation("list requests for erasure of");
    Statement query(connection_,
                    "SELECT account_id, reason, asked_utc, done_utc FROM erasure_requests ORDER BY "
                    "asked_utc, account_id");
    query.run();
    std::vector<ErasureRecord> found;
    while (query.next())
        found.push_back({query.integer("account_id"), query.text("reason"), query.text("asked_utc"),
                         query.text("done_utc")});
    return found;
}

void SqlStore::erase_person(int64_t user_id, bool with_attempts) {
    connection_.begin_operation("erase a person in");
    UnitOfWork work(connection_);
    connection_.lock_table("accounts");
    const UserRecord user = need_user(user_id);
    need_another_administrator(user);
    if (with_attempts) {
        std::vector<int64_t> attempts;
        {
            Statement query(connection_,
                            "SELECT id FROM attempts WHERE account_id = ? AND study = ''");
            query.run(user_id);
            while (query.next()) attempts.push_back(query.integer(0));
        }
        for (const int64_t id : attempts) delete_attempt(id);
    }
    Statement(connection_, "DELETE FROM sign_in_failures WHERE login_key = ?")
        .run(login_key(user.login));
    for (const char* table : {"persons", "account_pins", "group_members", "course_assignments",
                              "course_grants", "certificates"})
        Statement(connection_, std::string("DELETE FROM ") + table + " WHERE account_id = ?")
            .run(user_id);
    Statement(connection_,
              "UPDATE accounts SET active = 0, password_hash = '', roles = 0 WHERE id = ?")
        .run(user_id);
    Statement(connection_,
              "INSERT INTO erasure_requests (account_id, reason, asked_utc, done_utc) VALUES (?, "
              "'', ?, ?) ON CONFLICT (account_id) DO UPDATE SET reason = '', done_utc = "
              "excluded.done_utc")
        .run(user_id, utc_now(), utc_now());
    append_audit(actor_, "user.erase", user_name_of(user_id),
                 with_attempts ? "with attempts" : "attempts stay without a name");
    work.commit();
}

}  // namespace placode::db
