// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The file of an embedded store whose place another one takes. Only db/ includes this.

#include <string>

#include "db/raw_sqlite.h"
#include "db/store_url.h"

namespace placode::db {

/// Keeps every other program out of the store while its file is exchanged, and folds its log into
/// it. A damaged file cannot be held: it may be put aside all the same. Throws kLocked.
class HeldStore {
 public:
    HeldStore(const StoreUrl& url, const std::string& operation);

 private:
    SqlitePointer database_;
};

/// An empty file would open as a new store: a store is told by its mark before it is opened as one.
[[nodiscard]] bool is_marked_as_store(const std::string& path);

/// The log of a damaged store, which nobody could fold into it: beside the new file it would be
/// taken for its own. Its copy is whole before it goes.
void put_log_aside(const std::string& path, const std::string& aside);

}  // namespace placode::db
