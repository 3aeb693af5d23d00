// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Several programs at once, locks, migrations, and what only a server can do wrong.

#include <gmock/gmock.h>

#include "tests/store_cases.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// --- several programs, faults ------------------------------------------------------------------

TEST_P(StoreTest, FourThreadsWriteAtOnceAndNothingIsLost) {
    const int64_t user = open()->accounts().create(trainee("anna"));
    std::atomic<int> failures{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            try {
                const auto store = open(60000);
                for (int i = 0; i < 25; ++i) store->attempts().save(user, make_result());
            } catch (const StoreError& error) {
                ADD_FAILURE() << error.what();
                ++failures;
            }
        });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
    const auto store = open();
    EXPECT_EQ(store->attempts().list(user).size(), 100u);
    EXPECT_THAT(store->check(), IsEmpty()) << "the audit chain has no fork";
}

TEST_P(StoreTest, SeveralProgramsMayCreateTheStoreAtOnce) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            try {
                (void)open(60000)->accounts().list();
            } catch (const StoreError& error) {
                ADD_FAILURE() << error.what();
            }
        });
    for (auto& thread : threads) thread.join();
    EXPECT_THAT(open()->check(), IsEmpty());
}

TEST_P(StoreTest, ALockedStoreSaysSoAndLosesNothing) {
    const auto store = open(200);
    const int64_t user = store->accounts().create(trainee("anna"));
    RawConnection other = raw();
    ASSERT_TRUE(other.run(is_sqlite() ? "BEGIN EXCLUSIVE" : "BEGIN"));
    if (!is_sqlite()) {
        ASSERT_TRUE(other.run("LOCK TABLE attempts IN ACCESS EXCLUSIVE MODE"));
    }
    const auto error = failure_of([&] { store->attempts().save(user, make_result()); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kLocked);
    EXPECT_THAT(error.what(), HasSubstr("save an attempt in"));
    EXPECT_THAT(error.what(), HasSubstr("try again"));
    ASSERT_TRUE(other.run("COMMIT"));
    store->attempts().save(user, make_result());
    EXPECT_EQ(store->attempts().list(user).size(), 1u);
}

// --- migrations --------------------------------------------------------------------------------

TEST_P(StoreTest, AStoreOfANewerProgramIsRefused) {
    open()->accounts().create(trainee("anna"));
    ASSERT_TRUE(
        raw().run("INSERT INTO schema_migrations (name, checksum, applied_utc) VALUES "
                  "('9999_future.sql', 'x', 'y')"));
    const auto error = failure_of([&] { (void)open(); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kTooNew);
    EXPECT_THAT(error.what(), HasSubstr("9999_future.sql"));
    EXPECT_THAT(error.what(), HasSubstr("update Placode"));
}

TEST_P(StoreTest, AnOlderStoreIsBroughtUpToDateAndKeepsItsData) {
    const auto all = db::embedded_migrations();
    ASSERT_GE(all.size(), 4u);
    become_owner();
    open()->accounts().create(trainee("anna"));
    options.migrations = all;
    options.migrations.push_back(
        {"9001_test.sql",
         "-- A comment; with a semicolon.\nCREATE TABLE later (id {ID}, size_m {REAL}, number "
         "{INT64}, bytes {BLOB}) {STRICT};\n\n-- postgresql only\nCREATE TABLE only_postgresql (id "
         "{ID});\n\n-- sqlite only\nCREATE TABLE only_sqlite (id {ID});\n"});
    const auto store = open();
    EXPECT_EQ(store->accounts().list().size(), 1u);
    EXPECT_TRUE(raw().run("INSERT INTO later (size_m, number) VALUES (0.5, 9007199254740993)"));
    EXPECT_EQ(raw().value("SELECT number FROM later"), "9007199254740993");
    EXPECT_TRUE(
        raw().run(is_sqlite() ? "SELECT * FROM only_sqlite" : "SELECT * FROM only_postgresql"));
    if (!is_sqlite()) return;
    // A copy of the file as it was before.
    std::string copy;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().string().find(".before-update-") != std::string::npos)
            copy = entry.path().string();
    ASSERT_NE(copy, "");
    options.migrations.clear();
    EXPECT_EQ(db::open_store("sqlite:" + copy, options)->accounts().list().size(), 1u);
}

TEST_P(StoreTest, AnOlderStoreIsLeftAsItIsWhereThatIsAsked) {
    using db::UpdatePart;
    become_owner();
    open()->accounts().create(trainee("anna"));
    options.migrations = db::embedded_migrations();
    options.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID}) {STRICT};\n"});
    std::vector<UpdatePart> parts;
    std::string copy;
    options.updating = [&](const db::UpdateStep& step) {
        parts.push_back(step.part);
        if (!step.copy.empty()) copy = step.copy;
    };
    const auto kept = [this] {
        int found = 0;
        for (const auto& entry : fs::directory_iterator(folder.path()))
            if (entry.path().string().find(".before-update-") != std::string::npos) ++found;
        return found;
    };
    options.leave_older = true;
    EXPECT_EQ(failure_of([&] { (void)open(); }).kind(), StoreError::Kind::kOlder);
    EXPECT_FALSE(raw().run("SELECT * FROM later"));
    EXPECT_EQ(kept(), 0);
    EXPECT_TRUE(parts.empty());
    options.leave_older = false;
    EXPECT_EQ(open()->accounts().list().size(), 1u);
    EXPECT_TRUE(raw().run("SELECT * FROM later"));
    const std::vector<UpdatePart> of_a_file{UpdatePart::kCheck, UpdatePart::kCopy,
                                            UpdatePart::kTables};
    EXPECT_EQ(parts, is_sqlite() ? of_a_file : std::vector{UpdatePart::kTables});
    EXPECT_EQ(kept(), is_sqlite() ? 1 : 0);
    EXPECT_EQ(fs::exists(copy), is_sqlite()) << copy;
    // One that is up to date is opened, and nothing is told.
    options.leave_older = true;
    parts.clear();
    EXPECT_EQ(open()->accounts().list().size(), 1u);
    EXPECT_TRUE(parts.empty());
}

