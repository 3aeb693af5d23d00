// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The key of the centre: made, opened, sealed, changed, renewed, taken to another store.

#include <QJsonDocument>
#include <QJsonObject>

#include "db/norms.h"
#include "db/password.h"
#include "db/sealed_key.h"
#include "db/signature.h"
#include "db/station_role.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

constexpr const char* kKeyFormat = "placode centre key";

/// Whether both halves are one key's.
bool is_pair(const std::string& public_key, std::string_view secret_key) {
    const std::string proof = "a key pair that fits";
    try {
        return signature_is_right(proof, sign_text(proof, secret_key), public_key);
    } catch (const StoreError&) {
        return false;
    }
}

}  // namespace

struct Norms::KeptKey {
    std::string centre, public_key, kept, made_utc;
    ~KeptKey() { wipe(kept); }
};

std::optional<Norms::KeptKey> Norms::kept_key() {
    Statement query(connection_, "SELECT centre, public_key, secret_key, made_utc FROM centre_key");
    if (!query.run().next()) return std::nullopt;
    return KeptKey{query.text(0), query.text(1), query.text(2), query.text(3)};
}

Norms::KeptKey Norms::need_key() {
    auto kept = kept_key();
    if (!kept)
        connection_.fail(Kind::kNotFound,
                         "the centre has no key yet; it is made with the first norm pack");
    return *kept;
}

Norms::KeptKey Norms::need_sealed_key() {
    KeptKey key = need_key();
    if (!is_sealed_key(key.kept))
        connection_.fail(Kind::kNotFound,
                         "the centre's key has no passphrase yet; `placodectl norms key seal` "
                         "gives it one");
    return key;
}

std::pair<Norms::KeptKey, Secret> Norms::fresh_key(const std::string& centre,
                                                   std::string_view passphrase) {
    KeyPair pair = new_key_pair();
    Secret secret(pair.secret_key);
    wipe(pair.secret_key);
    KeptKey key{centre, pair.public_key,
                seal_key(secret.text(), passphrase, context_.options.cheap_passwords), utc_now()};
    return {std::move(key), std::move(secret)};
}

void Norms::need_passphrase(std::string_view passphrase) {
    if (const auto problem = passphrase_problem(passphrase))
        connection_.fail(Kind::kRefused, *problem);
}

void Norms::need_owner_of_key() {
    if (!connection_.is_sqlite() && !owns_tables(connection_))
        connection_.fail(
            Kind::kRefused,
            Said::that(
                "on a server the centre's key is sealed and changed with the log-in of the tables' "
                "owner; let an administrator run `placodectl norms key seal` with it"));
}

OpenCentreKey Norms::opened(const KeptKey& kept, std::string_view passphrase) {
    auto secret = open_key(kept.kept, passphrase);
    if (!secret)
        connection_.fail(Kind::kRefused,
                         Said::that("the passphrase of the centre's key is wrong; try again"));
    if (!is_pair(kept.public_key, secret->text()))
        connection_.fail(Kind::kDamaged,
                         "the centre's key and its public half do not fit; restore a backup");
    return {kept.centre, kept.public_key, std::move(*secret)};
}

void Norms::need_readable(const KeptKey& key, std::string_view passphrase, const Secret& secret) {
    const KeptKey there = need_key();
    if (there.public_key != key.public_key ||
        opened(there, passphrase).secret_key.text() != secret.text())
        connection_.fail(Kind::kDamaged, "the sealed key cannot be read back");
}

void Norms::add_key(const KeptKey& key) {
    Statement(connection_,
              "INSERT INTO centre_key (id, centre, public_key, secret_key, made_utc) VALUES (1, ?, "
              "?, ?, ?)")
        .run(key.centre, key.public_key, key.kept, key.made_utc);
    context_.made("centre key", 1);
}

