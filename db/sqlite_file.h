// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What only an embedded store has: a file that can be missing, foreign, damaged or copied.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "db/sql_connection.h"

namespace placode::db {

/// "PLCD" in the file's header says that it is a Placode store.
inline constexpr int kStoreApplicationId = 0x504c4344;

/// Creates the folder of `path` (0700), and those above it, when missing. Throws StoreError.
void prepare_sqlite_folder(const std::string& path, const std::string& operation);

/// Before opening: creates folder (0700) and file (0600) when missing; throws StoreError(kDamaged)
/// without touching a file that is no SQLite database or is shorter than it says.
void prepare_sqlite_file(const std::string& path, const std::string& operation);

/// The mark beside a store that has accounts: without it a file that is gone would be a first
/// start, and whoever comes first would become administrator.
[[nodiscard]] std::string mark_of_store(const std::string& path);
/// Writes the mark if it is not there. A folder that cannot be written has no mark.
void mark_store(const std::string& path) noexcept;
/// Throws StoreError(kMissing) when `known` or the mark says that there was a store and the file is
/// gone or empty.
void need_known_store(const std::string& path, bool known, const std::string& operation);

/// After opening: refuses another program's database; sets application id and write-ahead log.
void claim_sqlite_file(Connection& connection);

/// First problem that SQLite's integrity check finds, or "".
[[nodiscard]] std::string sqlite_integrity_problem(Connection& connection);

/// While it lives, a statement on a file ends with an error soon after `stop` said so, which a
/// thread of its own asks: what SQLite asks between its steps, as sqlite3_progress_handler, is not
/// asked in the long one of an integrity check (3.40). Not over the end of a transaction, which
/// must not be stopped. On a server it does nothing.
class InterruptOn {
 public:
    InterruptOn(Connection& connection, std::function<bool()> stop);
    ~InterruptOn();  ///< Has asked at least once.
    InterruptOn(const InterruptOn&) = delete;
    InterruptOn& operator=(const InterruptOn&) = delete;

    [[nodiscard]] bool stopped() const noexcept { return stopped_; }

 private:
    std::function<bool()> stop_;
    std::atomic<bool> stopped_{false};
    std::mutex mutex_;
    std::condition_variable ended_;
    bool over_ = false;
    std::thread asks_;
};

/// Behind the name of a copy: it is being written; it did not pass its check. Behind that of a
/// store: a backup that is about to take its place.
inline constexpr const char *kPartSuffix = ".part", *kFailedSuffix = ".failed",
                            *kRestoringSuffix = ".restoring";

/// The file and what SQLite keeps beside it: a journal that a killed program left would be taken
/// for that of the next file of this name. Throws std::filesystem::filesystem_error.
void remove_sqlite_file(const std::string& path);
/// The same as far as it can be done, after something else has failed.
void forget_sqlite_file(const std::string& path) noexcept;

/// After the last connection to a file was closed, which folds the log into it and says nothing
/// when the disk fails: throws StoreError(kUnavailable) while a log with what the file lacks lies
/// beside it. To be asked before the file gets another name.
void need_folded_log(const std::string& path, const std::string& operation);

/// A consistent copy (0600), while others may read and write, on the disk when it returns. Throws
/// StoreError when `path` exists.
void copy_sqlite_store(Connection& connection, const std::string& path);

}  // namespace placode::db
