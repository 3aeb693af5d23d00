// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Brings the tables of a store up to this program.

#include <functional>
#include <string>
#include <vector>

#include "db/migrations.h"
#include "db/sql_connection.h"

namespace placode::db {

/// The register of what was applied, which every store has.
inline constexpr const char* kCreateRegister =
    "CREATE TABLE IF NOT EXISTS schema_migrations (name TEXT PRIMARY KEY, checksum TEXT NOT NULL, "
    "applied_utc TEXT NOT NULL)";

/// Why a store is not opened whose register names `part`, which this program does not know.
[[nodiscard]] std::string too_new_sentence(const std::string& part);

/// Applies what is missing, all in one transaction; true when there was something. `before_change`
/// runs first when a store that already has tables is about to change (the place for a copy).
/// Throws StoreError(kTooNew) for a store of a newer program, kDamaged when an applied file is not
/// the one known here or when a file holds what acts by itself and is none of Placode's
/// (db/foreign_store.h), kRefused where the log-in to a server may make no tables.
bool migrate(Connection& connection, const std::vector<EmbeddedSql>& migrations,
             const std::function<void()>& before_change);

/// Statements of one file in the engine's own words.
[[nodiscard]] std::vector<std::string> statements_of(const EmbeddedSql& migration, Engine engine);

}  // namespace placode::db
