// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/password.h"

#include <sodium.h>

#include <QList>
#include <QString>
#include <array>
#include <regex>

#include "db/packing.h"
#include "db/store_error.h"
#include "sim/core/hidden_letters.h"

namespace placode::db {
namespace {

// Long enough for every passphrase, short enough that hashing cannot be made to read megabytes.
constexpr int kMostPasswordLength = 1000;

// The same password typed on another keyboard may arrive decomposed. RFC 8265, OpaqueString.
std::string composed(const std::string& password) {
    return QString::fromStdString(password).normalized(QString::NormalizationForm_C).toStdString();
}

// Whoever chose "3" or "user 3" would be taken for the account with that number: by commands, which
// take either, and in the trail, which keeps numbers only.
bool reads_as_number(const std::string& key) {
    static const std::regex form(R"((user )?[-+]?[0-9]+)");
    return std::regex_match(key, form);
}

}  // namespace

void need_sodium() {
    static const bool ready = sodium_init() >= 0;
    if (!ready)
        throw StoreError(StoreError::Kind::kUnavailable,
                         "start libsodium: no random numbers on this machine");
}

std::string random_letters(int count) {
    need_sodium();
    constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz23456789";
    std::string text;
    for (int i = 0; i < count; ++i)
        text += kLetters[randombytes_uniform(static_cast<uint32_t>(kLetters.size()))];
    return text;
}

std::string new_password() { return random_letters(16); }

std::string login_key(const std::string& login) {
    return QString::fromStdString(login)
        .trimmed()
        .normalized(QString::NormalizationForm_KC)
        .toCaseFolded()
        .toStdString();
}

std::optional<Said> hidden_letters_problem(const std::string& name) {
    if (!sim::has_hidden_letters(name)) return std::nullopt;
    return Said::that(
        "the name holds letters that are not seen, such as the end of a line; type it again");
}

std::optional<Said> name_problem(const std::string& name) {
    const QString text = QString::fromStdString(name);
    if (text.trimmed().isEmpty()) return Said::that("the name is empty");
    if (auto hidden = hidden_letters_problem(name)) return hidden;
    if (text.toUcs4().size() > kMostNameLength)
        return Said::that("the name is longer than %1 characters").with(kMostNameLength);
    return std::nullopt;
}

std::optional<Said> login_problem(const std::string& login) {
    const std::string key = login_key(login);
    if (key.empty()) return Said::that("the login is empty");
    if (reads_as_number(key))
        return Said::that("the login reads as the number of an account; put a letter before it");
    if (sim::has_hidden_letters(login))
        return Said::that("the login holds letters that are not seen; type it again");
    if (QString::fromStdString(login).toUcs4().size() > kMostNameLength)
        return Said::that("the login is longer than %1 characters").with(kMostNameLength);
    return std::nullopt;
}

std::string failures_key(const std::string& login, bool portal) {
    return checksum_hex(login_key(login)) + (portal ? " portal" : "");
}

std::optional<Said> password_problem(const std::string& login, const std::string& password) {
    const auto length = QString::fromStdString(password).toUcs4().size();
    if (length < kLeastPasswordLength)
        return Said::that("the length of the password is %1; it needs at least %2")
            .with(length)
            .with(kLeastPasswordLength);
    if (length > kMostPasswordLength)
        return Said::that("the password is longer than %1 characters").with(kMostPasswordLength);
    if (login_key(password) == login_key(login))
        return Said::that("the password is the login; choose another one");
    return std::nullopt;
}

std::string hash_password(const std::string& password, bool cheap) {
    need_sodium();
    const std::string text = composed(password);
    std::array<char, crypto_pwhash_STRBYTES> hash{};
    const auto passes = cheap ? crypto_pwhash_OPSLIMIT_MIN : crypto_pwhash_OPSLIMIT_INTERACTIVE;
    const auto memory = cheap ? crypto_pwhash_MEMLIMIT_MIN : crypto_pwhash_MEMLIMIT_INTERACTIVE;
    if (crypto_pwhash_str(hash.data(), text.data(), text.size(), passes, memory) != 0)
        throw StoreError(StoreError::Kind::kUnavailable,
                         "hash a password: 64 MiB of memory are not free; close other programs");
    return hash.data();
}

std::string hash_password_as(const std::string& prefix, const std::string& password) {
    need_sodium();
    const auto refuse = [] {
        throw StoreError(StoreError::Kind::kOther,
                         "sign in: the server asks for a password hash that is not Argon2id within "
                         "1 GiB and 10 passes; look at who set it up");
    };
    static const std::regex form(
        R"(\$argon2id\$v=19\$m=(\d{1,8}),t=(\d{1,3}),p=1\$([A-Za-z0-9+/]{22})\$)");
    std::smatch parts;
    if (!std::regex_match(prefix, parts, form)) refuse();
    // A server that is not what it seems does not make this computer work for hours.
    const size_t memory_kib = std::stoul(parts[1]), passes = std::stoul(parts[2]);
    std::array<unsigned char, crypto_pwhash_SALTBYTES> salt{};
    const std::string letters = parts[3];
    size_t read = 0;
    if (memory_kib > (size_t{1} << 20) || passes > 10 ||
        sodium_base642bin(salt.data(), salt.size(), letters.data(), letters.size(), nullptr, &read,
                          nullptr, sodium_base64_VARIANT_ORIGINAL_NO_PADDING) != 0 ||
        read != salt.size())
        refuse();
    const std::string text = composed(password);
    std::array<unsigned char, 32> raw{};
    if (crypto_pwhash(raw.data(), raw.size(), text.data(), text.size(), salt.data(), passes,
                      memory_kib * 1024, crypto_pwhash_ALG_ARGON2ID13) != 0)
        throw StoreError(StoreError::Kind::kUnavailable,
                         "hash a password: the memory for it is not free; close other programs");
    std::array<char, sodium_base64_ENCODED_LEN(32, sodium_base64_VARIANT_ORIGINAL_NO_PADDING)>
        end{};
    sodium_bin2base64(end.data(), end.size(), raw.data(), raw.size(),
                      sodium_base64_VARIANT_ORIGINAL_NO_PADDING);
    return prefix + end.data();
}

bool verify_password(const std::string& hash, const std::string& password) {
    need_sodium();
    const std::string text = composed(password);
    return crypto_pwhash_str_verify(hash.c_str(), text.data(), text.size()) == 0;
}

bool password_needs_rehash(const std::string& hash) {
    need_sodium();
    return crypto_pwhash_str_needs_rehash(hash.c_str(), crypto_pwhash_OPSLIMIT_INTERACTIVE,
                                          crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0;
}

}  // namespace placode::db
