// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts, passwords and the wait after wrong ones.

#include "db/accounts.h"

#include <algorithm>

#include "db/audit.h"
#include "db/password.h"
#include "db/sqlite_file.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr int kFreeTries = 5;
constexpr int kFirstWaitS = 5;
constexpr int kLongestWaitS = 900;
constexpr int64_t kForgetMs = int64_t{24} * 3600 * 1000;

int wait_s(int64_t failures) {
    if (failures < kFreeTries) return 0;
    const auto doublings = std::min<int64_t>(failures - kFreeTries, 10);
    return std::min(kLongestWaitS, kFirstWaitS << doublings);
}

void mark_store_of(const Connection& connection) {
    if (connection.is_sqlite()) mark_store(connection.url().path);
}

}  // namespace

Accounts::Accounts(StoreContext& context) : context_(context), connection_(context.connection) {}

std::string Accounts::check_new_user(const NewUser& user) {
    if (login_key(user.login).empty()) connection_.fail(Kind::kRefused, "the login is empty");
    if (user.display_name.empty()) connection_.fail(Kind::kRefused, "the name is empty");
    if (user.roles == 0) connection_.fail(Kind::kRefused, "the user has no role");
    if (const auto problem = password_problem(user.login, user.password))
        connection_.fail(Kind::kRefused, *problem);
    return hash_password(user.password, context_.options.cheap_passwords);
}

int64_t Accounts::create(const NewUser& user) {
    connection_.begin_operation("create the user \"" + user.login + "\" in");
    const std::string hash = check_new_user(user);
    UnitOfWork work(connection_);
    const int64_t id = insert_user(user, hash);
    work.commit();
    if (!user.demonstration) mark_store_of(connection_);
    return id;
}

int64_t Accounts::insert_user(const NewUser& user, const std::string& hash) {
    const std::string key = login_key(user.login);
    Statement taken(connection_, "SELECT account_id FROM persons WHERE login_key = ?");
    if (taken.run(key).next())
        connection_.fail(Kind::kConflict, "the login is taken; choose another one");
    Statement insert(connection_,
                     "INSERT INTO accounts (password_hash, roles, active, demonstration, "
                     "created_utc, password_given) VALUES (?, ?, 1, ?, ?, ?) RETURNING id");
    insert.run(hash, int{user.roles}, user.demonstration, utc_now(), user.password_given);
    const int64_t id = insert.returned_id();
    Statement(connection_,
              "INSERT INTO persons (account_id, login, login_key, display_name) VALUES (?, ?, ?, "
              "?)")
        .run(id, user.login, key, user.display_name);
    context_.made("user", id);
    context_.append_audit("user.create", user_object(id), "roles " + std::to_string(user.roles));
    return id;
}

int Accounts::wait_before_sign_in(const std::string& key) {
    const int64_t now = context_.now_ms();
    Statement query(connection_,
                    "SELECT failures, last_ms FROM sign_in_failures WHERE login_key = ?");
    query.run(key);
    if (!query.next()) return 0;
    const int64_t wait_ms = int64_t{1000} * wait_s(query.integer("failures"));
    const int64_t since = now - query.integer("last_ms");
    if (since < 0 && wait_ms > 0) {
        // A try in the future: the clock was set back. The wait begins now, or it would last until
        // the clock is there again, which may be years.
        Statement(connection_, "UPDATE sign_in_failures SET last_ms = ? WHERE login_key = ?")
            .run(now, key);
        return static_cast<int>(wait_ms / 1000);
    }
    return since < wait_ms ? static_cast<int>((wait_ms - since + 999) / 1000) : 0;
}

SignIn Accounts::sign_in(const std::string& login, const std::string& password) {
    connection_.begin_operation("sign in to");
    const std::string key = login_key(login);
    int64_t id = 0;
    std::string hash;
    {
        // The try is counted before the password is looked at, so that tries in parallel count too.
        UnitOfWork work(connection_);
        if (const int wait = wait_before_sign_in(key); wait > 0) {
            work.commit();
            return {SignInOutcome::kThrottled, std::nullopt, wait};
        }
        const int64_t now = context_.now_ms();
        Statement(connection_, "DELETE FROM sign_in_failures WHERE last_ms < ?")
            .run(now - kForgetMs);
        Statement(connection_,
                  "INSERT INTO sign_in_failures (login_key, failures, last_ms) VALUES (?, 1, ?) ON "
                  "CONFLICT (login_key) DO UPDATE SET failures = sign_in_failures.failures + 1, "
                  "last_ms = excluded.last_ms")
            .run(key, now);
        Statement account(connection_,
                          "SELECT a.id, a.password_hash FROM accounts a JOIN persons p ON "
                          "p.account_id = a.id WHERE p.login_key = ?");
        account.run(key);
        if (account.next()) {
            id = account.integer("id");
            hash = account.text("password_hash");
        }
        work.commit();
    }
    if (id == 0) {
        // The same work as for a real account, so that time does not tell which logins exist.
        (void)hash_password(password, context_.options.cheap_passwords);
        return {};
    }
    if (!verify_password(hash, password)) {
        Audit(context_).write("unknown", "sign_in.wrong_password", user_object(id), "");
        return {};
    }
    const UserRecord user = context_.need_user(id);
    UnitOfWork work(connection_);
    context_.touch("user", id);
    Statement(connection_, "DELETE FROM sign_in_failures WHERE login_key = ?").run(key);
    if (user.active && !context_.options.cheap_passwords && password_needs_rehash(hash))
        Statement(connection_, "UPDATE accounts SET password_hash = ? WHERE id = ?")
            .run(hash_password(password, false), id);
    context_.append_audit_as(user_object(id), user.active ? "sign_in" : "sign_in.deactivated",
                             user_object(id), "");
    work.commit();
    if (!user.active) return {SignInOutcome::kDeactivated, std::nullopt, 0};
    if (!user.demonstration) mark_store_of(connection_);
    context_.actor.name = user_object(id);
    return {SignInOutcome::kOk, user, 0};
}

