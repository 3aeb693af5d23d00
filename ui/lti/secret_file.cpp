// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lti/secret_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "db/durable_file.h"

namespace placode::lti {
namespace {

constexpr size_t kLargest = size_t{1} << 20;

class Descriptor {
 public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int number() const { return number_; }

 private:
    int number_;
};

/// @param forbidden bits of the mode that no such file may have.
std::string read_guarded(const std::string& path, mode_t forbidden, const char* way_out) {
    // The file that was looked at is the one that is read, whatever its name leads to meanwhile.
    // Without O_NONBLOCK a pipe that nobody writes into would be waited for without end.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0)
        throw SettingsError(path + ": " + std::strerror(errno));
    if (!S_ISREG(status.st_mode)) throw SettingsError(path + ": is no file");
    if ((status.st_mode & forbidden) != 0) throw SettingsError(path + ": " + way_out);
    if (static_cast<size_t>(status.st_size) > kLargest)
        throw SettingsError(path + ": is larger than 1 MB");
    std::string text;
    char part[4096];
    for (;;) {
        const ssize_t got = ::read(file.number(), part, sizeof part);
        if (got < 0) throw SettingsError(path + ": " + std::strerror(errno));
        if (got == 0 || text.size() > kLargest) return text;
        text.append(part, static_cast<size_t>(got));
    }
}

}  // namespace

std::string read_secret(const std::string& path) {
    return read_guarded(path, S_IRWXG | S_IRWXO,
                        "is open to others; a secret is for its owner alone: chmod 600");
}

std::string read_settings_text(const std::string& path) {
    return read_guarded(path, S_IWGRP | S_IWOTH,
                        "can be written by others, who could let themselves in: chmod go-w");
}

std::string read_text(const std::string& path) { return read_guarded(path, 0, ""); }

void replace_text(const std::string& path, const std::string& text) {
    struct stat before {};
    const bool was_there = ::stat(path.c_str(), &before) == 0;
    std::string fresh = path + ".XXXXXX";
    const Descriptor file(::mkostemp(fresh.data(), O_CLOEXEC));  // Mode 0600.
    const auto fail = [&] {
        const std::string why = std::strerror(errno);
        ::unlink(fresh.c_str());
        throw SettingsError(path + ": cannot be written: " + why);
    };
    if (file.number() < 0) fail();
    if (was_there &&
        (::fchmod(file.number(), before.st_mode & 07777) != 0 ||
         (::geteuid() == 0 && ::fchown(file.number(), before.st_uid, before.st_gid) != 0)))
        fail();
    for (size_t done = 0; done < text.size();) {
        const ssize_t wrote = ::write(file.number(), text.data() + done, text.size() - done);
        if (wrote <= 0) fail();
        done += static_cast<size_t>(wrote);
    }
    if (::fsync(file.number()) != 0 || ::rename(fresh.c_str(), path.c_str()) != 0) fail();
    db::sync_folder_of(path);
}

}  // namespace placode::lti
