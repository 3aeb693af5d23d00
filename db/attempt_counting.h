// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which attempts count. One that the machine spoilt, or that was broken off, is kept and counts for
// nothing: neither mastery nor standings, norms, standards, cohort or studies.

#include <string>
#include <string_view>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// Why the computer was too slow for the attempt to count, in plain words; empty = it was not, or
/// nobody measured it (scripts and windowless runs have no wall clock to keep to).
[[nodiscard]] std::string slow_machine_reason(const std::vector<sim::Event>& events);
/// How the store says that tissue or generator were tuned by hand.
inline constexpr std::string_view kTunedReason = "Tissue or generator was tuned";
/// That, or empty: what was tuned is not the task any more.
[[nodiscard]] std::string tuned_reason(const std::vector<sim::Event>& events);
/// "a; b", or the one that is not empty.
[[nodiscard]] std::string joined_reasons(const std::string& a, const std::string& b);

/// Neither broken off, nor void for cause, and something was tried.
[[nodiscard]] bool counts(const AttemptRecord& attempt) noexcept;

/// True when nothing but the machine is why the attempt does not count: it was neither left, nor
/// idle, nor tuned.
[[nodiscard]] bool machine_at_fault(const AttemptRecord& attempt) noexcept;

/// Attempts at the same task of whose it is, oldest first: of the person, or of the participant
/// within the study.
[[nodiscard]] std::vector<AttemptRecord> attempts_beside(Store& store,
                                                         const AttemptRecord& attempt);

}  // namespace placode::db
