// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a store that a restore replaces says of erasures and withdrawals, and what of it is proved:
// whoever can write to its file can add a row that names anybody.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// Whose word is taken.
struct Believed {
    std::string store;               ///< TrailHead::store: nothing is read of another one.
    std::set<std::string> stations;  ///< Public keys of those that are trusted.
    /// The backup is from before there were signatures, so that entries since then may be as well.
    bool without_signature = false;
};

struct Meanwhile {
    std::vector<AuditRecord> people, records;    ///< "user.erase"; "study.withdraw", ".retention".
    std::vector<AuditRecord> doubted;            ///< Such entries that are not proved.
    std::map<std::string, std::string> reasons;  ///< Of withdrawals, by "STUDY CODE".
};

/// Reads the file without opening it as a store, which would bring an older one up to date. An
/// entry is proved where its chain fits, and a station that is believed, or that one of those
/// trusted there, has signed it. One from before signatures has to fit, and the next one to it.
/// nullopt where it cannot be read.
[[nodiscard]] std::optional<Meanwhile> ended_meanwhile(const std::string& path, Believed believed);

/// Whether any entry of the trail in the file bears a station's name.
[[nodiscard]] bool has_signed_entries(const std::string& path);

/// Names in the trail of a restored store what was not believed, but for what the store says, too.
void name_doubted(Store& store, const std::string& actor, const std::vector<AuditRecord>& doubted);

/// What the last restore did not believe, a line each, such as "entry 17: user.erase user 5".
[[nodiscard]] std::vector<std::string> not_believed(Store& store);

}  // namespace placode::db
