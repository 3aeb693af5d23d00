// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Is a metric worth its weight? Difference between levels, repeatability, ceiling; what has no
// evidence is flagged, so that it can leave the score.

#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics.h"

namespace placode::assessment {

/// Repeats of one person in one metric, in order of time.
struct Repeats {
    int level = 0;  ///< 0 = novice, 1 = expert.
    std::vector<double> values;
};

struct MetricQuality {
    std::string metric;
    int novices = 0, experts = 0;  ///< Persons with a value.
    /// Means of persons, experts against novices, positive = experts better: Hedges' g with its 95
    /// % interval (noncentral t), Cliff's delta.
    std::optional<double> g, g_low, g_high, cliff_delta;
    int repeats = 0, repeated = 0;  ///< Repeats of each used, persons with that many.
    std::optional<double> icc, icc_low, icc_high;  ///< ICC(2,1) over these repeats.
    std::optional<double> ceiling_percent;  ///< Share of all values at the best one that occurs.
    bool separates = false;                 ///< The interval of g is above 0.
    bool repeatable = false;                ///< icc >= 0.5.
    bool ceiling = false;                   ///< Over 20 % of the values at the best one.
    bool evidence = false;                  ///< separates and repeatable and no ceiling.
    std::string why;                        ///< Plain words where evidence is missing.
};

/// @param repeats how many repeats of each person enter the ICC; persons with fewer are left out.
/// @pre repeats >= 2. What cannot be computed (too few people, no spread) is absent, and said.
[[nodiscard]] MetricQuality metric_quality(const std::string& metric, Direction direction,
                                           const std::vector<Repeats>& people, int repeats);

}  // namespace placode::assessment
