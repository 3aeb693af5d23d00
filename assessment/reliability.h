// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Internal consistency (alpha, omega) and agreement of raters (ICC). Values as R's psych and
// lavaan.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "assessment/rank_tests.h"

namespace placode::assessment {

/// Rows are respondents, columns items (n x k). Complete cases only: the caller counts what it left
/// out.
using Scores = std::vector<std::vector<double>>;

struct Alpha {
    int n = 0, k = 0;
    double raw = 0, standardized = 0, mean_interitem_r = 0;
    std::optional<double> g6;  ///< Guttman's lambda 6; none when items are linearly dependent.
    double ase = 0;            ///< Asymptotic standard error, Duhachek & Iacobucci 2004.
    Interval feldt_ci95, duhachek_ci95;
    std::vector<double> alpha_if_dropped;        ///< (k), empty for two items.
    std::vector<double> corrected_item_total_r;  ///< (k)
};
/// @pre n >= 3, k >= 2, no constant item; throws std::invalid_argument otherwise.
[[nodiscard]] Alpha cronbach_alpha(const Scores& scores);

/// One-factor model: loadings and unique variances.
struct Omega {
    double total_ml =
        0;  ///< (sum l)^2 / ((sum l)^2 + sum theta), maximum likelihood on covariances.
    double total_minres = 0;              ///< Same by least squares on correlations.
    std::vector<double> loadings, theta;  ///< Of the maximum-likelihood fit (k).
    bool converged = false;
};
/// @pre as cronbach_alpha, n > k >= 3.
[[nodiscard]] Omega mcdonald_omega(const Scores& scores);

struct IccForm {
    double icc = 0, f = 0, df1 = 0, df2 = 0, p = 1;
    Interval ci95;
};
/// All six forms of Shrout & Fleiss 1979.
struct Icc {
    int subjects = 0, raters = 0;
    IccForm icc1, icc2, icc3, icc1k, icc2k, icc3k;
    double ms_rows = 0, ms_columns = 0, ms_error = 0;
    double sem_agreement = 0, sem_consistency = 0;
};
/// Rows are subjects, columns raters. Perfect agreement is 1 with an infinite F; what is not
/// defined is NaN. @pre at least 2 x 2, complete, not all equal; throws std::invalid_argument
/// otherwise.
[[nodiscard]] Icc intraclass_correlation(const Scores& ratings);

/// `minimum + maximum - x`: turns a reverse-keyed item round.
[[nodiscard]] constexpr double reversed(double x, double minimum, double maximum) {
    return minimum + maximum - x;
}

}  // namespace placode::assessment
