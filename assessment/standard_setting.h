// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where to draw the pass mark: contrasting groups, Angoff, and sequential tests of competence.

#include <span>
#include <vector>

#include "assessment/rank_tests.h"

namespace placode::assessment {

struct ContrastingGroups {
    int n_novice = 0, n_expert = 0;
    double mean_novice = 0, sd_novice = 0, mean_expert = 0, sd_expert = 0;  ///< Sample SD.
    std::vector<double> roots;  ///< Where the two normal densities are equal, ascending.
    double cut_score = 0;       ///< The root between the means.
    double theoretical_false_positive = 0,
           theoretical_false_negative = 0;  ///< Novices above, experts below.
    double observed_false_positive = 0, observed_false_negative = 0;
    double auc = 0.5, mannwhitney_p_cc = 1, cohens_d = 0;  ///< d: expert - novice.
};
/// Jorgensen, Konge & Subhi 2018. Higher scores are better.
/// @pre at least 2 values a group, both vary, means differ; throws std::invalid_argument otherwise,
/// also when no root lies between the means.
[[nodiscard]] ContrastingGroups contrasting_groups(std::span<const double> novices,
                                                   std::span<const double> experts);

struct Angoff {
    int judges = 0, items = 0;
    std::vector<double> judge_totals;
    double cut_score_items = 0, cut_percent = 0, sd_judges = 0, se_cut = 0;  ///< SE = SD / sqrt(J).
    double sd_percent = 0, se_percent = 0;                                   ///< Of cut_percent.
};
/// `probability[judge][item]` in 0..1. Throws std::invalid_argument naming what is out of range.
/// With `weights` (above 0, one an item) cut_percent is the weighted share; totals stay in items.
[[nodiscard]] Angoff angoff(const std::vector<std::vector<double>>& probability,
                            std::span<const double> weights = {});

/// Limits of the CUSUM chart. Source: Bolsin & Colson 2000.
struct CusumLimits {
    double p0 = 0.05, p1 = 0.10, alpha = 0.05, beta = 0.20;
    double p = 0, q = 0, s = 0, h0_lower = 0, h1_upper = 0;
};
/// @pre 0 < p0 < p1 < 1, 0 < alpha, beta < 1; throws std::invalid_argument otherwise.
[[nodiscard]] CusumLimits cusum_limits(double p0, double p1, double alpha, double beta);

struct Cusum {
    CusumLimits limits;
    std::vector<double> path;  ///< Failure +(1 - s), success -s.
    int failures = 0;
    int first_above_h1 = 0;  ///< Trial from 1; 0 = never. Performance is unacceptable from here.
    int first_below_h0 = 0;  ///< Trial from 1; 0 = never. Acceptable from here.
};
[[nodiscard]] Cusum cusum(const std::vector<bool>& failed, const CusumLimits& limits);

struct LcCusum {
    double w_failure = 0, w_success = 0;
    std::vector<double> path;  ///< W_t = max(0, W_{t-1} + w).
    int first_reach_h = 0;     ///< Trial from 1; 0 = not competent yet.
};
/// Learning-curve CUSUM. Source: Biau & Porcher 2010. @pre 0 < p_adequate < p_inadequate < 1, h >
/// 0.
[[nodiscard]] LcCusum lc_cusum(const std::vector<bool>& failed, double p_adequate,
                               double p_inadequate, double h);

}  // namespace placode::assessment
