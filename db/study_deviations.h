// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a study did not go as its protocol says. Nobody writes these down: they follow from the
// steps, the attempts, and the events of their recordings.

#include <set>
#include <string>
#include <vector>

#include "db/store.h"

namespace placode::db {

/// Stored as numbers in exports: append only.
enum class DeviationKind : uint8_t {
    kPaused,       ///< Simulated time stood still: count, seconds, causes.
    kSlowMachine,  ///< The computer fell behind: count, seconds; text = why the attempt is void.
    kEndedEarly,   ///< seconds, and at least how many the protocol asks for (expected_s).
    kInterrupted,  ///< Broken off after seconds.
    kRepeated,     ///< Done again: text = the reason, by = whose decision.
    kOtherDevice,  ///< text = the device, expected = the one that was set.
    kSkipped,
    kNote,        ///< text = what the coordinator remarked; no deviation by itself.
    kNothingDone  ///< A procedure of seconds, long enough for the protocol, without any operating.
};
inline constexpr int kDeviationKinds = 9;
/// "paused", "slow_machine", ...: for files and programs.
[[nodiscard]] const char* deviation_name(DeviationKind kind) noexcept;

struct Deviation {
    DeviationKind kind = DeviationKind::kPaused;
    std::string participant;
    int visit = 1;
    std::string step;
    int64_t attempt_id = 0;  ///< 0 = none.
    std::string at_utc;
    int count = 0;
    double seconds = 0, expected_s = 0;
    std::set<sim::PauseCause> causes;
    std::string text, expected, by;
    std::string meaning;  ///< Of the text of an attempt that is void (db/void_reason.h).
};

/// Of everybody in the study, or of one code; by code, then in the order in which things were
/// done.
[[nodiscard]] std::vector<Deviation> study_deviations(Store& store, const std::string& study_id,
                                                      const std::string& code = {});

}  // namespace placode::db
