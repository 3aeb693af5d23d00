// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of one store put into another, of whatever engine, and compared. Rows stream in the order of
// their keys; of recordings one at a time is in memory. Only db/ includes this.

#include <cstdint>
#include <functional>
#include <string>

#include "db/store_tables.h"

namespace placode::db {

/// Called with the number of rows that were done since the last time. May throw, to stop.
using RowsDone = std::function<void(int64_t rows)>;

/// Adds the rows whose keys come after the last one that is there already, each thousand or so in
/// a transaction of its own: stopped at any moment, what is there is the beginning of the table.
void copy_rows(Connection& from, Connection& to, const StoreTable& table, const RowsDone& done);

/// Compares every value of every row. "" = the same; else the first row that is not, without its
/// values, which may be somebody's: "attempts, id 12: points differs".
[[nodiscard]] std::string first_difference(Connection& from, Connection& to,
                                           const StoreTable& table, const RowsDone& done);

}  // namespace placode::db
