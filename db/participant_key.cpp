// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/participant_key.h"

#include <sodium.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <algorithm>
#include <array>

#include "db/participant.h"
#include "db/password.h"
#include "db/private_file.h"
#include "db/said.h"
#include "db/store_error.h"
#include "db/store_url.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr const char* kFormat = "placode participant key";
constexpr qint64 kLargestFile = qint64{64} << 20;
/// What a file may ask for: a changed one must not exhaust the machine.
constexpr quint64 kMostOps = 16, kMostMemory = 1024ULL * 1024 * 1024;

using SecretKey = std::array<unsigned char, crypto_secretbox_KEYBYTES>;

[[noreturn]] void fail(Kind kind, const std::string& path, const std::string& problem) {
    throw StoreError(kind, "participant key " + path + ": " + problem);
}
[[noreturn]] void fail(Kind kind, const std::string& path, const Said& said) {
    throw StoreError(kind, "participant key " + path + ": ", said);
}

QByteArray random_bytes(int count) {
    QByteArray bytes(count, '\0');
    randombytes_buf(bytes.data(), static_cast<size_t>(count));
    return bytes;
}

const unsigned char* raw(const QByteArray& bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.constData());
}

SecretKey derive(const std::string& path, const std::string& passphrase, const QByteArray& salt,
                 quint64 ops, quint64 memory) {
    SecretKey key{};
    if (crypto_pwhash(key.data(), key.size(), passphrase.data(), passphrase.size(), raw(salt), ops,
                      memory, crypto_pwhash_ALG_ARGON2ID13) != 0)
        fail(Kind::kUnavailable, path,
             "not enough memory to check the passphrase (" + std::to_string(memory >> 20U) +
                 " MiB); close other programs");
    return key;
}

void need_passphrase(const std::string& path, const std::string& passphrase) {
    if (QString::fromStdString(passphrase).size() < kLeastPassphraseLength)
        fail(
            Kind::kRefused, path,
            Said::that(
                "the passphrase is too short; expected at least %1 characters, four words are good")
                .with(kLeastPassphraseLength));
}

QByteArray field(const QJsonObject& json, const char* name) {
    return QByteArray::fromBase64(json[QLatin1String(name)].toString().toLatin1());
}

std::string text_of(const QJsonObject& json, const char* name) {
    return json[QLatin1String(name)].toString().toStdString();
}

}  // namespace

ParticipantKey::~ParticipantKey() {
    sodium_memzero(passphrase_.data(), passphrase_.size());
    sodium_memzero(consent_keys_.secret_key.data(), consent_keys_.secret_key.size());
    for (PersonEntry& entry : entries_)
        for (std::string* text : {&entry.name, &entry.contact, &entry.remark})
            sodium_memzero(text->data(), text->size());
}

ParticipantKey ParticipantKey::create(const std::string& path, const std::string& study_id,
                                      const std::string& passphrase, bool cheap) {
    need_sodium();
    need_passphrase(path, passphrase);
    if (QFileInfo::exists(QString::fromStdString(path)))
        fail(Kind::kConflict, path,
             Said::that("is there already; open it, or choose another place"));
    ParticipantKey key;
    key.path_ = path;
    key.study_id_ = study_id;
    key.passphrase_ = passphrase;
    key.cheap_ = cheap;
    key.consent_keys_ = make_consent_keys();
    QDir().mkpath(QFileInfo(QString::fromStdString(path)).absolutePath());
    key.save();
    return key;
}

ParticipantKey ParticipantKey::open(const std::string& path, const std::string& passphrase) {
    need_sodium();
    QFile file(QString::fromStdString(path));
    if (!file.exists())
        fail(Kind::kNotFound, path, Said::that("there is no such file; create the key first"));
    if (!file.open(QIODevice::ReadOnly))
        fail(Kind::kUnavailable, path, file.errorString().toStdString());
    if (file.size() > kLargestFile) fail(Kind::kDamaged, path, "is too large to be a key file");
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    const QByteArray salt = field(json, "salt"), nonce = field(json, "nonce"),
                     box = field(json, "box");
    const auto ops = static_cast<quint64>(json["opslimit"].toDouble());
    const auto memory = static_cast<quint64>(json["memlimit_bytes"].toDouble());
    if (text_of(json, "format") != kFormat || json["version"].toInt() != 1 ||
        salt.size() != crypto_pwhash_SALTBYTES || nonce.size() != crypto_secretbox_NONCEBYTES ||
        box.size() < static_cast<int>(crypto_secretbox_MACBYTES) ||
        ops < crypto_pwhash_OPSLIMIT_MIN || ops > kMostOps || memory < crypto_pwhash_MEMLIMIT_MIN ||
        memory > kMostMemory)
        fail(Kind::kDamaged, path,
             "is no key file of this program, or is damaged; restore it from its copy");
    SecretKey secret = derive(path, passphrase, salt, ops, memory);
    QByteArray plain(box.size() - static_cast<int>(crypto_secretbox_MACBYTES), '\0');
    const int opened = crypto_secretbox_open_easy(
        reinterpret_cast<unsigned char*>(plain.data()), raw(box),
        static_cast<unsigned long long>(box.size()), raw(nonce), secret.data());
    sodium_memzero(secret.data(), secret.size());
    if (opened != 0)
        fail(Kind::kRefused, path, Said::that("the passphrase is wrong, or the file was changed"));
    const QJsonObject content = QJsonDocument::fromJson(plain).object();
    sodium_memzero(plain.data(), static_cast<size_t>(plain.size()));
    ParticipantKey key;
    key.path_ = path;
    key.passphrase_ = passphrase;
    key.cheap_ = memory <= crypto_pwhash_MEMLIMIT_MIN;
    key.study_id_ = text_of(content, "study");
    for (const QJsonValue each : content["people"].toArray()) {
        const QJsonObject person = each.toObject();
        key.entries_.push_back({text_of(person, "code"), text_of(person, "name"),
                                text_of(person, "contact"), text_of(person, "remark"),
                                text_of(person, "added_utc")});
    }
    key.consent_keys_ = {text_of(content, "seal_public"), text_of(content, "seal_secret")};
    if (key.consent_keys_.secret_key.empty()) {
        key.consent_keys_ = make_consent_keys();
        key.save();
    }
    return key;
}

