// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a centre's PostgreSQL itself asks before it shows a station a row or lets it change one: who
// has signed in on this connection, which roles that account has, and whose the row is. The schema
// placode_guard holds the functions and who has signed in; policies on the tables (row-level
// security, forced) ask them.
// Installed by the owner of the tables with the rights of db/station_role.h.

#include <string>
#include <string_view>
#include <vector>

#include "db/sql_connection.h"

namespace placode::db {

/// Members are programs of the centre without a person, such as jobs at night: they may do to rows
/// what stations may, and the server takes their word for whom they work.
inline constexpr const char* kServiceRole = "placode_service";

/// Columns that no station reads: who knows a hash has what a sign-in proves.
inline constexpr const char* kHiddenColumns = "'password_hash', 'pin_hash'";

/// Functions, policies and the rights to them, for the owner of the tables, to be repeated at will.
/// Behind the rights on the tables: some are taken back here.
[[nodiscard]] std::vector<std::string> station_guard_statements();

/// Whether the server has the functions of this program.
[[nodiscard]] bool has_station_guard(Connection& connection);

/// What is missing of it, one line each.
[[nodiscard]] std::vector<std::string> station_guard_problems(Connection& connection);

/// How a refusal of the server itself is said to people; its text is that of the function `need`.
[[nodiscard]] Said guard_refusal();

/// Whether a station lets the server seal an object of this kind: a part of it may be out of its
/// sight, or it is changed before anybody has signed in. Then placode_guard.seal_parts() is asked.
[[nodiscard]] bool server_seals(std::string_view kind);

// db/station_guard_sql.cpp, ..._accounts_sql.cpp, ..._reading_sql.cpp, ..._attempts_sql.cpp,
// others: statements, separated by lines "--".
extern const char* const kGuardTables;
extern const char* const kGuardChecksum;
extern const char* const kGuardIdentity;
extern const char* const kGuardChannel;
extern const char* const kGuardSignIn;
extern const char* const kGuardAccounts;
extern const char* const kGuardScopes;
extern const char* const kGuardAnswers;
extern const char* const kGuardAttempts;
extern const char* const kGuardExams;  // db/station_guard_exams_sql.cpp
extern const char* const kGuardWords;  // db/station_guard_words_sql.cpp

}  // namespace placode::db
