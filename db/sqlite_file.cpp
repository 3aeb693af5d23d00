// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/sqlite_file.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "db/durable_file.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;
using Kind = StoreError::Kind;

constexpr const char* kRestore =
    "; leave it as it is and restore a backup with `placodectl restore FILE`";

[[noreturn]] void fail(Kind kind, const std::string& operation, const std::string& path,
                       const std::string& problem) {
    throw StoreError(kind, operation + " sqlite:" + path + ": " + problem);
}

void try_sync_folder_of(const fs::path& path) noexcept {
    try {
        sync_folder_of(path.string());
    } catch (const std::exception&) {
        // A folder that may be searched and not read; what is written tells of a disk that fails.
    }
}

void create_folders(const fs::path& folder, const std::string& operation, const std::string& path) {
    if (folder.empty() || fs::exists(folder)) return;
    create_folders(folder.parent_path(), operation, path);
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
        fail(Kind::kUnavailable, operation, path,
             "cannot create the folder " + folder.string() + " (" + std::strerror(errno) +
                 "); choose another place with --store");
    // Its name is in the folder above, and with it the way to all that will be written there.
    try_sync_folder_of(folder);
}

// Reads the first bytes through SQLite's own file layer: opening and closing the file any other way
// would drop the locks that this process holds on it (https://www.sqlite.org/howtocorrupt.html).
// Returns the number of bytes read, -1 when the file cannot be opened.
int read_header(const std::string& path, std::array<unsigned char, 100>& header, int64_t& size) {
    sqlite3* database = nullptr;
    int got = -1;
    if (sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK) {
        sqlite3_file* file = nullptr;
        sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, &file);
        sqlite3_int64 bytes = 0;
        if (file != nullptr && file->pMethods != nullptr &&
            file->pMethods->xFileSize(file, &bytes) == SQLITE_OK) {
            got = static_cast<int>(std::min<sqlite3_int64>(bytes, header.size()));
            // The size again after the header: a program that writes now makes the file longer.
            if (got > 0 && (file->pMethods->xRead(file, header.data(), got, 0) != SQLITE_OK ||
                            file->pMethods->xFileSize(file, &bytes) != SQLITE_OK))
                got = -1;
            size = bytes;
        }
    }
    sqlite3_close(database);
    return got;
}

// Layout of the first page: https://www.sqlite.org/fileformat2.html#the_database_header
void check_header(const std::string& path, const std::string& operation) {
    std::array<unsigned char, 100> header{};
    int64_t size = 0;
    const int got = read_header(path, header, size);
    if (got < 0)
        fail(Kind::kUnavailable, operation, path,
             "cannot be read; check that folder and file may be read by you");
    if (got == 0) return;  // Just created, perhaps by a program that is about to fill it.
    if (got < static_cast<int>(header.size()) ||
        std::memcmp(header.data(), "SQLite format 3", 16) != 0)
        fail(Kind::kDamaged, operation, path, std::string("the file is not a database") + kRestore);
    const auto big_endian = [&](int at) {
        return (uint64_t{header[at]} << 24) | (uint64_t{header[at + 1]} << 16) |
               (uint64_t{header[at + 2]} << 8) | uint64_t{header[at + 3]};
    };
    int64_t page = (int64_t{header[16]} << 8) | header[17];
    if (page == 1) page = 65536;
    const auto pages = static_cast<int64_t>(big_endian(28));
    // The page count is valid only when both change counters agree; pages may still be in the log.
    const bool count_is_valid = big_endian(24) == big_endian(92);
    if (count_is_valid && !fs::exists(path + "-wal") && size < page * pages)
        fail(Kind::kDamaged, operation, path,
             "the file is cut short: " + std::to_string(size) + " of " +
                 std::to_string(page * pages) + " bytes" + kRestore);
}

constexpr const char* kMarkText =
    "Beside this file lies a store of Placode. If the store is missing, Placode says so instead "
    "of\n"
    "beginning anew, when whoever comes first would become administrator.\n";

// A program that waited while a backup was put in place holds the old file: under another name, and
// its log would be taken for the new file's.
bool has_moved(Connection& connection) {
    int moved = 0;
    sqlite3_file_control(connection.sqlite_handle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    return moved != 0;
}

int64_t pragma(Connection& connection, const std::string& name) {
    Statement query(connection, "PRAGMA " + name);
    query.run();
    return query.next() ? query.integer(0) : 0;
}

}  // namespace

void prepare_sqlite_folder(const std::string& path, const std::string& operation) {
    create_folders(fs::path(path).parent_path(), operation, path);
}

void prepare_sqlite_file(const std::string& path, const std::string& operation) {
    if (path == ":memory:") return;
    prepare_sqlite_folder(path, operation);
    if (fs::is_directory(path)) fail(Kind::kUnavailable, operation, path, "this is a folder");
    const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0) {
        ::close(file);
        return;
    }
    if (errno != EEXIST)
        fail(Kind::kUnavailable, operation, path,
             std::string("cannot create the file (") + std::strerror(errno) +
                 "); choose another place with --store");
    check_header(path, operation);
}

