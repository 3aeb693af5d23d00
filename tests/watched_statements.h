// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a store asks its engine: counted, and how it is looked up. Nothing is timed.

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <string>
#include <vector>

struct sqlite3_api_routines;

namespace placode::test {

/// Every statement that SQLite runs in this program, of connections that are opened while this
/// lives. One at a time.
class WatchedStatements {
 public:
    WatchedStatements() {
        current() = this;
        sqlite3_auto_extension(reinterpret_cast<void (*)()>(&opened));
    }
    ~WatchedStatements() {
        sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(&opened));
        current() = nullptr;
    }
    WatchedStatements(const WatchedStatements&) = delete;
    WatchedStatements& operator=(const WatchedStatements&) = delete;

    void forget() { all_.clear(); }
    [[nodiscard]] const std::vector<std::string>& all() const { return all_; }
    /// Those with this text in them.
    [[nodiscard]] std::vector<std::string> with(const std::string& text) const {
        std::vector<std::string> found;
        for (const std::string& each : all_)
            if (each.find(text) != std::string::npos) found.push_back(each);
        return found;
    }

 private:
    static WatchedStatements*& current() {
        static WatchedStatements* one = nullptr;
        return one;
    }
    static int opened(sqlite3* database, char** /*problem*/, const sqlite3_api_routines* /*api*/) {
        return sqlite3_trace_v2(database, SQLITE_TRACE_STMT, &asked, nullptr);
    }
    static int asked(unsigned /*event*/, void* /*context*/, void* statement, void* text) {
        const std::string said = static_cast<const char*>(text);
        // What a trigger does is given as a remark.
        if (current() != nullptr && !said.starts_with("--"))
            current()->all_.emplace_back(sqlite3_sql(static_cast<sqlite3_stmt*>(statement)));
        return 0;
    }

    std::vector<std::string> all_;
};

/// How SQLite looks up what a statement asks for, a line for each step.
inline std::string plan_of(const std::string& path, const std::string& statement) {
    sqlite3* database = nullptr;
    sqlite3_stmt* row = nullptr;
    std::string plan;
    if (sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY, nullptr) != SQLITE_OK ||
        sqlite3_prepare_v2(database, ("EXPLAIN QUERY PLAN " + statement).c_str(), -1, &row,
                           nullptr) != SQLITE_OK)
        ADD_FAILURE() << statement << ": " << sqlite3_errmsg(database);
    constexpr int kDetail = 3;
    while (row != nullptr && sqlite3_step(row) == SQLITE_ROW)
        plan +=
            std::string(reinterpret_cast<const char*>(sqlite3_column_text(row, kDetail))) + "\n";
    sqlite3_finalize(row);
    sqlite3_close(database);
    return plan;
}

}  // namespace placode::test
