// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/station.h"

#include <fcntl.h>
#include <unistd.h>

#include <QFile>
#include <QSaveFile>
#include <QStandardPaths>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "db/packing.h"
#include "db/store_error.h"

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
        tried_ = true;
        if (!read_key()) make_key();
    }
    return keys_.public_key;
}

std::string Station::public_key_if_any() {
    if (!tried_) tried_ = read_key();
    return keys_.public_key;
}

std::string Station::sign(const std::string& text) {
    return public_key().empty() ? std::string() : sign_text(text, keys_.secret_key);
}

bool Station::read_key() {
    QFile file(QString::fromStdString(key_path_));
    if (!file.exists()) return false;
    if (!file.open(QIODevice::ReadOnly))
        return true;  // It is there and not ours: nothing to sign with.
    std::istringstream words(file.read(1024).toStdString());
    KeyPair read;
    words >> read.public_key >> read.secret_key;
    const std::string proof = "a key pair that fits";
    bool sound = false;
    try {
        sound = signature_is_right(proof, sign_text(proof, read.secret_key), read.public_key);
    } catch (const StoreError&) {
        // Said below, with the file's name.
    }
    if (!sound)
        throw StoreError(StoreError::Kind::kDamaged,
                         "the station's key " + key_path_ +
                             " is damaged; put the file back from a copy, or move it away: the "
                             "computer then signs as a new station");
    keys_ = read;
    return true;
}

void Station::make_key() {
    const KeyPair made = new_key_pair();
    std::error_code ignored;
    fs::create_directories(fs::path(key_path_).parent_path(), ignored);
    const std::string part = key_path_ + ".part" + std::to_string(::getpid());
    if (!write_new_file(part, made.public_key + "\n" + made.secret_key + "\n")) {
        fs::remove(part, ignored);
        return;
    }
    // Another program may have been quicker: its key is the station's.
    const bool first = ::link(part.c_str(), key_path_.c_str()) == 0;
    fs::remove(part, ignored);
    if (first)
        keys_ = made;
    else
        (void)read_key();
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
        QSaveFile file(QString::fromStdString(path));
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
