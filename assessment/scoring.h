// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From metrics and events to a score of 0..100 with reasons: a rubric is data, this is the rule.

#include <string>
#include <vector>

#include "assessment/metrics.h"

namespace placode::assessment {

/// One line of a rubric: takes points off.
struct RubricItem {
    std::string id;              ///< "placode_burned"
    std::string metric;          ///< Metric id it looks at.
    std::string reason;          ///< Plain words with {value}, {unit}, {points}, {where}, {count}.
    double threshold = 0;        ///< Free up to here.
    double points_per_unit = 0;  ///< Points for each unit beyond the threshold.
    double points_fixed = 0;     ///< Points as soon as it is beyond the threshold.
    double max_points = 100;     ///< Cap of this line.
    bool critical = false;  ///< Beyond the threshold: the attempt is failed whatever the score.
    bool below = false;     ///< true: being below the threshold costs (completeness).
};

struct Rubric {
    std::string id;
    int version = 1;
    double start_points = 100;
    double pass_points = 70;
    std::vector<RubricItem> items;
};

/// Why points were lost, with the place in the recording that shows it.
struct Reason {
    std::string item;    ///< RubricItem::id
    std::string text;    ///< "The needle rested 3.2 s on one spot at 4 o'clock."
    double points = 0;   ///< Lost.
    double time_s = -1;  ///< Where to look in the recording; -1 = whole attempt.
    bool critical = false;
};

enum class Verdict : uint8_t { kPassed, kNotYet, kFailed };

struct Score {
    double points = 0;
    Verdict verdict = Verdict::kNotYet;
    std::vector<Reason> reasons;  ///< Critical ones first, then the most costly.
    std::string rubric_id;
    int rubric_version = 1;
    int metric_set_version = kMetricSetVersion;
};

[[nodiscard]] Score score_attempt(const Rubric& rubric, const MetricSet& metrics,
                                  const sim::Recording& recording);

/// Clock position of a point of the field seen from the scope: "12 o'clock" is cranial (+x).
[[nodiscard]] int clock_hour(double x_m, double y_m) noexcept;

}  // namespace placode::assessment
