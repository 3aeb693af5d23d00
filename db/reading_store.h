// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A store that is opened for one account and can be read only: for programs that show it to people
// who sit elsewhere.

#include <cstdint>
#include <memory>
#include <string>

#include "db/store.h"

namespace placode::db {

/// As open_store() and Store::act_for(), but nothing can be changed through it: the engine refuses
/// every statement that writes (`PRAGMA query_only`, `default_transaction_read_only`), and no
/// transaction begins, because the store begins one only in order to write. Makes and migrates
/// nothing: a store that is not there is kMissing, one whose tables are older than this program
/// kOther, newer ones kTooNew.
/// @param account_id for whom it works; it may read what the table of db/access.h says.
[[nodiscard]] std::unique_ptr<Store> open_for_reading(const std::string& url, int64_t account_id,
                                                      const StoreOptions& options = {});

}  // namespace placode::db
