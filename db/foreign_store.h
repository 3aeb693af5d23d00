// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Files that claim to be stores or backups: whether they hold what Placode makes and nothing else.
// A trigger in a backup would work inside the store once it is restored, a view would answer in the
// place of a table. What Placode makes is what any number of its migrations make, word for word.
// Only db/ includes this.

#include <string>
#include <vector>

#include "db/migrations.h"

namespace placode::db {

class Connection;

/// Before the file is opened as a store: opens it to be read only, runs nothing of it, and reads
/// its schema. Throws StoreError: kDamaged unless it bears the mark of a store and holds tables,
/// indexes and triggers of Placode only (naming the first other object and the way out), kTooNew
/// where a newer Placode made them, kUnavailable or kLocked where it cannot be read.
/// @param operation what is being done, with the names of the files, for the message
/// @param migrations of the store's tables; empty = those of this program
void need_own_schema(const std::string& path, const std::string& operation,
                     const std::vector<EmbeddedSql>& migrations = {});

/// What is wrong with a copy: as need_own_schema(), and then it is read from beginning to end; "" =
/// nothing. Throws nothing for what the file says.
[[nodiscard]] std::string copy_problem(const std::string& path,
                                       const std::vector<EmbeddedSql>& migrations = {});

/// The first object of an open embedded store that Placode did not make, such as `the view "x"`;
/// "" = there is none. Throws StoreError.
[[nodiscard]] std::string foreign_object(Connection& connection,
                                         const std::vector<EmbeddedSql>& migrations);

/// Before the first change of an open embedded store. Throws kDamaged where it holds a trigger, a
/// virtual table or another form of one of Placode's tables: these would act with Placode's own
/// statements. Views (which nothing asks), other tables and indexes of a centre may lie there.
void need_nothing_that_acts(Connection& connection, const std::vector<EmbeddedSql>& migrations);

}  // namespace placode::db
