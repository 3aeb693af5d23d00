// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a score grows with practice: exponential approach to a plateau, or a power law.

#include <cstddef>
#include <optional>
#include <span>

#include "assessment/rank_tests.h"

namespace placode::assessment {

/// Attempts of a person from which pages and reports show a curve: four, as many as R fits, leave
/// one degree of freedom.
inline constexpr size_t kCurveFrom = 5;

/// y = asymptote - gain exp(-(trial - 1) / tau), least squares.
struct ExponentialFit {
    double asymptote = 0, gain = 0, tau_trials = 0;
    double se_asymptote = 0, se_gain = 0, se_tau = 0;
    double rss = 0, r2 = 0, aic = 0;
    double trial_to_95pct_of_gain = 0;  ///< 1 + tau ln 20.
    bool converged = false;
};

/// log y = log a + b log trial, positive scores only.
struct PowerFit {
    double log_a = 0, b = 0, r2 = 0;
    int n_positive = 0;
};

struct LearningCurve {
    int n = 0;
    bool constant = false;  ///< All scores are equal: there is nothing to fit.
    /// Absent below 4 trials, when all scores are equal, or when nothing can be fitted.
    std::optional<ExponentialFit> exponential;
    std::optional<PowerFit> power;  ///< Absent below 3 positive scores.
    double mean_first10 = 0, mean_last10 = 0;
    std::optional<Interval> last10_slope_ci95;  ///< Per trial; absent below 3 trials.
    bool plateau = false;  ///< Past 95 % of the gain, and the slope's interval contains 0.
};

/// Scores of one person in order of the trials.
[[nodiscard]] LearningCurve learning_curve(std::span<const double> scores);

}  // namespace placode::assessment
