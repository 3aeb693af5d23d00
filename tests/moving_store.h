// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A full store that moves between a file and a server, for the tests of db/store_move.h.

#include <QSqlQuery>
#include <QSqlRecord>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "curriculum/course.h"
#include "curriculum/definitions.h"
#include "db/course_conduct.h"
#include "db/store_context.h"
#include "db/store_tables.h"
#include "tests/exam_course.h"
#include "tests/full_store.h"

namespace placode::test {

/// Table -> its rows, each as a text of all values, sorted.
using AllRows = std::map<std::string, std::vector<std::string>>;

/// Read past the store. Without what belongs to the place and not to the store.
inline AllRows rows_of(RawConnection raw) {
    AllRows all;
    for (const QString& table : raw.handle().tables()) {
        if (table.startsWith("sqlite_") || table == "schema_migrations" || table == "store_move")
            continue;
        std::vector<std::string>& rows = all[table.toStdString()];
        QSqlQuery query(raw.handle());
        query.exec("SELECT * FROM " + table);
        while (query.next()) {
            std::string row;
            for (int i = 0; i < query.record().count(); ++i) {
                const QVariant value = query.value(i);
                const bool bytes = value.typeId() == QMetaType::QByteArray;
                row += query.record().fieldName(i).toStdString() + "=" +
                       (value.isNull() ? "NULL"
                        : bytes        ? value.toByteArray().toHex().toStdString()
                                       : value.toString().toStdString()) +
                       "|";
            }
            rows.push_back(row);
        }
        std::sort(rows.begin(), rows.end());
    }
    return all;
}

class MoveTest : public testing::Test {
 protected:
    void SetUp() override {
        if (World::get().server().missing()) GTEST_SKIP() << World::get().server().problem();
        ASSERT_EQ(World::get().server().problem(), "");
        options.cheap_passwords = true;
        file = "sqlite:" + folder.file("placode.db");
        // Sorted as people do: nothing may depend on a server's order of texts.
        database = World::get().server().new_database(kSortedAsPeopleDo);
        server = World::get().server().url(database);
    }

    [[nodiscard]] std::unique_ptr<db::Store> open(const std::string& url) const {
        return db::open_store(url, options);
    }
    void fill(const std::string& url) {
        const auto store = open(url);
        full.fill(*store, *open(url), folder);
        (void)open(url)->accounts().sign_in("anna", "not her password");
        (void)store->norms().open_centre_key("Ours", kPassphrase);
        const curriculum::Course course = curriculum::load_course("first_steps");
        db::DefinitionRecord definition;
        definition.kind = "course";
        definition.id = course.id;
        definition.version = course.version;
        definition.json = course.json;
        store->definitions().publish(definition);
        publish_exam(*store, "touch_targets", "7");
        assign_exam(*store, full.anna);
        const auto program = open(url);
        (void)db::begin_exam(
            *program, full.anna,
            db::prepare_exam(*program, full.anna, "short", "final", "", "", db::utc_now()));
        fillTheRest(url);
    }
    /// Tables that only longer ways of the program fill.
    void fillTheRest(const std::string& url) const {
        db::StoreContext context(db::parse_store_url(url), options);
        db::UnitOfWork work(context.connection);
        for (const char* sql :
             {"INSERT INTO study_allocations (study_id, seed) VALUES ('arms', "
              "'18446744073709551615')",
              "INSERT INTO participants (study_id, code, number, created_utc) VALUES ('arms', "
              "'A-1', 1, '')",
              "INSERT INTO participant_states (study_id, code, protocol_version, arm, "
              "demonstration) VALUES ('arms', 'A-1', 1, 2, 0)",
              "INSERT INTO norm_packs (task_id, centre, content, signature, public_key, in_use, "
              "added_by, added_utc) VALUES ('ring', 'Ours', '{}', 'ab', 'cd', 1, 'bert', '')",
              "INSERT INTO course_assignments (course_id, course_version, account_id, starts_utc, "
              "due_utc, assigned_by, assigned_utc, ended_utc) VALUES ('first_steps', 1, 1, '', '', "
              "'', '', '')",
              "INSERT INTO attempts (account_id, task_id, task_version, started_utc, saved_utc, "
              "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, "
              "points, verdict, rubric_id, rubric_version, metric_set_version) SELECT account_id, "
              "task_id, task_version, 'b', saved_utc, 0.1, device, seed, build, end_reason, 'x', "
              "dropped, demonstration, points, verdict, rubric_id, rubric_version, "
              "metric_set_version FROM attempts WHERE id = 1"})
            context.connection.execute(sql);
        context.seal_the_unsealed();
        work.commit();
    }

    [[nodiscard]] RawConnection raw(const std::string& url) const {
        const db::StoreUrl parsed = db::parse_store_url(url);
        if (parsed.engine == db::Engine::kSqlite) return {"QSQLITE", parsed.path};
        return World::get().server().connect(parsed.name);
    }
    [[nodiscard]] AllRows rows(const std::string& url) const { return rows_of(raw(url)); }
    /// Both the same, but for the entries that the moves themselves wrote.
    static void expect_same(AllRows before, AllRows after, size_t moves) {
        EXPECT_EQ(after["audit"].size(), before["audit"].size() + moves);
        for (AllRows* rows : {&before, &after})
            std::erase_if((*rows)["audit"], [](const std::string& row) {
                return row.find("action=store.move|") != std::string::npos;
            });
        for (const auto& [table, rows] : before) EXPECT_TRUE(rows == after[table]) << table;
        EXPECT_EQ(before.size(), after.size());
    }
    void expect_sound(const std::string& url) const {
        const auto problems = open(url)->check();
        EXPECT_TRUE(problems.empty()) << url << ": " << problems.front();
    }
    [[nodiscard]] db::MoveReport move(const std::string& from, const std::string& to) const {
        return open(from)->move_to(to);
    }

    TemporaryFolder folder;
    db::StoreOptions options;
    std::string file, database, server;
    FullStore full;
};

}  // namespace placode::test
