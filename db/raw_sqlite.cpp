// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/raw_sqlite.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace placode::db {

void fail_sqlite(int code, const std::string& operation, const std::string& path,
                 const std::string& advice) {
    using Kind = StoreError::Kind;
    Kind kind = Kind::kOther;
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            kind = Kind::kLocked;
            break;
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            kind = Kind::kDamaged;
            break;
        case SQLITE_CANTOPEN:
        case SQLITE_READONLY:
        case SQLITE_PERM:
        case SQLITE_FULL:
        case SQLITE_IOERR:
            kind = Kind::kUnavailable;
            break;
        default:
            break;
    }
    throw StoreError(kind, operation + " " + path + ": " + sqlite3_errstr(code) + "; " + advice);
}

namespace {

constexpr int kStepsBetween = 10'000;
// A recording of an hour takes a few million; a question without an end is over in two seconds.
constexpr int64_t kMostSteps = 100'000'000;
constexpr int kLongestValue = 80 << 20, kLongestSql = 4096, kDeepest = 20;

int count_steps(void* left) {
    auto& steps = *static_cast<int64_t*>(left);
    steps -= kStepsBetween;
    return steps < 0 ? 1 : 0;
}

}  // namespace

ForeignDatabase::ForeignDatabase(const std::string& path)
    : steps_left_(std::make_unique<int64_t>(kMostSteps)) {
    std::error_code ignored;
    const bool journal = std::filesystem::exists(path + "-journal", ignored);
    sqlite3* database = nullptr;
    code_ = sqlite3_open_v2(path.c_str(), &database,
                            journal ? SQLITE_OPEN_READWRITE : SQLITE_OPEN_READONLY, nullptr);
    database_.reset(database);
    if (code_ != SQLITE_OK) return;
    for (const auto& [option, value] : {std::pair{SQLITE_DBCONFIG_DEFENSIVE, 1},
                                        {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
                                        {SQLITE_DBCONFIG_ENABLE_VIEW, 0},
                                        {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},
                                        {SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0}})
        sqlite3_db_config(database, option, value, nullptr);
    for (const auto& [limit, value] : {std::pair{SQLITE_LIMIT_LENGTH, kLongestValue},
                                       {SQLITE_LIMIT_SQL_LENGTH, kLongestSql},
                                       {SQLITE_LIMIT_EXPR_DEPTH, kDeepest},
                                       {SQLITE_LIMIT_COMPOUND_SELECT, 2},
                                       {SQLITE_LIMIT_ATTACHED, 0}})
        sqlite3_limit(database, limit, value);
    sqlite3_exec(database, "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
    sqlite3_progress_handler(database, kStepsBetween, count_steps, steps_left_.get());
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
