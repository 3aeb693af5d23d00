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

bool is_stuck(const TrialSummary& trials) {
    if (trials.attempts < kStuckTrials || !none_passed(trials.last)) return false;
    const double reached =
        trials.attempts == kStuckTrials ? trials.last.front().points : trials.best_before;
    return best_of(trials.last) < reached + kProgressPoints;
}

bool has_regressed(const TrialSummary& trials) {
    // With none of the last two passed, every pass lies before them.
    return trials.attempts > 2 && none_passed(std::span(trials.last).last(2)) && trials.passed > 0;
}

}  // namespace

const char* standing_name(Standing standing) {
    constexpr std::array<const char*, 5> kNames{"not tried", "learning", "passing", "regressed",
                                                "stuck"};
    return kNames[static_cast<size_t>(standing)];
}

TrialSummary summarise_trials(std::span<const TrialOutcome> outcomes) {
    TrialSummary trials;
    trials.attempts = static_cast<int>(outcomes.size());
    trials.best = best_of(outcomes);
    for (const TrialOutcome& each : outcomes) trials.passed += each.passed ? 1 : 0;
    for (auto each = outcomes.rbegin(); each != outcomes.rend() && each->passed; ++each)
        ++trials.streak;
    const auto last = outcomes.last(std::min<size_t>(kStuckTrials, outcomes.size()));
    trials.last.assign(last.begin(), last.end());
    trials.best_before = best_of(outcomes.first(outcomes.size() - last.size()));
    return trials;
}

CohortCell judge_standing(const TrialSummary& trials) {
    CohortCell cell;
    cell.attempts = trials.attempts;
    if (trials.attempts == 0 || trials.last.empty()) return cell;
    cell.last = trials.last.back().points;
    cell.best = trials.best;
    cell.streak = trials.streak;
    const auto recent =
        std::span(trials.last).last(std::min<size_t>(kRecentTrials, trials.last.size()));
    for (const TrialOutcome& each : recent)
        cell.recent += each.points / static_cast<double>(recent.size());
    cell.standing = Standing::kLearning;
    if (cell.streak > 0)
        cell.standing = Standing::kPassing;
    else if (has_regressed(trials))
        cell.standing = Standing::kRegressed;
    // Who passed long ago and fails five times since is stuck rather than regressed.
    if (is_stuck(trials)) cell.standing = Standing::kStuck;
    return cell;
}

CohortCell judge_standing(std::span<const TrialOutcome> outcomes) {
    return judge_standing(summarise_trials(outcomes));
}

}  // namespace placode::assessment