void Norms::replace_key(const KeptKey& key) {
    context_.touch("centre key", 1);
    Statement(connection_,
              "UPDATE centre_key SET centre = ?, public_key = ?, secret_key = ?, made_utc = ? "
              "WHERE id = 1")
        .run(key.centre, key.public_key, key.kept, key.made_utc);
}

void Norms::trust_own(const KeptKey& key) {
    Statement there(connection_, "SELECT centre FROM trusted_centres WHERE public_key = ?");
    if (there.run(key.public_key).next()) return;
    Statement(connection_,
              "INSERT INTO trusted_centres (public_key, centre, added_by, added_utc) VALUES (?, ?, "
              "?, ?)")
        .run(key.public_key, key.centre, context_.actor.name, utc_now());
    context_.made("centre", {key.public_key});
}

// The row is written over; its old bytes also lie in the log of a file, and in the old version of
// the row that a server keeps. What cannot be cleaned now goes when the last program closes the
// file, or when the server next vacuums.
void Norms::overwrite_clear_bytes() {
    try {
        connection_.execute(connection_.is_sqlite() ? "PRAGMA wal_checkpoint(TRUNCATE)"
                                                    : "VACUUM FULL centre_key");
    } catch (const StoreError&) {
        // Somebody reads just now. The key is sealed all the same.
    }
}

std::optional<CentreKey> Norms::centre_key() {
    connection_.begin_operation("look at the centre's key in");
    context_.need(Action::kUseStore);
    const auto kept = kept_key();
    if (!kept) return std::nullopt;
    return CentreKey{kept->centre, kept->public_key, kept->made_utc, is_sealed_key(kept->kept)};
}

OpenCentreKey Norms::open_centre_key(const std::string& centre, std::string_view passphrase) {
    connection_.begin_operation("open the centre's key in");
    context_.need(Action::kSetStandards);
    if (const auto kept = kept_key(); kept && is_sealed_key(kept->kept))
        return opened(*kept, passphrase);
    if (const auto kept = kept_key()) {
        seal_centre_key(passphrase);
        return opened(need_key(), passphrase);
    }
    if (centre.empty())
        connection_.fail(
            Kind::kRefused,
            Said::that("the centre has no name yet; give it with the first norm pack"));
    if (const auto problem = name_problem(centre)) connection_.fail(Kind::kRefused, *problem);
    need_passphrase(passphrase);
    const auto [key, secret] = fresh_key(centre, passphrase);
    UnitOfWork work(connection_);
    connection_.lock_table("centre_key");
    // Somebody else may have been quicker: that key is the centre's.
    if (const auto kept = kept_key()) return opened(*kept, passphrase);
    add_key(key);
    trust_own(key);
    context_.append_audit("norms.key", centre, fingerprint(key.public_key));
    need_readable(key, passphrase, secret);
    work.commit();
    return {key.centre, key.public_key, Secret(secret.text())};
}

void Norms::seal_centre_key(std::string_view passphrase) {
    connection_.begin_operation("seal the centre's key in");
    context_.need_any({Action::kSetStandards, Action::kBackup});
    need_passphrase(passphrase);
    {
        UnitOfWork work(connection_);
        connection_.lock_table("centre_key");
        KeptKey key = need_key();
        if (is_sealed_key(key.kept))
            connection_.fail(Kind::kConflict,
                             Said::as_is("the centre's key is sealed already; `placodectl norms "
                                         "key passphrase` changes its passphrase"));
        need_owner_of_key();
        const Secret secret(key.kept);
        if (!is_pair(key.public_key, secret.text()))
            connection_.fail(Kind::kDamaged,
                             "the centre's key and its public half do not fit; restore a backup");
        wipe(key.kept);
        key.kept = seal_key(secret.text(), passphrase, context_.options.cheap_passwords);
        replace_key(key);
        context_.append_audit("norms.key.seal", key.centre, fingerprint(key.public_key));
        need_readable(key, passphrase, secret);
        work.commit();
    }
    overwrite_clear_bytes();
}

