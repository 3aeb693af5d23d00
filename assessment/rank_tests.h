// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Comparison of groups by ranks, with effect sizes and intervals: exact where small, ties handled.
// Names of the fields follow R (wilcox.test, coin, effectsize, rstatix), whose values they
// reproduce.

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placode::assessment {

/// An estimate with its 95 % interval.
struct Interval {
    double low = 0, high = 0;
};

/// Two-sided p of a standard normal z; NaN for NaN.
[[nodiscard]] double normal_two_sided_p(double z);

/// Ranks from 1, ties get their mean rank (n).
[[nodiscard]] std::vector<double> mid_ranks(std::span<const double> values);

/// Sum of t^3 - t over groups of tied values.
[[nodiscard]] double tie_sum(std::span<const double> values);

struct MannWhitney {
    int n1 = 0, n2 = 0;
    double u1 = 0, u2 = 0;  ///< U1 = R1 - n1 (n1 + 1) / 2.
    double z = 0;           ///< Without continuity correction, tie-corrected.
    double p_asymptotic_cc = 1, p_asymptotic_nocc = 1;  ///< Two-sided.
    std::optional<double> p_exact;       ///< Permutation distribution with ties; n1 + n2 <= 60.
    double r = 0;                        ///< |z| / sqrt(N).
    double a12 = 0.5, cliffs_delta = 0;  ///< A12 = U1 / (n1 n2), delta = 2 A12 - 1.
    double hodges_lehmann = 0;           ///< Shift of group 1 against group 2.
    Interval hodges_lehmann_ci95;        ///< By inversion of the test with continuity correction.
    double mean1 = 0, sd1 = 0, mean2 = 0, sd2 = 0;  ///< Sample SD (n - 1).
    double cohens_d = 0, hedges_g = 0,
           glass_delta = 0;                 ///< Pooled SD; exact gamma factor; SD of group 2.
    Interval cohens_d_ci95, hedges_g_ci95;  ///< By the noncentral t distribution.
    double welch_t = 0, welch_df = 0, welch_p = 1;
};
/// What needs a spread (SD, d, g, Welch) is NaN where a group has one value or nothing varies.
/// @pre both groups have a value; throws std::invalid_argument otherwise.
[[nodiscard]] MannWhitney mann_whitney(std::span<const double> group1,
                                       std::span<const double> group2);

struct WilcoxonPaired {
    int n = 0, n_nonzero = 0;
    double v = 0;  ///< Sum of ranks of positive differences (before - after).
    double z = 0;  ///< Zeros dropped (Wilcoxon), no continuity correction.
    double p_cc = 1, p_nocc = 1;
    std::optional<double> p_exact;  ///< n_nonzero <= 60.
    double z_pratt = 0, p_pratt = 1;
    double matched_rank_biserial = 0;
    double r = 0;  ///< |z| / sqrt(n_nonzero).
    double cohens_dz = 0, paired_t = 0, paired_t_p = 1;
};
/// Differences are compared exactly as R does: 1.1 - 1.0 and 2.1 - 2.0 are no tie. With `digits`
/// above 0 they are rounded to that many significant digits first (R 4.3's digits.rank).
/// d and the paired t are NaN where the differences do not vary.
/// @pre same length, at least 1 pair, not all equal; throws std::invalid_argument otherwise.
[[nodiscard]] WilcoxonPaired wilcoxon_paired(std::span<const double> before,
                                             std::span<const double> after, int digits = 0);

struct DunnComparison {
    std::string group1, group2;
    double z = 0, p = 1, p_holm = 1, p_bonferroni = 1;  ///< z > 0: group 2 ranks higher.
};
struct KruskalWallis {
    int n = 0;
    double h = 0;  ///< Tie-corrected.
    int df = 0;
    double p = 1, epsilon2 = 0, eta2_h = 0;  ///< H / (n - 1); (H - k + 1) / (n - k).
    std::vector<DunnComparison> dunn;        ///< All pairs, groups in order of `names`.
};
struct NamedGroup {
    std::string name;
    std::vector<double> values;
};
/// @pre at least two groups, none empty; throws std::invalid_argument otherwise.
[[nodiscard]] KruskalWallis kruskal_wallis(std::span<const NamedGroup> groups);

/// Friedman test over k columns of n rows (row = block), tie-corrected. NaN when all rows are tied.
struct Friedman {
    double chi_square = 0;
    int df = 0;
    double p = 1, kendall_w = 0;
};
[[nodiscard]] Friedman friedman(const std::vector<std::vector<double>>& rows);

/// Holm's step-down adjustment, in the order of the input.
[[nodiscard]] std::vector<double> holm_adjusted(std::span<const double> p_values);

}  // namespace placode::assessment
