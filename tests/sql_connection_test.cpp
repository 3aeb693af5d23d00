// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Rows read by the names of their columns, on both engines.

#include "db/sql_connection.h"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>

#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace THIS_TEST {

World* const world = World::install();

class SqlConnection : public EngineTest {
 protected:
    [[nodiscard]] bool at_station() const override { return false; }  // Makes tables.
    void TearDown() override {}  // a database of the test, no store
    void ready() override {
        connection = std::make_unique<db::Connection>(db::parse_store_url(url()));
        connection->execute(
            "CREATE TABLE measured (id INTEGER PRIMARY KEY, name TEXT, grams DOUBLE PRECISION)");
        db::Statement insert(*connection,
                             "INSERT INTO measured (id, name, grams) VALUES (?, ?, ?)");
        insert.run(1, "ring", 0.25);
        insert.run(2, "", std::nan(""));
    }
    /// The connection holds the file, or the database, until the test has ended.
    std::unique_ptr<db::Connection> connection;
};

INSTANTIATE_TEST_SUITE_P(Engines, SqlConnection, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(SqlConnection, AColumnIsReadByItsNameInAnyOrder) {
    db::Statement query(*connection, "SELECT m.id, m.name, m.grams FROM measured m ORDER BY m.id");
    ASSERT_TRUE(query.run().next());
    EXPECT_EQ(query.columns(), 3);
    EXPECT_EQ(query.integer("id"), 1);
    EXPECT_EQ(query.text("name"), "ring");
    EXPECT_EQ(query.real("grams"), 0.25);
    EXPECT_EQ(query.text("name"), "ring");
    EXPECT_EQ(query.integer("id"), 1);
    ASSERT_TRUE(query.next());
    EXPECT_EQ(query.text("name"), "");
    EXPECT_EQ(query.integer("id"), 2);
    EXPECT_FALSE(query.next());
}

TEST_P(SqlConnection, AnExpressionHasTheNameThatTheQuestionGivesIt) {
    db::Statement query(*connection,
                        "SELECT COALESCE(MAX(m.id), 0) AS newest, COUNT(*) AS number FROM measured "
                        "m WHERE m.id <= ?");
    for (const int last : {1, 2}) {
        ASSERT_TRUE(query.run(last).next());
        EXPECT_EQ(query.integer("newest"), last);
        EXPECT_EQ(query.integer("number"), last);
    }
}

TEST_P(SqlConnection, ARealThatIsNullIsNotANumber) {
    db::Statement query(*connection, "SELECT name, grams FROM measured WHERE id = 2");
    ASSERT_TRUE(query.run().next());
    EXPECT_EQ(query.text("name"), "");
    EXPECT_TRUE(std::isnan(query.real("grams")));
    EXPECT_TRUE(std::isnan(query.real(1)));
}

TEST_P(SqlConnection, ANameThatIsNotThereThrowsAndSaysWhichAndWhere) {
    db::Statement query(*connection, "SELECT id, name, grams FROM measured ORDER BY id");
    ASSERT_TRUE(query.run().next());
    const auto says = [](const char* what) {
        return ThrowsMessage<std::logic_error>(
            testing::AllOf(HasSubstr(what), HasSubstr("FROM measured")));
    };
    EXPECT_THAT([&] { (void)query.text("nmae"); }, says("no column \"nmae\""));
    EXPECT_THAT([&] { (void)query.integer("ID"); }, says("no column \"ID\""));
    EXPECT_THAT([&] { (void)query.real(""); }, says("no column \"\""));
    EXPECT_THAT([&] { (void)query.bytes("id "); }, says("no column \"id \""));
    // What was asked in vain changes nothing.
    EXPECT_EQ(query.integer("id"), 1);
    EXPECT_EQ(query.text("name"), "ring");
}

TEST_P(SqlConnection, AStatementWithoutAnAnswerHasNoColumns) {
    db::Statement remove(*connection, "DELETE FROM measured WHERE id = ?");
    remove.run(1);
    EXPECT_EQ(remove.columns(), 0);
    EXPECT_THROW((void)remove.text("id"), std::logic_error);
}

TEST_P(SqlConnection, WhatTheEngineSaidComesWithoutTheWordBeforeIt) {
    const auto error = failure_of([&] {
        db::Statement(*connection, "INSERT INTO measured (id, name) VALUES (?, ?)").run(1, "again");
    });
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("ERROR")));
    EXPECT_THAT(error.what(), HasSubstr(is_sqlite() ? ": UNIQUE" : ": duplicate key"));
}

}  // namespace THIS_TEST
