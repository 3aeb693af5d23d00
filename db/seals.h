// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Seals bind what the store says to its audit trail. An object (an attempt with all that hangs on
// it, an account, a participant's record ...) has one checksum over its rows; every change writes
// the new one into the entry of that change, and the entries are chained and signed
// (db/station.h). Store::check() computes all of them again: whoever edits, adds or removes a row
// without this program leaves an object that does not fit its last seal.
//
// A checksum holds an account's password hash with its random salt, so that a name cannot be
// guessed from it once the account was erased.

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace placode::db {

class Connection;

/// "attempt", {"12"}; "participant", {"fv1", "P-003"}.
struct SealedObject {
    std::string kind;
    std::vector<std::string> key;
    // clang-tidy 14 takes the 0 that it is compared with for a pointer. NOLINTNEXTLINE
    auto operator<=>(const SealedObject&) const = default;
    /// For people: "attempt 12", "participant fv1 P-003".
    [[nodiscard]] std::string name() const;
};

inline constexpr const char* kNoObject = "-";  ///< The seal of what is not there (any more).

/// BLAKE2b-256 over the object's rows in all its tables, hexadecimal; kNoObject without a row.
/// Throws std::logic_error for a kind that is none.
[[nodiscard]] std::string seal_of(Connection& connection, const SealedObject& object);

/// Of all objects there are, one pass over each table.
/// @param pace called before each row; may throw, to stop
[[nodiscard]] std::map<SealedObject, std::string> all_seals(Connection& connection,
                                                            const std::function<void()>& pace = {});

/// An object's seal before and after a change. Both, so that what somebody edited in between shows
/// even when the program changes the same object later.
struct SealChange {
    std::string before = kNoObject, after = kNoObject;
};
using SealChanges = std::map<SealedObject, SealChange>;
/// As an entry of the trail keeps them: a line each, and back. Lines that are none are left out.
[[nodiscard]] std::string seals_text(const SealChanges& changes);
[[nodiscard]] SealChanges seals_of_text(const std::string& text);

/// Tables and columns that are sealed, for the test that none is forgotten.
struct SealedTable {
    std::string table;
    std::vector<std::string> columns;
};
[[nodiscard]] std::vector<SealedTable> sealed_tables();

}  // namespace placode::db
