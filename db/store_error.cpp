// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_error.h"

#include "db/said.h"

namespace placode::db {

StoreError::StoreError(Kind kind, const std::string& before, const Said& said)
    : std::runtime_error(before + said.english()),
      kind_(kind),
      said_(std::make_shared<const Said>(said)) {}

}  // namespace placode::db
