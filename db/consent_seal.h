// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Seals the hand's lines under a consent: whoever has the store can add a signature but read none.
// The public half stands in the store as a published definition of kind `consent_seal`, the secret
// half only in the study's participant key (db/participant_key.h), under its passphrase.
// Source: libsodium's crypto_box_seal (X25519, XSalsa20-Poly1305; an ephemeral key for each text).

#include <optional>
#include <string>

namespace placode::db {

/// Hexadecimal, 32 bytes each.
struct SealPair {
    std::string public_key, secret_key;
};
[[nodiscard]] SealPair make_seal_pair();

/// "sealed:" and hexadecimal digits. Throws StoreError kDamaged for a key that is none.
[[nodiscard]] std::string sealed(const std::string& text, const std::string& public_key);
[[nodiscard]] bool is_sealed(const std::string& text);
/// A text that is not sealed is given back as it is; nothing when it was sealed for another key.
[[nodiscard]] std::optional<std::string> unsealed(const std::string& text, const SealPair& pair);

/// The definition that a store keeps: `{"study": ID, "version": N, "public_key": HEX}`.
[[nodiscard]] std::string seal_json(const std::string& study_id, int version,
                                    const std::string& public_key);
struct SealDefinition {
    std::string study_id, public_key;
    int version = 0;
};
/// Throws StoreError kDamaged.
[[nodiscard]] SealDefinition seal_of(const std::string& json);

class Store;
/// Publishes the public half, when the store has another one or none. From then on signatures of
/// the study are sealed when they are saved; those that were there in clear are sealed at once.
void keep_seal(Store& store, const std::string& study_id, const std::string& public_key);

}  // namespace placode::db
