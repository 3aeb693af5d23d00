// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/cohort.h"

#include <algorithm>
#include <array>

namespace placode::assessment {
namespace {

double best_of(std::span<const TrialOutcome> outcomes) {
    double best = 0;
    for (const TrialOutcome& each : outcomes) best = std::max(best, each.points);
    return best;
}

bool none_passed(std::span<const TrialOutcome> outcomes) {
    return std::none_of(outcomes.begin(), outcomes.end(),
                        [](const TrialOutcome& each) { return each.passed; });
}

bool is_stuck(std::span<const TrialOutcome> outcomes) {
    if (outcomes.size() < kStuckTrials) return false;
    const auto last = outcomes.last(kStuckTrials);
    if (!none_passed(last)) return false;
    const auto before = outcomes.first(outcomes.size() - kStuckTrials);
    const double reached = before.empty() ? last.front().points : best_of(before);
    return best_of(last) < reached + kProgressPoints;
}

}  // namespace

const char* standing_name(Standing standing) {
    constexpr std::array<const char*, 5> kNames{"not tried", "learning", "passing", "regressed",
                                                "stuck"};
    return kNames[static_cast<size_t>(standing)];
}

CohortCell judge_standing(std::span<const TrialOutcome> outcomes) {
    CohortCell cell;
    cell.attempts = static_cast<int>(outcomes.size());
    if (outcomes.empty()) return cell;
    cell.last = outcomes.back().points;
    cell.best = best_of(outcomes);
    const auto recent = outcomes.last(std::min<size_t>(kRecentTrials, outcomes.size()));
    for (const TrialOutcome& each : recent)
        cell.recent += each.points / static_cast<double>(recent.size());
    for (auto each = outcomes.rbegin(); each != outcomes.rend() && each->passed; ++each)
        ++cell.streak;
    cell.standing = Standing::kLearning;
    if (cell.streak > 0)
        cell.standing = Standing::kPassing;
    else if (outcomes.size() > 2 && none_passed(outcomes.last(2)) &&
             !none_passed(outcomes.first(outcomes.size() - 2)))
        cell.standing = Standing::kRegressed;
    // Who passed long ago and fails five times since is stuck rather than regressed.
    if (is_stuck(outcomes)) cell.standing = Standing::kStuck;
    return cell;
}

}  // namespace placode::assessment
