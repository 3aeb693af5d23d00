// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "assessment/loci.h"
#include "assessment/tissue_metrics.h"
#include "sim/step/live_tuning.h"

namespace placode::assessment {

namespace {

Reason make_reason(std::string item, ReasonMeaning meaning, double points, double time_s,
                   bool critical) {
    Reason reason{std::move(item), {}, points, time_s, critical, std::move(meaning)};
    reason.text = english_words(reason.meaning, points);
    return reason;
}

/// Everything that a line is judged by.
struct Sight {
    const Rubric& rubric;
    const MetricSet& metrics;
    const sim::Recording& recording;
    double weights;  ///< Of all lines that earn the points.
};

/// Points that a line takes at this value of its metric, before its cap.
double cost(const Sight& sight, const RubricItem& item, double value) {
    const double beyond = item.below ? item.threshold - value : value - item.threshold;
    if (!(beyond > 0)) return 0;
    double points = item.points_fixed + item.points_per_unit * beyond;
    if (item.earns > 0 && item.below && item.threshold > 0)
        points += sight.rubric.start_points * item.earns / sight.weights *
                  std::min(1.0, beyond / item.threshold);
    return std::min(item.max_points, points);
}

/// A line whose metric is missing. Made by an older program the recording cannot tell: no points
/// are taken, and no pass is given. Else nothing was done that could be measured: the line counts
/// in full.
Reason missing(const Sight& sight, const RubricItem& item, bool recorded) {
    ReasonMeaning meaning;
    meaning.metric = item.metric;
    if (!recorded) {
        meaning.pattern = "Not recorded, so this is no pass: {metric}.";
        return make_reason(item.id, std::move(meaning), 0, -1, false);
    }
    constexpr double kFar = 1e9;
    meaning.pattern = kNotMeasuredPattern;
    return make_reason(item.id, std::move(meaning), cost(sight, item, item.below ? -kFar : kFar),
                       -1, false);
}

/// True when the recording shows that something was done: rubrics that do not say what counts as
/// that do not ask.
bool attempted(const Rubric& rubric, const MetricSet& metrics) {
    if (rubric.attempted_by.empty()) return true;
    const bool earned =
        std::any_of(rubric.items.begin(), rubric.items.end(), [&](const RubricItem& item) {
            return item.earns > 0 && metrics.find(item.metric).value_or(0) > 0;
        });
    return earned ||
           std::any_of(rubric.attempted_by.begin(), rubric.attempted_by.end(),
                       [&](const std::string& id) { return metrics.find(id).value_or(0) > 0; });
}

/// The lines in the order of the rubric. `proven` = nothing that decides is unknown.
std::vector<Reason> judge_lines(const Sight& sight, bool& proven) {
    const std::vector<std::string_view> unknown = not_recorded(sight.recording);
    std::vector<Reason> reasons;
    for (const RubricItem& item : sight.rubric.items) {
        const std::optional<double> value = sight.metrics.find(item.metric);
        if (!value) {
            const bool recorded =
                std::find(unknown.begin(), unknown.end(), item.metric) == unknown.end();
            Reason reason = missing(sight, item, recorded);
            proven = proven && recorded && !item.critical;
            if (!recorded || item.critical || reason.points > 0)
                reasons.push_back(std::move(reason));
            continue;
        }
        const double lost = cost(sight, item, *value);
        const double beyond = item.below ? item.threshold - *value : *value - item.threshold;
        // Less than a twentieth of a point is no reason worth reading.
        if (!(beyond > 0) || (lost < 0.05 && !item.critical)) continue;
        const Locus locus = locate(item.metric, item.threshold, sight.recording);
        const int hour = locus.at_m ? clock_hour(locus.at_m->x(), locus.at_m->y()) : 0;
        reasons.push_back(make_reason(
            item.id,
            {item.reason, item.reason_pl, item.metric, *value, locus.count, hour, locus.between},
            lost, locus.time_s, item.critical));
    }
    return reasons;
}

/// Tissue that was changed by hand is not the task's: such an attempt shows something, it proves
/// nothing.
void add_tuned(const sim::Recording& recording, std::vector<Reason>& reasons) {
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::EventKind::kTuned) continue;
        ReasonMeaning meaning;
        meaning.pattern = "Tissue or generator was tuned: this attempt is not scored as a pass.";
        reasons.insert(reasons.begin(),
                       make_reason("tuned", std::move(meaning), 0, event.time_s, true));
        return;
    }
}

/// Nobody is judged by what was given to them.
Reason given_reason(int stage) {
    ReasonMeaning meaning;
    meaning.pattern = "Not scored: begun at stage {value}, what came before was given.";
    meaning.value = stage;
    return make_reason(std::string(kGivenItem), std::move(meaning), 0, -1, false);
}

}  // namespace

const char* verdict_name(Verdict verdict) noexcept {
    constexpr const char* kNames[]{"passed", "not yet", "failed", "not attempted"};
    const auto i = static_cast<size_t>(verdict);
    return i < std::size(kNames) ? kNames[i] : "unknown";
}

int clock_hour(double x_m, double y_m) noexcept {
    // +x is up and +y is left in the picture, so the clock runs from +x towards -y.
    const double turns = std::atan2(-y_m, x_m) / (2 * std::numbers::pi);
    const int hour = static_cast<int>(std::lround(turns * 12 + 12)) % 12;
    return hour == 0 ? 12 : hour;
}

Score score_attempt(const Rubric& rubric, const MetricSet& metrics,
                    const sim::Recording& recording) {
    Score score;
    score.rubric_id = rubric.id;
    score.rubric_version = rubric.version;
    score.metric_set_version = metrics.version;
    if (recording.header.stage != 0) {
        score.reasons.push_back(given_reason(recording.header.stage));
        return score;
    }
    std::vector<Reason> tuned;
    add_tuned(recording, tuned);
    if (tuned.empty() && !attempted(rubric, metrics)) {
        score.verdict = Verdict::kNotAttempted;
        ReasonMeaning meaning;
        meaning.pattern = "Nothing was done: this attempt does not count.";
        score.reasons.push_back(make_reason(std::string(kNotAttemptedItem), std::move(meaning),
                                            rubric.start_points, -1, false));
        return score;
    }
    Sight sight{rubric, metrics, recording, 0};
    for (const RubricItem& item : rubric.items) sight.weights += item.earns;
    bool proven = true, critical = false;
    score.reasons = judge_lines(sight, proven);
    score.reasons.insert(score.reasons.begin(), tuned.begin(), tuned.end());
    double points = rubric.start_points;
    for (const Reason& reason : score.reasons) {
        points -= reason.points;
        critical = critical || reason.critical;
    }
    score.points = std::clamp(points, 0.0, 100.0);
    std::stable_sort(score.reasons.begin(), score.reasons.end(),
                     [](const Reason& a, const Reason& b) {
                         // What failed the attempt comes first, also where it took no points.
                         return a.critical != b.critical ? a.critical : a.points > b.points;
                     });
    score.verdict = critical                                       ? Verdict::kFailed
                    : proven && score.points >= rubric.pass_points ? Verdict::kPassed
                                                                   : Verdict::kNotYet;
    return score;
}

}  // namespace placode::assessment
