// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts: made, changed, looked up.

#include "db/accounts.h"

#include <algorithm>

#include "db/password.h"
#include "db/sqlite_file.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

}  // namespace

Accounts::Accounts(StoreContext& context) : context_(context), connection_(context.connection) {}

std::string Accounts::check_new_user(const NewUser& user) {
    if (const auto problem = login_problem(user.login)) connection_.fail(Kind::kRefused, *problem);
    if (const auto problem = name_problem(user.display_name))
        connection_.fail(Kind::kRefused, *problem);
    if (user.roles == 0) connection_.fail(Kind::kRefused, Said::that("the user has no role"));
    if (const auto problem = password_problem(user.login, user.password))
        connection_.fail(Kind::kRefused, *problem);
    return hash_password(user.password, context_.options.cheap_passwords);
}

int64_t Accounts::create(const NewUser& user) {
    // Whoever comes to a store without accounts makes the first one: an administrator.
    const bool first = context_.actor.kind == Actor::Kind::kNobody &&
                       has_role(user.roles, Role::kAdministrator) && !any();
    connection_.begin_operation("create the user \"" + user.login + "\" in");
    if (!first) context_.need(Action::kManageUsers);
    need_accounts();
    const std::string hash = check_new_user(user);
    UnitOfWork work(connection_);
    const int64_t id = insert_user(user, hash);
    work.commit();
    if (!user.demonstration && connection_.is_sqlite()) mark_store(connection_.url().path);
    return id;
}

void Accounts::create_all(const std::vector<ListedUser>& people, size_t& at) {
    at = 0;
    connection_.begin_operation("create the users of a list in");
    context_.need(Action::kManageUsers);
    need_accounts();
    // Hashing takes its time: before the transaction, or nobody else could write meanwhile.
    std::vector<std::string> hashes;
    for (; at < people.size(); ++at) {
        if (people[at].group_id != 0)
            context_.need_for_group(Action::kManageGroups, people[at].group_id);
        hashes.push_back(check_new_user(people[at].user));
    }
    UnitOfWork work(connection_);
    for (at = 0; at < people.size(); ++at) {
        const ListedUser& person = people[at];
        const int64_t id = insert_user(person.user, hashes[at]);
        if (person.group_id == 0) continue;
        context_.need_group(person.group_id);
        context_.touch("group", person.group_id);
        Statement(connection_,
                  "INSERT INTO group_members (group_id, account_id, teaches) VALUES (?, ?, 0)")
            .run(person.group_id, id);
        context_.append_audit("group.member",
                              "group " + std::to_string(person.group_id) + " " + user_object(id),
                              "member");
    }
    work.commit();
    const bool real = std::any_of(people.begin(), people.end(),
                                  [](const ListedUser& each) { return !each.user.demonstration; });
    if (real && connection_.is_sqlite()) mark_store(connection_.url().path);
}

void Accounts::need_free_login(const std::string& key, int64_t but_of) {
    const int64_t of = account_of(connection_, key);
    if (of != 0 && of != but_of)
        connection_.fail(Kind::kConflict, Said::that("the login is taken; choose another one"));
}

int64_t Accounts::insert_user(const NewUser& user, const std::string& hash) {
    const std::string key = login_key(user.login);
    need_free_login(key);
    int64_t id = 0;
    if (context_.server.guards()) {
        id = context_.server.add_account({hash, user.roles, user.demonstration, user.password_given,
                                          utc_now(), user.login, key, user.display_name});
    } else {
        Statement insert(connection_,
                         "INSERT INTO accounts (password_hash, roles, active, demonstration, "
                         "created_utc, password_given) VALUES (?, ?, 1, ?, ?, ?) RETURNING id");
        insert.run(hash, int{user.roles}, user.demonstration, utc_now(), user.password_given);
        id = insert.returned_id();
        Statement(connection_,
                  "INSERT INTO persons (account_id, login, login_key, display_name) VALUES (?, ?, "
                  "?, ?)")
            .run(id, user.login, key, user.display_name);
    }
    context_.made("user", id);
    context_.append_audit("user.create", user_object(id), "roles " + std::to_string(user.roles));
    return id;
}

void Accounts::set_password(int64_t user_id, const std::string& password, bool given) {
    connection_.begin_operation("set a password in");
    context_.need_for(Action::kSetPassword, user_id);
    const UserRecord user = context_.need_user(user_id);
    if (const auto problem = password_problem(user.login, password))
        connection_.fail(Kind::kRefused, *problem);
    const std::string hash = hash_password(password, context_.options.cheap_passwords);
    UnitOfWork work(connection_);
    context_.touch("user", user_id);
    if (context_.server.guards())
        context_.server.set_password(user_id, hash, given);
    else
        Statement(connection_,
                  "UPDATE accounts SET password_hash = ?, password_given = ? WHERE id = ?")
            .run(hash, given, user_id);
    Statement(connection_, "DELETE FROM sign_in_failures WHERE login_key IN (?, ?)")
        .run(failures_key(user.login), failures_key(user.login, true));
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
        connection_.fail(
            Kind::kRefused,
            Said::that("\"%1\" is the last active administrator; make another one first")
                .with(user.login));
}

void Accounts::set_active(int64_t user_id, bool active) {
    connection_.begin_operation(active ? "activate a user in" : "deactivate a user in");
    context_.need_for(Action::kManageUsers, user_id);
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
    context_.need_for(Action::kManageUsers, user_id);
    if (roles == 0) connection_.fail(Kind::kRefused, Said::that("the user has no role"));
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
    context_.need(Action::kViewPersonalData);
    Statement query(connection_, user_columns() + "ORDER BY p.login_key");
    query.run();
    std::vector<UserRecord> users;
    while (query.next()) users.push_back(read_user(query));
    return users;
}

std::optional<UserRecord> Accounts::find(int64_t id) {
    connection_.begin_operation("look up a user in");
    if (!context_.is_self(id)) context_.need_for(Action::kViewPersonalData, id);
    Statement query(connection_, user_columns() + "WHERE a.id = ?");
    query.run(id);
    if (!query.next()) return std::nullopt;
    return read_user(query);
}

std::optional<UserRecord> Accounts::find_login(const std::string& login) {
    connection_.begin_operation("look up a user in");
    std::optional<UserRecord> found;
    {
        Statement query(connection_, user_columns() + "WHERE p.login_key = ?");
        if (query.run(login_key(login)).next()) found = read_user(query);
    }
    // What is not there is refused alike: who may not see names does not learn which there are.
    context_.need_for(Action::kViewPersonalData, found ? found->id : 0);
    return found;
}

std::optional<UserRecord> Accounts::find_staff(const std::string& login_or_name) {
    connection_.begin_operation("look up an educator in");
    context_.need(Action::kUseStore);
    return context_.find_staff(login_or_name);
}

}  // namespace placode::db
