// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The address of a store, taken apart.

#include <cstdint>
#include <string>

namespace placode::db {

enum class Engine : uint8_t { kSqlite, kPostgresql };

struct StoreUrl {
    Engine engine = Engine::kSqlite;
    std::string path;  ///< SQLite; ":memory:" for none.
    std::string host, user, password, name;
    int port = 5432;
    int timeout_ms = 5000;  ///< How long to wait for a lock.
    std::string shown;      ///< For messages: without password and options.
};

/// Throws StoreError(kOther) saying what was found and what is expected.
[[nodiscard]] StoreUrl parse_store_url(const std::string& url);

}  // namespace placode::db