void Norms::change_key_passphrase(std::string_view old_one, std::string_view new_one) {
    connection_.begin_operation("change the passphrase of the centre's key in");
    context_.need_any({Action::kSetStandards, Action::kBackup});
    need_passphrase(new_one);
    UnitOfWork work(connection_);
    connection_.lock_table("centre_key");
    KeptKey key = need_sealed_key();
    need_owner_of_key();
    const OpenCentreKey open = opened(key, old_one);
    key.kept = seal_key(open.secret_key.text(), new_one, context_.options.cheap_passwords);
    replace_key(key);
    context_.append_audit("norms.key.passphrase", key.centre, fingerprint(key.public_key));
    need_readable(key, new_one, open.secret_key);
    work.commit();
}

void Norms::renew_centre_key(std::string_view passphrase) {
    connection_.begin_operation("make a new key of the centre in");
    context_.need_any({Action::kSetStandards, Action::kBackup});
    need_passphrase(passphrase);
    {
        UnitOfWork work(connection_);
        connection_.lock_table("centre_key");
        const KeptKey old = need_key();
        need_owner_of_key();
        const auto [key, secret] = fresh_key(old.centre, passphrase);
        trust_own(old);  // Already, unless somebody took it out: its packs stay to be checked.
        replace_key(key);
        trust_own(key);
        context_.append_audit("norms.key.renew", key.centre,
                              fingerprint(key.public_key) + " for " + fingerprint(old.public_key));
        need_readable(key, passphrase, secret);
        work.commit();
    }
    overwrite_clear_bytes();
}

std::string Norms::exported_centre_key() {
    connection_.begin_operation("export the centre's key from");
    context_.need_any({Action::kSetStandards, Action::kBackup});
    const KeptKey key = need_sealed_key();
    const auto text = [](const std::string& each) { return QString::fromStdString(each); };
    return QJsonDocument(QJsonObject{{"format", kKeyFormat},
                                     {"version", 1},
                                     {"centre", text(key.centre)},
                                     {"public_key", text(key.public_key)},
                                     {"sealed_key", text(key.kept)},
                                     {"made_utc", text(key.made_utc)}})
        .toJson()
        .toStdString();
}

void Norms::take_centre_key(const std::string& text, std::string_view passphrase, bool replace) {
    connection_.begin_operation("take a centre's key into");
    context_.need_any({Action::kSetStandards, Action::kBackup});
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    const auto field = [&json](const char* name) {
        return json[QLatin1String(name)].toString().toStdString();
    };
    const KeptKey key{field("centre"), field("public_key"), field("sealed_key"), field("made_utc")};
    if (field("format") != kKeyFormat || json["version"].toInt() != 1 || key.centre.empty() ||
        !is_public_key(key.public_key) || !is_sealed_key(key.kept))
        connection_.fail(Kind::kDamaged,
                         "the file holds no centre's key; `placodectl norms key export` writes "
                         "one");
    if (const auto problem = name_problem(key.centre)) connection_.fail(Kind::kRefused, *problem);
    const OpenCentreKey open = opened(key, passphrase);
    UnitOfWork work(connection_);
    connection_.lock_table("centre_key");
    if (const auto old = kept_key()) {
        if (old->public_key == key.public_key)
            connection_.fail(Kind::kConflict, Said::as_is("it has this key already"));
        if (!replace)
            connection_.fail(
                Kind::kConflict,
                Said::as_is("it has the key " + fingerprint(old->public_key) +
                            " already; --replace puts the new one in its place, and the old "
                            "one can sign nothing any more: export that one first"));
        need_owner_of_key();
        trust_own(*old);
        replace_key(key);
    } else {
        add_key(key);
    }
    trust_own(key);
    context_.append_audit("norms.key.import", key.centre, fingerprint(key.public_key));
    need_readable(key, passphrase, open.secret_key);
    work.commit();
}

}  // namespace placode::db
