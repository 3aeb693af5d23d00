// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A secret key under a passphrase, as one line of text. Argon2id makes a key from the passphrase
// (libsodium's "moderate" limits: 3 passes, 256 MiB), XSalsa20-Poly1305 (secretbox) hides and
// proves the content; salt and nonce are new with every sealing. Source: RFC 9106; Bernstein 2011.

#include <optional>
#include <string>
#include <string_view>

#include "db/said.h"
#include "db/secret.h"

namespace placode::db {

/// Whether seal_key() wrote this. A key in clear is 128 hexadecimal digits and nothing else.
[[nodiscard]] bool is_sealed_key(const std::string& kept);

/// What is wrong with a new passphrase in plain words, or nothing.
[[nodiscard]] std::optional<Said> passphrase_problem(std::string_view passphrase);

/// Throws StoreError(kUnavailable) when memory for Argon2id is missing.
/// @param cheap tests only: least work for Argon2id.
[[nodiscard]] std::string seal_key(std::string_view secret, std::string_view passphrase,
                                   bool cheap);

/// nullopt: the passphrase is wrong, or the text was changed. Throws StoreError: kDamaged for a
/// text that is no sealed key, kUnavailable when memory is missing.
[[nodiscard]] std::optional<Secret> open_key(const std::string& sealed,
                                             std::string_view passphrase);

}  // namespace placode::db
