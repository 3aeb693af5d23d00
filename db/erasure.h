// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Erasing a person from a store and from every copy of it that Placode made and that can be
// reached: backups, and the files that updates and restores keep beside an embedded store. The
// audit trail is the register of the backups. What cannot be reached is named, and a restore of it
// erases again.

#include <cstdint>
#include <string>
#include <vector>

#include "db/store.h"
#include "db/store_copies.h"

namespace placode::db {

struct Erasure {
    int64_t user_id = 0;
    bool with_attempts = false;
    std::string at_utc, store;         ///< When; which store (TrailHead::store).
    std::vector<std::string> cleaned;  ///< Copies that held the person, and do not any more.
    std::vector<LeftCopy> left;
    std::vector<std::string> gone;  ///< Backups that are not where they were made.
    /// Of the audit trail: an earlier version named the person there, or a copy lies at a place
    /// with that name. They stay, because each proves those after it.
    std::vector<int64_t> entries;
    /// Recordings of the person that nobody had saved, which are removed.
    std::vector<std::string> recordings;
};

/// As Accounts::erase(), which it throws as; then the copies, where nothing throws any more.
/// @param url of the store, as it was opened.
Erasure erase_person(Store& store, const std::string& url, int64_t user_id, bool with_attempts);

/// In the trail of a restored store, where the store that it replaced was there and told nobody:
/// whoever was erased in it since the backup is back.
inline constexpr const char* kErasuresUnknown = "erasures since the backup are unknown";

/// Who was erased in a store, and whether with the attempts: by account.
struct ErasedPerson {
    int64_t user_id = 0;
    bool with_attempts = false;
};
/// @param entries "user.erase" of its trail.
[[nodiscard]] std::vector<ErasedPerson> people_of(const std::vector<AuditRecord>& entries);
/// Erases those who are still there; how many. A person who cannot be erased stays.
int erase_again(Store& store, const std::vector<ErasedPerson>& people);

/// What was done, signed by this computer where it has a key: for whom it concerns. No name.
[[nodiscard]] std::string erasure_certificate(const Erasure& erasure);

}  // namespace placode::db
