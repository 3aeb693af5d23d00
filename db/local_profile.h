// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "db/said.h"

namespace placode::db {

/// Why nothing that needs passwords happens to the store of a local profile (accounts.h).
[[nodiscard]] inline Said one_persons_store() {
    return Said::that(
        "this store is one person's without a password; make an account of that profile first");
}

}  // namespace placode::db
