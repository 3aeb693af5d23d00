// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/raw_sqlite.h"

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
