// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A copy of an embedded store is called one when it was opened and read. Only db/*.cpp include
// this.

#include <functional>
#include <string>

namespace placode::db {

struct StoreContext;

/// A copy counts once it was opened and read; one that does not pass stays as PATH.failed. Throws
/// StoreError: kDamaged for such a one, kUnavailable where it cannot be written.
/// @param deeper what else may be wrong with it; "" = nothing.
void keep_checked_copy(StoreContext& context, const std::string& path,
                       const std::function<std::string(const std::string&)>& deeper = {});

}  // namespace placode::db
