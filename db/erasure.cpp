// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/erasure.h"

#include <charconv>
#include <filesystem>

#include "db/foreign_store.h"
#include "db/sql_connection.h"
#include "db/station.h"
#include "db/store_url.h"
#include "db/unsaved_recordings.h"

namespace placode::db {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWithAttempts = "with attempts";  // In the trail: Accounts::erase().

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
    for (const std::string& before : kept_by_updates(path)) fs::remove(before);
    Station(parse_store_url(url)).forget();
    fs::last_write_time(path, age);
    return result;
}

void remove_unsaved(const UserRecord& user, const std::string& url, Erasure& done) {
    const std::string folder = recordings_beside(url);
    if (folder.empty()) return;
    UnsavedOf found = remove_unsaved_of(user, folder);
    done.recordings = std::move(found.removed);
    for (std::string& order : found.naming)
        done.left.push_back({std::move(order),
                             "an attempt that was not saved yet names the person: save it, or "
                             "delete it with its recording"});
}

}  // namespace

Erasure erase_person(Store& store, const std::string& url, int64_t user_id, bool with_attempts) {
    Erasure done{user_id, with_attempts, utc_now(), {}, {}, {}, {}, {}, {}};
    const std::optional<UserRecord> user = store.accounts().find(user_id);
    store.accounts().erase(user_id, with_attempts);
    std::vector<std::string> copies;
    try {
        if (user) {
            done.entries = store.audit().naming({user->login, user->display_name});
            remove_unsaved(*user, url, done);
        }
        done.store = store.audit().head().store;
        copies = copies_of(store, url);
        for (LeftCopy& each : out_of_reach(store, url, done.gone))
            done.left.push_back(std::move(each));
        remove_half_made(store, url);
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
        int64_t id = 0;
        const auto read = std::from_chars(number.data(), number.data() + number.size(), id);
        if (read.ec == std::errc() && read.ptr == number.data() + number.size() && id > 0)
            people.push_back({id, entry.detail == kWithAttempts});
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

}  // namespace placode::db
