// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The local profile: one person alone on a computer, who begins without an account and may make one
// of the profile later.

#include "db/accounts.h"
#include "db/password.h"
#include "db/sqlite_file.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr const char* kLogin = "guest";  ///< Until the person chooses another one.
/// Instead of the hash of a password, so sign_in() never lets anybody in by it. Erased people have
/// an empty one.
constexpr const char* kNoPassword = "local profile";

}  // namespace

int64_t Accounts::begin_alone(const std::string& display_name) {
    connection_.begin_operation("begin without an account in");
    if (any()) context_.need(Action::kManageUsers);
    if (!connection_.is_sqlite())
        connection_.fail(Kind::kRefused, "on a server everybody has an account and a password");
    if (display_name.empty()) connection_.fail(Kind::kRefused, "the name is empty");
    NewUser user;
    user.login = kLogin;
    user.display_name = display_name;
    user.roles = static_cast<Roles>(Role::kAdministrator) | static_cast<Roles>(Role::kTrainee);
    UnitOfWork work(connection_);
    // Two programs that begin at once: the second one sees the first one's account here.
    if (any()) connection_.fail(Kind::kRefused, "there is an account already; sign in to it");
    const int64_t id = insert_user(user, kNoPassword);
    work.commit();
    mark_store(connection_.url().path);
    return id;
}

std::optional<UserRecord> Accounts::local_profile() {
    connection_.begin_operation("look for a local profile in");
    if (!connection_.is_sqlite()) return std::nullopt;
    Statement query(connection_, user_columns() + "WHERE a.password_hash = ? AND a.active = 1");
    if (!query.run(kNoPassword).next()) return std::nullopt;
    return read_user(query);
}

SignIn Accounts::enter() {
    const std::optional<UserRecord> profile = local_profile();
    connection_.begin_operation("sign in to");
    if (!profile) return {};
    UnitOfWork work(connection_);
    context_.append_audit_as(user_object(profile->id), "sign_in.local_profile",
                             user_object(profile->id), "");
    work.commit();
    context_.become(profile->id);
    return {SignInOutcome::kOk, profile, 0};
}

void Accounts::name_local_profile(const NewUser& user) {
    const std::optional<UserRecord> profile = local_profile();
    connection_.begin_operation("make an account in");
    context_.need(Action::kUseStore);
    if (!profile || !context_.is_self(profile->id))
        connection_.fail(Kind::kRefused, "there is no profile without a password here");
    NewUser named = user;
    named.roles = profile->roles;
    const std::string hash = check_new_user(named);
    const std::string key = login_key(named.login);
    UnitOfWork work(connection_);
    need_free_login(key, profile->id);
    context_.touch("user", profile->id);
    Statement(connection_, "UPDATE accounts SET password_hash = ? WHERE id = ?")
        .run(hash, profile->id);
    Statement(connection_,
              "UPDATE persons SET login = ?, login_key = ?, display_name = ? WHERE account_id = ?")
        .run(named.login, key, named.display_name, profile->id);
    Statement(connection_, "DELETE FROM account_pins WHERE account_id = ?").run(profile->id);
    context_.append_audit("user.named", user_object(profile->id), "");
    work.commit();
}

void Accounts::need_accounts() {
    // Not local_profile(): what the caller does stays named in the message.
    if (!connection_.is_sqlite()) return;
    Statement query(connection_, "SELECT id FROM accounts WHERE password_hash = ? AND active = 1");
    if (query.run(kNoPassword).next())
        connection_.fail(Kind::kRefused,
                         "this store is one person's without a password; make an account of that "
                         "profile first");
}

}  // namespace placode::db
