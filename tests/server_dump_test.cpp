// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A backup of a store on a server, by an owner of the tables who is no superuser, and the way back.
#include "db/server_dump.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <QProcess>

#include "db/trail_head.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

class ServerDump : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        (void)open();  // The group of the stations is there.
        const std::string password = World::get().server().password();
        RawConnection admin = raw();
        for (const std::string& each :
             {"DO $$ BEGIN IF NOT EXISTS (SELECT FROM pg_roles WHERE rolname = 'librarian') THEN "
              "CREATE ROLE librarian LOGIN PASSWORD '" +
                  password + "'; END IF; END $$",
              "DROP DATABASE IF EXISTS " + kOwn, "CREATE DATABASE " + kOwn + " OWNER librarian"})
            ASSERT_TRUE(admin.run(each)) << admin.problem();
        const auto store = db::open_store(as_owner(kOwn), options);
        person_ = store->accounts().create(trainee("anna"));
        (void)store->attempts().save(person_, make_result());
    }
    /// Owner of the tables, and otherwise nobody in particular.
    [[nodiscard]] static std::string as_owner(const std::string& of) {
        std::string url = World::get().server().url(of);
        return url.replace(url.find("placode:"), 8, "librarian:");
    }
    int restore(const std::string& dump, const std::string& into) const {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("PGPASSWORD", QString::fromStdString(World::get().server().password()));
        process.setProcessEnvironment(environment);
        const db::StoreUrl url = db::parse_store_url(as_owner(into));
        process.start("/usr/lib/postgresql/15/bin/pg_restore",
                      {"--exit-on-error", "--host=127.0.0.1", "--port=" + QString::number(url.port),
                       "--username=placode", "--dbname=" + QString::fromStdString(into),
                       QString::fromStdString(dump)});
        process.waitForFinished(-1);
        EXPECT_EQ(process.readAllStandardError().toStdString(), "");
        return process.exitCode();
    }
    const std::string kOwn = "librarians";
    int64_t person_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Server, ServerDump, testing::Values("Postgresql"), engine_name);

TEST_P(ServerDump, HoldsAllThatTheOwnerHasAndComesBack) {
    const std::string dump = folder.file("placode.dump");
    {
        // Who has signed in at this moment is nobody's to keep.
        const auto store = db::open_store(as_owner(kOwn), options);
        RawConnection behind("QPSQL", kOwn, db::parse_store_url(as_owner(kOwn)).port,
                             World::get().server().password());
        ASSERT_TRUE(behind.run("INSERT INTO placode_guard.sessions VALUES ('t', 1, now(), false)"));
        ASSERT_TRUE(behind.run("INSERT INTO placode_guard.confirmations VALUES (1, 1, now())"));
        store->backup(dump);
    }
    struct stat status {};
    ASSERT_EQ(::stat(dump.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600u);
    EXPECT_FALSE(fs::exists(dump + ".part"));
    const db::TrailHead head = db::read_trail_head(db::head_file_of(dump));
    EXPECT_GT(head.entry, 0);

    const std::string again = World::get().server().new_database("OWNER librarian");
    ASSERT_EQ(restore(dump, again), 0);
    {
        const auto store = db::open_store(as_owner(again), options);
        store->give_station_role();
        std::vector<std::string> problems = store->check();
        store->audit().check_head(head, problems);
        EXPECT_THAT(problems, IsEmpty());
        EXPECT_EQ(store->accounts().find(person_)->login, "anna");
        EXPECT_EQ(store->attempts().list(person_).size(), 1u);
    }
    RawConnection behind = World::get().server().connect(again);
    EXPECT_EQ(behind.value("SELECT COUNT(*) FROM placode_guard.sessions"), "0");
    EXPECT_EQ(behind.value("SELECT COUNT(*) FROM placode_guard.confirmations"), "0");
    // What is there is not written over.
    const StoreError twice =
        failure_of([&] { db::open_store(as_owner(kOwn), options)->backup(dump); });
    EXPECT_EQ(twice.kind(), StoreError::Kind::kConflict);
}

TEST_P(ServerDump, IsRefusedToWhoSeesLess) {
    const StoreError refused = failure_of([&] { open()->backup(folder.file("mine.dump")); });
    EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(refused.what(), HasSubstr("tables' owner, placode"));
    EXPECT_FALSE(fs::exists(folder.file("mine.dump")));
}

// Rows that security hides from the owner would be missing in the dump without a word.
TEST_P(ServerDump, IsNotMadeOfAStoreThatIsNotSound) {
    RawConnection behind("QPSQL", kOwn, db::parse_store_url(as_owner(kOwn)).port,
                         World::get().server().password());
    ASSERT_TRUE(behind.run("DROP POLICY owner_all ON persons"));
    const StoreError refused = failure_of(
        [&] { db::open_store(as_owner(kOwn), options)->backup(folder.file("half.dump")); });
    EXPECT_EQ(refused.kind(), StoreError::Kind::kDamaged) << refused.what();
    EXPECT_FALSE(fs::exists(folder.file("half.dump")));
}

}  // namespace THIS_TEST
