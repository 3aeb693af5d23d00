// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/held_store.h"

#include <filesystem>

#include "db/durable_file.h"
#include "db/sqlite_file.h"

namespace placode::db {

namespace fs = std::filesystem;

HeldStore::HeldStore(const StoreUrl& url, const std::string& operation) {
    sqlite3* database = nullptr;
    int code = sqlite3_open_v2(url.path.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
    database_.reset(database);
    sqlite3_busy_timeout(database, url.timeout_ms);
    // From the first access on and until it is closed. Leaving the write-ahead log is allowed only
    // to the one program that has the file open.
    for (const char* sql :
         {"PRAGMA locking_mode = EXCLUSIVE", "PRAGMA journal_mode = DELETE", "BEGIN EXCLUSIVE"})
        if (code == SQLITE_OK) code = sqlite3_exec(database, sql, nullptr, nullptr, nullptr);
    if ((code & 0xff) == SQLITE_BUSY || (code & 0xff) == SQLITE_LOCKED)
        throw StoreError(StoreError::Kind::kLocked,
                         operation + ": another program uses the store; close it and try again");
}

bool is_marked_as_store(const std::string& path) {
    sqlite3* database = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
    const SqlitePointer owner(database);
    if (code != SQLITE_OK) return false;
    RawStatement query(database, "PRAGMA application_id");
    return query.prepared() == SQLITE_OK && query.step() == SQLITE_ROW &&
           query.integer(0) == kStoreApplicationId;
}

void put_log_aside(const std::string& path, const std::string& aside) {
    if (fs::exists(path + "-wal")) {
        fs::copy_file(path + "-wal", aside + "-wal");
        sync_file(aside + "-wal");
        sync_folder_of(aside);
        fs::remove(path + "-wal");
    }
    fs::remove(path + "-shm");
    sync_folder_of(path);
}

}  // namespace placode::db
