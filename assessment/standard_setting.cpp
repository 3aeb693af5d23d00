// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/standard_setting.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace placode::assessment {
namespace {

double phi(double z) { return boost::math::cdf(boost::math::normal(), z); }

void require(bool holds, const std::string& message) {
    if (!holds) throw std::invalid_argument(message);
}

/// Roots of the quadratic that sets N(m1, s1) equal to N(m2, s2).
std::vector<double> equal_density(double m1, double s1, double m2, double s2) {
    const double a = 1 / (s1 * s1) - 1 / (s2 * s2);
    const double b = 2 * (m2 / (s2 * s2) - m1 / (s1 * s1));
    const double c = m1 * m1 / (s1 * s1) - m2 * m2 / (s2 * s2) + 2 * std::log(s1 / s2);
    if (std::abs(a) < 1e-12 * (1 / (s1 * s1))) return {-c / b};  // equal SD: a straight line
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {};
    // The stable form: no difference of nearly equal numbers.
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    std::vector<double> roots{q / a, c / q};
    std::sort(roots.begin(), roots.end());
    return roots;
}

}  // namespace

ContrastingGroups contrasting_groups(std::span<const double> novices,
                                     std::span<const double> experts) {
    const MannWhitney test = mann_whitney(experts, novices);
    ContrastingGroups result;
    result.n_novice = test.n2;
    result.n_expert = test.n1;
    result.mean_novice = test.mean2;
    result.sd_novice = test.sd2;
    result.mean_expert = test.mean1;
    result.sd_expert = test.sd1;
    require(test.sd1 > 0 && test.sd2 > 0, "contrasting groups: the scores of a group do not vary");
    require(test.mean1 > test.mean2,
            "contrasting groups: the experts' mean " + std::to_string(test.mean1) +
                " is not above the novices' mean " + std::to_string(test.mean2));
    result.auc = test.a12;
    result.mannwhitney_p_cc = test.p_asymptotic_cc;
    result.cohens_d = test.cohens_d;
    result.roots = equal_density(test.mean2, test.sd2, test.mean1, test.sd1);
    const auto between = std::find_if(result.roots.begin(), result.roots.end(),
                                      [&](double r) { return r >= test.mean2 && r <= test.mean1; });
    require(between != result.roots.end(),
            "contrasting groups: the two distributions do not cross between their means");
    const double cut = *between;
    result.cut_score = cut;
    result.theoretical_false_positive = 1 - phi((cut - test.mean2) / test.sd2);
    result.theoretical_false_negative = phi((cut - test.mean1) / test.sd1);
    const auto above = [&](double score) { return score >= cut; };
    result.observed_false_positive =
        static_cast<double>(std::count_if(novices.begin(), novices.end(), above)) / test.n2;
    result.observed_false_negative =
        1 - static_cast<double>(std::count_if(experts.begin(), experts.end(), above)) / test.n1;
    return result;
}

namespace {

/// Mean and spread over the judges of the weighted share in percent.
void add_percent(Angoff& result, const std::vector<std::vector<double>>& probability,
                 std::span<const double> weights) {
    const double n = result.judges;
    double all = 0;
    for (size_t i = 0; i < probability[0].size(); ++i) all += weights.empty() ? 1 : weights[i];
    std::vector<double> shares;
    for (const std::vector<double>& judge : probability) {
        double sum = 0;
        for (size_t i = 0; i < judge.size(); ++i)
            sum += judge[i] * (weights.empty() ? 1 : weights[i]);
        shares.push_back(100 * sum / all);
        result.cut_percent += shares.back() / n;
    }
    double squares = 0;
    for (const double share : shares)
        squares += (share - result.cut_percent) * (share - result.cut_percent);
    result.sd_percent = std::sqrt(squares / (n - 1));
    result.se_percent = result.sd_percent / std::sqrt(n);
}

}  // namespace

