// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever edits the store past the program is found, on both engines: every table, every column,
// rows added and removed, the audit trail cut, edited and chained anew.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "db/seals.h"

#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QVariant>
#include <set>
#include <thread>

#include "db/attempt_counting.h"
#include "db/packing.h"
#include "db/signature.h"
#include "db/sql_connection.h"
#include "db/store_context.h"
#include "sim/core/random.h"
#include "tests/bars.h"
#include "tests/full_store.h"
#include "tests/recorded_attempt.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;

namespace THIS_TEST {

std::string all_of(const std::vector<std::string>& problems) {
    std::string text;
    for (const std::string& each : problems) text += each + "\n";
    return text;
}

class SealsTest : public EngineTest {
 protected:
    void ready() override {
        store = open();
        FullStore full;
        full.fill(*store, *open(), folder);
        anna = full.anna;
        bert = full.bert;
        attempt_id = full.attempt_id;
        ASSERT_EQ(all_of(store->check()), "");
    }

    /// Past the store, without its rules and triggers.
    [[nodiscard]] RawConnection forger() const {
        RawConnection made = raw();
        if (is_sqlite())
            for (const char* trigger :
                 {"audit_is_never_changed", "audit_is_never_deleted",
                  "definitions_are_never_changed", "definitions_are_never_deleted"})
                made.run(std::string("DROP TRIGGER IF EXISTS ") + trigger);
        else
            made.run("SET session_replication_role = replica");
        return made;
    }
    [[nodiscard]] std::string found() { return all_of(open()->check()); }

