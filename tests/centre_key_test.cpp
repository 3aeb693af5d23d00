// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The centre's key: sealed from its first moment, or at its first use where an earlier version kept
// it in clear; changed, renewed, taken elsewhere; never lost on the way. On both engines.

#include <gmock/gmock.h>

#include "db/norm_bands.h"
#include "db/sealed_key.h"
#include "db/signature.h"
#include "db/store_context.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kOther = "quite another passphrase";

class CentreKey : public EngineTest {
 protected:
    void ready() override { store = open(); }
    /// From now on with the log-in that may change the key.
    void as_owner() {
        store.reset();
        become_owner();
        store = open();
    }
    /// As the version before kept a key: word for word what it wrote.
    db::KeyPair keep_in_clear() const {
        const db::KeyPair pair = db::new_key_pair();
        db::StoreContext context(db::parse_store_url(url()), options);
        db::UnitOfWork work(context.connection);
        db::Statement(context.connection,
                      "INSERT INTO centre_key (id, centre, public_key, secret_key, made_utc) "
                      "VALUES (1, ?, ?, ?, ?)")
            .run("A", pair.public_key, pair.secret_key, "2026-01-01T00:00:00Z");
        db::Statement(context.connection,
                      "INSERT INTO trusted_centres (public_key, centre, added_by, added_utc) "
                      "VALUES (?, ?, ?, ?)")
            .run(pair.public_key, "A", "ada", "2026-01-01T00:00:00Z");
        context.made("centre key", 1);
        context.made("centre", {pair.public_key});
        context.append_audit("norms.key", "A", db::fingerprint(pair.public_key));
        work.commit();
        return pair;
    }
    [[nodiscard]] std::string kept() const {
        return raw().value("SELECT secret_key FROM centre_key");
    }
    /// Files below the test's folder with these bytes in them.
    [[nodiscard]] std::vector<std::string> files_with(const std::string& bytes) const {
        std::vector<std::string> found;
        for (const auto& each : fs::recursive_directory_iterator(folder.path()))
            if (each.is_regular_file() &&
                read_text(each.path().string()).find(bytes) != std::string::npos)
                found.push_back(each.path().filename().string());
        return found;
    }
    [[nodiscard]] curriculum::SignedNorms signed_by(const db::OpenCentreKey& key) const {
        curriculum::SignedNorms norms;
        norms.content = R"({"schema": 1})";
        norms.signature = db::sign_text(norms.content, key.secret_key.text());
        norms.public_key = key.public_key;
        return norms;
    }
    [[nodiscard]] static bool is_right(const curriculum::SignedNorms& norms) {
        return db::signature_is_right(norms.content, norms.signature, norms.public_key);
    }

    std::unique_ptr<db::Store> store;
};

