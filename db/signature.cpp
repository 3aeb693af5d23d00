// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/signature.h"

#include <sodium.h>

#include <array>

#include "db/hex.h"
#include "db/packing.h"
#include "db/password.h"
#include "db/store_error.h"

namespace placode::db {
namespace {

const unsigned char* bytes_in(const std::string& text) {
    return reinterpret_cast<const unsigned char*>(text.data());
}

}  // namespace

KeyPair new_key_pair() {
    need_sodium();
    std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
    std::array<unsigned char, crypto_sign_SECRETKEYBYTES> secret{};
    crypto_sign_keypair(open.data(), secret.data());
    KeyPair pair{hex_of(open), hex_of(secret)};
    sodium_memzero(secret.data(), secret.size());
    return pair;
}

std::string sign_text(const std::string& text, std::string_view secret_key) {
    need_sodium();
    std::array<unsigned char, crypto_sign_SECRETKEYBYTES> secret{};
    if (!bytes_of_hex(secret_key, secret))
        throw StoreError(StoreError::Kind::kDamaged, "sign: the centre's key is damaged");
    std::array<unsigned char, crypto_sign_BYTES> signature{};
    crypto_sign_detached(signature.data(), nullptr, bytes_in(text), text.size(), secret.data());
    sodium_memzero(secret.data(), secret.size());
    return hex_of(signature);
}

bool signature_is_right(const std::string& text, const std::string& signature,
                        const std::string& public_key) {
    need_sodium();
    std::array<unsigned char, crypto_sign_BYTES> mark{};
    std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
    return bytes_of_hex(signature, mark) && bytes_of_hex(public_key, open) &&
           crypto_sign_verify_detached(mark.data(), bytes_in(text), text.size(), open.data()) == 0;
}

bool is_public_key(const std::string& text) {
    std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
    return bytes_of_hex(text, open);
}

std::string fingerprint(const std::string& public_key) {
    const std::string digits = checksum_hex(public_key).substr(0, 16);
    return digits.substr(0, 4) + " " + digits.substr(4, 4) + " " + digits.substr(8, 4) + " " +
           digits.substr(12, 4);
}

}  // namespace placode::db
