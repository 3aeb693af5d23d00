// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/rank_tests.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

#include "assessment/statistics.h"

namespace placode::assessment {
namespace {

double t_two_sided(double t, double df) {
    return std::min(1.0, 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(df),
                                                                      std::abs(t))));
}

/// `value` rounded to `digits` significant digits; unchanged for 0 digits.
double significant(double value, int digits) {
    if (digits <= 0 || value == 0) return value;
    const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

double sign(double value) { return value > 0 ? 1.0 : value < 0 ? -1.0 : 0.0; }

/// Exact two-sided p of the sum of signed ranks: every sign pattern is equally likely.
double exact_signed_rank_p(std::span<const double> ranks, double v) {
    std::vector<double> chances{1.0};  // chances[s]: patterns whose positive ranks sum to s / 2
    double total_half = 0;
    for (const double rank : ranks) {
        const auto step = static_cast<size_t>(std::lround(2 * rank));
        std::vector<double> next(chances.size() + step, 0.0);
        for (size_t s = 0; s < chances.size(); ++s) {
            next[s] += chances[s] / 2;
            next[s + step] += chances[s] / 2;
        }
        chances.swap(next);
        total_half += rank;
    }
    const double distance = std::abs(2 * v - total_half) - 1e-9;  // in units of half ranks
    double p = 0;
    for (size_t s = 0; s < chances.size(); ++s) {
        if (std::abs(static_cast<double>(s) - total_half) >= distance) p += chances[s];
    }
    return std::min(1.0, p);
}

}  // namespace

double normal_two_sided_p(double z) {
    if (std::isnan(z)) return z;
    return std::min(
        1.0, 2 * boost::math::cdf(boost::math::complement(boost::math::normal(), std::abs(z))));
}

std::vector<double> mid_ranks(std::span<const double> values) {
    std::vector<size_t> order(values.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return values[a] < values[b]; });
    std::vector<double> ranks(values.size());
    for (size_t i = 0; i < order.size();) {
        size_t end = i;
        while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
        const double rank = 0.5 * static_cast<double>(i + 1 + end);
        for (; i < end; ++i) ranks[order[i]] = rank;
    }
    return ranks;
}

double tie_sum(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    double sum = 0;
    for (size_t i = 0; i < sorted.size();) {
        size_t end = i;
        while (end < sorted.size() && sorted[end] == sorted[i]) ++end;
        const auto t = static_cast<double>(end - i);
        sum += t * t * t - t;
        i = end;
    }
    return sum;
}

namespace {

/// Pratt's form of the signed ranks: zeros take part in the ranking and are dropped afterwards.
void add_pratt(const std::vector<double>& difference, const std::vector<double>& magnitude,
               WilcoxonPaired& result) {
    const std::vector<double> pratt = mid_ranks(magnitude);
    double pratt_v = 0, pratt_sum = 0, pratt_squares = 0;
    for (size_t i = 0; i < pratt.size(); ++i) {
        if (difference[i] == 0) continue;
        if (difference[i] > 0) pratt_v += pratt[i];
        pratt_sum += pratt[i];
        pratt_squares += pratt[i] * pratt[i];
    }
    result.z_pratt = (pratt_v - pratt_sum / 2) / std::sqrt(pratt_squares / 4);
    result.p_pratt = normal_two_sided_p(result.z_pratt);
}

/// The paired t-test of the same differences, and Cohen's d of them.
void add_paired_t(const std::vector<double>& difference, WilcoxonPaired& result) {
    const double n = static_cast<double>(result.n);
    const double mean = *mean_of(difference);
    double variance = 0;
    for (const double d : difference) variance += (d - mean) * (d - mean);
    const double sd = std::sqrt(variance / (n - 1));
    result.cohens_dz = result.paired_t = result.paired_t_p =
        std::numeric_limits<double>::quiet_NaN();
    if (n > 1 && sd > 0) {
        result.cohens_dz = mean / sd;
        result.paired_t = mean / (sd / std::sqrt(n));
        result.paired_t_p = t_two_sided(result.paired_t, n - 1);
    }
}

}  // namespace

WilcoxonPaired wilcoxon_paired(std::span<const double> before, std::span<const double> after,
                               int digits) {
    if (before.size() != after.size() || before.empty()) {
        throw std::invalid_argument(
            "wilcoxon: needs two columns of equal length with at least 1 pair");
    }
    std::vector<double> difference(before.size()), nonzero, magnitude, all_magnitude;
    for (size_t i = 0; i < before.size(); ++i) {
        difference[i] = significant(before[i] - after[i], digits);
        all_magnitude.push_back(std::abs(difference[i]));
        if (difference[i] == 0) continue;
        nonzero.push_back(difference[i]);
        magnitude.push_back(std::abs(difference[i]));
    }
    if (nonzero.empty())
        throw std::invalid_argument("wilcoxon: all pairs are equal, nothing can be tested");
    WilcoxonPaired result;
    result.n = static_cast<int>(difference.size());
    result.n_nonzero = static_cast<int>(nonzero.size());
    const std::vector<double> ranks = mid_ranks(magnitude);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < ranks.size(); ++i) {
        if (nonzero[i] > 0) result.v += ranks[i];
        sum += ranks[i];
        squares += ranks[i] * ranks[i];
    }
    const double sigma = std::sqrt(squares / 4);
    const double centred = result.v - sum / 2;
    result.z = centred / sigma;
    result.p_nocc = normal_two_sided_p(result.z);
    result.p_cc = normal_two_sided_p((centred - 0.5 * sign(centred)) / sigma);
    if (result.n_nonzero <= 60) result.p_exact = exact_signed_rank_p(ranks, result.v);
    result.matched_rank_biserial = (2 * result.v - sum) / sum;
    result.r = std::abs(result.z) / std::sqrt(static_cast<double>(result.n_nonzero));
    add_pratt(difference, all_magnitude, result);
    add_paired_t(difference, result);
    return result;
}