INSTANTIATE_TEST_SUITE_P(Engines, CentreKey, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(CentreKey, IsSealedFromItsFirstMoment) {
    EXPECT_FALSE(store->norms().centre_key());
    EXPECT_THAT(failure_of([&] { (void)store->norms().open_centre_key("", kPassphrase); }).what(),
                HasSubstr("the centre has no name yet"));
    EXPECT_THAT(failure_of([&] { (void)store->norms().open_centre_key("A", "short"); }).what(),
                HasSubstr("the passphrase is too short; expected at least 12 characters"));
    EXPECT_FALSE(store->norms().centre_key());
    EXPECT_THAT(
        failure_of([&] { (void)store->norms().open_centre_key("A\nB", kPassphrase); }).what(),
        HasSubstr("letters that are not seen"));
    const auto made = store->norms().open_centre_key("A", kPassphrase);
    EXPECT_EQ(store->norms().centre_key()->public_key, made.public_key);
    EXPECT_TRUE(store->norms().centre_key()->sealed);
    EXPECT_TRUE(db::is_sealed_key(kept()));
    EXPECT_THAT(kept(), Not(HasSubstr(std::string(made.secret_key.text().substr(0, 32)))));
    EXPECT_THAT(files_with(std::string(made.secret_key.text().substr(0, 32))), IsEmpty());
    EXPECT_THAT(files_with(kPassphrase), IsEmpty());
    // The same key again, and nobody else's passphrase opens it, however often it is tried.
    EXPECT_EQ(store->norms().open_centre_key("B", kPassphrase).secret_key.text(),
              made.secret_key.text());
    for (int i = 0; i < 8; ++i)
        EXPECT_THAT(failure_of([&] { (void)store->norms().open_centre_key("A", kOther); }).what(),
                    HasSubstr("the passphrase of the centre's key is wrong; try again"));
    EXPECT_TRUE(is_right(signed_by(store->norms().open_centre_key("", kPassphrase))));
}

TEST_P(CentreKey, ThatLiesInClearIsSealedAtItsFirstUse) {
    const db::KeyPair old = keep_in_clear();
    ASSERT_TRUE(store->norms().centre_key());
    EXPECT_FALSE(store->norms().centre_key()->sealed);
    EXPECT_THAT(store->check(), IsEmpty()) << "a store as it was is sound, and can be backed up";
    if (!is_sqlite()) {
        EXPECT_THAT(
            failure_of([&] { (void)store->norms().open_centre_key("A", kPassphrase); }).what(),
            HasSubstr("let an administrator run `placodectl norms key seal`"));
        EXPECT_EQ(kept(), old.secret_key) << "refused before anything was changed";
    } else {
        EXPECT_THAT(files_with(old.secret_key), Not(IsEmpty())) << "as it was until now";
    }
    as_owner();
    const auto opened = store->norms().open_centre_key("", kPassphrase);
    EXPECT_EQ(opened.public_key, old.public_key) << "packs from before stay this centre's";
    EXPECT_EQ(opened.secret_key.text(), old.secret_key);
    EXPECT_TRUE(store->norms().centre_key()->sealed);
    // Also not in the log of the open file.
    EXPECT_THAT(files_with(old.secret_key.substr(0, 32)), IsEmpty());
    EXPECT_EQ(store->audit().trail(1)[0].action, "norms.key.seal");
    EXPECT_THAT(store->check(), IsEmpty());
    EXPECT_EQ(failure_of([&] { store->norms().seal_centre_key(kPassphrase); }).kind(),
              StoreError::Kind::kConflict);
    if (!is_sqlite()) return;
    store->backup(folder.file("a.backup"));
    EXPECT_THAT(files_with(old.secret_key.substr(0, 32)), IsEmpty());
}

TEST_P(CentreKey, IsNotLostWhereSealingFails) {
    const db::KeyPair old = keep_in_clear();
    as_owner();
    EXPECT_THAT(failure_of([&] { store->norms().seal_centre_key("short"); }).what(),
                HasSubstr("too short"));
    EXPECT_EQ(kept(), old.secret_key);
    // What cannot be read back is not committed: here the other half is another key's.
    const db::KeyPair other = db::new_key_pair();
    RawConnection behind = raw();
    ASSERT_TRUE(behind.run("UPDATE centre_key SET public_key = '" + other.public_key + "'"));
    EXPECT_EQ(failure_of([&] { store->norms().seal_centre_key(kPassphrase); }).kind(),
              StoreError::Kind::kDamaged);
    EXPECT_EQ(kept(), old.secret_key);
    ASSERT_TRUE(behind.run("UPDATE centre_key SET public_key = '" + old.public_key + "'"));
    store->norms().seal_centre_key(kPassphrase);
    EXPECT_EQ(store->norms().open_centre_key("", kPassphrase).secret_key.text(), old.secret_key);
    // A text that somebody changed is no key, and says so.
    ASSERT_TRUE(behind.run("UPDATE centre_key SET secret_key = secret_key || '00'"));
    EXPECT_THAT(failure_of([&] { (void)store->norms().open_centre_key("", kPassphrase); }).what(),
                HasSubstr("is wrong"));
    ASSERT_TRUE(behind.run("UPDATE centre_key SET secret_key = 'sealed-1 argon2id13 99999 8'"));
    EXPECT_EQ(failure_of([&] { (void)store->norms().open_centre_key("", kPassphrase); }).kind(),
              StoreError::Kind::kDamaged);
}

TEST_P(CentreKey, GetsAnotherPassphrase) {
    EXPECT_EQ(failure_of([&] { store->norms().change_key_passphrase(kPassphrase, kOther); }).kind(),
              StoreError::Kind::kNotFound);
    const auto made = store->norms().open_centre_key("A", kPassphrase);
    if (!is_sqlite()) {
        EXPECT_EQ(
            failure_of([&] { store->norms().change_key_passphrase(kPassphrase, kOther); }).kind(),
            StoreError::Kind::kRefused);
    }
    as_owner();
    EXPECT_THAT(failure_of([&] { store->norms().change_key_passphrase(kOther, kOther); }).what(),
                HasSubstr("is wrong"));
    EXPECT_THAT(failure_of([&] { store->norms().change_key_passphrase(kPassphrase, "x"); }).what(),
                HasSubstr("too short"));
    store->norms().change_key_passphrase(kPassphrase, kOther);
    EXPECT_EQ(failure_of([&] { (void)store->norms().open_centre_key("", kPassphrase); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(store->norms().open_centre_key("", kOther).secret_key.text(), made.secret_key.text());
}

TEST_P(CentreKey, IsReplacedAndWhatItSignedStaysRight) {
    const auto old = store->norms().open_centre_key("A", kPassphrase);
    const auto before = signed_by(old);
    as_owner();
    store->norms().renew_centre_key(kOther);
    const auto now = store->norms().open_centre_key("", kOther);
    EXPECT_NE(now.public_key, old.public_key);
    EXPECT_EQ(now.centre, "A");
    EXPECT_TRUE(is_right(before));
    EXPECT_TRUE(is_right(signed_by(now)));
    const auto trusted = store->norms().trusted_centres();
    EXPECT_EQ(trusted.size(), 2u);
    EXPECT_TRUE(trusted.contains(old.public_key) && trusted.contains(now.public_key));
    EXPECT_EQ(failure_of([&] { (void)store->norms().open_centre_key("", kPassphrase); }).kind(),
              StoreError::Kind::kRefused);
}

TEST_P(CentreKey, GoesToAnotherStoreSealed) {
    const auto made = store->norms().open_centre_key("A", kPassphrase);
    const std::string file = store->norms().exported_centre_key();
    EXPECT_THAT(file, Not(HasSubstr(std::string(made.secret_key.text().substr(0, 32)))));
    const auto there = db::open_store("sqlite:" + folder.file("there.db"), options);
    EXPECT_EQ(failure_of([&] { there->norms().take_centre_key("{}", kPassphrase, false); }).kind(),
              StoreError::Kind::kDamaged);
    EXPECT_EQ(failure_of([&] { there->norms().take_centre_key(file, kOther, false); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_FALSE(there->norms().centre_key());
    there->norms().take_centre_key(file, kPassphrase, false);
    EXPECT_EQ(there->norms().open_centre_key("", kPassphrase).secret_key.text(),
              made.secret_key.text());
    EXPECT_EQ(failure_of([&] { there->norms().take_centre_key(file, kPassphrase, true); }).kind(),
              StoreError::Kind::kConflict);
    // Another key in its place only when that is said.
    there->norms().renew_centre_key(kOther);
    EXPECT_THAT(
        failure_of([&] { there->norms().take_centre_key(file, kPassphrase, false); }).what(),
        HasSubstr("--replace"));
    there->norms().take_centre_key(file, kPassphrase, true);
    EXPECT_EQ(there->norms().open_centre_key("", kPassphrase).public_key, made.public_key);
    EXPECT_EQ(there->norms().trusted_centres().size(), 2u);
    EXPECT_THAT(there->check(), IsEmpty());
}

}  // namespace THIS_TEST
