// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/sealed_key.h"

#include <sodium.h>

#include <QList>
#include <QString>
#include <array>
#include <sstream>
#include <vector>

#include "db/hex.h"
#include "db/participant_key.h"
#include "db/password.h"
#include "db/store_error.h"

namespace placode::db {
namespace {

constexpr const char* kSealedMark = "sealed-1 argon2id13 ";
/// What a text may ask for: a changed one must not exhaust the machine.
constexpr unsigned long long kMostPasses = 16, kMostMemoryBytes = 1024ULL * 1024 * 1024;
constexpr size_t kLongestSecret = 1024;

/// The parts of a sealed key, as they stand in its text.
struct SealedParts {
    unsigned long long passes = 0, memory_bytes = 0;
    std::array<unsigned char, crypto_pwhash_SALTBYTES> salt{};
    std::array<unsigned char, crypto_secretbox_NONCEBYTES> nonce{};
    std::vector<unsigned char> box;
};

/// The key of the box, overwritten when it goes.
class BoxKey {
 public:
    /// The same passphrase typed on another keyboard may arrive decomposed. RFC 8265.
    BoxKey(std::string_view passphrase, const SealedParts& parts) {
        std::string text =
            QString::fromUtf8(passphrase.data(), static_cast<qsizetype>(passphrase.size()))
                .normalized(QString::NormalizationForm_C)
                .toStdString();
        const int made = crypto_pwhash(
            bytes_.data(), bytes_.size(), text.data(), text.size(), parts.salt.data(), parts.passes,
            static_cast<size_t>(parts.memory_bytes), crypto_pwhash_ALG_ARGON2ID13);
        wipe(text);
        if (made != 0)
            throw StoreError(StoreError::Kind::kUnavailable,
                             "check the passphrase: " + std::to_string(parts.memory_bytes >> 20U) +
                                 " MiB of memory are not free; close other programs");
    }
    ~BoxKey() { sodium_memzero(bytes_.data(), bytes_.size()); }
    BoxKey(const BoxKey&) = delete;
    BoxKey& operator=(const BoxKey&) = delete;
    [[nodiscard]] const unsigned char* data() const { return bytes_.data(); }

 private:
    std::array<unsigned char, crypto_secretbox_KEYBYTES> bytes_{};
};

std::optional<SealedParts> read_parts(const std::string& sealed) {
    if (!is_sealed_key(sealed)) return std::nullopt;
    std::istringstream words(sealed.substr(std::string(kSealedMark).size()));
    SealedParts parts;
    std::string salt, nonce, box, more;
    if (!(words >> parts.passes >> parts.memory_bytes >> salt >> nonce >> box) || words >> more)
        return std::nullopt;
    parts.box.resize(box.size() / 2);
    const bool sound = parts.passes >= crypto_pwhash_OPSLIMIT_MIN && parts.passes <= kMostPasses &&
                       parts.memory_bytes >= crypto_pwhash_MEMLIMIT_MIN &&
                       parts.memory_bytes <= kMostMemoryBytes &&
                       parts.box.size() > crypto_secretbox_MACBYTES &&
                       parts.box.size() <= kLongestSecret && bytes_of_hex(salt, parts.salt) &&
                       bytes_of_hex(nonce, parts.nonce) && bytes_of_hex(box, parts.box);
    return sound ? std::optional(parts) : std::nullopt;
}

}  // namespace

bool is_sealed_key(const std::string& kept) { return kept.starts_with(kSealedMark); }

std::optional<Said> passphrase_problem(std::string_view passphrase) {
    if (QString::fromUtf8(passphrase.data(), static_cast<qsizetype>(passphrase.size()))
            .toUcs4()
            .size() >= kLeastPassphraseLength)
        return std::nullopt;
    return Said::that(
               "the passphrase is too short; expected at least %1 characters, four words are good")
        .with(kLeastPassphraseLength);
}

std::string seal_key(std::string_view secret, std::string_view passphrase, bool cheap) {
    need_sodium();
    SealedParts parts;
    parts.passes = cheap ? crypto_pwhash_OPSLIMIT_MIN : crypto_pwhash_OPSLIMIT_MODERATE;
    parts.memory_bytes = cheap ? crypto_pwhash_MEMLIMIT_MIN : crypto_pwhash_MEMLIMIT_MODERATE;
    randombytes_buf(parts.salt.data(), parts.salt.size());
    randombytes_buf(parts.nonce.data(), parts.nonce.size());
    parts.box.resize(secret.size() + crypto_secretbox_MACBYTES);
    const BoxKey key(passphrase, parts);
    crypto_secretbox_easy(parts.box.data(), reinterpret_cast<const unsigned char*>(secret.data()),
                          secret.size(), parts.nonce.data(), key.data());
    return kSealedMark + std::to_string(parts.passes) + " " + std::to_string(parts.memory_bytes) +
           " " + hex_of(parts.salt) + " " + hex_of(parts.nonce) + " " + hex_of(parts.box);
}

std::optional<Secret> open_key(const std::string& sealed, std::string_view passphrase) {
    need_sodium();
    const auto parts = read_parts(sealed);
    if (!parts)
        throw StoreError(StoreError::Kind::kDamaged,
                         "the sealed key is damaged; restore a backup, or make a new key with "
                         "`placodectl norms key renew`");
    const BoxKey key(passphrase, *parts);
    std::string plain(parts->box.size() - crypto_secretbox_MACBYTES, '\0');
    const bool opened = crypto_secretbox_open_easy(reinterpret_cast<unsigned char*>(plain.data()),
                                                   parts->box.data(), parts->box.size(),
                                                   parts->nonce.data(), key.data()) == 0;
    std::optional<Secret> secret;
    if (opened) secret.emplace(plain);
    wipe(plain);
    return secret;
}

}  // namespace placode::db
