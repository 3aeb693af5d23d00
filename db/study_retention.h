// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long a study's records are kept. A protocol may say so (keep_years), and then every
// participant was told before consenting: records go so many years after a participant's last
// step, by the version of the protocol that the participant was enrolled under. Nothing goes by
// itself: a coordinator is told and erases.

#include <string>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// Records of one participant and until when they are kept.
struct KeptRecords {
    std::string code;
    std::string last_utc;   ///< Of the newest step or answers.
    int keep_years = 0;     ///< Of the protocol's version; above 0.
    std::string until_utc;  ///< last_utc and as many years; of 29 February the 28th.
    [[nodiscard]] bool overdue(const std::string& now_utc) const { return until_utc <= now_utc; }
};

/// The same day and time so many years later. Throws std::invalid_argument for what is no time.
[[nodiscard]] std::string years_later(const std::string& utc, int years);

/// Of all participants who have records and were told how long they are kept; what goes first
/// stands first.
[[nodiscard]] std::vector<KeptRecords> kept_records(Store& store, const std::string& study_id);

/// Erases what is overdue at `now_utc`: answers, steps, signatures and attempts. Codes, arms and
/// withdrawals stay, and an entry in the audit trail. Returns the codes. Throws as
/// Studies::erase_kept().
std::vector<std::string> erase_overdue(Store& store, const std::string& study_id,
                                       const std::string& now_utc);

}  // namespace placode::db
