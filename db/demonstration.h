// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Demonstration accounts: for looking around, marked as such everywhere, with a password that is
// no secret.

#include <algorithm>
#include <vector>

#include "db/records.h"

namespace placode::db {

/// Of every demonstration account that the program makes.
inline constexpr const char* kDemonstrationPassword = "placode-demo";

/// Whether the store was made to be looked at: it has people, and all are demonstration accounts.
[[nodiscard]] inline bool is_demonstration_store(const std::vector<UserRecord>& users) {
    return !users.empty() && std::all_of(users.begin(), users.end(),
                                         [](const UserRecord& each) { return each.demonstration; });
}

}  // namespace placode::db