void ParticipantKey::save() const {
    QJsonArray people;
    for (const PersonEntry& each : entries_)
        people.append(QJsonObject{{"code", QString::fromStdString(each.code)},
                                  {"name", QString::fromStdString(each.name)},
                                  {"contact", QString::fromStdString(each.contact)},
                                  {"remark", QString::fromStdString(each.remark)},
                                  {"added_utc", QString::fromStdString(each.added_utc)}});
    const QByteArray plain =
        QJsonDocument(
            QJsonObject{{"study", QString::fromStdString(study_id_)},
                        {"people", people},
                        {"seal_public", QString::fromStdString(consent_keys_.public_key)},
                        {"seal_secret", QString::fromStdString(consent_keys_.secret_key)}})
            .toJson(QJsonDocument::Compact);
    const QByteArray salt = random_bytes(crypto_pwhash_SALTBYTES),
                     nonce = random_bytes(crypto_secretbox_NONCEBYTES);
    const quint64 ops = cheap_ ? crypto_pwhash_OPSLIMIT_MIN : crypto_pwhash_OPSLIMIT_MODERATE;
    const quint64 memory = cheap_ ? crypto_pwhash_MEMLIMIT_MIN : crypto_pwhash_MEMLIMIT_MODERATE;
    SecretKey secret = derive(path_, passphrase_, salt, ops, memory);
    QByteArray box(plain.size() + static_cast<int>(crypto_secretbox_MACBYTES), '\0');
    crypto_secretbox_easy(reinterpret_cast<unsigned char*>(box.data()), raw(plain),
                          static_cast<unsigned long long>(plain.size()), raw(nonce), secret.data());
    sodium_memzero(secret.data(), secret.size());
    const auto base64 = [](const QByteArray& bytes) { return QString(bytes.toBase64()); };
    const QJsonObject json{{"format", kFormat},
                           {"version", 1},
                           {"study", QString::fromStdString(study_id_)},
                           {"kdf", "argon2id13"},
                           {"opslimit", static_cast<double>(ops)},
                           {"memlimit_bytes", static_cast<double>(memory)},
                           {"cipher", "xsalsa20poly1305"},
                           {"salt", base64(salt)},
                           {"nonce", base64(nonce)},
                           {"box", base64(box)}};
    PrivateFile file(path_);
    if (!file.open(QIODevice::WriteOnly))
        fail(Kind::kUnavailable, path_, file.errorString().toStdString());
    file.write(QJsonDocument(json).toJson());
    if (!file.commit()) fail(Kind::kUnavailable, path_, file.errorString().toStdString());
}

void ParticipantKey::put(PersonEntry entry) {
    if (!valid_participant_code(entry.code))
        fail(Kind::kRefused, path_, Said::that("\"%1\" is no participant's code").with(entry.code));
    if (entry.name.empty()) fail(Kind::kRefused, path_, Said::that("the name is missing"));
    if (entry.added_utc.empty())
        entry.added_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    const auto before = entries_;
    const auto place =
        std::lower_bound(entries_.begin(), entries_.end(), entry,
                         [](const auto& a, const auto& b) { return a.code < b.code; });
    if (place != entries_.end() && place->code == entry.code)
        *place = std::move(entry);
    else
        entries_.insert(place, std::move(entry));
    try {
        save();
    } catch (...) {
        entries_ = before;
        throw;
    }
}

void ParticipantKey::remove(const std::string& code) {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const auto& each) { return each.code == code; });
    if (found == entries_.end()) fail(Kind::kNotFound, path_, code + " is not in it");
    entries_.erase(found);
    save();
}

void ParticipantKey::change_passphrase(const std::string& passphrase) {
    need_passphrase(path_, passphrase);
    passphrase_ = passphrase;
    save();
}

std::string default_key_path(const std::string& store_url, const std::string& study_id) {
    const StoreUrl url = parse_store_url(store_url);
    const QString folder =
        is_store_file(url) ? QFileInfo(QString::fromStdString(url.path)).absolutePath()
                           : QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return (folder + "/keys/" + QString::fromStdString(study_id) + ".placode-key").toStdString();
}

}  // namespace placode::db
