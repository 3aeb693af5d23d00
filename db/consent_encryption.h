// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Encrypts the hand's lines under a consent: whoever has the store can add a signature but read
// none. The public key stands in the store as a published definition of kind `consent_seal` (the
// stored name, from libsodium's "sealed box"; nothing to do with db/seals.h), the secret one only
// in the study's participant key (db/participant_key.h), under its passphrase. Source: libsodium's
// crypto_box_seal (X25519, XSalsa20-Poly1305; an ephemeral key for each text).

#include <optional>
#include <string>

namespace placode::db {

/// Hexadecimal, 32 bytes each.
struct ConsentKeys {
    std::string public_key, secret_key;
};
[[nodiscard]] ConsentKeys make_consent_keys();

/// "sealed:" and hexadecimal digits. Throws StoreError kDamaged for a key that is none.
[[nodiscard]] std::string encrypted(const std::string& text, const std::string& public_key);
[[nodiscard]] bool is_encrypted(const std::string& text);
/// A text in clear is given back as it is; nothing when it was encrypted for another key.
[[nodiscard]] std::optional<std::string> decrypted(const std::string& text,
                                                   const ConsentKeys& pair);

/// The definition that a store keeps: `{"study": ID, "version": N, "public_key": HEX}`.
[[nodiscard]] std::string consent_key_json(const std::string& study_id, int version,
                                           const std::string& public_key);
struct ConsentKeyDefinition {
    std::string study_id, public_key;
    int version = 0;
};
/// Throws StoreError kDamaged.
[[nodiscard]] ConsentKeyDefinition consent_key_of(const std::string& json);

class Store;
/// Publishes the public half, when the store has another one or none. From then on signatures of
/// the study are encrypted when they are saved, and those that are there in clear at once.
void keep_consent_key(Store& store, const std::string& study_id, const std::string& public_key);

}  // namespace placode::db
