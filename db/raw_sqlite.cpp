// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/raw_sqlite.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace placode::db {

StoreError::Kind kind_of_sqlite(int code) noexcept {
    using Kind = StoreError::Kind;
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return Kind::kLocked;
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            return Kind::kDamaged;
        case SQLITE_CANTOPEN:
        case SQLITE_READONLY:
        case SQLITE_PERM:
        case SQLITE_FULL:
        case SQLITE_IOERR:
            return Kind::kUnavailable;
        default:
            return Kind::kOther;
    }
}

void fail_sqlite(int code, const std::string& operation, const std::string& path,
                 const std::string& advice) {
    throw StoreError(kind_of_sqlite(code),
                     operation + " " + path + ": " + sqlite3_errstr(code) + "; " + advice);
}

namespace {

constexpr int kStepsBetween = 10'000;

int count_steps(void* left) {
    auto& steps = *static_cast<int64_t*>(left);
    steps -= kStepsBetween;
    return steps < 0 ? 1 : 0;
}

}  // namespace

void distrust_schema(sqlite3* database) noexcept {
    for (const auto& [option, value] : {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1},
                                        {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
                                        {SQLITE_DBCONFIG_ENABLE_VIEW, 0},
                                        {SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0}})
        sqlite3_db_config(database, option, value, nullptr);
}

ForeignDatabase::ForeignDatabase(const std::string& path, const ForeignLimits& limits)
    : steps_left_(std::make_unique<int64_t>(limits.most_steps)) {
    std::error_code ignored;
    const bool journal = std::filesystem::exists(path + "-journal", ignored);
    sqlite3* database = nullptr;
    code_ = sqlite3_open_v2(path.c_str(), &database,
                            journal ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY, nullptr);
    database_.reset(database);
    if (code_ != SQLITE_OK) return;
    distrust_schema(database);
    sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    for (const auto& [limit, value] : {std::pair{SQLITE_LIMIT_LENGTH, limits.longest_value_bytes},
                                       {SQLITE_LIMIT_SQL_LENGTH, limits.longest_sql_bytes},
                                       {SQLITE_LIMIT_EXPR_DEPTH, limits.deepest_expression},
                                       {SQLITE_LIMIT_COMPOUND_SELECT, 2},
                                       {SQLITE_LIMIT_ATTACHED, 0}})
        sqlite3_limit(database, limit, value);
    sqlite3_exec(database, "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
    sqlite3_progress_handler(database, kStepsBetween, count_steps, steps_left_.get());
}

std::string ForeignDatabase::schema_problem() const {
    const RawStatement query(get(), "SELECT 1 FROM sqlite_schema");
    const int code = query.prepared() & 0xff;
    if (code != SQLITE_CORRUPT && code != SQLITE_ERROR && code != SQLITE_TOOBIG) return {};
    // It quotes the file, which may say anything at any length.
    constexpr size_t kMostSaid = 200;
    return std::string(sqlite3_errmsg(get())).substr(0, kMostSaid);
}

std::string ForeignDatabase::other_schema(std::initializer_list<const char*> statements) const {
    RawStatement query(get(), "SELECT type, name, COALESCE(sql, '') FROM sqlite_schema");
    if (query.prepared() != SQLITE_OK) return {};
    int code = query.step();
    for (; code == SQLITE_ROW; code = query.step()) {
        const std::string type = query.text(0), name = query.text(1), sql = query.text(2);
        // What SQLite makes for a PRIMARY KEY has no statement.
        if (type == "index" && sql.empty() && name.starts_with("sqlite_autoindex_")) continue;
        if (std::find(statements.begin(), statements.end(), sql) == statements.end())
            return "the " + type.substr(0, 20) + " \"" + name.substr(0, 60) + "\"";
    }
    return {};
}

RawStatement::RawStatement(sqlite3* database, const char* sql) {
    sqlite3_stmt* statement = nullptr;
    code_ = sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
    statement_.reset(statement);
}

RawStatement& RawStatement::bind(const std::string& text) {
    sqlite3_bind_text64(statement_.get(), place_++, text.data(), text.size(), SQLITE_TRANSIENT,
                        SQLITE_UTF8);
    return *this;
}

RawStatement& RawStatement::bind(int64_t number) {
    sqlite3_bind_int64(statement_.get(), place_++, number);
    return *this;
}

RawStatement& RawStatement::bind(std::span<const std::byte> bytes) {
    sqlite3_bind_blob64(statement_.get(), place_++, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
    return *this;
}

int64_t RawStatement::integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

std::string RawStatement::text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return text == nullptr ? std::string() : std::string(text, static_cast<size_t>(size));
}

std::span<const std::byte> RawStatement::bytes(int column) const {
    const auto* bytes =
        static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return {bytes, static_cast<size_t>(bytes == nullptr ? 0 : size)};
}

}  // namespace placode::db
