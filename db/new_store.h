// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A new embedded store is made beside its place and gets its name when it is whole: a full disk or
// a kill on the way leaves nothing that the next start would call damaged.

#include <string>
#include <vector>

#include "db/migrations.h"
#include "db/store_url.h"

namespace placode::db {

/// Behind the name of a store that is being made. What a kill has left there goes the next time: it
/// never was a store, and nobody had the name to write into it.
inline constexpr const char* kMakingSuffix = ".making";

/// Does nothing where there is a file, also an empty one, or where the folder lets nobody make one
/// beside: the store is then made in its place. Several programs may call it at once. Throws
/// StoreError.
void make_store_file(const StoreUrl& url, const std::vector<EmbeddedSql>& migrations,
                     const std::string& operation);

}  // namespace placode::db
