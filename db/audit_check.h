// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether the audit trail is whole, and the store what the trail says. Only db/ includes this.

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "db/store_check.h"

namespace placode::db {

struct StoreContext;

/// Public keys of the stations that the trail itself vouches for: the one that began, whom it
/// trusted, and so on.
[[nodiscard]] std::set<std::string> registered_stations(StoreContext& context);

/// Public keys of the stations that may sign: the one that began, this one where the store is a
/// file, and whom one of them trusted, and so on. What is said of a station counts where its entry
/// is proved by chain and signature.
[[nodiscard]] std::set<std::string> trusted_stations(StoreContext& context);

/// Whether the station of this key is one of them, so that what it recorded counts. A file's first
/// computer, which has no key yet, gets its own on the way.
[[nodiscard]] bool is_trusted_station(StoreContext& context, const std::string& key);

/// Checksum of an entry that does not fit the trail; empty for one that does, or is not there.
[[nodiscard]] std::string entry_to_set_aside(StoreContext& context, int64_t entry);

/// Adds to `problems`, each naming the entry or the object: an entry that was edited, removed or
/// put between others; one without a signature, or by a station that nobody trusts; a trail that
/// ends before what this computer wrote; an object that was edited, added or removed without the
/// program. One that does not fit is named, its word is not taken, and the others are looked at
/// all the same; one that was set aside is not named any more. In one snapshot: what others write
/// meanwhile is not seen. Throws StoreError.
void check_trail(StoreContext& context, std::vector<std::string>& problems, const CheckPace& pace);

}  // namespace placode::db
