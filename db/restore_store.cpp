// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A backup takes the place of an embedded store. At every moment there is one whole store.

#include <sqlite3.h>

#include <QDateTime>
#include <array>
#include <filesystem>

#include "db/raw_sqlite.h"
#include "db/sqlite_file.h"
#include "db/store.h"
#include "db/store_url.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;
using Kind = StoreError::Kind;

constexpr std::array<const char*, 3> kSuffixes{"", "-wal", "-shm"};

// Leaving the write-ahead log is allowed only to the one program that has the file open.
bool nobody_else_uses(const std::string& path, int timeout_ms) {
    sqlite3* database = nullptr;
    int code = sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
    if (code == SQLITE_OK) {
        sqlite3_busy_timeout(database, timeout_ms);
        code = sqlite3_exec(database, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
    }
    sqlite3_close(database);
    // A damaged file answers with other codes: it may be put aside.
    return (code & 0xff) != SQLITE_BUSY && (code & 0xff) != SQLITE_LOCKED;
}

// An empty file would open as a new store: a backup is told by its mark before it is opened as one.
bool is_marked_as_store(const std::string& path) {
    sqlite3* database = nullptr;
    const int code = sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY, nullptr);
    const SqlitePointer owner(database);
    if (code != SQLITE_OK) return false;
    RawStatement query(database, "PRAGMA application_id");
    return query.prepared() == SQLITE_OK && query.step() == SQLITE_ROW &&
           query.integer(0) == kStoreApplicationId;
}

void prove(const std::string& copy, const std::string& backup_path, const std::string& operation,
           const std::string& actor) {
    if (!is_marked_as_store(copy))
        throw StoreError(Kind::kDamaged,
                         operation + ": the file is not a backup of a store; nothing was changed");
    const auto store = open_store("sqlite:" + copy);
    const auto problems = store->check();
    if (!problems.empty())
        throw StoreError(Kind::kDamaged, operation + ": the backup is damaged (" +
                                             problems.front() + "); nothing was changed");
    store->audit().write(actor, "store.restore", backup_path, "");
}

}  // namespace

std::string restore_store(const std::string& url, const std::string& backup_path,
                          const std::string& actor) {
    const StoreUrl target = parse_store_url(url);
    const std::string operation = "restore " + backup_path + " to " + target.shown;
    if (target.engine != Engine::kSqlite || target.path == ":memory:")
        throw StoreError(Kind::kRefused, operation +
                                             ": only an embedded store is restored from a file; "
                                             "use pg_restore on the server");
    if (!fs::is_regular_file(backup_path))
        throw StoreError(Kind::kNotFound, operation + ": there is no such backup");
    // 1. The backup is proved on a copy, which becomes the new store: it stays as it is itself.
    const std::string fresh = target.path + ".restoring";
    const auto forget = [&fresh] {
        for (const char* suffix : kSuffixes) fs::remove(fresh + suffix);
    };
    std::string aside;
    try {
        forget();
        prepare_sqlite_file(fresh, operation);  // Folder, and file with mode 0600.
        fs::copy_file(backup_path, fresh, fs::copy_options::overwrite_existing);
        fs::permissions(fresh, fs::perms::owner_read | fs::perms::owner_write);
        prove(fresh, backup_path, operation, actor);
        // 2. The old store steps aside, whole, with its log if it has one.
        if (fs::exists(target.path)) {
            if (!nobody_else_uses(target.path, target.timeout_ms))
                throw StoreError(Kind::kLocked,
                                 operation +
                                     ": another program uses the store; close it and try "
                                     "again");
            aside =
                target.path + ".replaced-" +
                QDateTime::currentDateTimeUtc().toString("yyyyMMdd'T'HHmmsszzz'Z'").toStdString();
            for (const char* suffix : kSuffixes)
                if (fs::exists(target.path + suffix))
                    fs::rename(target.path + suffix, aside + suffix);
        }
        // 3. The new one takes its place. prove() has closed it: it is one file.
        fs::rename(fresh, target.path);
    } catch (const fs::filesystem_error& error) {
        forget();
        throw StoreError(Kind::kUnavailable, operation + ": " + error.what());
    } catch (...) {
        forget();
        throw;
    }
    return aside;
}

}  // namespace placode::db
