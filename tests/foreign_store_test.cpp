// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a store may hold beside what Placode makes, where it is opened, backed up, restored, erased
// in or moved. Files that were made to do harm: hostile_files_test.

#include "db/foreign_store.h"

#include <gmock/gmock.h>

#include "db/erasure.h"
#include "db/packing.h"
#include "db/schema.h"
#include "db/sqlite_file.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

class ForeignStore : public testing::Test {
 protected:
    void SetUp() override {
        ASSERT_NE(world, nullptr);
        ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
        options.cheap_passwords = true;
    }
    [[nodiscard]] std::unique_ptr<db::Store> open() const { return db::open_store(url, options); }
    void begin() {
        db::NewUser boss = trainee("boss");
        boss.roles = static_cast<db::Roles>(db::Role::kAdministrator);
        const auto store = open();
        store->accounts().create(boss);
        anna = store->accounts().create(trainee("anna"));
    }
    static void run(const std::string& file, const std::string& sql) {
        RawConnection raw("QSQLITE", file);
        ASSERT_TRUE(raw.run(sql)) << raw.problem();
    }

    TemporaryFolder folder;
    const std::string path = folder.file("placode.db"), url = "sqlite:" + path,
                      copy = folder.file("copy.db");
    db::StoreOptions options;
    int64_t anna = 0;
};

const char* const kTrigger =
    "CREATE TRIGGER mine AFTER INSERT ON audit BEGIN UPDATE accounts SET roles = 15; END";

TEST_F(ForeignStore, OfEveryOlderProgramIsRestored) {
    const auto migrations = db::embedded_migrations();
    for (size_t known = 1; known <= migrations.size(); ++known) {
        SCOPED_TRACE(migrations[known - 1].name);
        fs::remove(copy);
        {
            RawConnection old("QSQLITE", copy);
            ASSERT_TRUE(old.run("BEGIN"));
            ASSERT_TRUE(old.run(db::kCreateRegister));
            for (size_t i = 0; i < known; ++i) {
                for (const auto& each : db::statements_of(migrations[i], db::Engine::kSqlite))
                    ASSERT_TRUE(old.run(each)) << old.problem();
                ASSERT_TRUE(old.run("INSERT INTO schema_migrations VALUES ('" + migrations[i].name +
                                    "', '" + db::checksum_hex(migrations[i].text) + "', '')"));
            }
            ASSERT_TRUE(old.run("COMMIT"));
            ASSERT_TRUE(
                old.run("PRAGMA application_id = " + std::to_string(db::kStoreApplicationId)));
        }
        EXPECT_EQ(db::copy_problem(copy), "");
        EXPECT_NO_THROW((void)db::restore_store(url, copy));
    }
}

TEST_F(ForeignStore, ThatSqliteHasAnalysedIsOneOfPlacodes) {
    begin();
    run(path, "ANALYZE");
    EXPECT_THAT(open()->check(), IsEmpty());
    EXPECT_NO_THROW(open()->backup(copy));
}

TEST_F(ForeignStore, OfANewerProgramIsToldAsNewer) {
    begin();
    db::StoreOptions newer = options;
    newer.migrations = db::embedded_migrations();
    newer.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID}) {STRICT};\n"});
    db::open_store(url, newer)->backup(copy);
    const auto error = failure_of([&] { (void)db::restore_store(url, copy); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kTooNew) << error.what();
    EXPECT_THAT(error.what(), AllOf(HasSubstr("9001_test.sql"), HasSubstr("update Placode")));
}

TEST_F(ForeignStore, WithATriggerIsNotOpened) {
    begin();
    run(path, kTrigger);
    const auto error = failure_of([&] { (void)open(); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kRefused) << error.what();
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("open " + url), HasSubstr("the trigger \"mine\" of the table "),
                      HasSubstr("have whoever put it there take it out")));
    run(path, "DROP TRIGGER mine");
    EXPECT_EQ(open()->accounts().list().size(), 2u);
}

TEST_F(ForeignStore, WithAnotherFormOfATableIsNotOpened) {
    begin();
    run(path, "ALTER TABLE accounts ADD COLUMN note TEXT AS (hex(password_hash))");
    EXPECT_THAT(failure_of([&] { (void)open(); }).what(), HasSubstr("the table \"accounts\""));
}

TEST_F(ForeignStore, OfACentreWithNotesOpensAndCheckNamesThem) {
    begin();
    run(path, "CREATE TABLE my_notes (id INTEGER PRIMARY KEY, note TEXT)");
    EXPECT_THAT(open()->check(), ElementsAre(AllOf(HasSubstr("the table \"my_notes\""),
                                                   HasSubstr("have it taken out"))));
    run(path, "DROP TABLE my_notes");
    run(path, "CREATE VIEW report AS SELECT COUNT(*) FROM accounts");
    EXPECT_THAT(open()->check(), ElementsAre(HasSubstr("the view \"report\"")));
    EXPECT_THAT(failure_of([&] { open()->backup(copy); }).what(), HasSubstr("the view \"report\""));
    EXPECT_FALSE(fs::exists(copy)) << "no backup that could not be restored";
}

TEST_F(ForeignStore, AViewAnswersInTheStoreForNobody) {
    begin();
    run(path, "CREATE VIEW report AS SELECT 1");
    db::Connection connection(db::parse_store_url(url));
    EXPECT_THAT(failure_of([&] { db::Statement(connection, "SELECT * FROM report").run(); }).what(),
                HasSubstr("report"));
}

TEST_F(ForeignStore, AmongTheCopiesIsNamedAndNotOpenedWhenAPersonIsErased) {
    begin();
    const auto store = open();
    store->backup(copy);
    run(copy, kTrigger);
    const std::string before = read_text(copy);
    const db::Erasure done = db::erase_person(*store, url, anna, false);
    ASSERT_EQ(done.left.size(), 1u);
    EXPECT_THAT(done.left[0].why, HasSubstr("the trigger \"mine\""));
    EXPECT_EQ(read_text(copy), before);
}

}  // namespace THIS_TEST