    std::unique_ptr<db::Store> store;
    int64_t anna = 0, bert = 0, attempt_id = 0;
};

/// One value of one row, as somebody with the file or the database may set it.
struct Edit {
    std::string table, column, row;  ///< `row`: what stands behind WHERE.
    QVariant old_value;
};

/// Sets the column to what `value` says. @return where the row stands now; PostgreSQL moves a row
/// that changes. Nothing where the engine's own rules refuse it.
std::optional<std::string> set_column(RawConnection& forger, bool sqlite, const Edit& edit,
                                      const std::string& value, const QVariant& bound = {}) {
    QSqlQuery query(forger.handle());
    query.prepare(QString::fromStdString("UPDATE " + edit.table + " SET " + edit.column + " = " +
                                         value + " WHERE " + edit.row +
                                         (sqlite ? "" : " RETURNING ctid")));
    if (value == "?") query.addBindValue(bound);
    if (!query.exec()) return std::nullopt;
    if (sqlite) return edit.row;
    if (!query.next()) return std::nullopt;
    return "ctid = '" + query.value(0).toString().toStdString() + "'";
}

std::optional<Edit> edit_somewhere(RawConnection& forger, bool sqlite, sim::SplitMix64& random) {
    static const auto tables = db::sealed_tables();
    const auto& table = tables[random.next() % tables.size()];
    const auto rows = std::stoull("0" + forger.value("SELECT COUNT(*) FROM " + table.table));
    if (rows == 0) return std::nullopt;
    Edit edit{table.table, table.columns[random.next() % table.columns.size()], {}, {}};
    const std::string place = sqlite ? "rowid" : "ctid";
    // An order that does not change with what is edited.
    const std::string which =
        forger.value("SELECT " + place + " FROM " + table.table + " ORDER BY " + place +
                     " LIMIT 1 OFFSET " + std::to_string(random.next() % rows));
    edit.row = place + " = " + (sqlite ? which : "'" + which + "'");
    QSqlQuery query(forger.handle());
    query.exec(QString::fromStdString("SELECT " + edit.column + " FROM " + edit.table + " WHERE " +
                                      edit.row));
    if (!query.next()) return std::nullopt;
    edit.old_value = query.value(0);
    const bool text = edit.old_value.typeId() == QMetaType::QString;
    std::string changed =
        text ? "'" + edit.old_value.toString().replace("'", "''").toStdString() + "x'"
             : "CASE WHEN " + edit.column + " = 0 THEN 1 ELSE " + edit.column + " - 1 END";
    if (edit.old_value.isNull())
        changed = "1";
    else if (random.next() % 4 == 0)
        changed = "NULL";
    query.finish();
    const auto moved = set_column(forger, sqlite, edit, changed);
    if (!moved) return std::nullopt;
    edit.row = *moved;
    // A number that is the row's own place moves the row.
    if (forger.value("SELECT COUNT(*) FROM " + edit.table + " WHERE " + edit.row) == "0")
        edit.row = place + " = " +
                   (edit.old_value == 0 ? "1" : std::to_string(edit.old_value.toLongLong() - 1));
    // -1 from the largest double is the largest double.
    QSqlQuery now(forger.handle());
    now.exec(QString::fromStdString("SELECT " + edit.column + " FROM " + edit.table + " WHERE " +
                                    edit.row));
    if (!now.next() || now.value(0) == edit.old_value) return std::nullopt;
    return edit;
}

INSTANTIATE_TEST_SUITE_P(Engines, SealsTest, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(SealsTest, EveryColumnOfEveryTableIsSealedOrNamedHere) {
    // Counters and waits that mean nothing later; bytes that `recordings.checksum` proves; who has
    // read them, which changes nothing; the trail itself, which is chained and signed; which
    // migrations were applied.
    const std::set<std::string> open_tables{"sign_in_failures", "schema_migrations", "audit"};
    const std::set<std::string> open_columns{"account_pins.failures", "recordings.content",
                                             "recordings.attempt_id", "attempts.read_by"};
    std::map<std::string, std::set<std::string>> sealed;
    for (const auto& table : db::sealed_tables())
        sealed[table.table].insert(table.columns.begin(), table.columns.end());
    RawConnection connection = raw();
    for (const QString& name : connection.handle().tables()) {
        const std::string table = name.toStdString();
        if (open_tables.contains(table) || table.starts_with("sqlite_")) continue;
        if (table.starts_with("placode_guard.")) continue;  // Who has signed in now: no data.
        EXPECT_TRUE(sealed.contains(table)) << table;
        const QSqlRecord columns = connection.handle().record(name);
        ASSERT_GT(columns.count(), 0) << table;
        for (int i = 0; i < columns.count(); ++i) {
            const std::string column = columns.fieldName(i).toStdString();
            // Numbers that only hang rows together: their order and their owner are sealed.
            if (column == "id" && table != "attempts" && table != "accounts") continue;
            EXPECT_TRUE(sealed[table].contains(column) || column == "score_id" ||
                        column == "rating_id" || open_columns.contains(table + "." + column))
                << table << "." << column;
        }
    }
}

TEST_P(SealsTest, AThousandRandomEditsAreFoundAThousandTimes) {
    Bar bar("random edits of a store that are not found");
    RawConnection pen = forger();
    sim::SplitMix64 random(20261125);
    std::set<std::string> seen;
    const int all = is_sqlite() ? 1000 : times(100, 1000);
    int made = 0;
    for (int i = 0; i < 20000 && made < all; ++i) {
        const auto edit = edit_somewhere(pen, is_sqlite(), random);
        if (!edit) continue;
        ++made;
        seen.insert(edit->table + "." + edit->column);
        const std::string found = all_of(store->check());
        EXPECT_THAT(found, HasSubstr("seals: "))
            << edit->table << "." << edit->column << " WHERE " << edit->row;
        bar.tried(found.find("seals: ") != std::string::npos);
        ASSERT_TRUE(set_column(pen, is_sqlite(), *edit, "?", edit->old_value))
            << edit->table << "." << edit->column;
        ASSERT_EQ(all_of(store->check()), "") << edit->table << "." << edit->column;
    }
    EXPECT_EQ(made, all);
    EXPECT_GT(seen.size(), is_sqlite() ? 130u : 55u) << "the edits are all over the store";
}

TEST_P(SealsTest, RowsThatAreAddedOrRemovedAreFound) {
    const std::string attempt = std::to_string(attempt_id), user = std::to_string(anna);
    const std::vector<std::pair<std::string, std::string>> cases{
        {"DELETE FROM attempt_reasons WHERE attempt_id = " + attempt + " AND position = 0",
         "attempt " + attempt + " was changed"},
        {"DELETE FROM course_grants", "user " + user + " was changed"},
        {"INSERT INTO course_grants (account_id, course_id, stage_id, attempts, reason, "
         "granted_by, "
         "granted_utc) VALUES (" +
             user + ", 'c', 's', 9, '', '', '')",
         "user " + user + " was changed"},
        {"DELETE FROM attempt_comments", "attempt " + attempt + " was changed"},
        {"INSERT INTO accounts (id, password_hash, roles, active, demonstration, created_utc) "
         "VALUES (999, '', 255, 1, 0, '')",
         "user 999 was added"},
        {"DELETE FROM training_groups", "group 1 was removed"},
        {"DELETE FROM invitations", "invitation 1 was removed"},
        {"DELETE FROM answer_items", "participant pilot"},
        {"DELETE FROM withdrawals", "participant pilot"},
    };
    RawConnection pen = forger();
    for (const auto& [sql, said] : cases) {
        ASSERT_TRUE(pen.run(sql)) << sql << ": " << pen.problem();
        EXPECT_THAT(found(), HasSubstr(said)) << sql;
    }
}

TEST_P(SealsTest, NoRowIsHiddenByLookingLikeACopyForMeasurements) {
    RawConnection pen = forger();
    const auto add = [&](int id, int64_t account, const std::string& exam) {
        return pen.run(
            "INSERT INTO attempts (id, account_id, task_id, task_version, started_utc, saved_utc, "
            "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, "
            "points, verdict, rubric_id, rubric_version, metric_set_version, generated_from, "
            "exam_course, exam_stage) SELECT " +
            std::to_string(id) + ", " + std::to_string(account) +
            ", task_id, task_version, started_utc, saved_utc, duration_s, device, seed, build, 1, "
            "final_hash, dropped, 1, 100, 0, rubric_id, rubric_version, metric_set_version, id, '" +
            exam + "', 'exam' FROM attempts WHERE id = " + std::to_string(attempt_id));
    };
    ASSERT_TRUE(add(9001, anna, "")) << pen.problem();
    ASSERT_TRUE(add(9002, anna, "fetoscopy")) << pen.problem();
    EXPECT_THAT(found(),
                AllOf(HasSubstr("attempt 9001 was added"), HasSubstr("attempt 9002 was added")));
    ASSERT_TRUE(
        pen.run("UPDATE accounts SET demonstration = 1 WHERE id = " + std::to_string(anna)));
    EXPECT_THAT(found(), AllOf(HasSubstr("user " + std::to_string(anna) + " was changed"),
                               HasSubstr("attempt 9002 was added")));
}

TEST_P(SealsTest, AnEditThatTheProgramLaterWritesOverIsStillFound) {
    RawConnection pen = forger();
    ASSERT_TRUE(pen.run("UPDATE accounts SET roles = 255 WHERE id = " + std::to_string(anna)));
    store->accounts().set_password(anna, "another long one");
    EXPECT_THAT(found(), HasSubstr("user " + std::to_string(anna) + " was changed before entry"));
}

TEST_P(SealsTest, TheTrailCannotBeEditedCutOrWrittenAnew) {
    const std::string last = raw().value("SELECT MAX(id) FROM audit");
    const auto kept = [&](const std::string& sql) {
        RawConnection pen = forger();
        ASSERT_TRUE(pen.run(sql)) << pen.problem();
    };
    store.reset();  // remembers how far the trail went
    kept("DELETE FROM audit WHERE id = " + last);
    EXPECT_THAT(found(), HasSubstr("this computer wrote entry " + last));
    kept("UPDATE audit SET signature = '' WHERE id = 2");
    EXPECT_THAT(found(), HasSubstr("entry 2 has a signature that is not right"));
    kept("UPDATE audit SET detail = detail || 'x' WHERE id = 3");
    EXPECT_THAT(found(), HasSubstr("entry 2"));
    kept("UPDATE audit SET station = '', signature = '', seals = ''");
    EXPECT_THAT(found(), HasSubstr("entry 1 or the one before it was changed"));
}

TEST_P(SealsTest, EntriesThatChangePlacesAreFound) {
    store.reset();
    RawConnection pen = forger();
    for (const char* sql :
         {"UPDATE audit SET id = -1 WHERE id = 2", "UPDATE audit SET id = 2 WHERE id = 3",
          "UPDATE audit SET id = 3 WHERE id = -1"})
        ASSERT_TRUE(pen.run(sql)) << pen.problem();
    EXPECT_THAT(found(), HasSubstr("audit: entry 2 or the one before it was changed"));
}

TEST_P(SealsTest, ATrailThatIsWrittenAnewWithoutAKeyIsNotSealedAgain) {
    // As whoever may write the store's folder, and not the folder of the station's key: with the
    // note beside the store gone, and an entry of the form from before there were signatures.
    store.reset();
    fs::remove(folder.file("placode.db.seen"));
    RawConnection pen = forger();
    ASSERT_TRUE(pen.run("DELETE FROM audit"));
    const std::string forged = "UPDATE accounts SET roles = 15 WHERE id = " + std::to_string(anna);
    ASSERT_TRUE(pen.run(forged));
    const std::string chain =
        db::checksum_hex(std::string("\x1ft\x1f"
                                     "bert\x1f"
                                     "sign_in\x1fuser 2\x1f"));
    for (const bool with_entry : {false, true}) {
        if (with_entry) {
            ASSERT_TRUE(
                pen.run("INSERT INTO audit (at_utc, actor, action, object, detail, chain, "
                        "seals, station, signature) VALUES ('t', 'bert', 'sign_in', "
                        "'user 2', '', '" +
                        chain + "', '', '', '')"))
                << pen.problem();
        }
        EXPECT_THAT(found(), HasSubstr("and the trail does not hold it as it was"));
        EXPECT_THAT(found(), HasSubstr("and the trail does not hold it as it was")) << "again";
    }
}

/// A row of the trail as somebody adds it by SQL. @param id "" = the next one
std::string added_entry(const std::string& id, const std::string& action, const std::string& detail,
                        const std::string& station = "", const std::string& chain = "none") {
    return "INSERT INTO audit (" + std::string(id.empty() ? "" : "id, ") +
           "at_utc, actor, action, object, detail, chain, seals, station, signature) VALUES (" +
           (id.empty() ? "" : id + ", ") + "'2026-01-01T00:00:00Z', 'bert', '" + action +
           "', 'x', '" + detail + "', '" + chain + "', '', '" + station + "', '')";
}

TEST_P(SealsTest, ARowThatDoesNotFitHidesNothingThatComesAfterIt) {
    const std::string attempt = std::to_string(attempt_id);
    RawConnection pen = forger();
    const std::string last = pen.value("SELECT MAX(id) FROM audit");
    ASSERT_TRUE(pen.run(added_entry("", "export", "")));
    const std::string added = pen.value("SELECT MAX(id) FROM audit");
    ASSERT_TRUE(pen.run("UPDATE attempts SET points = 100 WHERE id = " + attempt));
    store->groups().create("after it");  // The program goes on from that row.
    ASSERT_TRUE(pen.run("UPDATE accounts SET roles = 255 WHERE id = " + std::to_string(anna)));
    const std::string found_now = found();
    EXPECT_THAT(found_now, AllOf(HasSubstr("entry " + added + " or the one before it"),
                                 HasSubstr("attempt " + attempt + " was changed"),
                                 HasSubstr("user " + std::to_string(anna) + " was changed")));
    EXPECT_THAT(found_now, Not(HasSubstr("entry " + std::to_string(std::stoll(added) + 1))))
        << "only that one";
    // Somebody has looked into it.
    store = open();
    EXPECT_EQ(failure_of([&] { store->audit().set_aside(std::stoll(last), "why"); }).kind(),
              db::StoreError::Kind::kNotFound)
        << "it fits";
    EXPECT_EQ(failure_of([&] { store->audit().set_aside(std::stoll(added), ""); }).kind(),
              db::StoreError::Kind::kRefused);
    store->audit().set_aside(std::stoll(added), "a script of ours");
    EXPECT_THAT(all_of(store->check()),
                AllOf(Not(HasSubstr("audit: ")), HasSubstr("attempt " + attempt + " was changed")));
    ASSERT_TRUE(pen.run("UPDATE audit SET detail = 'other' WHERE id = " + added));
    EXPECT_THAT(all_of(store->check()), HasSubstr("entry " + added))
        << "as it was when somebody looked";
}

TEST_P(SealsTest, ARowFarOnHidesNothingEither) {
    const std::string attempt = std::to_string(attempt_id);
    RawConnection pen = forger();
    ASSERT_TRUE(pen.run(added_entry("9223372036854775000", "export", "")));
    ASSERT_TRUE(pen.run("UPDATE attempts SET points = 100 WHERE id = " + attempt));
    EXPECT_THAT(found(), AllOf(HasSubstr("entry 9223372036854775000"),
                               HasSubstr("attempt " + attempt + " was changed")));
}

TEST_P(SealsTest, NobodyIsTrustedByARowThatNobodySigned) {
    store.reset();
    const std::string own = folder.file("station.key"), other = folder.file("other/station.key");
    ::setenv("PLACODE_STATION_KEY", other.c_str(), 1);
    store = open();
    store->audit().write("bert", "export", "of the other", "");
    store.reset();
    ::setenv("PLACODE_STATION_KEY", own.c_str(), 1);
    store = open();
    const std::string first = store->audit().stations().at(0).public_key,
                      key = store->audit().stations().at(1).public_key;
    store.reset();
    const auto trusted = [&] {
        const auto again = open();
        for (const db::StationRecord& each : again->audit().stations())
            if (each.public_key == key) return each.trusted;
        return false;
    };
    RawConnection pen = forger();
    // By its text, in the name of who is trusted; and as the one that began the store.
    ASSERT_TRUE(pen.run(added_entry("", "station.trust", key, first)));
    EXPECT_FALSE(trusted());
    ASSERT_TRUE(pen.run(added_entry("0", "export", "", key)));
    EXPECT_FALSE(trusted());
    // With the chain that belongs there, which anybody can compute.
    ASSERT_TRUE(pen.run("DELETE FROM audit WHERE id <= 0"));
    db::TrailEntry entry;
    entry.record = {0, "t", "bert", "export", "", ""};
    entry.station = key;
    ASSERT_TRUE(
        pen.run("INSERT INTO audit (id, at_utc, actor, action, object, detail, chain, "
                "seals, station, signature) VALUES (0, 't', 'bert', 'export', '', '', '" +
                db::audit_chain("", entry) + "', '', '" + key + "', '')"));
    EXPECT_FALSE(trusted());
}

TEST_P(SealsTest, ANewStoreAtAnOldAddressIsNotSuspected) {
    if (!is_sqlite()) GTEST_SKIP() << "a server's database is not replaced by a file";
    store.reset();
    for (const char* left : {"placode.db", "placode.db.known", "placode.db-wal", "placode.db-shm"})
        fs::remove(folder.file(left));
    db::StoreOptions anew;
    anew.begin_anew = true;
    store = db::open_store(url(), anew);
    EXPECT_EQ(all_of(store->check()), "");
}

TEST_P(SealsTest, ATrailThatIsCutAndGoesOnIsStillFound) {
    const std::string last = raw().value("SELECT MAX(id) FROM audit");
    store.reset();
    RawConnection pen = forger();
    ASSERT_TRUE(pen.run("DELETE FROM audit WHERE id = " + last));
    store = open();
    store->audit().write("anna", "export", "something", "");
    store->audit().write("anna", "export", "something else", "");
    store.reset();  // must not remember the new end in place of the old one
    EXPECT_THAT(found(), HasSubstr("this computer wrote entry " + last));
}

TEST_P(SealsTest, AnotherStationCountsOnceItIsTrusted) {
    store.reset();
    const std::string own = folder.file("station.key"), other = folder.file("other/station.key");
    ::setenv("PLACODE_STATION_KEY", other.c_str(), 1);
    store = open();
    store->audit().write("bert", "export", "of the other", "");
    store.reset();
    ::setenv("PLACODE_STATION_KEY", own.c_str(), 1);
    EXPECT_THAT(found(), HasSubstr("which no other one trusts"));
    store = open();
    const auto stations = store->audit().stations();
    ASSERT_EQ(stations.size(), 2u);
    EXPECT_TRUE(stations[0].own && stations[0].trusted);
    EXPECT_FALSE(stations[1].own || stations[1].trusted);
    const std::string mark = db::fingerprint(stations[1].public_key);
    EXPECT_EQ(failure_of([&] { store->audit().trust_station("1234"); }).kind(),
              db::StoreError::Kind::kNotFound);
    store->audit().trust_station(mark);
    EXPECT_EQ(failure_of([&] { store->audit().trust_station(mark); }).kind(),
              db::StoreError::Kind::kConflict);
    EXPECT_EQ(all_of(store->check()), "");
}

TEST_P(SealsTest, WhoRewritesEverythingWithAKeyOfTheirOwnIsFound) {
    // As an attacker who has the program and the database, and not the station's key file.
    store.reset();
    RawConnection pen = forger();
    ASSERT_TRUE(pen.run("DELETE FROM audit"));
    ASSERT_TRUE(pen.run("UPDATE attempts SET points = 100"));
    ::setenv("PLACODE_STATION_KEY", folder.file("forged/station.key").c_str(), 1);
    store = open();
    store->audit().write("bert", "sign_in", "user 2", "");
    store.reset();
    ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
    EXPECT_NE(found(), "");
}

TEST_P(SealsTest, AnOlderStoreIsSealedOnceWhenItIsUpdated) {
    store.reset();
    RawConnection pen = forger();
    // As version 14 left it: no seals, and an entry with the chain of then.
    ASSERT_TRUE(pen.run("DELETE FROM audit"));
    for (const char* column : {"seals", "station", "signature"})
        ASSERT_TRUE(pen.run(std::string("ALTER TABLE audit DROP COLUMN ") + column));
    ASSERT_TRUE(pen.run("DELETE FROM schema_migrations WHERE name = '0015_seals.sql'"));
    const std::string chain =
        db::checksum_hex(std::string("\x1ft\x1f"
                                     "bert\x1f"
                                     "sign_in\x1fuser 2\x1f"));
    ASSERT_TRUE(
        pen.run("INSERT INTO audit (at_utc, actor, action, object, detail, chain) VALUES "
                "('t', 'bert', 'sign_in', 'user 2', '', '" +
                chain + "')"))
        << pen.problem();
    // And a computer that knows nothing of the store.
    ::setenv("PLACODE_STATION_KEY", folder.file("updated/station.key").c_str(), 1);
    fs::remove(folder.file("placode.db.seen"));
    become_owner();
    store = open();
    EXPECT_EQ(all_of(store->check()), "");
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM audit WHERE seals <> ''"), "1");
    store.reset();
    store = open();
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM audit WHERE seals <> ''"), "1");
    ASSERT_TRUE(
        pen.run("UPDATE attempts SET points = 100 WHERE id = " + std::to_string(attempt_id)));
    EXPECT_THAT(found(), HasSubstr("attempt " + std::to_string(attempt_id) + " was changed"));
}

TEST_P(SealsTest, WhatWasSealedBeforeReasonsHadAMeaningIsSound) {
    // As version 15 wrote it: the English alone, and seals over what there was then.
    store.reset();
    RawConnection pen = forger();
    const std::string attempt = std::to_string(attempt_id);
    ASSERT_TRUE(
        pen.run("UPDATE attempts SET void_reason = '2 device faults' WHERE id = " + attempt));
    ASSERT_TRUE(pen.run("UPDATE attempts SET void_meaning = ''"));
    ASSERT_TRUE(pen.run("UPDATE study_steps SET detail = 'interrupted', detail_meaning = ''"));
    ASSERT_TRUE(pen.run("DELETE FROM audit"));
    ::setenv("PLACODE_STATION_KEY", folder.file("updated/station.key").c_str(), 1);
    fs::remove(folder.file("placode.db.seen"));
    become_owner();
    store = open();
    ASSERT_EQ(all_of(store->check()), "");
    const std::string sealed = raw().value("SELECT seals FROM audit WHERE seals <> ''");
    store.reset();
    // Without what later versions added.
    for (const char* later :
         {"ALTER TABLE attempts DROP COLUMN read_by",
          "DELETE FROM schema_migrations WHERE name = '0019_readings.sql'",
          "DROP INDEX attempts_by_exam_begin", "ALTER TABLE attempts DROP COLUMN exam_begin",
          "DROP TABLE exam_begins",
          "DELETE FROM schema_migrations WHERE name = '0017_exam_begins.sql'"})
        ASSERT_TRUE(pen.run(later)) << pen.problem();
    ASSERT_TRUE(pen.run("ALTER TABLE attempts DROP COLUMN void_meaning")) << pen.problem();
    ASSERT_TRUE(pen.run("ALTER TABLE study_steps DROP COLUMN detail_meaning"));
    ASSERT_TRUE(pen.run("DELETE FROM schema_migrations WHERE name = '0016_void_meaning.sql'"));
    store = open();
    EXPECT_EQ(all_of(store->check()), "");
    EXPECT_EQ(raw().value("SELECT seals FROM audit WHERE seals <> ''"), sealed) << "not anew";
    // The row: a record says of what a script did that it is void as well.
    EXPECT_EQ(raw().value("SELECT void_reason || '|' || void_meaning FROM attempts WHERE id = " +
                          attempt),
              "2 device faults|");
    ASSERT_TRUE(pen.run("UPDATE attempts SET void_meaning = '[]' WHERE id = " + attempt));
    EXPECT_THAT(found(), HasSubstr("attempt " + attempt + " was changed"));
}

// A reason and its meaning are written together, wherever a reason is written.
TEST_P(SealsTest, WhatAReasonMeansIsSealedWithIt) {
    using db::Said;
    store->act_as("bert");
    db::AttemptResult result = make_result("touch_targets");
    result.header.mode = "study";
    result.not_verified = {{db::VoidCause::kUnsound, 0, 0,
                            Said::that("sample %1 has a tip that lies nowhere").with(12)}};
    const int64_t id = save_recorded(*store, anna, result, folder.path().string());
    const auto why = [&] { return db::why_void(store->attempts().detail(id).record); };
    EXPECT_THAT(why(), testing::Contains(result.not_verified[0]));
    const Said differs = Said::that("%1 at %2 s").with(Said::that("a sample")).with("2.500");
    open()->attempts().set_replay(id, db::ReplayState::kDiffers, differs);
    EXPECT_THAT(why(), testing::Contains(result.not_verified[0]));
    EXPECT_THAT(why(),
                testing::Contains(db::VoidReason{db::VoidCause::kReplayDiffers, 0, 0, differs}));
    db::StepRecord step;
    step.study_id = "pilot";
    step.participant = store->studies().new_participant("pilot");
    step.step = "run";
    step.attempt_id = id;
    db::record_attempt_step(*store, step);
    EXPECT_THAT(why(), testing::Contains(result.not_verified[0])) << "the participant's now";
    const db::StepRecord kept = store->studies().steps("pilot").back();
    EXPECT_EQ(db::not_done(kept.detail, kept.detail_meaning).voids, why());
    EXPECT_EQ(all_of(store->check()), "");
    RawConnection pen = forger();
    ASSERT_TRUE(pen.run("UPDATE attempts SET void_meaning = '' WHERE id = " + std::to_string(id)));
    EXPECT_THAT(found(), HasSubstr("attempt " + std::to_string(id) + " was changed"));
}

TEST_P(SealsTest, TwoComputersChangeOneObjectAtOnce) {
    constexpr int kEach = 15;
    const auto remark = [&] {
        const auto own = open();  // a connection of this thread
        for (int i = 0; i < kEach; ++i) {
            db::CommentRecord comment;
            comment.attempt_id = attempt_id;
            comment.author_id = bert;
            comment.text = "remark " + std::to_string(i);
            own->reviews().add_comment(comment);
        }
    };
    std::thread other(remark);
    remark();
    other.join();
    EXPECT_EQ(store->reviews().comments(attempt_id).size(), size_t{1 + 2 * kEach});
    EXPECT_EQ(all_of(store->check()), "");
}

TEST_P(SealsTest, AfterErasureNoNameIsLeftAnywhere) {
    db::NewUser third = trainee("cecylia");
    third.roles = static_cast<db::Roles>(db::Role::kAdministrator);
    store->accounts().create(third);
    db::AttemptResult exam = make_result("touch_targets");
    exam.exam.course_id = "fetoscopy";
    exam.exam.proctor = "bert";
    const int64_t examined = save_recorded(*store, anna, exam, folder.path().string());
    EXPECT_EQ(store->attempts().detail(examined).record.exam.proctor, "Name of bert");
    store->records().unlock("pilot", store->studies().participants("pilot").at(0).code, "a slip");
    EXPECT_EQ(store->records().events("pilot").back().login, "bert");
    EXPECT_EQ(store->audit().trail(1).at(0).actor, "bert");
    store->act_as("cecylia");
    for (const int64_t person : {anna, bert}) store->accounts().erase(person, false);
    EXPECT_EQ(store->attempts().detail(examined).record.exam.proctor,
              "user " + std::to_string(bert));
    EXPECT_EQ(all_of(store->check()), "");
    RawConnection connection = raw();
    for (const QString& table : connection.handle().tables()) {
        QSqlQuery rows(connection.handle());
        ASSERT_TRUE(rows.exec("SELECT * FROM " + table));
        while (rows.next())
            for (int i = 0; i < rows.record().count(); ++i)
                for (const char* name : {"anna", "bert"})
                    EXPECT_FALSE(rows.value(i).toString().contains(name, Qt::CaseInsensitive))
                        << table.toStdString() << "." << rows.record().fieldName(i).toStdString()
                        << ": " << rows.value(i).toString().toStdString();
    }
}

TEST(SealedObject, ItsLineIsReadBack) {
    const db::SealChanges changes{{{"participant", {"pilot", "P001-K"}}, {"-", "ab"}},
                                  {{"attempt", {"12"}}, {"cd", "-"}}};
    const auto back = db::seals_of_text(db::seals_text(changes) + "no line\n");
    ASSERT_EQ(back.size(), 2u);
    EXPECT_EQ((back.at({"participant", {"pilot", "P001-K"}}).after), "ab");
    EXPECT_EQ((back.at({"attempt", {"12"}}).before), "cd");
}

/// The seals of a participant and an attempt that were made by these statements.
std::string seals_of_rows(const std::string& url, RawConnection pen) {
    const std::vector<std::string> rows{
        "INSERT INTO accounts (id, password_hash, roles, active, demonstration, created_utc) "
        "VALUES (1, '', 1, 1, 0, '')",
        "INSERT INTO attempts (id, account_id, task_id, task_version, started_utc, saved_utc, "
        "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, points, "
        "verdict, rubric_id, rubric_version, metric_set_version) VALUES (1, 1, 't', 1, '', '', "
        "0.1, '', '', '', 0, '', 0, 0, -1e-300, 0, '', 1, 1)",
        "INSERT INTO attempt_metrics (attempt_id, position, metric_id, value) VALUES (1, 0, 'm', "
        "NULL), (1, 1, 'n', 0.30000000000000004)",
        "INSERT INTO participants (study_id, code, number, created_utc) VALUES ('s', 'c', 1, '')",
        "INSERT INTO answers (study_id, participant, questionnaire_id, questionnaire_version, "
        "answered_utc, demonstration) VALUES ('s', 'c', 'q', 1, '', 0)",
        "INSERT INTO answer_items (answer_id, item, answer) VALUES (1, 'a_b', '1'), (1, 'B', '2'), "
        "(1, 'a1', '3'), (1, 'ą', '4'), (1, 'b', '5')"};
    for (const std::string& row : rows) EXPECT_TRUE(pen.run(row)) << pen.problem();
    db::Connection connection(db::parse_store_url(url));
    return db::seal_of(connection, {"participant", {"s", "c"}}) + " " +
           db::seal_of(connection, {"attempt", {"1"}});
}

TEST(Seals, AreTheSameOnBothEnginesHoweverTheServerSorts) {
    if (world->server().missing()) GTEST_SKIP() << world->server().problem();
    const TemporaryFolder folder;
    const std::string file = folder.file("placode.db");
    const std::string database = world->server().new_database(kSortedAsPeopleDo);
    for (const std::string& url : {"sqlite:" + file, world->server().url(database)})
        (void)db::open_store(url);
    RawConnection server = world->server().connect(database);
    ASSERT_EQ(server.value("SELECT CASE WHEN 'a_b' < 'a1' AND 'b' < 'B' THEN 1 ELSE 0 END"), "1");
    const std::string seals =
        seals_of_rows(world->server().url(database), world->server().connect(database));
    EXPECT_EQ(seals_of_rows("sqlite:" + file, {"QSQLITE", file}), seals);
    // Nothing is not zero.
    ASSERT_TRUE(server.run("UPDATE attempt_metrics SET value = 0 WHERE value IS NULL"));
    db::Connection connection(db::parse_store_url(world->server().url(database)));
    EXPECT_FALSE(seals.ends_with(db::seal_of(connection, {"attempt", {"1"}})));
}

}  // namespace THIS_TEST
