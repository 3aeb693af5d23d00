// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody can do with a station's log-in to the centre's server and SQL of their own. That
// the programs can do all that they must, the other tests of the store show: on a server they run
// with such a log-in.
#include "db/station_role.h"

#include <gmock/gmock.h>

#include "db/reading_store.h"
#include "tests/station_guard_attacks.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

namespace THIS_TEST {

// What an owner of the tables, or the role of a server that nobody has set up, could do.
constexpr std::array kAttacks{
    "UPDATE attempts SET points = 100",
    "UPDATE attempts SET verdict = 1, points = 100 WHERE id = 1",
    "UPDATE attempts SET account_id = account_id",
    "UPDATE attempt_metrics SET value = 0",
    "UPDATE attempt_reasons SET points = 0",
    "UPDATE attempt_scores SET points = 100",
    "UPDATE recordings SET content = ''",
    "UPDATE attempt_events SET time_s = 0",
    "UPDATE certificates SET code = 'X'",
    "UPDATE course_grants SET reason = ''",
    "UPDATE definitions SET content = '{}'",
    "DELETE FROM definitions",
    "UPDATE answer_items SET answer = '5'",
    "UPDATE participants SET code = 'P999-X'",
    "DELETE FROM participants",
    "UPDATE audit SET actor = 'somebody else'",
    "DELETE FROM audit",
    "INSERT INTO audit (id, at_utc, actor, action, object, detail, chain) VALUES (0, '', '', '', "
    "'', '', '')",
    "TRUNCATE audit",
    "TRUNCATE attempts CASCADE",
    "UPDATE trusted_centres SET public_key = ''",
    "UPDATE centre_key SET secret_key = ''",
    "DELETE FROM record_events",
    "INSERT INTO schema_migrations (name, checksum, applied_utc) VALUES ('9999.sql', '', '')",
    "ALTER TABLE audit DISABLE TRIGGER ALL",
    "ALTER TABLE attempts ADD COLUMN more TEXT",
    "DROP TRIGGER audit_is_never_changed ON audit",
    "DROP TABLE attempts CASCADE",
    "CREATE OR REPLACE FUNCTION audit_is_append_only() RETURNS trigger LANGUAGE plpgsql AS "
    "'BEGIN RETURN NULL; END'",
    "CREATE FUNCTION public.mine() RETURNS int LANGUAGE sql AS 'SELECT 1'",
    "CREATE TABLE public.mine (id INT)",
    "CREATE TEMPORARY TABLE attempts (id INT)",
    "CREATE VIEW public.mine AS SELECT 1",
    "CREATE SCHEMA mine",
    "CREATE EXTENSION dblink",
    "SET session_replication_role = replica",
    "SET ROLE placode",
    "SET SESSION AUTHORIZATION placode",
    "ALTER ROLE theatre SUPERUSER",
    "ALTER ROLE placode PASSWORD 'mine'",
    "CREATE ROLE mine SUPERUSER LOGIN",
    "GRANT placode TO theatre",
    "ALTER TABLE attempts OWNER TO theatre",
    "COPY audit TO '/tmp/trail'",
    "COPY attempts FROM PROGRAM 'id'",
    "SELECT pg_read_file('postgresql.conf')",
    "ALTER SYSTEM SET fsync = off",
    "DROP DATABASE postgres",
};

class StationRole : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        const auto store = open();
        person_ = store->accounts().create(trainee("anna"));
        attempt_ = store->attempts().save(person_, make_result());
    }
    [[nodiscard]] RawConnection at_the_station() const {
        return World::get().server().connect_station(database);
    }
    [[nodiscard]] std::unique_ptr<db::Store> owner(bool station = false) const {
        db::StoreOptions its = options;
        its.station = station;
        return db::open_store(World::get().server().url(database), its);
    }
    /// As `check` says about rows that somebody edited past the programs.
    [[nodiscard]] std::vector<std::string> seals() const {
        std::vector<std::string> found;
        for (const std::string& each : owner()->check())
            if (each.starts_with("seals:") || each.starts_with("audit:")) found.push_back(each);
        return found;
    }

    int64_t person_ = 0, attempt_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Server, StationRole, testing::Values("Postgresql"), engine_name);

TEST_P(StationRole, NoAttackBySqlGetsAnywhere) {
    EXPECT_GE(kAttacks.size(), 30u);
    for (const char* attack : kAttacks) {
        RawConnection station = at_the_station();  // Some leave a connection that does nothing.
        ASSERT_TRUE(station.is_open());
        EXPECT_FALSE(station.run(attack)) << attack;
        // Refused for want of rights, not because a name in it is wrong.
        EXPECT_THAT(station.problem(),
                    testing::AnyOf(HasSubstr("permission denied"), HasSubstr("must be owner"),
                                   HasSubstr("must be superuser"), HasSubstr("must have admin"),
                                   HasSubstr("append-only"), HasSubstr("must be able to")))
            << attack;
    }
    // PostgreSQL only warns where a grant gives nothing.
    RawConnection station = at_the_station();
    EXPECT_TRUE(station.run("GRANT UPDATE ON attempts TO theatre"));
    EXPECT_FALSE(station.run("UPDATE attempts SET points = 100"));
    EXPECT_THAT(seals(), IsEmpty());
    EXPECT_EQ(open()->attempts().detail(attempt_).record.points, make_result().score.points);
}

