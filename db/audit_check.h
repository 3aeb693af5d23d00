// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether the audit trail is whole, and the store what the trail says. Only db/ includes this.

#include <set>
#include <string>
#include <vector>

namespace placode::db {

struct StoreContext;

/// Public keys of the stations that may sign: the one that began, this one, and whom one of them
/// trusted, and so on.
[[nodiscard]] std::set<std::string> trusted_stations(StoreContext& context);

/// Adds to `problems`, each naming the entry or the object: an entry that was edited, removed or
/// put between others; one without a signature, or by a station that nobody trusts; a trail that
/// ends before what this computer wrote; an object that was edited, added or removed without the
/// program. In one snapshot: what others write meanwhile is not seen. Throws StoreError.
void check_trail(StoreContext& context, std::vector<std::string>& problems);

}  // namespace placode::db
