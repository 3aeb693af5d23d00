// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Signing in by password, the wait after wrong ones, and what may be asked before.

#include <algorithm>

#include "db/accounts.h"
#include "db/demonstration.h"
#include "db/password.h"
#include "db/sqlite_file.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

constexpr int kFreeTries = 5;
constexpr int kFirstWaitS = 5;
constexpr int kLongestWaitS = 900;
constexpr int64_t kForgetMs = int64_t{24} * 3600 * 1000;
// Names that nobody has are without number, so no wait bounds what they write: this does, in a day.
constexpr int64_t kMostUnknown = 1000;
constexpr const char* kUnknown = "unknown";  // Their row; the others are called as checksums are.

int wait_s(int64_t failures) {
    if (failures < kFreeTries) return 0;
    const auto doublings = std::min<int64_t>(failures - kFreeTries, 10);
    return std::min(kLongestWaitS, kFirstWaitS << doublings);
}

}  // namespace

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
    SignIn found = check_password(login, password);
    if (found.user) context_.become(found.user->id);
    return found;
}

SignIn Accounts::confirm(const std::string& login, const std::string& password) {
    connection_.begin_operation("confirm in");
    context_.need(Action::kUseStore);
    const ServerSession::OnlyConfirms only(context_.server);
    return check_password(login, password);
}

SignIn Accounts::check_password(const std::string& login, const std::string& password) {
    const std::string key = login_key(login);
    const std::string failures = failures_key(login, context_.options.portal);
    const bool guarded = context_.server.guards();
    int64_t id = 0;
    std::string hash;
    {
        // The try is counted before the password is looked at, so that tries in parallel count too.
        UnitOfWork work(connection_);
        if (const int wait = wait_before_sign_in(failures); wait > 0) {
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
            .run(failures, now);
        Statement account(
            connection_,
            guarded ? "SELECT placode_guard.account_of(?, false) AS id, '' AS hash"
                    : "SELECT a.id, a.password_hash AS hash FROM accounts a JOIN persons p ON "
                      "p.account_id = a.id WHERE p.login_key = ?");
        if (account.run(key).next()) {
            id = account.integer("id");
            hash = account.text("hash");
        }
        (void)account.next();  // its end
        work.commit();
    }
    std::optional<UserRecord> entered;
    if (guarded) entered = context_.server.enter(key, password);
    const bool right =
        id != 0 && (guarded ? entered && entered->id == id : verify_password(hash, password));
    if (id == 0) {
        // The same work as for a real account, so that time does not tell which logins exist. A
        // server that asks by itself gave a salt for it.
        if (!guarded) (void)hash_password(password, context_.options.cheap_passwords);
    }
    if (!right) {
        note_wrong_try(id);
        return {};
    }
    const UserRecord user = guarded ? *entered : context_.need_user(id);
    UnitOfWork work(connection_);
    context_.touch("user", id);
    Statement(connection_, "DELETE FROM sign_in_failures WHERE login_key = ?").run(failures);
    if (user.active && !guarded && !context_.options.cheap_passwords && password_needs_rehash(hash))
        Statement(connection_, "UPDATE accounts SET password_hash = ? WHERE id = ?")
            .run(hash_password(password, false), id);
    context_.append_audit_as(user_object(id), user.active ? "sign_in" : "sign_in.deactivated",
                             user_object(id), "");
    work.commit();
    if (!user.active) return {SignInOutcome::kDeactivated, std::nullopt, 0};
    if (!user.demonstration && connection_.is_sqlite()) mark_store(connection_.url().path);
    return {SignInOutcome::kOk, user, 0};
}

// Whether the log-in is there, or not (0), the same is written in the same transaction, but for the
// words of the entry: a commit takes milliseconds, and they would show from afar.
void Accounts::note_wrong_try(int64_t id) {
    UnitOfWork work(connection_);
    context_.lock_trail();
    // Its time is the first of its day, which the next try after it takes away.
    const int64_t unknown =
        Statement(connection_,
                  "INSERT INTO sign_in_failures (login_key, failures, last_ms) VALUES (?, ?, ?) ON "
                  "CONFLICT (login_key) DO UPDATE SET failures = sign_in_failures.failures + "
                  "excluded.failures, last_ms = CASE WHEN sign_in_failures.last_ms > "
                  "excluded.last_ms THEN excluded.last_ms ELSE sign_in_failures.last_ms END "
                  "RETURNING failures")
            .run(kUnknown, id == 0 ? 1 : 0, context_.now_ms())
            .returned_id();
    // Under the name of who is signed in, if anybody: a proctor's password is typed in a trainee's
    // session, for example. What was typed may be a password; nobody's try begins a trail.
    if (id != 0)
        context_.append_audit("sign_in.wrong_password", user_object(id), "");
    else if (unknown <= kMostUnknown && any_account(connection_))
        context_.append_audit("sign_in.unknown", "", "");
    work.commit();
}

bool Accounts::any() {
    connection_.begin_operation("look for accounts in");
    return any_account(connection_);
}

bool Accounts::may_sign_in(const std::string& login) {
    connection_.begin_operation("look for an account in");
    return account_of(connection_, login_key(login), true) != 0;
}

std::vector<UserRecord> Accounts::demonstrators() {
    connection_.begin_operation("look for demonstration accounts in");
    std::vector<UserRecord> users;
    Statement query(connection_, user_columns() + "ORDER BY p.login_key");
    query.run();
    while (query.next()) users.push_back(read_user(query));
    return is_demonstration_store(users) ? users : std::vector<UserRecord>{};
}

}  // namespace placode::db