// A log-in of a program of the centre manages people without anybody signing in, and can do so by
// SQL as well. It shows. At a station where nobody has signed in the same gets nowhere.
TEST_P(StationRole, WhatItDoesPastTheProgramsShows) {
    const std::string person = std::to_string(person_), attempt = std::to_string(attempt_);
    size_t before = seals().size();
    EXPECT_EQ(before, 0u);
    for (const std::string& edit :
         {"UPDATE accounts SET roles = 15 WHERE id = " + person,
          "UPDATE attempts SET void_reason = 'by nobody' WHERE id = " + attempt,
          "UPDATE attempts SET void_meaning = '[]' WHERE id = " + attempt,
          std::string("INSERT INTO accounts (password_hash, roles, active, demonstration, "
                      "created_utc) VALUES ('', 15, 1, 0, '2026-01-01T00:00:00.000Z')"),
          "DELETE FROM attempt_events WHERE attempt_id = " + attempt +
              "; DELETE FROM recordings WHERE attempt_id = " + attempt}) {
        RawConnection station = at_the_station();
        EXPECT_FALSE(outcome_of(station, edit).got_anything()) << edit;
        RawConnection service = World::get().server().connect_service(database);
        ASSERT_TRUE(service.run(edit)) << edit << ": " << service.problem();
        const auto found = seals();
        EXPECT_THAT(found, Not(IsEmpty())) << edit;
        EXPECT_GE(found.size(), before) << edit;
        before = found.size();
    }
}

TEST_P(StationRole, APersonsProgramRefusesTheOwner) {
    const StoreError refused = failure_of([&] { (void)owner(true); });
    EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(refused.what(), HasSubstr("is superuser of the server"));
    EXPECT_THAT(refused.what(), HasSubstr("placode_station"));
    EXPECT_EQ(std::string(refused.what()).find(World::get().server().password()),
              std::string::npos);
    EXPECT_NO_THROW((void)owner());
    db::StoreOptions its = options;
    its.station = true;
    EXPECT_EQ(failure_of([&] {
                  (void)db::open_for_reading(World::get().server().url(database), person_, its);
              }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_NO_THROW((void)open_at_station());
    EXPECT_NO_THROW(
        (void)db::open_for_reading(World::get().server().station_url(database), person_, its));
    // Nor does it take a log-in whose word the server believes.
    const StoreError trusted = failure_of([&] { (void)db::open_store(url(), its); });
    EXPECT_EQ(trusted.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(trusted.what(), HasSubstr("is a service's"));
}

TEST_P(StationRole, SaysWhatALogInMayDoBeyond) {
    EXPECT_THAT(open_at_station()->role_problems(), IsEmpty());
    EXPECT_THAT(open()->role_problems(), SizeIs(1)) << "a service's log-in";
    EXPECT_THAT(owner()->role_problems(), Not(IsEmpty()));
    RawConnection admin = raw();
    ASSERT_TRUE(admin.run("GRANT UPDATE ON attempts TO theatre"));
    db::StoreOptions plain = options;
    plain.station = false;
    const auto problems =
        db::open_store(World::get().server().station_url(database), plain)->role_problems();
    EXPECT_THAT(problems, SizeIs(1));
    EXPECT_THAT(problems.front(), HasSubstr("may change scores"));
    // What was given by hand is taken back by the script for the group only: said until then.
    ASSERT_TRUE(admin.run("REVOKE UPDATE ON attempts FROM theatre"));
    EXPECT_THAT(open_at_station()->role_problems(), IsEmpty());
}

TEST_P(StoreTest, AFileHasNoLogIns) {
    EXPECT_THAT(open_at_station()->role_problems(), IsEmpty());
    EXPECT_EQ(failure_of([&] { open()->give_station_role(); }).kind(), StoreError::Kind::kRefused);
}

// New tables of an update are of use to stations at once.
TEST_P(StationRole, RightsFollowAnUpdate) {
    db::StoreOptions newer = options;
    newer.station = false;
    newer.migrations = db::embedded_migrations();
    newer.migrations.push_back({"9000_test.sql", "CREATE TABLE later (id {ID}, word TEXT)\n"});
    (void)db::open_store(World::get().server().url(database), newer);
    RawConnection station = at_the_station();
    EXPECT_TRUE(station.run("INSERT INTO later (word) VALUES ('new')")) << station.problem();
    EXPECT_EQ(station.value("SELECT word FROM later"), "new");
    EXPECT_FALSE(station.run("UPDATE later SET word = 'old'"));
}

TEST_P(StationRole, TheOwnerGivesTheRightsAgain) {
    RawConnection admin = raw();
    ASSERT_TRUE(admin.run("REVOKE ALL ON ALL TABLES IN SCHEMA public FROM placode_station"));
    EXPECT_FALSE(at_the_station().run("SELECT id FROM attempts"));
    owner()->give_station_role();
    EXPECT_TRUE(at_the_station().run("SELECT id FROM attempts"));
    const StoreError refused = failure_of([&] { open()->give_station_role(); });
    EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(refused.what(), HasSubstr("does not own the tables"));
}

// An update is the owner's: a station says so instead of failing halfway.
TEST_P(StationRole, AStationDoesNotUpdate) {
    db::StoreOptions newer = options;
    newer.migrations = db::embedded_migrations();
    newer.migrations.push_back({"9000_test.sql", "CREATE TABLE later (id {ID}, word TEXT)\n"});
    const StoreError refused = failure_of([&] { (void)db::open_store(url(), newer); });
    EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(refused.what(), HasSubstr("owner"));
    EXPECT_NO_THROW((void)open());
}

}  // namespace THIS_TEST
