// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A backup does not bring back what participants of studies asked to have used no more or erased
// since it was made, nor what went because its time was over: whoever restores it withdraws and
// erases again what the trail of the replaced store says.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// An entry of a trail that ended the use of a participant's records.
struct EndedRecords {
    AuditRecord entry;  ///< "study.withdraw" or "study.retention".
    std::string study, code;
    std::optional<WithdrawalMode> mode;  ///< nullopt: the time was over for which they were kept.
    std::string until_utc;               ///< Without a mode: until when they were kept.
};

/// Of such entries, in their order; what cannot be read is left out.
[[nodiscard]] std::vector<EndedRecords> ended_records(const std::vector<AuditRecord>& entries);

/// Withdraws and erases again in a store, as a program. What its own trail says already is done,
/// and participants who are not there are passed over.
/// @param reasons for which they withdrew, by "STUDY CODE"; the trail has none.
void end_again(Store& store, const std::vector<EndedRecords>& records,
               const std::map<std::string, std::string>& reasons);

/// Whom a restore has erased or withdrawn again: what the trail of the restored store says since,
/// a line each, such as "pilot P001-C: erase". Nothing where it was not restored.
[[nodiscard]] std::vector<std::string> done_again(Store& store);

}  // namespace placode::db
