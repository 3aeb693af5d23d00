// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Receiver operating characteristic: area with DeLong's variance, best threshold, paired
// comparison.

#include <span>
#include <vector>

#include "assessment/rank_tests.h"

namespace placode::assessment {

struct Roc {
    int positives = 0, negatives = 0;
    double auc = 0.5;
    double delong_se = 0;  ///< 0 with a perfect separation: then use exact bounds of the rates.
    Interval delong_ci95_unclipped, delong_ci95;  ///< Clipped to [0, 1].
    double youden_threshold = 0;  ///< Midpoint between values; positive when above. -inf
                                  ///< when calling everybody positive is best.
    double sensitivity = 0, specificity = 0;
    std::vector<double> positive_placements,
        negative_placements;  ///< DeLong's structural components.
};

/// Higher values speak for `positive`. @pre both classes present; throws std::invalid_argument
/// otherwise.
[[nodiscard]] Roc roc(std::span<const double> values, const std::vector<bool>& positive);

struct RocComparison {
    double z = 0, p = 1;
};
/// Two predictors on the same cases (paired DeLong).
[[nodiscard]] RocComparison compare_paired(const Roc& first, const Roc& second);

}  // namespace placode::assessment
