// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether a disk has room for a copy of a store, asked before anything is written. Only db/
// includes this.

#include <string>

namespace placode::db {

struct StoreContext;

/// Throws StoreError(kRefused) where the disk of `path` has less room than a copy of the store
/// takes and a reserve: the store itself may lie on that disk, and has to go on. Of a folder that
/// is not there it says nothing.
void need_room_for_copy(StoreContext& context, const std::string& path);

}  // namespace placode::db
