// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The local profile: one person alone on a computer, who begins without an account and may make one
// of the profile later.

#include "db/accounts.h"
#include "db/local_profile.h"
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

/// Does not change the operation that a refusal names.
std::optional<UserRecord> find_profile(Connection& connection) {
    if (!connection.is_sqlite()) return std::nullopt;
    Statement query(connection, user_columns() + "WHERE a.password_hash = ? AND a.active = 1");
    if (!query.run(kNoPassword).next()) return std::nullopt;
    return read_user(query);
}

}  // namespace

int64_t Accounts::begin_alone(const std::string& display_name) {
    const bool begun = any();
    connection_.begin_operation("begin without an account in");
    if (begun) context_.need(Action::kManageUsers);
    if (!connection_.is_sqlite())
        connection_.fail(Kind::kRefused,
                         Said::that("on a server everybody has an account and a password"));
    if (const auto problem = name_problem(display_name)) connection_.fail(Kind::kRefused, *problem);
    NewUser user;
    user.login = kLogin;
    user.display_name = display_name;
    user.roles = static_cast<Roles>(Role::kAdministrator) | static_cast<Roles>(Role::kTrainee);
    UnitOfWork work(connection_);
    // Two programs that begin at once: the second one sees the first one's account here.
    const bool begun_meanwhile = any();
    connection_.begin_operation("begin without an account in");
    if (begun_meanwhile)
        connection_.fail(Kind::kRefused, Said::that("there is an account already; sign in to it"));
    const int64_t id = insert_user(user, kNoPassword);
    work.commit();
    mark_store(connection_.url().path);
    return id;
}

std::optional<UserRecord> Accounts::local_profile() {
    connection_.begin_operation("look for a local profile in");
    return find_profile(connection_);
}

SignIn Accounts::enter() {
    connection_.begin_operation("sign in to");
    const std::optional<UserRecord> profile = find_profile(connection_);
    if (!profile) return {};
    UnitOfWork work(connection_);
    context_.append_audit_as(user_object(profile->id), "sign_in.local_profile",
                             user_object(profile->id), "");
    work.commit();
    context_.become(profile->id);
    return {SignInOutcome::kOk, profile, 0};
}

void Accounts::name_local_profile(const NewUser& user) {
    connection_.begin_operation("make an account in");
    context_.need(Action::kUseStore);
    const std::optional<UserRecord> profile = find_profile(connection_);
    if (!profile || !context_.is_self(profile->id))
        connection_.fail(Kind::kRefused, Said::that("there is no profile without a password here"));
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
    if (find_profile(connection_)) connection_.fail(Kind::kRefused, one_persons_store());
}

}  // namespace placode::db
