// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who acts on which store. Rights are those of db/access.

#include <memory>
#include <optional>
#include <string>

#include "db/access.h"
#include "db/store.h"
#include "ui/cli/cli.h"

namespace placode::cli {

/// What to do when an embedded store is not there.
enum class Missing : uint8_t {
    kRefuse,
    kCreate,     ///< Not where one was before.
    kBeginAnew,  ///< Also there: somebody has said so.
};

class Session {
 public:
    /// Signs in as --as; without it acts as local administrator, which only the owner of an
    /// embedded store's file may, and the audit trail says so. Throws AccessError, InputError or
    /// StoreError.
    Session(const Context& context, Missing missing);

    /// With the rights of user(); of the local administrator all.
    [[nodiscard]] db::Store& store() { return *store_; }
    /// For what the program itself does once it is clear that it may: it simulates attempts again,
    /// and fills a store with a demonstration. In the name of user().
    [[nodiscard]] db::Store& program_store();
    /// nullopt: local administrator.
    [[nodiscard]] const std::optional<db::UserRecord>& user() const { return user_; }
    [[nodiscard]] const std::string& actor() const { return actor_; }
    /// Throws AccessError naming the role that could.
    void need(db::Action action, db::Scope scope) const;
    [[nodiscard]] bool may(db::Action action, db::Scope scope) const;
    /// The same about a person: own, in reach, or not.
    void need_for(db::Action action, int64_t subject) const;
    /// By login or number. Throws InputError, also where it is one person's login and another's
    /// number.
    [[nodiscard]] db::UserRecord find_user(const std::string& login_or_id);

 private:
    std::string url_;  ///< As it was opened; may hold a password.
    std::unique_ptr<db::Store> store_, program_store_;
    std::optional<db::UserRecord> user_;
    std::string actor_;
};

/// A refusal about what was typed, or an error of kind `also`, is bad input, not a failure of the
/// store: throws InputError instead.
template <class Work>
auto as_input(Work&& work, db::StoreError::Kind also = db::StoreError::Kind::kConflict) {
    try {
        return work();
    } catch (const db::StoreError& error) {
        if (error.kind() == db::StoreError::Kind::kRefused || error.kind() == also)
            throw InputError(error.what());
        throw;
    }
}

[[nodiscard]] std::string store_url_of(const Context& context);

/// The address to open, with the password of a server typed in where nothing else has it.
[[nodiscard]] std::string url_to_open(const Context& context);
[[nodiscard]] std::string url_to_open(const std::string& url);

/// Throws InputError when the address behind this option of the command line holds a password: `ps`
/// shows it to everybody on the computer.
void refuse_open_password(const std::string& option, const std::string& url);

/// Throws AccessError unless the store is embedded and its file, if it is there, belongs to whoever
/// runs the program. Returns the name for the audit trail.
std::string need_local_administrator(const std::string& url);

}  // namespace placode::cli
