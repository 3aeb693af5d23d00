// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A backup of a store on a server: PostgreSQL's own pg_dump, and a look into what it wrote.

#include <string>

#include "db/trail_head.h"

namespace placode::db {

struct StoreContext;

/// Dumps the database in pg_dump's custom format into `path`, durably, readable by this account
/// only, and reads the file again: it has to hold as many rows of every table as the database had
/// at that moment. One that does not is kept as PATH.failed. Who has signed in is left out.
/// Needs the log-in of the tables' owner, to whom row-level security shows all rows.
/// @return the trail's end at that moment, not yet signed.
/// Throws StoreError: kRefused for another log-in, kUnavailable without pg_dump or where it fails,
/// kDamaged for a dump that is not whole.
[[nodiscard]] TrailHead dump_store(StoreContext& context, const std::string& path);

/// Role that owns the tables of a server's store; any log-in may ask.
[[nodiscard]] std::string owner_of_tables(StoreContext& context);
/// Throws kRefused for another log-in than that.
void need_owner_of_tables(StoreContext& context);

}  // namespace placode::db
