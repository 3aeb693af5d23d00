// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a store says that it could not do what was asked.

#include <cstdint>
#include <stdexcept>
#include <string>

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
        kMissing,  ///< A store that was here before is not here now.
        kOther
    };
    StoreError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] Kind kind() const noexcept { return kind_; }

 private:
    Kind kind_;
};

/// What says nothing about the data itself: the disk failed, or another program holds the file.
/// Nothing may be concluded from it that stays.
[[nodiscard]] inline bool may_pass(const StoreError& error) noexcept {
    return error.kind() == StoreError::Kind::kUnavailable ||
           error.kind() == StoreError::Kind::kLocked;
}

}  // namespace placode::db
