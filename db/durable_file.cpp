// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/durable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace placode::db {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* what, const std::string& path, int number) {
    throw fs::filesystem_error(what, path, std::error_code(number, std::generic_category()));
}

void sync_opened(const std::string& path, int flags) {
    const int file = ::open(path.c_str(), flags | O_CLOEXEC);
    if (file < 0) fail("cannot open", path, errno);
    const int problem = ::fsync(file) == 0 ? 0 : errno;
    ::close(file);
    // Some network file systems cannot sync a folder; their server does.
    if (problem != 0 && problem != EINVAL && problem != EROFS)
        fail("cannot write to the disk", path, problem);
}

// Both names in one step; false where the file system or kernel knows no such step.
bool exchange(const std::string& one, const std::string& other) {
    if (::renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0)
        return true;
    if (errno == EINVAL || errno == ENOSYS || errno == ENOTSUP || errno == EPERM) return false;
    fail("cannot exchange", one, errno);
}

}  // namespace

void sync_file(const std::string& path) { sync_opened(path, O_RDWR); }

void sync_folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    sync_opened(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
}

void replace_file(const std::string& fresh, const std::string& path, const std::string& aside) {
    sync_file(fresh);
    // The new file gets the name of the old one's copy first, so that the exchange is the only step
    // that counts: killed before it, one more copy of the new file lies there.
    fs::rename(fresh, aside);
    if (exchange(aside, path)) return sync_folder_of(path);
    fs::rename(aside, fresh);
    const std::string part = aside + ".part";
    fs::copy_file(path, part, fs::copy_options::overwrite_existing);
    sync_file(part);
    fs::rename(part, aside);
    sync_folder_of(path);
    fs::rename(fresh, path);
    sync_folder_of(path);
}

}  // namespace placode::db
