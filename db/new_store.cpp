// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/new_store.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "db/durable_file.h"
#include "db/schema.h"
#include "db/sqlite_file.h"

namespace placode::db {
namespace {

bool is_there(const std::string& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) == 0;
}

/// One program at a time makes a store in a folder. The lock is on the folder itself: it leaves no
/// file behind, and ends with the program.
class OnlyMaker {
 public:
    explicit OnlyMaker(const std::filesystem::path& folder)
        : folder_(
              ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        while (folder_ >= 0 && ::flock(folder_, LOCK_EX) != 0) {
            if (errno == EINTR) continue;
            ::close(folder_);
            folder_ = -1;
        }
    }
    ~OnlyMaker() {
        if (folder_ >= 0) ::close(folder_);
    }
    OnlyMaker(const OnlyMaker&) = delete;
    OnlyMaker& operator=(const OnlyMaker&) = delete;
    [[nodiscard]] bool holds() const { return folder_ >= 0; }

 private:
    int folder_;
};

/// Never over a file that somebody else has made meanwhile; false: there is one.
bool give_name(const std::string& part, const std::string& path) {
    if (::renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, path.c_str(), RENAME_NOREPLACE) == 0)
        return true;
    const bool unknown = errno == EINVAL || errno == ENOSYS || errno == ENOTSUP || errno == EPERM;
    if (unknown && !is_there(path) && ::rename(part.c_str(), path.c_str()) == 0) return true;
    if (is_there(path)) return false;
    throw StoreError(StoreError::Kind::kUnavailable,
                     "open sqlite:" + path + ": cannot create the file (" + std::strerror(errno) +
                         "); choose another place with --store");
}

void fill(StoreUrl there, const std::string& part, const std::vector<EmbeddedSql>& migrations,
          const std::string& operation) {
    there.path = part;  // Messages name the store, not this.
    {
        Connection connection(there);
        connection.begin_operation(operation);
        claim_sqlite_file(connection);
        migrate(connection, migrations, [] {});
    }
    need_folded_log(part, operation + " " + there.shown);
    sync_file(part);
}

}  // namespace

void make_store_file(const StoreUrl& url, const std::vector<EmbeddedSql>& migrations,
                     const std::string& operation) {
    if (url.path == ":memory:" || is_there(url.path)) return;
    prepare_sqlite_folder(url.path, operation);
    const OnlyMaker only(std::filesystem::path(url.path).parent_path());
    if (!only.holds() || is_there(url.path)) return;
    const std::string part = url.path + kMakingSuffix;
    forget_sqlite_file(part);
    const int file = ::open(part.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600);
    if (file < 0) return;
    ::close(file);
    try {
        fill(url, part, migrations, operation);
        if (!give_name(part, url.path)) forget_sqlite_file(part);
        sync_folder_of(url.path);
    } catch (const std::filesystem::filesystem_error& error) {
        forget_sqlite_file(part);
        throw StoreError(StoreError::Kind::kUnavailable,
                         operation + " " + url.shown + ": cannot write the file (" +
                             error.code().message() + "); make room, or choose another place");
    } catch (...) {
        forget_sqlite_file(part);
        throw;
    }
}

}  // namespace placode::db