std::string mark_of_store(const std::string& path) { return path + ".known"; }

void mark_store(const std::string& path) noexcept {
    if (path == ":memory:") return;
    const int file =
        ::open(mark_of_store(path).c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0) return;  // It is there, or nobody may write here.
    // The name counts; the text is for people.
    [[maybe_unused]] const ssize_t written = ::write(file, kMarkText, std::strlen(kMarkText));
    ::fsync(file);
    ::close(file);
    try_sync_folder_of(mark_of_store(path));
}

void need_known_store(const std::string& path, bool known, const std::string& operation) {
    if (path == ":memory:") return;
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && status.st_size > 0) return;
    if (known || ::access(mark_of_store(path).c_str(), F_OK) == 0)
        fail(Kind::kMissing, operation, path,
             "the store that was here is gone; restore a backup with `placodectl restore FILE`, "
             "give its new place with --store, or begin anew with `placodectl user add LOGIN "
             "--begin-anew`");
}

void claim_sqlite_file(Connection& connection) {
    // The schema first: a program that fills the file at this moment has written its id before.
    const bool filled = pragma(connection, "schema_version") != 0;
    if (has_moved(connection))
        connection.fail(Kind::kLocked, "another program has just replaced the store; try again");
    const int64_t id = pragma(connection, "application_id");
    if (id != kStoreApplicationId) {
        if (id != 0 || filled)
            connection.fail(Kind::kDamaged,
                            "this is the database of another program, not a Placode store; give "
                            "the right file with --store");
        connection.execute("PRAGMA application_id = " + std::to_string(kStoreApplicationId));
    }
    // Changing the journal needs the file alone and does not wait for it by itself.
    const auto give_up =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(connection.url().timeout_ms);
    for (;;) {
        try {
            connection.execute("PRAGMA journal_mode = WAL");
            return;
        } catch (const StoreError& error) {
            if (error.kind() != Kind::kLocked || std::chrono::steady_clock::now() > give_up) throw;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

std::string sqlite_integrity_problem(Connection& connection) {
    Statement query(connection, "PRAGMA integrity_check(1)");
    query.run();
    const std::string answer = query.next() ? query.text(0) : "no answer";
    return answer == "ok" ? "" : answer;
}

InterruptOn::InterruptOn(Connection& connection, std::function<bool()> stop)
    : stop_(std::move(stop)) {
    sqlite3* const file = connection.sqlite_handle();
    if (file == nullptr || !stop_) return;
    asks_ = std::thread([this, file] {
        constexpr std::chrono::milliseconds kBetween{50};
        std::unique_lock lock(mutex_);
        do {
            if (!stop_()) continue;
            stopped_ = true;
            sqlite3_interrupt(file);  // The statement that runs now; the next one next time.
        } while (!ended_.wait_for(lock, kBetween, [this] { return over_; }));
    });
}

InterruptOn::~InterruptOn() {
    if (!asks_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    ended_.notify_one();
    asks_.join();
}

constexpr std::array<const char*, 4> kFilesOfSqlite{"", "-wal", "-shm", "-journal"};

void remove_sqlite_file(const std::string& path) {
    for (const char* suffix : kFilesOfSqlite) fs::remove(path + suffix);
}

void forget_sqlite_file(const std::string& path) noexcept {
    for (const char* suffix : kFilesOfSqlite) ::unlink((path + suffix).c_str());
}

void need_folded_log(const std::string& path, const std::string& operation) {
    std::error_code none;
    const auto size = fs::file_size(path + "-wal", none);
    if (none || size == 0) return;
    throw StoreError(Kind::kUnavailable, operation + ": the disk did not take all of " + path +
                                             "; check the disk and try again");
}

void copy_sqlite_store(Connection& connection, const std::string& path) {
    const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600);
    if (file < 0)
        connection.fail(Kind::kUnavailable, "cannot create " + path + " (" + std::strerror(errno) +
                                                "); nothing was written, give another name");
    ::close(file);
    sqlite3* copy = nullptr;
    int code = sqlite3_open_v2(path.c_str(), &copy, SQLITE_OPEN_READWRITE, nullptr);
    if (code == SQLITE_OK) {
        sqlite3_backup* backup =
            sqlite3_backup_init(copy, "main", connection.sqlite_handle(), "main");
        if (backup != nullptr) {
            sqlite3_backup_step(backup, -1);
            sqlite3_backup_finish(backup);
        }
        code = sqlite3_errcode(copy);
        // One file, complete in itself.
        if (code == SQLITE_OK)
            code = sqlite3_exec(copy, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
    }
    const std::string problem = code == SQLITE_OK ? "" : sqlite3_errstr(code);
    sqlite3_close(copy);
    if (!problem.empty()) {
        forget_sqlite_file(path);
        connection.fail(Kind::kUnavailable, "cannot write " + path + " (" + problem +
                                                "); the store is unchanged, give another place");
    }
    sync_file(path);
}

}  // namespace placode::db
