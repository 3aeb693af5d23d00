// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Correlation of two columns, with intervals named by method. Values as R's cor.test gives them.

#include <span>

#include "assessment/rank_tests.h"

namespace placode::assessment {

struct Correlation {
    int n = 0;
    double spearman = 0, spearman_p_t_approx = 1, spearman_s = 0;
    Interval spearman_ci95;  ///< Fisher z with SE^2 = (1 + r^2/2)/(n - 3), Bonett & Wright 2000.
    double kendall_tau_b = 0, kendall_p = 1;
    double pearson = 0, pearson_p = 1;
    Interval pearson_ci95;  ///< Fisher z.
};

/// The intervals are NaN for 3 pairs: they divide by n - 3.
/// @pre same length, at least 3 pairs, neither column constant; throws std::invalid_argument
/// otherwise.
[[nodiscard]] Correlation correlation(std::span<const double> x, std::span<const double> y);

/// Pearson's r. NaN when a column is constant.
[[nodiscard]] double pearson(std::span<const double> x, std::span<const double> y);

}  // namespace placode::assessment