Angoff angoff(const std::vector<std::vector<double>>& probability,
              std::span<const double> weights) {
    require(probability.size() >= 2 && !probability[0].empty(),
            "angoff: needs at least 2 judges and 1 item");
    Angoff result;
    result.judges = static_cast<int>(probability.size());
    result.items = static_cast<int>(probability[0].size());
    for (size_t judge = 0; judge < probability.size(); ++judge) {
        require(probability[judge].size() == probability[0].size(),
                "angoff: judge " + std::to_string(judge + 1) + " did not rate all items");
        for (const double p : probability[judge]) {
            require(p >= 0 && p <= 1, "angoff: judge " + std::to_string(judge + 1) + ": " +
                                          std::to_string(p) + " is not between 0 and 1");
        }
        result.judge_totals.push_back(
            std::accumulate(probability[judge].begin(), probability[judge].end(), 0.0));
    }
    const double n = result.judges;
    result.cut_score_items =
        std::accumulate(result.judge_totals.begin(), result.judge_totals.end(), 0.0) / n;
    double squares = 0;
    for (const double total : result.judge_totals)
        squares += (total - result.cut_score_items) * (total - result.cut_score_items);
    result.sd_judges = std::sqrt(squares / (n - 1));
    result.se_cut = result.sd_judges / std::sqrt(n);
    require(weights.empty() || weights.size() == probability[0].size(),
            "angoff: every item needs a weight");
    for (const double w : weights) require(w > 0, "angoff: a weight must be above 0");
    add_percent(result, probability, weights);
    return result;
}

CusumLimits cusum_limits(double p0, double p1, double alpha, double beta) {
    require(p0 > 0 && p0 < p1 && p1 < 1, "cusum: rates must be 0 < p0 < p1 < 1, found p0 = " +
                                             std::to_string(p0) + ", p1 = " + std::to_string(p1));
    require(alpha > 0 && alpha < 1 && beta > 0 && beta < 1,
            "cusum: alpha and beta must lie between 0 and 1");
    CusumLimits limits{p0, p1, alpha, beta};
    limits.p = std::log(p1 / p0);
    limits.q = std::log((1 - p0) / (1 - p1));
    limits.s = limits.q / (limits.p + limits.q);
    limits.h0_lower = -std::log((1 - alpha) / beta) / (limits.p + limits.q);
    limits.h1_upper = std::log((1 - beta) / alpha) / (limits.p + limits.q);
    return limits;
}

Cusum cusum(const std::vector<bool>& failed, const CusumLimits& limits) {
    Cusum result;
    result.limits = limits;
    double sum = 0;
    for (size_t i = 0; i < failed.size(); ++i) {
        sum += failed[i] ? 1 - limits.s : -limits.s;
        result.failures += failed[i];
        result.path.push_back(sum);
        if (sum > limits.h1_upper && result.first_above_h1 == 0)
            result.first_above_h1 = static_cast<int>(i) + 1;
        if (sum < limits.h0_lower && result.first_below_h0 == 0)
            result.first_below_h0 = static_cast<int>(i) + 1;
    }
    return result;
}

LcCusum lc_cusum(const std::vector<bool>& failed, double p_adequate, double p_inadequate,
                 double h) {
    require(p_adequate > 0 && p_adequate < p_inadequate && p_inadequate < 1,
            "lc-cusum: rates must be 0 < adequate < inadequate < 1");
    require(h > 0, "lc-cusum: h must be above 0");
    LcCusum result;
    result.w_failure = std::log(p_adequate / p_inadequate);
    result.w_success = std::log((1 - p_adequate) / (1 - p_inadequate));
    double sum = 0;
    for (size_t i = 0; i < failed.size(); ++i) {
        sum = std::max(0.0, sum + (failed[i] ? result.w_failure : result.w_success));
        result.path.push_back(sum);
        if (sum >= h && result.first_reach_h == 0) result.first_reach_h = static_cast<int>(i) + 1;
    }
    return result;
}

}  // namespace placode::assessment
