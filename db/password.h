// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Passwords: the rule, Argon2id, and how a login is compared. Libsodium's
// crypto_pwhash_str with its "interactive" limits (2 passes, 64 MiB); Source: RFC 9106.

#include <optional>
#include <string>

#include "db/said.h"

namespace placode::db {

inline constexpr int kLeastPasswordLength = 10;  ///< Characters.
inline constexpr int kMostNameLength = 200;      ///< Characters.

/// What is wrong with a password in plain words, or nothing.
[[nodiscard]] std::optional<Said> password_problem(const std::string& login,
                                                   const std::string& password);

/// Throws StoreError when memory for hashing is missing. @param cheap tests only.
[[nodiscard]] std::string hash_password(const std::string& password, bool cheap);
/// With the limits and salt of a hash that was made before, which stand at its begin up to the last
/// "$". Throws StoreError for limits that no program of ours would set.
[[nodiscard]] std::string hash_password_as(const std::string& prefix, const std::string& password);
[[nodiscard]] bool verify_password(const std::string& hash, const std::string& password);
/// True when the hash was made with other limits than today's.
[[nodiscard]] bool password_needs_rehash(const std::string& hash);

/// Random letters and digits without those that look alike, 4.9 bits each. Throws StoreError.
[[nodiscard]] std::string random_letters(int count);
/// For a first password: 16 of them.
[[nodiscard]] std::string new_password();

/// Starts libsodium once. Throws StoreError.
void need_sodium();

/// Key by which logins are compared: trimmed, compatibility-composed, without case.
[[nodiscard]] std::string login_key(const std::string& login);
/// That the name holds letters which are not seen, or nothing; it may be empty and of any length.
[[nodiscard]] std::optional<Said> hidden_letters_problem(const std::string& name);
/// What is wrong with the name of a person or a group, or nothing: where a name is shown there is
/// room for a line, and whoever pastes a book into the field means something else.
[[nodiscard]] std::optional<Said> name_problem(const std::string& name);
/// The same for a login, which must not read as the number of an account either.
[[nodiscard]] std::optional<Said> login_problem(const std::string& login);
/// Under which wrong passwords are counted: a checksum, because people type names that are gone, or
/// a password, into the field of the log-in. @param portal those that came through the portal.
[[nodiscard]] std::string failures_key(const std::string& login, bool portal = false);

}  // namespace placode::db
