// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a person stands with a task, from the outcomes of all attempts: who is stuck, who
// regressed. The one rule for pages, reports and command line; it points at people to look at and
// does not judge them.

#include <cstdint>
#include <span>
#include <vector>

namespace placode::assessment {

/// One attempt that was not interrupted.
struct TrialOutcome {
    double points = 0;
    bool passed = false;
};

enum class Standing : uint8_t {
    kNotTried,
    kLearning,
    kPassing,    ///< The last attempt passed.
    kRegressed,  ///< Passed once, but neither of the last two did.
    kStuck       ///< See kStuckTrials.
};

/// Stuck: none of the last five attempts passed, and their best is not 3 points above the best of
/// those before (or, without earlier ones, above the first of them).
inline constexpr int kStuckTrials = 5;
inline constexpr double kProgressPoints = 3;

inline constexpr int kRecentTrials = 3;

/// "not tried", "learning", "passing", "regressed", "stuck".
[[nodiscard]] const char* standing_name(Standing standing);

struct CohortCell {
    Standing standing = Standing::kNotTried;
    int attempts = 0;
    int streak = 0;  ///< Passed in a row, up to now.
    double last = 0, best = 0;
    double recent = 0;  ///< Mean of the last kRecentTrials (of all while there are fewer).
};

/// What the rule needs to know of all attempts: a store can tell it without reading each of them.
struct TrialSummary {
    int attempts = 0, passed = 0, streak = 0;
    double best = 0;
    double best_before = 0;          ///< Of those before `last`; needed where there are any.
    std::vector<TrialOutcome> last;  ///< The last kStuckTrials (all while there are fewer).
};
/// `outcomes` oldest first.
[[nodiscard]] TrialSummary summarise_trials(std::span<const TrialOutcome> outcomes);

[[nodiscard]] CohortCell judge_standing(const TrialSummary& trials);
/// `outcomes` oldest first.
[[nodiscard]] CohortCell judge_standing(std::span<const TrialOutcome> outcomes);

}  // namespace placode::assessment