TEST_P(StoreTest, AMigrationThatFailsLeavesTheStoreAsItWas) {
    become_owner();
    open()->accounts().create(trainee("anna"));
    const auto good = options.migrations;
    options.migrations = db::embedded_migrations();
    options.migrations.push_back(
        {"9001_test.sql", "CREATE TABLE later (id {ID});\n\nINSERT INTO nowhere VALUES (1);\n"});
    (void)failure_of([&] { (void)open(); });
    EXPECT_FALSE(raw().run("SELECT * FROM later"));
    options.migrations = good;
    EXPECT_EQ(open()->accounts().list().size(), 1u);
}

TEST_P(StoreTest, AMigrationThatWasEditedAfterwardsIsRefused) {
    open()->accounts().create(trainee("anna"));
    options.migrations = db::embedded_migrations();
    options.migrations[1].text += "\n-- edited\n";
    const auto error = failure_of([&] { (void)open(); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kDamaged);
    EXPECT_THAT(error.what(), HasSubstr(options.migrations[1].name));
}

// --- only PostgreSQL ---------------------------------------------------------------------------

TEST(PostgresqlStore, AWrongPasswordIsNotRepeatedInTheMessage) {
    if (world->server().missing()) GTEST_SKIP() << world->server().problem();
    std::string url = world->server().url(world->server().new_database());
    url.replace(url.find(world->server().password()), world->server().password().size(), "secret1");
    const auto error = failure_of([&] { (void)db::open_store(url); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(error.what(), Not(HasSubstr("secret1")));
    EXPECT_THAT(error.what(), HasSubstr("user and password are right"));
}

TEST(PostgresqlStore, AServerThatCannotProveWhoItIsGetsNoPassword) {
    if (world->server().missing()) GTEST_SKIP() << world->server().problem();
    // This server has no certificate: what an impostor would have.
    const std::string url = world->server().url(world->server().new_database());
    const auto error = failure_of([&] { (void)db::open_store(url + "?sslmode=verify-full"); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(error.what(), HasSubstr("has to prove who it is"));
    EXPECT_THAT(error.what(), Not(HasSubstr(world->server().password())));
    EXPECT_THAT(db::open_store(url + "?sslmode=disable&timeout_ms=900")->accounts().list(),
                IsEmpty());
}

TEST(PostgresqlStore, APasswordFileIsEnough) {
    if (world->server().missing()) GTEST_SKIP() << world->server().problem();
    std::string url = world->server().url(world->server().new_database());
    const TemporaryFolder folder;
    std::ofstream(folder.file("pgpass")) << "*:*:*:placode:" << world->server().password() << "\n";
    fs::permissions(folder.file("pgpass"), fs::perms::owner_read | fs::perms::owner_write);
    url.erase(url.find(":" + world->server().password()), world->server().password().size() + 1);
    ::setenv("PGPASSFILE", folder.file("pgpass").c_str(), 1);
    EXPECT_THAT(db::open_store(url)->accounts().list(), IsEmpty());
    ::unsetenv("PGPASSFILE");
}

TEST(PostgresqlStore, AServerThatIsNotThereIsSaidSo) {
    const auto error =
        failure_of([] { (void)db::open_store("postgresql://a:b@127.0.0.1:1/placode"); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(error.what(), HasSubstr("127.0.0.1:1/placode"));
}

TEST(PostgresqlStore, ABrokenConnectionIsOpenedAgainByTheNextCall) {
    if (world->server().missing()) GTEST_SKIP() << world->server().problem();
    const std::string database = world->server().new_database();
    const auto store = db::open_store(world->server().url(database));
    EXPECT_THAT(store->accounts().list(), IsEmpty());
    RawConnection admin = world->server().connect("postgres");
    ASSERT_TRUE(
        admin.run("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE datname = '" +
                  database + "'"));
    EXPECT_EQ(failure_of([&] { (void)store->accounts().list(); }).kind(),
              StoreError::Kind::kUnavailable);
    EXPECT_THAT(store->accounts().list(), IsEmpty());
}

}  // namespace THIS_TEST
