// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a store says that it could not do what was asked.

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

namespace placode::sim {
class Said;
}

namespace placode::db {

using sim::Said;

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
        kMissing,  ///< A store that was here before is not here now.
        kOlder,    ///< Its tables are older than this program, which was not to update them.
        kOther
    };
    StoreError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    /// A refusal, or another trouble that a person can mend. @param before operation and place with
    /// what parts them from the sentence, "open sqlite:/x: ", or nothing.
    StoreError(Kind kind, const std::string& before, const Said& said);
    [[nodiscard]] Kind kind() const noexcept { return kind_; }
    /// What it says to people, without operation and place (db/said.h); nullptr where only what()
    /// is there: what an engine or a file says.
    [[nodiscard]] const Said* said() const noexcept { return said_.get(); }

 private:
    Kind kind_;
    std::shared_ptr<const Said> said_;  ///< Shared: the copy of an exception may not throw.
};

/// What says nothing about the data itself: the disk failed, or another program holds the file.
/// Nothing may be concluded from it that stays.
[[nodiscard]] inline bool may_pass(const StoreError& error) noexcept {
    return error.kind() == StoreError::Kind::kUnavailable ||
           error.kind() == StoreError::Kind::kLocked;
}

}  // namespace placode::db
