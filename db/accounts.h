// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: who people are to it. Users, sign-in, PIN, invitations, erasure.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

enum class SignInOutcome : uint8_t { kOk, kWrong, kThrottled, kDeactivated };
struct SignIn {
    SignInOutcome outcome = SignInOutcome::kWrong;
    std::optional<UserRecord> user;
    int wait_s = 0;  ///< kThrottled: seconds until the next try.
};

struct NewUser {
    std::string login, display_name, password;
    Roles roles = static_cast<Roles>(Role::kTrainee);
    bool demonstration = false;
    bool password_given = false;  ///< Somebody else chose it: the owner is to choose another.
};

/// Somebody of a list.
struct ListedUser {
    NewUser user;
    int64_t group_id = 0;  ///< Whose member; 0 = of none.
};

/// `store.accounts()`. Every change is one transaction and in the audit trail.
class Accounts {
 public:
    explicit Accounts(StoreContext& context);

    /// Throws kConflict, kRefused (weak password). Nobody may make the first one, an administrator.
    int64_t create(const NewUser& user);
    /// All of a list, or nobody. Throws as create(), and kNotFound for a group; `at` is then the
    /// place of who could not be made.
    void create_all(const std::vector<ListedUser>& people, size_t& at);
    /// After 5 wrong passwords in a row the login has to wait: 5 s, then twice as long each time,
    /// at most 15 min. What is not an account waits and takes as long as what is one.
    /// From then on the store works for this account, with its rights.
    SignIn sign_in(const std::string& login, const std::string& password);
    /// As sign_in(), for somebody who is present and confirms something: who acts stays.
    SignIn confirm(const std::string& login, const std::string& password);
    /// @param given somebody else chose it.
    void set_password(int64_t user_id, const std::string& password, bool given = false);
    /// Throws kRefused when it would leave no active administrator.
    void set_active(int64_t user_id, bool active);
    /// Throws kRefused for no role at all, and as set_active().
    void set_roles(int64_t user_id, Roles roles);
    [[nodiscard]] std::vector<UserRecord> list();  ///< By login.
    /// The own account also when it is closed.
    [[nodiscard]] std::optional<UserRecord> find(int64_t id);
    [[nodiscard]] std::optional<UserRecord> find_login(const std::string& login);
    /// An active educator or administrator, by login or else by name: everybody who has signed in
    /// may know who they are.
    [[nodiscard]] std::optional<UserRecord> find_staff(const std::string& login_or_name);

    // accounts_sign_in.cpp: what may be asked before anybody has signed in
    [[nodiscard]] bool any();  ///< Whether there is an account.
    /// Whether this login has an account that is not closed.
    [[nodiscard]] bool may_sign_in(const std::string& login);
    /// Everybody, in a store that was made to be looked at (db/demonstration.h); else nobody.
    [[nodiscard]] std::vector<UserRecord> demonstrators();

    // accounts_local_profile.cpp: one person alone on this computer, without a password. Whoever
    // can open the file of such a store is that person, so nobody else may be in it.
    /// Makes the first account of a store that is a file: an administrator who trains. Throws
    /// kRefused where there is an account already, or a server.
    int64_t begin_alone(const std::string& display_name);
    /// Who may come in without a password; nullopt = nobody. May be asked before anybody signed in.
    [[nodiscard]] std::optional<UserRecord> local_profile();
    /// Signs the local profile in: kWrong where there is none.
    SignIn enter();
    /// The local profile becomes an account as all others: name, login and password (roles stay).
    /// Throws as create(), and kRefused when who acts is not the local profile.
    void name_local_profile(const NewUser& user);

    // accounts_pin.cpp
    /// Four to twelve digits for a quick return at a shared station; empty = none any more. Throws
    /// kRefused for a PIN that is too easy. A new password takes the PIN away.
    void set_pin(int64_t user_id, const std::string& pin);
    [[nodiscard]] bool has_pin(int64_t user_id);  ///< Also before anybody has signed in.
    /// As sign_in(), by PIN. After 3 wrong ones in a row the PIN is gone and the password needed.
    SignIn unlock(int64_t user_id, const std::string& pin);

    // accounts_invitations.cpp
    /// Returns the code to hand over; the store keeps its hash only.
    std::string invite(const InvitationRecord& invitation);
    [[nodiscard]] std::vector<InvitationRecord> invitations();
    /// Makes the account of who was invited; roles and group are the invitation's. A code works
    /// once. Throws kRefused for a code that is wrong, used or expired, else as create().
    int64_t accept_invitation(const std::string& code, const NewUser& user);

    // accounts_erasure.cpp
    void request_erasure(int64_t user_id, const std::string& reason);
    /// For who may not manage accounts: the own one.
    [[nodiscard]] std::vector<ErasureRecord> erasure_requests();
    /// Removes who the account is: name, login, password, PIN, groups, assignments; it can never be
    /// signed in to again. Attempts stay without a name, or go as well. Throws kRefused for the
    /// last active administrator.
    void erase(int64_t user_id, bool with_attempts);

 private:
    [[nodiscard]] int wait_before_sign_in(const std::string& key);
    void note_wrong_try(int64_t id);  ///< 0: nobody has that log-in.
    /// By which login it is throttled, and its outcome in the audit trail; who acts stays.
    SignIn check_password(const std::string& login, const std::string& password);
    void need_another_administrator(const UserRecord& user);
    /// Inside a transaction, everything checked.
    int64_t insert_user(const NewUser& user, const std::string& hash);
    /// Throws kRefused while the store is one person's without a password.
    void need_accounts();
    /// Throws kConflict when another account has this login.
    void need_free_login(const std::string& key, int64_t but_of = 0);
    /// Throws kRefused for what a new account may not be; returns the hash of the password.
    [[nodiscard]] std::string check_new_user(const NewUser& user);

    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
