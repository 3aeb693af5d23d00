// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A store that was opened for reading shows what the account may see and changes nothing.

#include "db/reading_store.h"

#include <functional>
#include <vector>

#include "tests/rights_world.h"

namespace placode::test {

namespace THIS_TEST {

using Kind = db::StoreError::Kind;

class ReadingStoreTest : public StoreTest {
 protected:
    [[nodiscard]] std::unique_ptr<db::Store> read(int64_t account) const {
        return db::open_for_reading(url(), account, options);
    }
};

TEST_P(ReadingStoreTest, ShowsWhatTheAccountMaySeeAndNoMore) {
    const int64_t anna = open()->accounts().create(
        {"root", "Root", kPassword, static_cast<db::Roles>(db::Role::kAdministrator)});
    const int64_t jan = open()->accounts().create(trainee("jan"));
    EXPECT_EQ(read(anna)->accounts().list().size(), 2U);
    EXPECT_EQ(read(jan)->accounts().find(jan)->login, "jan");
    EXPECT_EQ(failure_of([&] { (void)read(jan)->accounts().list(); }).kind(), Kind::kRefused);
    EXPECT_EQ(failure_of([&] { (void)read(0)->accounts().find(jan); }).kind(), Kind::kRefused);
}

TEST_P(ReadingStoreTest, RefusesEveryChangeAndLeavesNoTrace) {
    RightsWorld people;
    people.fill(*open(), folder);
    const auto audit = [&] { return open()->audit().trail(100000).size(); };
    const size_t before = audit();
    const auto as = [&](const char* login) { return read(people.of.at(login).person); };
    const auto own = [&](const char* login) { return people.of.at(login); };
    // Each by somebody who may do it in a store that can be written.
    const std::vector<std::function<void()>> changes{
        [&] { as("administrator")->accounts().create(trainee("new")); },
        [&] { as("administrator")->accounts().set_active(own("trainee").person, false); },
        [&] { as("administrator")->groups().create("New"); },
        [&] { as("trainee")->accounts().set_password(own("trainee").person, "another one 123"); },
        [&] { as("trainee")->attempts().save(own("trainee").person, make_result()); },
        [&] {
            as("educator")
                ->reviews()
                .add_comment({0, own("grouped").attempt, own("educator").person, "", -1, "x", ""});
        },
        [&] { as("educator")->courses().end_assignment(own("grouped").assignment); },
        [&] { as("coordinator")->studies().new_participant(RightsWorld::kStudy); },
        [&] { as("coordinator")->records().lock(RightsWorld::kStudy, people.code); },
        [&] { (void)as("educator")->accounts().sign_in("trainee", kPassword); },
    };
    for (size_t i = 0; i < changes.size(); ++i) {
        // SQLite does not even begin to write.
        const std::string said = failure_of(changes[i]).what();
        EXPECT_NE(said.find(is_sqlite() ? "readonly database" : "for reading only"),
                  std::string::npos)
            << i << ": " << said;
    }
    EXPECT_EQ(audit(), before);
}

TEST_P(ReadingStoreTest, MakesNoStoreAndMigratesNone) {
    if (is_sqlite()) {
        EXPECT_EQ(failure_of([&] { (void)read(1); }).kind(), Kind::kMissing);
        EXPECT_FALSE(fs::exists(folder.file("placode.db")));
    }
    (void)open();
    EXPECT_NO_THROW((void)read(1));
    // A program that is newer than the tables; on a server the station's log-in makes none, too.
    options.migrations = db::embedded_migrations();
    options.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID})\n"});
    EXPECT_NE(std::string(failure_of([&] { (void)read(1); }).what()).find("older"),
              std::string::npos);
    EXPECT_FALSE(raw().run("SELECT id FROM later"));
    options.migrations.clear();
    EXPECT_NO_THROW((void)read(1));
}

INSTANTIATE_TEST_SUITE_P(Engines, ReadingStoreTest, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

}  // namespace THIS_TEST
}  // namespace placode::test
