// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/consent_encryption.h"

#include <sodium.h>

#include <QJsonDocument>
#include <QJsonObject>
#include <array>
#include <vector>

#include "db/hex.h"
#include "db/password.h"
#include "db/store.h"

namespace placode::db {
namespace {

constexpr std::string_view kMark = "sealed:";

using PublicKey = std::array<unsigned char, crypto_box_PUBLICKEYBYTES>;
using SecretKey = std::array<unsigned char, crypto_box_SECRETKEYBYTES>;

PublicKey need_public(const std::string& hex) {
    PublicKey key{};
    if (!bytes_of_hex(hex, key))
        throw StoreError(StoreError::Kind::kDamaged,
                         "seal of consents: \"" + hex + "\" is no public key of 64 digits");
    return key;
}

}  // namespace

ConsentKeys make_consent_keys() {
    need_sodium();
    PublicKey open{};
    SecretKey secret{};
    crypto_box_keypair(open.data(), secret.data());
    ConsentKeys pair{hex_of(open), hex_of(secret)};
    sodium_memzero(secret.data(), secret.size());
    return pair;
}

std::string encrypted(const std::string& text, const std::string& public_key) {
    need_sodium();
    const PublicKey key = need_public(public_key);
    std::vector<unsigned char> box(text.size() + crypto_box_SEALBYTES);
    crypto_box_seal(box.data(), reinterpret_cast<const unsigned char*>(text.data()), text.size(),
                    key.data());
    return std::string(kMark) + hex_of(box);
}

bool is_encrypted(const std::string& text) { return text.starts_with(kMark); }

std::optional<std::string> decrypted(const std::string& text, const ConsentKeys& pair) {
    if (!is_encrypted(text)) return text;
    need_sodium();
    const std::string_view digits = std::string_view(text).substr(kMark.size());
    std::vector<unsigned char> box(digits.size() / 2);
    PublicKey open{};
    SecretKey secret{};
    if (box.size() < crypto_box_SEALBYTES || !bytes_of_hex(digits, box) ||
        !bytes_of_hex(pair.public_key, open) || !bytes_of_hex(pair.secret_key, secret))
        return std::nullopt;
    std::string plain(box.size() - crypto_box_SEALBYTES, '\0');
    const int opened = crypto_box_seal_open(reinterpret_cast<unsigned char*>(plain.data()),
                                            box.data(), box.size(), open.data(), secret.data());
    sodium_memzero(secret.data(), secret.size());
    if (opened != 0) return std::nullopt;
    return plain;
}

std::string consent_key_json(const std::string& study_id, int version,
                             const std::string& public_key) {
    return QJsonDocument(QJsonObject{{"study", QString::fromStdString(study_id)},
                                     {"version", version},
                                     {"public_key", QString::fromStdString(public_key)}})
        .toJson(QJsonDocument::Compact)
        .toStdString();
}

ConsentKeyDefinition consent_key_of(const std::string& json) {
    const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
    ConsentKeyDefinition read{object["study"].toString().toStdString(),
                              object["public_key"].toString().toStdString(),
                              object["version"].toInt()};
    (void)need_public(read.public_key);
    return read;
}

void keep_consent_key(Store& store, const std::string& study_id, const std::string& public_key) {
    const auto newest = store.definitions().find("consent_seal", study_id);
    if (newest && consent_key_of(newest->json).public_key == public_key) return;
    DefinitionRecord definition;
    definition.kind = "consent_seal";
    definition.id = study_id;
    definition.version = newest ? newest->version + 1 : 1;
    definition.json = consent_key_json(study_id, definition.version, public_key);
    if (newest) definition.reason = "another participant key";
    store.definitions().publish(definition);
}

}  // namespace placode::db
