// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where copies of a store are: backups, which its audit trail names, and the files that updates,
// restores and moves keep beside it.

#include <string>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// A copy that may still hold who was erased.
struct LeftCopy {
    std::string path, why;
};

/// Files with copies of the embedded store at `url` that are there now: beside it, and backups that
/// its trail names. Of a server: none.
[[nodiscard]] std::vector<std::string> copies_of(Store& store, const std::string& url);

/// Copies that may still hold the records of a participant who was just erased in the embedded
/// store at `url`: nothing goes through them, and a restore of one erases again (db/ended_again.h).
/// Opens the file by itself, because whoever may erase such records may not read where backups lie.
/// Of a server: none. Throws nothing but for an address that cannot be read.
[[nodiscard]] std::vector<LeftCopy> copies_with_records(const std::string& url);

/// What the updates of a file kept of it, as it was before each.
[[nodiscard]] std::vector<std::string> kept_by_updates(const std::string& path);

/// What nothing goes through: backups that did not pass their check or whose place is unknown, and
/// where the store has been. @param gone of backups that are not where they were made, sorted
[[nodiscard]] std::vector<LeftCopy> out_of_reach(Store& store, const std::string& url,
                                                 std::vector<std::string>& gone);

/// Removes what a backup or restore that was killed has left: no use to anybody, and it may hold
/// the person.
void remove_half_made(Store& store, const std::string& url);

}  // namespace placode::db