void Accounts::set_password(int64_t user_id, const std::string& password, bool given) {
    connection_.begin_operation("set a password in");
    const UserRecord user = context_.need_user(user_id);
    if (const auto problem = password_problem(user.login, password))
        connection_.fail(Kind::kRefused, *problem);
    const std::string hash = hash_password(password, context_.options.cheap_passwords);
    UnitOfWork work(connection_);
    context_.touch("user", user_id);
    Statement(connection_, "UPDATE accounts SET password_hash = ?, password_given = ? WHERE id = ?")
        .run(hash, given, user_id);
    Statement(connection_, "DELETE FROM sign_in_failures WHERE login_key = ?")
        .run(login_key(user.login));
    Statement(connection_, "DELETE FROM account_pins WHERE account_id = ?").run(user_id);
    context_.append_audit("user.password", user_object(user_id), "");
    work.commit();
}

void Accounts::need_another_administrator(const UserRecord& user) {
    if (!has_role(user.roles, Role::kAdministrator)) return;
    Statement others(connection_, "SELECT id, roles FROM accounts WHERE active = 1 AND id <> ?");
    others.run(user.id);
    bool another = false;
    while (others.next())
        another =
            another || has_role(static_cast<Roles>(others.integer("roles")), Role::kAdministrator);
    if (!another)
        connection_.fail(Kind::kRefused, "\"" + user.login +
                                             "\" is the last active administrator; make another "
                                             "one first");
}

void Accounts::set_active(int64_t user_id, bool active) {
    connection_.begin_operation(active ? "activate a user in" : "deactivate a user in");
    UnitOfWork work(connection_);
    connection_.lock_table("accounts");
    const UserRecord user = context_.need_user(user_id);
    if (!active) need_another_administrator(user);
    context_.touch("user", user_id);
    Statement(connection_, "UPDATE accounts SET active = ? WHERE id = ?").run(active, user_id);
    context_.append_audit(active ? "user.activate" : "user.deactivate", user_object(user_id), "");
    work.commit();
}

void Accounts::set_roles(int64_t user_id, Roles roles) {
    connection_.begin_operation("change the roles of a user in");
    if (roles == 0) connection_.fail(Kind::kRefused, "the user has no role");
    UnitOfWork work(connection_);
    connection_.lock_table("accounts");
    const UserRecord user = context_.need_user(user_id);
    if (user.roles == roles) return;
    if (user.active && !has_role(roles, Role::kAdministrator)) need_another_administrator(user);
    context_.touch("user", user_id);
    Statement(connection_, "UPDATE accounts SET roles = ? WHERE id = ?").run(int{roles}, user_id);
    context_.append_audit("user.roles", user_object(user_id),
                          "roles " + std::to_string(user.roles) + " -> " + std::to_string(roles));
    work.commit();
}

std::vector<UserRecord> Accounts::list() {
    connection_.begin_operation("list the users of");
    Statement query(connection_, user_columns() + "ORDER BY p.login_key");
    query.run();
    std::vector<UserRecord> users;
    while (query.next()) users.push_back(read_user(query));
    return users;
}

std::optional<UserRecord> Accounts::find(int64_t id) {
    connection_.begin_operation("look up a user in");
    Statement query(connection_, user_columns() + "WHERE a.id = ?");
    query.run(id);
    if (!query.next()) return std::nullopt;
    return read_user(query);
}

std::optional<UserRecord> Accounts::find_login(const std::string& login) {
    connection_.begin_operation("look up a user in");
    Statement query(connection_, user_columns() + "WHERE p.login_key = ?");
    query.run(login_key(login));
    if (!query.next()) return std::nullopt;
    return read_user(query);
}

}  // namespace placode::db
