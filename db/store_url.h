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
    std::string path;                        ///< SQLite; ":memory:" for none.
    std::string host, user, password, name;  ///< A host with '/' is the folder of a Unix socket.
    int port = 5432;
    /// libpq's: verify-full, verify-ca, require, prefer or disable. Unless the address says it,
    /// verify-full, and prefer for a server on this computer.
    std::string sslmode;
    std::string sslrootcert;  ///< File with who may vouch for the server; empty = libpq's own.
    int timeout_ms = 5000;    ///< How long to wait for a lock.
    std::string shown;        ///< For messages: without password and options.
};

/// "sqlite:PATH" or "postgresql://USER@HOST:PORT/NAME", with options behind '?', joined by '&':
/// timeout_ms (5000), and of a server sslmode, sslrootcert and host (folder of a Unix socket).
/// Throws StoreError(kOther) saying what was found and what is expected.
[[nodiscard]] StoreUrl parse_store_url(const std::string& url);

/// True for a store that is a file.
[[nodiscard]] inline bool is_store_file(const StoreUrl& url) {
    return url.engine == Engine::kSqlite && url.path != ":memory:";
}

/// What libpq is told beside the address, joined by ';': who has to prove what, and how long a
/// server that went away without a word is waited for (10 s).
[[nodiscard]] std::string connect_options(const StoreUrl& url);

/// True where whoever opens this has to be asked for a password first: a server, and neither the
/// address nor $PGPASSWORD nor a password file ($PGPASSFILE, ~/.pgpass) has one for it.
[[nodiscard]] bool needs_password(const StoreUrl& url);

/// The same address with a password in it, for this process only.
[[nodiscard]] std::string with_password(const std::string& url, const std::string& password);

}  // namespace placode::db
