// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which attempts count. One that the machine spoilt, or that was broken off, is kept and counts for
// nothing: neither mastery nor standings, norms, standards, cohort or studies.

#include <string>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// Why the computer was too slow for the attempt to count, in plain words; empty = it was not, or
/// nobody measured it (scripts and windowless runs have no wall clock to keep to).
[[nodiscard]] std::string slow_machine_reason(const std::vector<sim::Event>& events);
/// "a; b", or the one that is not empty.
[[nodiscard]] std::string joined_reasons(const std::string& a, const std::string& b);

/// Neither broken off, nor void for cause, and something was tried.
[[nodiscard]] bool counts(const AttemptRecord& attempt) noexcept;

/// Attempts at the same task of whose it is, oldest first: of the person, or of the participant
/// within the study.
[[nodiscard]] std::vector<AttemptRecord> attempts_beside(Store& store,
                                                         const AttemptRecord& attempt);

}  // namespace placode::db
