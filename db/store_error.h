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

}  // namespace placode::db
