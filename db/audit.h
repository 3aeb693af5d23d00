// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: the audit trail. Every change of the store writes its entry itself, in its own
// transaction; an entry's chain says that none before it was changed.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "db/records.h"
#include "db/store_check.h"
#include "db/trail_head.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// A computer that signs its entries (db/station.h).
struct StationRecord {
    std::string public_key, first_utc, last_utc;
    int64_t entries = 0;
    bool own = false;      ///< The computer that this program runs on.
    bool trusted = false;  ///< It began the store, is this one, or was vouched for.
};

/// `store.audit().write()`. Every change is one transaction and in the audit trail.
class Audit {
 public:
    explicit Audit(StoreContext& context);

    /// How much a store takes the word of a key.
    enum class Standing : uint8_t {
        kUnknown,    ///< Nobody vouched for it.
        kOfTheFile,  ///< Of the computer that has the file, and not in its trail as trusted.
        kRegistered  ///< It began the trail, or somebody registered vouched for it.
    };
    [[nodiscard]] Standing standing_of(const std::string& public_key);

    /// What is no change of the store, such as an export. An account writes in its own name only.
    /// Object and detail name nobody: whoever has an account and is named there, by log-in or name,
    /// stands there by number.
    void write(const std::string& actor, const std::string& action, const std::string& object,
               const std::string& detail);
    [[nodiscard]] std::vector<AuditRecord> trail(int limit);  ///< Newest first.
    /// Oldest first.
    [[nodiscard]] std::vector<AuditRecord> of_action(const std::string& action);
    /// Entries whose object or detail holds one of these words by itself, in whatever case: what an
    /// earlier version wrote there, and where copies lie. They cannot be changed.
    [[nodiscard]] std::vector<int64_t> naming(const std::vector<std::string>& words);
    /// The making of the store, which tells it from every other one; nullopt in an empty one.
    [[nodiscard]] std::optional<AuditRecord> first();
    /// Who has written into the trail, in the order of their first entries.
    [[nodiscard]] std::vector<StationRecord> stations();
    /// Public keys of those that are trusted, also of some that have not written here.
    [[nodiscard]] std::set<std::string> trusted_keys();
    /// Public key of this computer, made where there is none yet; "" where there can be none.
    [[nodiscard]] std::string own_station();
    /// From now on what the station has signed and signs is right. @param station the fingerprint
    /// (db/signature.h) of one that has written here, or the public key of any. Throws kNotFound
    /// for what is neither, kConflict for one that is trusted.
    void trust_station(const std::string& station);
    /// Check names an entry that does not fit no more, as long as it stays as it is: somebody has
    /// looked into it. What it says of objects stays without belief. Throws kNotFound for an entry
    /// that fits or is not there, kRefused without a reason.
    void set_aside(int64_t entry, const std::string& reason);
    /// Where the trail ends now, signed by this computer where it has a key.
    [[nodiscard]] TrailHead head();
    /// Adds to `problems` what this trail does not hold of an earlier end of it.
    void check_head(const TrailHead& head, std::vector<std::string>& problems);
    /// Adds what does not fit (db/audit_check.h) to `problems`, for Store::check().
    void check_chain(std::vector<std::string>& problems, const CheckPace& pace = {});

 private:
    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
