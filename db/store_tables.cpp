// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_tables.h"

#include <QSqlField>
#include <QSqlIndex>
#include <QSqlRecord>
#include <algorithm>
#include <set>
#include <sstream>

#include "db/schema.h"

namespace placode::db {
namespace {

/// The word behind `begin` in a statement that has it at its start; "" for another one.
std::string word_behind(const std::string& begin, const std::string& statement) {
    std::istringstream lines(statement);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("--")) continue;
        if (!line.starts_with(begin)) return {};
        std::istringstream words(line.substr(begin.size()));
        std::string word;
        words >> word;
        return word.substr(0, word.find(';'));
    }
    return {};
}

/// Names and counters, from the text of the migrations: both engines make the same tables.
std::vector<StoreTable> made_tables(const std::vector<EmbeddedSql>& migrations, Engine engine) {
    std::vector<StoreTable> tables;
    for (const EmbeddedSql& migration : migrations)
        for (const std::string& statement : statements_of(migration, engine)) {
            if (std::string name = word_behind("CREATE TABLE ", statement); !name.empty()) {
                StoreTable& table = tables.emplace_back();
                table.name = std::move(name);
                table.has_counter = statement.find(" AUTOINCREMENT") != std::string::npos ||
                                    statement.find(" AS IDENTITY") != std::string::npos;
            }
            const std::string gone = word_behind("DROP TABLE ", statement);
            std::erase_if(tables, [&](const StoreTable& each) { return each.name == gone; });
        }
    return tables;
}

void read_columns(Connection& connection, StoreTable& table) {
    const QString name = QString::fromStdString(table.name);
    const QSqlRecord columns = connection.handle().record(name);
    const QSqlIndex key = connection.handle().primaryIndex(name);
    for (int i = 0; i < columns.count(); ++i) {
        const QSqlField column = columns.field(i);
        table.columns.push_back(column.name().toStdString());
        table.has_bytes = table.has_bytes || column.metaType().id() == QMetaType::QByteArray;
        // In the order of the columns: both engines then go through the rows in the same one.
        if (!key.contains(column.name())) continue;
        table.key.push_back(column.name().toStdString());
        table.key_is_text.push_back(column.metaType().id() == QMetaType::QString);
    }
    if (table.key.empty())
        connection.fail(StoreError::Kind::kOther, "its table " + table.name + " has no key");
}

/// The sequence behind the ids of a table of a server.
std::string sequence_of(Connection& connection, const StoreTable& table) {
    Statement query(connection, "SELECT pg_get_serial_sequence(?, 'id')");
    return query.run(table.name).next() ? query.text(0) : std::string();
}

}  // namespace

std::vector<StoreTable> store_tables(Connection& connection, const StoreOptions& options,
                                     const std::string& also) {
    auto tables =
        made_tables(options.migrations.empty() ? embedded_migrations() : options.migrations,
                    connection.url().engine);
    const auto there = names_of_tables(connection);
    std::set<std::string> unknown(there.begin(), there.end());
    unknown.erase(kMigrationsTable);
    unknown.erase(also);
    for (StoreTable& table : tables) {
        if (unknown.erase(table.name) == 0)
            connection.fail(StoreError::Kind::kDamaged, "its table " + table.name + " is missing");
        read_columns(connection, table);
    }
    if (!unknown.empty())
        connection.fail(
            StoreError::Kind::kOther,
            "its table " + *unknown.begin() + " is none of Placode's; take it out of there first");
    return tables;
}

std::vector<std::string> names_of_tables(Connection& connection) {
    Statement query(connection,
                    connection.is_sqlite()
                        ? "SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE "
                          "'sqlite\\_%' ESCAPE '\\'"
                        : "SELECT tablename FROM pg_tables WHERE schemaname = current_schema()");
    query.run();
    std::vector<std::string> names;
    while (query.next()) names.push_back(query.text(0));
    return names;
}

int64_t counter_of(Connection& connection, const StoreTable& table) {
    if (!table.has_counter) return 0;
    if (connection.is_sqlite()) {
        Statement query(connection, "SELECT seq FROM sqlite_sequence WHERE name = ?");
        return query.run(table.name).next() ? query.integer(0) : 0;
    }
    Statement query(connection, "SELECT CASE WHEN is_called THEN last_value ELSE 0 END FROM " +
                                    sequence_of(connection, table));
    return query.run().next() ? query.integer(0) : 0;
}

void set_counter(Connection& connection, const StoreTable& table, int64_t last) {
    if (!table.has_counter || last == 0) return;
    if (connection.is_sqlite()) {
        Statement(connection, "DELETE FROM sqlite_sequence WHERE name = ?").run(table.name);
        Statement(connection, "INSERT INTO sqlite_sequence (name, seq) VALUES (?, ?)")
            .run(table.name, last);
        return;
    }
    Statement query(connection, "SELECT setval(CAST(? AS regclass), ?, true)");
    (void)query.run(sequence_of(connection, table), last).next();
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace placode::db
