// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_copies.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <set>

#include "db/sqlite_file.h"
#include "db/store_place.h"
#include "db/store_url.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOfUpdate = ".before-update-";

/// Beside a file: PATH and one of the endings, which a time follows.
std::vector<std::string> kept_copies(const std::string& path,
                                     std::initializer_list<const char*> endings) {
    std::vector<std::string> found;
    std::error_code none;
    const fs::path file = path;
    for (const auto& entry : fs::directory_iterator(file.parent_path(), none)) {
        const std::string name = entry.path().filename().string();
        const bool log = name.ends_with("-wal") || name.ends_with("-shm");
        const auto begins = [&](const char* ending) {
            return name.starts_with(file.filename().string() + ending);
        };
        if (!log && std::any_of(endings.begin(), endings.end(), begins))
            found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Where the store has been: it is kept there as it was, and closed to every program.
std::vector<LeftCopy> old_places(Store& store, const std::string& url) {
    std::vector<LeftCopy> left;
    const std::string here = place_name(parse_store_url(url));
    std::set<std::string> seen;
    for (const AuditRecord& entry : store.audit().of_action("store.move")) {
        const std::string from = entry.detail.substr(entry.detail.find(' ') + 1);
        const bool gone = from.starts_with("sqlite:") && !fs::exists(from.substr(7));
        if (!gone && !same_place(from, here) && seen.insert(from).second)
            left.push_back({from, "the store moved away from there and is kept as it was"});
    }
    return left;
}

/// Backups in the order of their making, as the trail names them.
std::vector<std::string> backups_of(Store& store) {
    std::vector<std::string> paths;
    for (const AuditRecord& entry : store.audit().of_action("store.backup"))
        paths.push_back(entry.object);
    return paths;
}

}  // namespace

std::vector<std::string> copies_of(Store& store, const std::string& url) {
    const StoreUrl parsed = parse_store_url(url);
    if (!is_store_file(parsed)) return {};
    std::vector<std::string> found =
        kept_copies(fs::absolute(parsed.path).string(), {kOfUpdate, ".replaced-", ".moved-"});
    // Also what an earlier version wrote down as it was typed, if it happens to be here.
    for (const std::string& path : backups_of(store))
        if (fs::is_regular_file(path)) found.push_back(fs::absolute(path).string());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<LeftCopy> copies_with_records(const std::string& url) {
    const StoreUrl parsed = parse_store_url(url);
    if (!is_store_file(parsed)) return {};
    std::vector<LeftCopy> left;
    try {
        const auto store = open_store(url);
        for (const std::string& path : copies_of(*store, url))
            left.push_back({path, "a copy of the store; a restore of it erases again"});
        std::vector<std::string> gone;  // Mostly old backups, of which only the newest are kept.
        for (LeftCopy& each : out_of_reach(*store, url, gone)) left.push_back(std::move(each));
    } catch (const std::exception& error) {
        left.push_back({"all copies", std::string("their list cannot be read: ") + error.what()});
    }
    return left;
}

std::vector<std::string> kept_by_updates(const std::string& path) {
    return kept_copies(path, {kOfUpdate});
}

std::vector<LeftCopy> out_of_reach(Store& store, const std::string& url,
                                   std::vector<std::string>& gone) {
    std::vector<LeftCopy> left;
    std::set<std::string> missing, unknown;
    for (const std::string& path : backups_of(store)) {
        if (fs::path(path).is_relative()) {
            unknown.insert(path);
            continue;
        }
        if (!fs::exists(path)) missing.insert(path);
        if (fs::exists(path + kFailedSuffix))
            left.push_back({path + kFailedSuffix, "a backup that did not pass its check"});
    }
    gone.assign(missing.begin(), missing.end());
    for (const std::string& path : unknown)
        left.push_back({path,
                        "a backup whose place is unknown: an earlier version wrote it down without "
                        "its folder"});
    for (LeftCopy& place : old_places(store, url)) left.push_back(std::move(place));
    return left;
}

void remove_half_made(Store& store, const std::string& url) {
    for (const std::string& path : backups_of(store))
        if (fs::path(path).is_absolute()) remove_sqlite_file(path + kPartSuffix);
    const StoreUrl parsed = parse_store_url(url);
    if (is_store_file(parsed)) remove_sqlite_file(parsed.path + kRestoringSuffix);
}

}  // namespace placode::db
