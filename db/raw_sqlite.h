// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// SQLite without Qt: for recording files, made on one thread and used on another, where no
// application object is needed, and for files that anybody may have made. Only db/ includes this.

#include <sqlite3.h>

#include <initializer_list>
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

/// What kind of failure SQLite's code is.
[[nodiscard]] StoreError::Kind kind_of_sqlite(int code) noexcept;

/// Throws StoreError with the kind that fits SQLite's code: `OPERATION PATH: what SQLite said`.
[[noreturn]] void fail_sqlite(int code, const std::string& operation, const std::string& path,
                              const std::string& advice);

/// Nothing that a schema brings along runs by itself or speaks for a table: no views, no functions
/// but SQLite's harmless ones, no writing past SQL. Triggers stay: a store has its own.
void distrust_schema(sqlite3* database) noexcept;

/// What a file from outside may ask for at most. The defaults are a recording's.
struct ForeignLimits {
    int longest_value_bytes = 80 << 20;
    int longest_sql_bytes = 4096;
    int deepest_expression = 20;
    /// Of SQLite's machine, for all questions together. A recording of an hour takes a few million;
    /// a question without an end is over in two seconds.
    int64_t most_steps = 100'000'000;
};

/// A file that anybody may have made, opened to be read: no views, no triggers, no functions of its
/// own, and an end to every question. It is written to only where a killed writer's journal lies
/// beside it, which is rolled back first.
class ForeignDatabase {
 public:
    explicit ForeignDatabase(const std::string& path, const ForeignLimits& limits = {});
    [[nodiscard]] int code() const { return code_; }  ///< SQLITE_OK, or why it cannot be opened.
    [[nodiscard]] sqlite3* get() const { return database_.get(); }
    /// What SQLite says against the schema itself, such as an expression that is too deep; "" where
    /// it can be read, or is not read for another reason, such as a lock.
    [[nodiscard]] std::string schema_problem() const;
    /// Empty when its schema is exactly these statements, else what it holds beside them. A schema
    /// that cannot be read is empty, too: whatever is asked next fails with the reason.
    [[nodiscard]] std::string other_schema(std::initializer_list<const char*> statements) const;

 private:
    std::unique_ptr<int64_t> steps_left_;  ///< Before the database, whose handler counts them.
    SqlitePointer database_;
    int code_ = SQLITE_OK;
};

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
