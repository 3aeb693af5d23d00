// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tables of a store, as its migrations make them: for what has to reach every row. Only db/
// includes this.

#include <cstdint>
#include <string>
#include <vector>

#include "db/sql_connection.h"
#include "db/store_options.h"

namespace placode::db {

/// Which tables were made by which file; each store has its own.
inline constexpr const char* kMigrationsTable = "schema_migrations";

struct StoreTable {
    std::string name;
    bool has_counter = false;  ///< Its ids are given out by the engine, none of them twice.
    std::vector<std::string> columns;
    std::vector<std::string> key;  ///< Columns of the primary key.
    std::vector<bool> key_is_text;
    bool has_bytes = false;  ///< A column without a limit to its size: row by row, then.
};

/// In the order in which they are made, so that what a table refers to stands before it; without
/// kMigrationsTable. Throws StoreError when the store has a table that no migration makes, but for
/// `also`, or lacks one.
[[nodiscard]] std::vector<StoreTable> store_tables(Connection& connection,
                                                   const StoreOptions& options,
                                                   const std::string& also = "");

/// Names of what is there, in no order.
[[nodiscard]] std::vector<std::string> names_of_tables(Connection& connection);

/// The highest id that a table has ever given out, also to a row that is gone; 0 = none.
[[nodiscard]] int64_t counter_of(Connection& connection, const StoreTable& table);
/// Goes on behind it. On a server with the log-in of the tables' owner.
void set_counter(Connection& connection, const StoreTable& table, int64_t last);

/// "a, b, c"
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace placode::db
