// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a store needs before this program works with it. Only db/*.cpp include this.

namespace placode::db {

struct StoreContext;

/// The tables of this program, in a store that may be new or older: an older embedded one is
/// checked and copied first, and sealed afterwards where it is from before there were seals. Tells
/// StoreOptions::updating. Throws StoreError: kOlder where StoreOptions::leave_older asks for it,
/// else as migrate() (db/schema.h).
void bring_up_to_date(StoreContext& context);

}  // namespace placode::db
