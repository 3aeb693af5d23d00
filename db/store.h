// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The store: users, attempts, recordings, answers, audit. SQLite embedded or PostgreSQL for a
// centre, one code over Qt Sql. One Store per thread. Every change is one transaction.

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

/// Operation, place and way out, e.g. `open sqlite:/x/placode.db: database is locked by another
/// program; close it, or wait and try again`.
class StoreError : public std::runtime_error {
 public:
    enum class Kind : uint8_t {
        kUnavailable,
        kLocked,
        kDamaged,
        kTooNew,
        kConflict,
        kRefused,
        kNotFound,
        kOther
    };
    StoreError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return kind_; }

 private:
    Kind kind_;
};

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
};

class Store {
 public:
    virtual ~Store() = default;

    // --- accounts
    virtual int64_t create_user(
        const NewUser& user) = 0;  ///< Throws kConflict, kRefused (weak password).
    virtual SignIn sign_in(const std::string& login, const std::string& password) = 0;
    virtual void set_password(int64_t user_id, const std::string& password) = 0;
    virtual void set_active(int64_t user_id, bool active) = 0;
    [[nodiscard]] virtual std::vector<UserRecord> users() = 0;
    [[nodiscard]] virtual std::optional<UserRecord> user(int64_t id) = 0;
    [[nodiscard]] virtual std::optional<UserRecord> user_by_login(const std::string& login) = 0;

    // --- attempts
    virtual int64_t save_attempt(int64_t user_id, const AttemptResult& result) = 0;
    /// Oldest first; user_id 0 = everybody; task_id empty = all.
    [[nodiscard]] virtual std::vector<AttemptRecord> attempts(int64_t user_id,
                                                              const std::string& task_id = {}) = 0;
    [[nodiscard]] virtual AttemptDetail attempt(int64_t id) = 0;  ///< Throws kNotFound.
    /// Writes the recording file of an attempt to `path`.
    virtual void extract_recording(int64_t attempt_id, const std::string& path) = 0;

    // --- studies (thin): answers of participants
    virtual std::string new_participant(
        const std::string& study_id) = 0;  ///< Next code with check character.
    virtual int64_t save_answers(const AnswerRecord& answers) = 0;
    [[nodiscard]] virtual std::vector<AnswerRecord> answers(const std::string& study_id) = 0;

    // --- audit, health
    virtual void audit(const std::string& actor, const std::string& action,
                       const std::string& object, const std::string& detail) = 0;
    [[nodiscard]] virtual std::vector<AuditRecord> audit_trail(int limit) = 0;
    virtual std::vector<std::string> check() = 0;      ///< Problems found; empty = sound.
    virtual void backup(const std::string& path) = 0;  ///< SQLite: a consistent copy.
    [[nodiscard]] virtual std::string url() const = 0;
};

/// "sqlite:PATH", "sqlite::memory:" or "postgresql://user:password@host:port/name". Creates and
/// migrates. Throws StoreError.
[[nodiscard]] std::unique_ptr<Store> open_store(const std::string& url);

/// "sqlite:" + the user's data folder + "/placode.db" (folder is created).
[[nodiscard]] std::string default_store_url();

}  // namespace placode::db
