// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/erasure.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <filesystem>
#include <set>

#include "db/foreign_store.h"
#include "db/named_word.h"
#include "db/recording_file.h"
#include "db/sql_connection.h"
#include "db/sqlite_file.h"
#include "db/station.h"
#include "db/store_context.h"
#include "db/store_place.h"
#include "db/store_url.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOrderSuffix = ".order.json";  // Beside a recording: ui/shell.
constexpr const char* kWithAttempts = "with attempts";    // In the trail: Accounts::erase().

/// Of a file: PATH.before-update-TIME, PATH.replaced-TIME and PATH.moved-TIME.
std::vector<std::string> kept_copies(const std::string& path, bool of_updates_only = false) {
    std::vector<std::string> found;
    std::error_code none;
    const fs::path file = path;
    for (const auto& entry : fs::directory_iterator(file.parent_path(), none)) {
        const std::string name = entry.path().filename().string();
        const auto begins = [&](const char* kind) {
            return name.starts_with(file.filename().string() + kind);
        };
        const bool log = name.ends_with("-wal") || name.ends_with("-shm");
        if (!log && (begins(".before-update-") ||
                     (!of_updates_only && (begins(".replaced-") || begins(".moved-")))))
            found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

enum class CopyResult : uint8_t { kCleaned, kHeldNobody };

/// Throws what opening and erasing throw.
CopyResult erase_in_copy(const std::string& path, const Erasure& erasure) {
    const std::string url = "sqlite:" + path;
    // Retention goes by age: the copy is not a newer one for this.
    const auto age = fs::last_write_time(path);
    CopyResult result = CopyResult::kHeldNobody;
    need_own_schema(path, "open " + url);
    {
        const auto copy = open_store(url);
        copy->act_as("erasure of copies");
        if (copy->audit().head().store != erasure.store)
            throw StoreError(StoreError::Kind::kRefused, "is a copy of another store");
        if (erase_again(*copy, {{erasure.user_id, erasure.with_attempts}}) > 0)
            result = CopyResult::kCleaned;
        else if (copy->accounts().find(erasure.user_id))
            throw StoreError(StoreError::Kind::kRefused, "the person is its only administrator");
    }
    // An older copy was brought up to date for it, and kept as it was before.
    for (const std::string& before : kept_copies(path, true)) fs::remove(before);
    Station(parse_store_url(url)).forget();
    fs::last_write_time(path, age);
    return result;
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

bool is_file(const StoreUrl& url) {
    return url.engine == Engine::kSqlite && url.path != ":memory:";
}

std::vector<std::string> copies_among(const std::vector<std::string>& backups,
                                      const StoreUrl& url) {
    if (!is_file(url)) return {};
    std::vector<std::string> found = kept_copies(fs::absolute(url.path).string());
    // Also what an earlier version wrote down as it was typed, if it happens to be here.
    for (const std::string& path : backups)
        if (fs::is_regular_file(path)) found.push_back(fs::absolute(path).string());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// What a backup or restore that was killed has left: no use to anybody, and it may hold the
/// person.
void remove_half_made(const std::vector<std::string>& backups, const StoreUrl& url) {
    for (const std::string& path : backups)
        if (fs::path(path).is_absolute()) remove_sqlite_file(path + kPartSuffix);
    if (is_file(url)) remove_sqlite_file(url.path + kRestoringSuffix);
}

/// What nothing goes through: backups that did not pass their check or whose place is unknown, and
/// where the store has been. @param gone of backups that are not where they were made, sorted
std::vector<LeftCopy> out_of_reach(Store& store, const std::string& url,
                                   const std::vector<std::string>& backups,
                                   std::vector<std::string>& gone) {
    std::vector<LeftCopy> left;
    std::set<std::string> missing, unknown;
    for (const std::string& path : backups) {
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

fs::path beside(const StoreUrl& url) { return fs::absolute(url.path).parent_path() / "recordings"; }

/// Recordings beside an embedded store that a crash has left: with a file that says whose they are.
void remove_leftovers(const StoreUrl& url, const UserRecord& user, Erasure& done) {
    if (!is_file(url)) return;
    std::error_code none;
    const fs::path folder = beside(url);
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        const std::string order = entry.path().string();
        const size_t length = order.size() - std::min(order.size(), kOrderSuffix.size());
        if (order.substr(length) != kOrderSuffix) continue;
        QFile file(QString::fromStdString(order));
        if (!file.open(QIODevice::ReadOnly)) continue;
        const QByteArray text = file.readAll();
        const QJsonObject json = QJsonDocument::fromJson(text).object();
        file.close();
        const std::string recording = order.substr(0, length);
        const bool of_a_study = !json["study"].toString().isEmpty();
        if (json["user_id"].toInteger() == user.id && !of_a_study) {
            remove_sqlite_file(recording);
            if (fs::remove(order, none)) done.recordings.push_back(recording);
        } else if (holds_word(text.toStdString(), user.login) ||
                   holds_word(text.toStdString(), user.display_name)) {
            done.left.push_back({order,
                                 "an attempt that was not saved yet names the person: save "
                                 "it, or delete it with its recording"});
        }
    }
}

std::string lines_of(const char* head, const std::vector<std::string>& lines) {
    if (lines.empty()) return {};
    std::string text = std::string(head) + "\n";
    for (const std::string& line : lines) text += "  " + line + "\n";
    return text;
}

}  // namespace

std::string recordings_beside(const std::string& url) {
    if (!url.starts_with("sqlite:")) return {};
    const StoreUrl parsed = parse_store_url(url);
    return is_file(parsed) ? beside(parsed).string() : std::string();
}

std::vector<std::string> unsaved_recordings(const std::string& folder, const StudyContext& whose,
                                            Unsaved what) {
    std::vector<std::string> found;
    if (folder.empty()) return found;
    for (const std::string& recording : leftover_recordings(folder)) {
        const std::string order = recording + std::string(kOrderSuffix);
        QFile file(QString::fromStdString(order));
        if (!file.open(QIODevice::ReadOnly)) continue;
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        file.close();
        if (json["study"].toString().toStdString() != whose.study ||
            json["participant"].toString().toStdString() != whose.participant)
            continue;
        found.push_back(recording);
        if (what == Unsaved::kName) continue;
        remove_sqlite_file(recording);
        std::error_code none;
        fs::remove(order, none);
    }
    return found;
}

std::vector<std::string> copies_of(Store& store, const std::string& url) {
    return copies_among(backups_of(store), parse_store_url(url));
}

std::vector<LeftCopy> copies_with_records(const std::string& url) {
    const StoreUrl parsed = parse_store_url(url);
    if (!is_file(parsed)) return {};
    std::vector<LeftCopy> left;
    try {
        const auto store = open_store(url);
        const std::vector<std::string> backups = backups_of(*store);
        for (const std::string& path : copies_among(backups, parsed))
            left.push_back({path, "a copy of the store; a restore of it erases again"});
        std::vector<std::string> gone;  // Mostly old backups, of which only the newest are kept.
        for (LeftCopy& each : out_of_reach(*store, url, backups, gone))
            left.push_back(std::move(each));
    } catch (const std::exception& error) {
        left.push_back({"all copies", std::string("their list cannot be read: ") + error.what()});
    }
    return left;
}

Erasure erase_person(Store& store, const std::string& url, int64_t user_id, bool with_attempts) {
    Erasure done{user_id, with_attempts, utc_now(), {}, {}, {}, {}, {}, {}};
    const std::optional<UserRecord> user = store.accounts().find(user_id);
    store.accounts().erase(user_id, with_attempts);
    std::vector<std::string> copies;
    try {
        if (user) {
            done.entries = store.audit().naming({user->login, user->display_name});
            remove_leftovers(parse_store_url(url), *user, done);
        }
        done.store = store.audit().head().store;
        const std::vector<std::string> backups = backups_of(store);
        copies = copies_among(backups, parse_store_url(url));
        for (LeftCopy& each : out_of_reach(store, url, backups, done.gone))
            done.left.push_back(std::move(each));
        remove_half_made(backups, parse_store_url(url));
    } catch (const std::exception& error) {
        done.left.push_back(
            {"all copies", std::string("their list cannot be read: ") + error.what()});
    }
    for (const std::string& path : copies) {
        try {
            if (erase_in_copy(path, done) == CopyResult::kCleaned) done.cleaned.push_back(path);
        } catch (const std::exception& error) {
            done.left.push_back({path, error.what()});
        }
    }
    return done;
}

std::vector<ErasedPerson> people_of(const std::vector<AuditRecord>& entries) {
    std::vector<ErasedPerson> people;
    for (const AuditRecord& entry : entries) {
        const std::string number = entry.object.substr(entry.object.find(' ') + 1);
        if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos)
            people.push_back({std::stoll(number), entry.detail == kWithAttempts});
    }
    return people;
}

int erase_again(Store& store, const std::vector<ErasedPerson>& people) {
    int erased = 0;
    for (const ErasedPerson& person : people) {
        if (!store.accounts().find(person.user_id)) continue;
        try {
            store.accounts().erase(person.user_id, person.with_attempts);
            ++erased;
        } catch (const StoreError& error) {
            if (error.kind() != StoreError::Kind::kRefused) throw;
        }
    }
    return erased;
}

std::string erasure_certificate(const Erasure& erasure) {
    std::string text = "Placode: certificate of erasure\n";
    text += "account " + std::to_string(erasure.user_id) + " of the store " +
            erasure.store.substr(0, 16) + ", " + erasure.at_utc + "\n";
    text += "removed: name, log-in, password, PIN, groups, assignments, grants, certificates; ";
    text += erasure.with_attempts ? "the attempts as well\n" : "attempts stay without a name\n";
    text += lines_of("erased as well in these copies:", erasure.cleaned);
    text +=
        lines_of("recordings of the person that were not saved yet, removed:", erasure.recordings);
    std::string entries;
    for (const int64_t entry : erasure.entries)
        entries += (entries.empty() ? "" : ", ") + std::to_string(entry);
    if (!entries.empty())
        text +=
            "entries of the audit trail that name the person, from an earlier version or as the "
            "place of a copy; each proves those after it, so they stay: " +
            entries + "\n";
    std::vector<std::string> left;
    for (const LeftCopy& each : erasure.left) left.push_back(each.path + ": " + each.why);
    text += lines_of("may still hold the person (delete them):", left);
    text += lines_of(
        "backups that are not where they were made (a restore of them erases again, as long as the "
        "store that they replace says so):",
        erasure.gone);
    text +=
        "not in the store, and not looked at: links to a learning platform (lti.json, "
        "lti.json.sent); `placodectl lti unlink` takes the account out of the first, the second "
        "keeps which points were sent\n";
    Station station;
    const std::string key = station.public_key(), signature = station.sign(text);
    if (!signature.empty()) text += "station " + key + "\nsignature " + signature + "\n";
    return text;
}

}  // namespace placode::db
