// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A store that goes from a file to a server and back is the same store; work goes on in the new
// place, and the old one is closed.

#include "db/store_move.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "db/erasure.h"
#include "db/reading_store.h"
#include "db/signature.h"
#include "sim/core/random.h"
#include "tests/moving_store.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

namespace THIS_TEST {

// --- every table -------------------------------------------------------------------------------

class StoreTables : public EngineTest {
 protected:
    [[nodiscard]] bool at_station() const override { return false; }
    void TearDown() override {}  // With tables that no other program knows.
};

INSTANTIATE_TEST_SUITE_P(Engines, StoreTables, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(StoreTables, AreAllThatTheDatabaseHas) {
    (void)open();
    db::Connection connection(db::parse_store_url(url()));
    std::set<std::string> there{db::kMigrationsTable};
    for (const auto& table : db::store_tables(connection, options)) there.insert(table.name);
    const auto names = db::names_of_tables(connection);
    EXPECT_EQ(there, (std::set<std::string>(names.begin(), names.end())));
    EXPECT_GT(there.size(), 40u);
}

TEST_P(StoreTables, OfALaterMigrationAreAmongThem) {
    options.migrations = db::embedded_migrations();
    options.migrations.push_back(
        {"9001_test.sql",
         "-- A comment.\nCREATE TABLE later (\n    id {ID},\n    bytes {BLOB}\n) {STRICT};\n\n"
         "DROP TABLE study_allocations;\n"});
    (void)open();
    db::Connection connection(db::parse_store_url(url()));
    const auto tables = db::store_tables(connection, options);
    EXPECT_EQ(tables.back().name, "later");
    EXPECT_TRUE(tables.back().has_counter);
    EXPECT_TRUE(tables.back().has_bytes);
    for (const auto& table : tables) EXPECT_NE(table.name, "study_allocations");
}

TEST_P(StoreTables, OfSomebodyElseAreRefusedByName) {
    (void)open();
    ASSERT_TRUE(raw().run("CREATE TABLE my_notes (id INTEGER PRIMARY KEY)"));
    db::Connection connection(db::parse_store_url(url()));
    EXPECT_THAT(failure_of([&] { (void)db::store_tables(connection, options); }).what(),
                HasSubstr("my_notes"));
}

// --- there and back ----------------------------------------------------------------------------

TEST_F(MoveTest, ThereAndBackEveryRowIsTheSame) {
    fill(file);
    const AllRows before = rows(file);
    for (const auto& [table, rows] : before) {
        const bool needs_more = table == "certificates";  // Of a course that is mastered.
        EXPECT_TRUE(needs_more || !rows.empty()) << table << " is empty: fill it";
    }
    const db::MoveReport there = move(file, server);
    EXPECT_FALSE(there.went_on);
    EXPECT_GT(there.rows, 100);
    EXPECT_GT(there.recording_bytes, 1000);
    expect_same(before, rows(server), 1);
    expect_sound(server);
    const std::string back = "sqlite:" + folder.file("back/placode.db");
    (void)move(server, back);
    expect_same(before, rows(back), 2);
    expect_sound(back);
    EXPECT_FALSE(fs::exists(folder.file("back/placode.db.moving")));
    const auto trail = open(back)->audit().trail(2);
    EXPECT_EQ(trail[0].action, "store.move");
    EXPECT_EQ(trail[0].object, back);
    EXPECT_THAT(trail[0].detail, AllOf(HasSubstr("from postgresql://placode@127.0.0.1:"),
                                       Not(HasSubstr(World::get().server().password()))));
    EXPECT_EQ(trail[1].detail, "from " + file);
}

TEST_F(MoveTest, BackInItsOldPlaceTheOldFileIsKept) {
    fill(file);
    (void)move(file, server);
    open(server)->accounts().create(trainee("later"));
    const AllRows before = rows(server);
    const db::MoveReport back = move(server, file);
    ASSERT_TRUE(fs::exists(back.old_file)) << back.old_file;
    EXPECT_THAT(back.old_file, HasSubstr("placode.db.moved-2"));
    expect_same(before, rows(file), 1);
    expect_sound(file);
    // And once more away: the database still holds what was left there.
    const auto error = failure_of([&] { (void)move(file, server); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kConflict);
    EXPECT_THAT(error.what(), HasSubstr("still this store as it was when it moved away"));
    (void)move(file, World::get().server().url(World::get().server().new_database()));
}

TEST_F(MoveTest, WorkGoesOnInTheNewPlace) {
    fill(file);
    int64_t last = 0;
    {
        // The newest attempt is gone, and its number is not given out again.
        const auto store = open(file);
        const int64_t gone = store->accounts().create(trainee("gone"));
        last = store->attempts().save(gone, make_result());
        store->accounts().erase(gone, true);
    }
    std::string to = server;
    for (const std::string& from : {file, server}) {
        (void)move(from, to);
        const auto store = open(to);
        EXPECT_EQ(open(to)->accounts().sign_in("bert", kPassword).outcome, db::SignInOutcome::kOk);
        const int64_t made = store->accounts().create(trainee("after" + std::to_string(last)));
        db::AttemptResult result = make_result();
        fs::remove(folder.file("new.placode"));
        write_recording(folder.file("new.placode"), 1);
        result.recording_file = folder.file("new.placode");
        const int64_t attempt = store->attempts().save(made, result);
        EXPECT_EQ(attempt, last + 1) << "in " << to;
        last = attempt;
        store->groups().create("Group " + std::to_string(attempt));
        for (const auto& station : store->audit().stations()) EXPECT_TRUE(station.trusted);
        expect_sound(to);
        to = "sqlite:" + folder.file("back.db");
    }
}

TEST_F(MoveTest, StationsAndWhomTheyTrustGoWithIt) {
    fill(file);
    const std::string other = db::new_key_pair().public_key;
    open(file)->audit().trust_station(other);
    // The group for stations is there before, as a centre's server is set up.
    PostgresqlServer& here = World::get().server();
    const std::string before = here.new_database();
    (void)open(here.url(before));
    here.make_station(before);
    (void)move(file, server);
    const auto error = failure_of([&] { open(server)->audit().trust_station(other); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kConflict) << "it is trusted already";
    // A station's log-in may work with the tables that the move has made.
    db::StoreOptions station = options;
    station.station = true;
    const auto store = db::open_store(World::get().server().station_url(database), station);
    EXPECT_THAT(failure_of([&] { store->accounts().create(trainee("by_a_station")); }).what(),
                HasSubstr("you may not do this on the server"));
    const int64_t person = open(server)->accounts().create(trainee("at_a_station"));
    ASSERT_EQ(store->accounts().sign_in("at_a_station", kPassword).outcome, db::SignInOutcome::kOk);
    store->act_for(person);
    db::AttemptResult attempt = make_result();
    (void)store->attempts().save(person, attempt);
    EXPECT_THAT(open(server)->check(), IsEmpty());
}

// --- the old place -----------------------------------------------------------------------------

TEST_F(MoveTest, TheOldPlaceRefusesAndNamesTheNewOne) {
    fill(file);
    const auto open_already = open(file);
    const std::string back = "sqlite:" + folder.file("back.db");
    for (const auto& [from, to] : {std::pair(file, server), std::pair(server, back)}) {
        const auto writer = from == file ? nullptr : open(from);
        (void)move(from, to);
        const auto error = failure_of([&, from = from] { (void)open(from); });
        EXPECT_EQ(error.kind(), StoreError::Kind::kRefused);
        const std::string place = to == server ? "postgresql://placode@127.0.0.1:" : to;
        EXPECT_THAT(
            error.what(),
            AllOf(HasSubstr("the store was moved to " + place),
                  HasSubstr("bring it back with `placodectl --store " + place),
                  HasSubstr("store move --to"), Not(HasSubstr(World::get().server().password()))));
        EXPECT_EQ(failure_of([&, from = from] {
                      (void)db::open_for_reading(from, full.bert, options);
                  }).kind(),
                  StoreError::Kind::kRefused);
        // A program that has it open is refused by the engine.
        db::Store& still = writer ? *writer : *open_already;
        const auto refused = failure_of([&] { still.accounts().create(trainee("late")); });
        EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused);
        EXPECT_THAT(refused.what(), HasSubstr("the store was moved to " + place));
        // The engine has only text; what it means goes along, to be said in any language.
        ASSERT_NE(refused.said(), nullptr);
        EXPECT_THAT(refused.said()->in("pl", [](const char*) { return std::string("do %1: %2"); }),
                    AllOf(StartsWith("do " + place), HasSubstr(": placodectl --store " + place)));
        // Whatever it wants to write, and by whatever way.
        db::Connection behind(db::parse_store_url(from));
        for (const std::string& table : db::names_of_tables(behind))
            EXPECT_FALSE(raw(from).run("DELETE FROM " + table) && !rows(from)[table].empty())
                << table;
    }
}

TEST_F(MoveTest, AnErasureNamesThePlacesThatTheStoreHasLeft) {
    fill(file);
    (void)move(file, server);
    const db::Erasure there = db::erase_person(*open(server), server, full.anna, true);
    ASSERT_EQ(there.left.size(), 1u);
    EXPECT_EQ(there.left[0].path, file);
    const std::string kept = move(server, file).old_file;
    const int64_t later = open(file)->accounts().create(trainee("later"));
    std::set<std::string> left;
    for (const auto& each : db::erase_person(*open(file), file, later, true).left)
        left.insert(each.path);
    ASSERT_EQ(left.size(), 2u);
    EXPECT_TRUE(left.contains(kept));
    EXPECT_THAT(*left.rbegin(), HasSubstr("postgresql://"));
}

// --- places that are not free ------------------------------------------------------------------

TEST_F(MoveTest, AServerThatHoldsSomethingElseIsRefusedByName) {
    fill(file);
    const auto refused = [&](const std::string& database_url) {
        const auto error = failure_of([&] { (void)move(file, database_url); });
        EXPECT_EQ(error.kind(), StoreError::Kind::kConflict) << error.what();
        EXPECT_TRUE(open(file)->check().empty());
        return std::string(error.what());
    };
    PostgresqlServer& here = World::get().server();
    const std::string other = here.url(here.new_database());
    open(other)->accounts().create(trainee("somebody"));
    EXPECT_THAT(refused(other),
                AllOf(HasSubstr("there is another store, begun on 20"),
                      HasSubstr("with 1 account;"), HasSubstr("give an empty database")));
    const std::string foreign = here.new_database();
    ASSERT_TRUE(here.connect(foreign).run("CREATE TABLE invoices (id INTEGER)"));
    EXPECT_THAT(refused(here.url(foreign)), HasSubstr("another program's tables"));
    // An unfinished move of another store.
    const std::string half = here.url(here.new_database());
    const std::string second = "sqlite:" + folder.file("second.db");
    open(second)->accounts().create(trainee("second"));
    db::MoveOptions stop;
    stop.progress = [](const db::MoveProgress& at) {
        return at.step != db::MoveProgress::Step::kCopy;
    };
    EXPECT_TRUE(open(second)->move_to(half, stop).stopped);
    EXPECT_THAT(refused(half),
                AllOf(HasSubstr("unfinished move of another store"), HasSubstr("second.db")));
    EXPECT_THAT(failure_of([&] { (void)open(half); }).what(),
                AllOf(HasSubstr("is being moved here from"), HasSubstr("second.db")));
    // Tables that `station role --apply` made are free.
    const std::string prepared = here.url(here.new_database());
    (void)open(prepared);
    (void)move(file, prepared);
    expect_sound(prepared);
}

TEST_F(MoveTest, AFileThatIsAnotherStoreIsRefusedByName) {
    fill(server);
    const std::string other = "sqlite:" + folder.file("other.db");
    open(other)->accounts().create(trainee("somebody"));
    const AllRows before = rows(other);
    EXPECT_THAT(
        failure_of([&] { (void)move(server, other); }).what(),
        AllOf(HasSubstr("there is another store, begun on 20"), HasSubstr("give another place")));
    EXPECT_EQ(rows(other), before);
    std::ofstream(folder.file("letter.db")) << "Dear colleague";
    EXPECT_THAT(
        failure_of([&] { (void)move(server, "sqlite:" + folder.file("letter.db")); }).what(),
        HasSubstr("another program's file"));
    EXPECT_EQ(read_text(folder.file("letter.db")), "Dear colleague");
}

TEST_F(MoveTest, WhatCannotMoveSaysWhy) {
    const auto said = [&](const std::string& from, const std::string& to) {
        return std::string(failure_of([&] { (void)move(from, to); }).what());
    };
    EXPECT_THAT(said(file, server), HasSubstr("there is nothing in it yet"));
    fill(file);
    EXPECT_THAT(said(file, "sqlite:" + folder.file("b.db")), HasSubstr("placodectl backup"));
    (void)open(server);
    World::get().server().make_station(database);
    EXPECT_THAT(said(file, World::get().server().station_url(database)),
                HasSubstr("use their owner's"));
    const auto trainee_store = open(file);
    trainee_store->act_for(full.anna);
    EXPECT_THAT(failure_of([&] { (void)trainee_store->move_to(server); }).what(),
                HasSubstr("an administrator can"));
    ASSERT_TRUE(raw(file).run("UPDATE accounts SET roles = 255 WHERE id = 1"));
    EXPECT_THAT(said(file, server),
                AllOf(HasSubstr("it is not sound (seals: user 1"), HasSubstr("nothing was moved")));
}

// --- looking, and large ones -------------------------------------------------------------------

TEST_F(MoveTest, ADryRunSaysWhatAndChangesNothing) {
    fill(file);
    const AllRows before = rows(file);
    db::MoveOptions look;
    look.dry_run = true;
    const db::MoveReport report = open(file)->move_to(server, look);
    int64_t all = 0;
    for (const auto& table : report.tables) {
        EXPECT_EQ(table.rows, static_cast<int64_t>(before.at(table.name).size())) << table.name;
        all += table.rows;
    }
    EXPECT_EQ(report.rows, all);
    EXPECT_EQ(report.tables.size(), before.size());
    EXPECT_TRUE(raw(server).handle().tables().isEmpty());
    EXPECT_EQ(rows(file), before);
    fs::remove(folder.file("one.placode"));
    fill(server);
    (void)open(server)->move_to("sqlite:" + folder.file("new/placode.db"), look);
    EXPECT_FALSE(fs::exists(folder.file("new")));
}

TEST_F(MoveTest, RecordingsStream) {
    const auto store = open(file);
    {
        const auto sink = db::create_recording_file(folder.file("long.placode"));
        sink->begin(make_result().header);
        std::vector<sim::Input> inputs(20000);
        sim::SplitMix64 random(1);
        for (int64_t frame = 0; frame < 200000;) {
            for (sim::Input& each : inputs) {
                each.frame = frame++;
                for (float& x : each.tools[0].position_m) x = static_cast<float>(random.next());
            }
            sink->append(inputs, {}, {});
        }
        sink->finish({sim::EndReason::kFinished, 200, 1, 0});
    }
    constexpr int kPeople = 40;
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("long.placode");
    for (int i = 0; i < kPeople; ++i)
        store->attempts().save(store->accounts().create(trainee("p" + std::to_string(i))), result);
    const auto peak_kib = [] {
        rusage used{};
        ::getrusage(RUSAGE_SELF, &used);
        return used.ru_maxrss;
    };
    const auto before = peak_kib();
    const db::MoveReport report = store->move_to(server);
    const int64_t grown = (peak_kib() - before) * 1024;
    RecordProperty("recording_bytes", std::to_string(report.recording_bytes));
    RecordProperty("grown_bytes", std::to_string(grown));
    EXPECT_GT(report.recording_bytes, int64_t{64} << 20);
    EXPECT_LT(grown, report.recording_bytes / 2);
    expect_sound(server);
}

}  // namespace THIS_TEST
