// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From metrics and events to a score of 0..100 with reasons: a rubric is data, this is the rule.

#include <string>
#include <vector>

#include "assessment/metrics.h"
#include "assessment/reason.h"

namespace placode::assessment {

/// One line of a rubric: takes points off. A line that earns says what the task asks for: the
/// points of all start at nothing and grow with the share of it that was done, so that harm that
/// was avoided counts only where something was done.
struct RubricItem {
    std::string id;              ///< "placode_burned"
    std::string metric;          ///< Metric id it looks at.
    std::string reason;          ///< English sentence with places (reason.h).
    double threshold = 0;        ///< Free up to here.
    double points_per_unit = 0;  ///< Points for each unit beyond the threshold.
    double points_fixed = 0;     ///< Points as soon as it is beyond the threshold.
    double max_points = 100;     ///< Cap of this line.
    bool critical = false;  ///< Beyond the threshold: the attempt is failed whatever the score.
    bool below = false;     ///< true: being below the threshold costs (completeness).
    /// Weight of this line (with `below`) among those that earn the start points: at `threshold`
    /// its share is earned, at 0 nothing of it, in proportion between. 0 = an ordinary line.
    double earns = 0;
    std::string reason_pl = {};  ///< `reason` in Polish; may be empty.
};

struct Rubric {
    std::string id;
    int version = 1;
    double start_points = 100;
    double pass_points = 70;
    std::vector<RubricItem> items;
    /// Metrics that show that something was done, beside those that earn points: where all are 0
    /// the attempt is "not attempted". Empty: not asked.
    std::vector<std::string> attempted_by;
};

/// Stored as a number: append only. An attempt in which nothing was done is neither passed nor a
/// try that failed; it has 0 points.
enum class Verdict : uint8_t { kPassed, kNotYet, kFailed, kNotAttempted };

/// "passed", "not yet", "failed", "not attempted".
[[nodiscard]] const char* verdict_name(Verdict verdict) noexcept;

/// RubricItem::id of the one reason of an attempt in which nothing was done.
inline constexpr std::string_view kNotAttemptedItem = "not_attempted";
/// Of a line whose metric is missing: it says something of the points, and nothing of what
/// happened.
inline constexpr const char* kNotMeasuredPattern =
    "It could not be measured and counts in full: {metric}.";

/// RubricItem::id of the one reason of an attempt that began at a stage: it has no points.
inline constexpr std::string_view kGivenItem = "given";

struct Score {
    double points = 0;
    Verdict verdict = Verdict::kNotYet;
    /// Critical ones first, then the most costly. Their points and the score make the start points,
    /// but for what would go below 0.
    std::vector<Reason> reasons;
    std::string rubric_id;
    int rubric_version = 1;
    int metric_set_version = kMetricSetVersion;
};

/// Pure function of the three. A metric that the rubric asks for and the recording lacks never
/// helps: where an older program did not record it (see not_recorded()) the line takes nothing and
/// the attempt cannot pass; where there was nothing to measure, the line costs its most. An attempt
/// that began at a stage has no points: a rubric weighs the whole of a task.
[[nodiscard]] Score score_attempt(const Rubric& rubric, const MetricSet& metrics,
                                  const sim::Recording& recording);

/// Clock position of a point of the field seen from the scope: "12 o'clock" is cranial (+x).
[[nodiscard]] int clock_hour(double x_m, double y_m) noexcept;

}  // namespace placode::assessment
