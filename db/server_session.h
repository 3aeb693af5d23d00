// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who has signed in, for a server that asks by itself (db/station_guard.h): this side of its
// functions. Only where the connection's log-in may not read hashes of passwords; elsewhere the
// store compares and writes them itself, and nothing here is called.
//
// A password is proved by the Argon2id result that only its owner can compute, and that not even as
// it is: statements of one log-in can be seen by others with the same log-in while they run. What
// this program remembers of a sign-in, a random token, lies in its memory only and lets its further
// connections to the same store act for the account.

#include <optional>
#include <string>

#include "db/records.h"
#include "db/sql_connection.h"

namespace placode::db {

class ServerSession {
 public:
    explicit ServerSession(Connection& connection);
    ~ServerSession();
    ServerSession(const ServerSession&) = delete;
    ServerSession& operator=(const ServerSession&) = delete;

    /// Whether the server asks by itself.
    [[nodiscard]] bool guards() { return connection_.hides_passwords(); }

    /// While one lives, enter() proves a password and changes nobody's session.
    class OnlyConfirms {
     public:
        explicit OnlyConfirms(ServerSession& session) : session_(session) {
            session_.confirms_ = true;
        }
        ~OnlyConfirms() { session_.confirms_ = false; }
        OnlyConfirms(const OnlyConfirms&) = delete;
        OnlyConfirms& operator=(const OnlyConfirms&) = delete;

     private:
        ServerSession& session_;
    };

    /// Signs in by password; nullopt where login or password is wrong. An account that is closed is
    /// named and has no session.
    [[nodiscard]] std::optional<UserRecord> enter(const std::string& login_key,
                                                  const std::string& password);
    /// The same by PIN, for an account that gave its password in this program in the last 12 h.
    [[nodiscard]] int64_t enter_by_pin(int64_t account, const std::string& pin);
    /// Acts for an account that has signed in in this program, on another connection perhaps.
    /// Without such a sign-in nothing changes: to the server this connection stays nobody's.
    void resume(int64_t account);
    /// Nobody acts on this connection from now on; a PIN may bring the account back.
    void leave() noexcept;

    /// The account that was made; with the hash of its password, which the server alone keeps.
    struct NewAccount {
        std::string hash;
        int64_t roles = 0;
        bool demonstration = false, password_given = false;
        std::string created_utc, login, login_key, display_name;
    };
    [[nodiscard]] int64_t add_account(const NewAccount& account);
    /// Roles and group are those of the invitation.
    [[nodiscard]] int64_t accept_invitation(const std::string& code, const NewAccount& account);
    void set_password(int64_t account, const std::string& hash, bool given);
    void set_pin(int64_t account, const std::string& hash);
    void drop_worn_pin(int64_t account);  ///< After three wrong ones.

 private:
    /// A secret of one call that the server told this connection alone.
    [[nodiscard]] std::string open_channel();
    void remember(int64_t account);
    void again();  ///< After a connection that broke.
    [[nodiscard]] bool resume_with(const std::string& token);

    Connection& connection_;
    bool confirms_ = false;
    bool entered_ = false;  ///< By password or PIN, here: further connections go by its token.
    int64_t account_ = 0;   ///< 0 = nobody.
    std::string token_;
};

}  // namespace placode::db