std::vector<double> holm_adjusted(std::span<const double> p_values) {
    const size_t m = p_values.size();
    std::vector<size_t> order(m);
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(),
              [&](size_t a, size_t b) { return p_values[a] < p_values[b]; });
    std::vector<double> adjusted(m);
    double running = 0;
    for (size_t i = 0; i < m; ++i) {
        running = std::max(running, std::min(1.0, static_cast<double>(m - i) * p_values[order[i]]));
        adjusted[order[i]] = running;
    }
    return adjusted;
}

KruskalWallis kruskal_wallis(std::span<const NamedGroup> groups) {
    std::vector<double> all;
    for (const NamedGroup& group : groups) {
        if (group.values.empty())
            throw std::invalid_argument("kruskal: group \"" + group.name + "\" is empty");
        all.insert(all.end(), group.values.begin(), group.values.end());
    }
    if (groups.size() < 2) throw std::invalid_argument("kruskal: needs at least two groups");
    const std::vector<double> ranks = mid_ranks(all);
    const auto n = static_cast<double>(all.size());
    const double ties = tie_sum(all);
    if (ties >= n * n * n - n) throw std::invalid_argument("kruskal: all values are equal");
    std::vector<double> mean_rank, size;
    double sum = 0;
    size_t at = 0;
    for (const NamedGroup& group : groups) {
        const double total =
            std::accumulate(ranks.begin() + static_cast<long>(at),
                            ranks.begin() + static_cast<long>(at + group.values.size()), 0.0);
        at += group.values.size();
        size.push_back(static_cast<double>(group.values.size()));
        mean_rank.push_back(total / size.back());
        sum += total * total / size.back();
    }
    KruskalWallis result;
    result.n = static_cast<int>(all.size());
    result.df = static_cast<int>(groups.size()) - 1;
    result.h = (12 * sum / (n * (n + 1)) - 3 * (n + 1)) / (1 - ties / (n * n * n - n));
    result.p = boost::math::cdf(
        boost::math::complement(boost::math::chi_squared(result.df), std::max(0.0, result.h)));
    result.epsilon2 = result.h / (n - 1);
    const auto k = static_cast<double>(groups.size());
    result.eta2_h = n > k ? (result.h - k + 1) / (n - k) : 0;
    const double variance = n * (n + 1) / 12 - ties / (12 * (n - 1));
    std::vector<double> p_values;
    for (size_t a = 0; a < groups.size(); ++a) {
        for (size_t b = a + 1; b < groups.size(); ++b) {
            DunnComparison pair{groups[a].name, groups[b].name};
            pair.z =
                (mean_rank[b] - mean_rank[a]) / std::sqrt(variance * (1 / size[a] + 1 / size[b]));
            pair.p = normal_two_sided_p(pair.z);
            p_values.push_back(pair.p);
            result.dunn.push_back(pair);
        }
    }
    const std::vector<double> holm = holm_adjusted(p_values);
    for (size_t i = 0; i < result.dunn.size(); ++i) {
        result.dunn[i].p_holm = holm[i];
        result.dunn[i].p_bonferroni =
            std::min(1.0, p_values[i] * static_cast<double>(p_values.size()));
    }
    return result;
}

Friedman friedman(const std::vector<std::vector<double>>& rows) {
    if (rows.size() < 2 || rows.front().size() < 2) {
        throw std::invalid_argument("friedman: needs at least 2 rows and 2 columns");
    }
    const auto n = static_cast<double>(rows.size());
    const auto k = static_cast<double>(rows.front().size());
    std::vector<double> sum(rows.front().size(), 0.0);
    double ties = 0;
    for (const auto& row : rows) {
        const std::vector<double> ranks = mid_ranks(row);
        for (size_t j = 0; j < sum.size(); ++j) sum[j] += ranks[j];
        ties += tie_sum(row);
    }
    double squares = 0;
    for (const double s : sum) squares += (s - n * (k + 1) / 2) * (s - n * (k + 1) / 2);
    Friedman result;
    result.df = static_cast<int>(k) - 1;
    const double spread = n * k * (k + 1) - ties / (k - 1);
    if (!(spread > 0)) {  // Every row is tied throughout: there is nothing to rank.
        result.chi_square = result.p = result.kendall_w = std::numeric_limits<double>::quiet_NaN();
        return result;
    }
    result.chi_square = 12 * squares / spread;
    result.p = boost::math::cdf(
        boost::math::complement(boost::math::chi_squared(result.df), result.chi_square));
    result.kendall_w = result.chi_square / (n * (k - 1));
    return result;
}

}  // namespace placode::assessment
