// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// SQLite without Qt, for recording files: made on one thread, used on another, no application
// object needed. Only db/ includes this.

#include <sqlite3.h>

#include <memory>
#include <span>
#include <string>

#include "db/store_error.h"

namespace placode::db {

struct CloseSqlite {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using SqlitePointer = std::unique_ptr<sqlite3, CloseSqlite>;

/// Throws StoreError with the kind that fits SQLite's code: `OPERATION PATH: what SQLite said`.
[[noreturn]] void fail_sqlite(int code, const std::string& operation, const std::string& path,
                              const std::string& advice);

class RawStatement {
 public:
    RawStatement(sqlite3* database, const char* sql);
    RawStatement& bind(const std::string& text);
    RawStatement& bind(int64_t number);
    RawStatement& bind(std::span<const std::byte> bytes);
    int step() { return sqlite3_step(statement_.get()); }  ///< SQLite's code.
    [[nodiscard]] int64_t integer(int column) const;
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::span<const std::byte> bytes(int column) const;
    [[nodiscard]] int prepared() const { return code_; }  ///< SQLITE_OK, or why it could not be.

 private:
    std::unique_ptr<sqlite3_stmt, CloseSqlite> statement_;
    int code_ = SQLITE_OK;
    int place_ = 1;
};

}  // namespace placode::db
