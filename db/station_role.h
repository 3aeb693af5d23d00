// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a station's log-in may do on a centre's PostgreSQL: what the programs do, and nothing else.
// The tables belong to the owner's role, which creates and updates them; stations are members of
// the group `placode_station`. A member cannot change scores, recordings, published texts or the
// trail, cannot drop a table or switch a trigger off; accounts, courses and records of studies it
// changes as whoever has signed in may (db/station_guard.h). What it may change past the programs
// shows in the seals (db/seals.h).

#include <string>
#include <vector>

#include "db/sql_connection.h"

namespace placode::db {

inline constexpr const char* kStationRole = "placode_station";

/// For the owner of the tables, to be repeated at will; also in psql. The first statement makes the
/// group where it is missing, for which a log-in needs CREATEROLE.
[[nodiscard]] std::vector<std::string> station_role_statements();

/// Those of them that let a station change and remove rows. They count into the version of the
/// server's own rules, so that a server whose stations have other rights is given these.
[[nodiscard]] std::vector<std::string> station_table_rights();

/// Runs station_role_statements(). Throws StoreError, kRefused for an embedded store and where the
/// log-in may not.
void give_station_role(Connection& connection);

/// After an update: gives the group its rights on new tables, where there is the group; `changed`:
/// the tables are new. Without that only the owner does it, where the server's own rules
/// (db/station_guard.h) are of another version of the program.
void renew_station_role(Connection& connection, bool changed);

/// Whether this log-in to a server owns tables there, and so may do all with them.
[[nodiscard]] bool owns_tables(Connection& connection);
inline constexpr const char* kOnlyTheOwner =
    "this log-in does not own the tables; use their owner's";

[[nodiscard]] bool has_station_role(Connection& connection);

/// Why the role of this connection can do more than a station should, one line each; empty where it
/// cannot, and for an embedded store.
[[nodiscard]] std::vector<std::string> station_role_problems(Connection& connection);

/// Throws kRefused where there is the group for stations and this log-in can do more.
/// @param service the log-in has to be a service's instead (placode_service)
void need_station_role(Connection& connection, bool service = false);

}  // namespace placode::db
