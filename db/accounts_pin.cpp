// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The PIN for a quick return at a shared station.

#include <algorithm>
#include <optional>

#include "db/accounts.h"
#include "db/password.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr int kPinTries = 3;

/// What is wrong with a PIN, or nothing.
std::optional<Said> pin_problem(const std::string& pin) {
    if (pin.size() < 4 || pin.size() > 12 ||
        !std::all_of(pin.begin(), pin.end(), [](char c) { return c >= '0' && c <= '9'; }))
        return Said::that("a PIN has four to twelve digits");
    const auto steps = [&](int step) {
        for (size_t i = 1; i < pin.size(); ++i)
            if (pin[i] - pin[i - 1] != step) return false;
        return true;
    };
    if (steps(0) || steps(1) || steps(-1))
        return Said::that("all digits the same, or in a row, is the first that somebody tries");
    return std::nullopt;
}

}  // namespace

void Accounts::set_pin(int64_t user_id, const std::string& pin) {
    connection_.begin_operation("set a PIN in");
    context_.need_for(pin.empty() ? Action::kSetPassword : Action::kSetPin, user_id);
    (void)context_.need_user(user_id);
    if (!pin.empty())
        if (const auto problem = pin_problem(pin)) connection_.fail(Kind::kRefused, *problem);
    const std::string hash =
        pin.empty() ? std::string() : hash_password(pin, context_.options.cheap_passwords);
    UnitOfWork work(connection_);
    context_.touch("user", user_id);
    Statement(connection_, "DELETE FROM account_pins WHERE account_id = ?").run(user_id);
    if (!pin.empty() && context_.server.guards())
        context_.server.set_pin(user_id, hash);
    else if (!pin.empty())
        Statement(connection_,
                  "INSERT INTO account_pins (account_id, pin_hash, failures) VALUES (?, ?, 0)")
            .run(user_id, hash);
    context_.append_audit(pin.empty() ? "user.pin_removed" : "user.pin", user_object(user_id), "");
    work.commit();
}

bool Accounts::has_pin(int64_t user_id) {
    connection_.begin_operation("look for a PIN in");
    const bool guarded = context_.server.guards();
    Statement query(connection_, guarded
                                     ? "SELECT 1 WHERE placode_guard.has_pin(?)"
                                     : "SELECT account_id FROM account_pins WHERE account_id = ?");
    return query.run(user_id).next();
}

SignIn Accounts::unlock(int64_t user_id, const std::string& pin) {
    connection_.begin_operation("unlock");
    const bool guarded = context_.server.guards();
    bool right = false;
    if (guarded) {
        if (!has_pin(user_id)) return {};
        connection_.begin_operation("unlock");
        right = context_.server.enter_by_pin(user_id, pin) == user_id;
    } else {
        std::string hash;
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
        right = verify_password(hash, pin);
    }
    if (!right) {
        UnitOfWork work(connection_);
        context_.touch("user", user_id);
        if (guarded)
            context_.server.drop_worn_pin(user_id);
        else
            Statement(connection_,
                      "DELETE FROM account_pins WHERE account_id = ? AND failures >= ?")
                .run(user_id, kPinTries);
        context_.append_audit("sign_in.wrong_pin", user_object(user_id), "");
        work.commit();
        return {};
    }
    UserRecord user;
    if (const auto found = context_.find_user(user_id))
        user = *found;
    else if (guarded)
        user.active = false;  // Closed: to the server nobody has signed in.
    else
        (void)context_.need_user(user_id);
    UnitOfWork work(connection_);
    if (!guarded)
        Statement(connection_, "UPDATE account_pins SET failures = 0 WHERE account_id = ?")
            .run(user_id);
    context_.append_audit_as(user_object(user_id),
                             user.active ? "sign_in.pin" : "sign_in.deactivated",
                             user_object(user_id), "");
    work.commit();
    if (!user.active) return {SignInOutcome::kDeactivated, std::nullopt, 0};
    context_.become(user_id);
    return {SignInOutcome::kOk, user, 0};
}

}  // namespace placode::db
