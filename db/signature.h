// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ed25519 signatures of texts (libsodium). Keys and signatures are hexadecimal.

#include <string>
#include <string_view>

namespace placode::db {

struct KeyPair {
    std::string public_key, secret_key;
};
/// Throws StoreError when libsodium cannot start.
[[nodiscard]] KeyPair new_key_pair();

/// Detached signature over the bytes of `text`. Throws StoreError for a key that is none.
[[nodiscard]] std::string sign_text(const std::string& text, std::string_view secret_key);

/// False for everything that is not a right signature of exactly this text by this key.
[[nodiscard]] bool signature_is_right(const std::string& text, const std::string& signature,
                                      const std::string& public_key);

/// Whether the text can be one: as many hexadecimal digits.
[[nodiscard]] bool is_public_key(const std::string& text);

/// The first 16 digits in groups of four, to be read out over the telephone.
[[nodiscard]] std::string fingerprint(const std::string& public_key);

}  // namespace placode::db
