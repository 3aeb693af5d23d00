// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/station.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QStandardPaths>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>

#include "db/packing.h"
#include "db/said.h"
#include "db/store_error.h"
#include "db/whole_file.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;

std::string key_place() {
    if (const char* set = std::getenv("PLACODE_STATION_KEY"); set != nullptr && *set != '\0')
        return set;
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() +
           "/placode/station.key";
}

std::vector<std::string> head_places(const StoreUrl& url, const std::string& key_path) {
    const auto in_key_folder = [&key_path](const std::string& address) {
        return (fs::path(key_path).parent_path() /
                ("trail-" + checksum_hex(address).substr(0, 16) + ".seen"))
            .string();
    };
    if (url.engine != Engine::kSqlite) return {in_key_folder(url.shown)};
    if (url.path == ":memory:") return {};
    const fs::path path = fs::absolute(url.path);
    std::error_code unknown;
    const fs::path whole = fs::weakly_canonical(path, unknown);  // not another one by a link
    return {in_key_folder("sqlite:" + (unknown ? path : whole).string()), path.string() + ".seen"};
}

/// Digits as `chmod` takes them.
std::string mode_text(mode_t mode) {
    std::string text;
    for (const int shift : {6, 3, 0})
        text += static_cast<char>('0' + ((mode >> static_cast<unsigned>(shift)) & 7U));
    return text;
}

/// systemd gives a service its credentials for it alone: at times with root as owner, and by an
/// access list that shows as rights of the group.
bool is_credential(const std::string& path) {
    const char* folder = std::getenv("CREDENTIALS_DIRECTORY");
    return folder != nullptr && *folder != '\0' && path.starts_with(std::string(folder) + "/");
}

/// As far as a key can be long.
std::string read_begin(int file) {
    constexpr size_t kMost = 1024;
    std::string text(kMost, '\0');
    const ssize_t got = ::read(file, text.data(), kMost);
    text.resize(got > 0 ? static_cast<size_t>(got) : 0);
    return text;
}

/// A whole file under a name of its own; false: nobody may write there.
bool write_new_file(const std::string& path, const std::string& text) {
    const int file = ::open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600);
    if (file < 0) return false;
    const bool whole =
        ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
        ::fsync(file) == 0;
    ::close(file);
    return whole;
}

}  // namespace

Station::Station() : key_path_(key_place()) {}

Station::Station(const StoreUrl& url)
    : key_path_(key_place()), head_paths_(head_places(url, key_path_)) {}

const std::string& Station::public_key() {
    if (!tried_) {
        if (!read_key()) make_key();
        tried_ = true;
    }
    return public_key_;
}

std::string Station::public_key_if_any() {
    if (!tried_) tried_ = read_key();
    return public_key_;
}

std::string Station::sign(const std::string& text) {
    return public_key().empty() ? std::string() : sign_text(text, secret_key_.text());
}

// Of the file that is read, whatever its name leads to meanwhile.
void Station::need_private(int file) const {
    struct stat status {};
    if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) say_damaged();
    const bool credential = is_credential(key_path_);
    const mode_t others = credential ? S_IRWXO : S_IRWXG | S_IRWXO;
    if ((status.st_mode & others) != 0)
        throw StoreError(
            StoreError::Kind::kRefused, "",
            Said::that("the station's key %1 is open to others (mode %2); `chmod 600` it, or move "
                       "it away if somebody may have copied it: the computer then signs as a new "
                       "station")
                .with(key_path_)
                .with(mode_text(status.st_mode)));
    if (!credential && status.st_uid != ::geteuid())
        throw StoreError(
            StoreError::Kind::kRefused, "",
            Said::that("the station's key %1 belongs to another account (number %2); run Placode "
                       "as that one, or set PLACODE_STATION_KEY to a file of your own")
                .with(key_path_)
                .with(int64_t{status.st_uid}));
}

void Station::say_damaged() const {
    throw StoreError(StoreError::Kind::kDamaged,
                     "the station's key " + key_path_ +
                         " is damaged; put the file back from a copy, or move it away: the "
                         "computer then signs as a new station");
}

bool Station::read_key() {
    const int file = ::open(key_path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    // There and not ours: nothing to sign with.
    if (file < 0) return errno != ENOENT && errno != ENOTDIR;
    std::string text;
    try {
        need_private(file);
        text = read_begin(file);
    } catch (...) {
        ::close(file);
        throw;
    }
    ::close(file);
    // No stream: what it holds meanwhile would be overwritten by nobody.
    constexpr const char* kBlanks = " \t\r\n";
    const size_t open_end = std::min(text.find_first_of(kBlanks), text.size());
    const size_t secret = std::min(text.find_first_not_of(kBlanks, open_end), text.size());
    const size_t secret_end = std::min(text.find_first_of(kBlanks, secret), text.size());
    const std::string public_key = text.substr(0, open_end);
    Secret secret_key(std::string_view(text).substr(secret, secret_end - secret));
    wipe(text);
    const std::string proof = "a key pair that fits";
    bool sound = false;
    try {
        sound = signature_is_right(proof, sign_text(proof, secret_key.text()), public_key);
    } catch (const StoreError&) {
        // Said below, with the file's name.
    }
    if (!sound) say_damaged();
    public_key_ = public_key;
    secret_key_ = std::move(secret_key);
    return true;
}

void Station::make_key() {
    KeyPair made = new_key_pair();
    std::error_code ignored;
    fs::create_directories(fs::path(key_path_).parent_path(), ignored);
    const std::string part = key_path_ + ".part" + std::to_string(::getpid());
    std::string text = made.public_key + "\n";
    text.reserve(text.size() + made.secret_key.size() + 1);  // One place to overwrite.
    text += made.secret_key;
    text += '\n';
    wipe(made.secret_key);
    const bool written = write_new_file(part, text);
    wipe(text);
    // Another program may have been quicker: its key is the station's.
    [[maybe_unused]] const bool first = written && ::link(part.c_str(), key_path_.c_str()) == 0;
    fs::remove(part, ignored);
    if (written) (void)read_key();
}

std::vector<Station::Head> Station::heads() const {
    std::vector<Head> heads;
    for (const std::string& path : head_paths_) {
        QFile file(QString::fromStdString(path));
        if (!file.open(QIODevice::ReadOnly)) continue;
        std::istringstream words(file.read(1024).toStdString());
        Head head;
        if (words >> head.entry >> head.chain) heads.push_back(std::move(head));
    }
    return heads;
}

void Station::remember(const Head& head) const noexcept {
    for (const std::string& path : head_paths_) {
        WholeFile file(QString::fromStdString(path));
        if (!file.open(QIODevice::WriteOnly)) continue;
        file.write((std::to_string(head.entry) + " " + head.chain + "\n").c_str());
        file.commit();
    }
}

void Station::forget() const {
    for (const std::string& path : head_paths_) {
        std::error_code error;
        fs::remove(path, error);
        if (error)
            throw StoreError(StoreError::Kind::kUnavailable,
                             path + " cannot be removed (" + error.message() +
                                 "): how far the trail of the store before went; check folder and "
                                 "disk and try again");
    }
}

}  // namespace placode::db
