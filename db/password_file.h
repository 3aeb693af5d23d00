// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The file of passwords that PostgreSQL's own library reads (PostgreSQL manual, "The Password
// File"): a line host:port:database:user:password for each, `*` for any, `\` before `:` and `\`.

#include <string>

#include "db/store_url.h"

namespace placode::db {

/// Whether the file has a line for this server. One that others may read does not count, as the
/// library passes it by; nor does one that cannot be read.
[[nodiscard]] bool password_file_has(const std::string& path, const StoreUrl& url);

}  // namespace placode::db
