// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What only an embedded store has: a file that can be missing, foreign, damaged or copied.

#include <string>

#include "db/sql_connection.h"

namespace placode::db {

/// "PLCD" in the file's header says that it is a Placode store.
inline constexpr int kStoreApplicationId = 0x504c4344;

/// Before opening: creates folder (0700) and file (0600) when missing; throws StoreError(kDamaged)
/// without touching a file that is no SQLite database or is shorter than it says.
void prepare_sqlite_file(const std::string& path, const std::string& operation);

/// After opening: refuses another program's database; sets application id and write-ahead log.
void claim_sqlite_file(Connection& connection);

/// First problem that SQLite's integrity check finds, or "".
[[nodiscard]] std::string sqlite_integrity_problem(Connection& connection);

/// A consistent copy (0600), while others may read and write. Throws StoreError when `path` exists.
void copy_sqlite_store(Connection& connection, const std::string& path);

}  // namespace placode::db
