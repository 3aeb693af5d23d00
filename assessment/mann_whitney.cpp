// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Two independent groups: U, its exact permutation distribution, and effect sizes.

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "assessment/rank_tests.h"
#include "assessment/statistics.h"

namespace placode::assessment {
namespace {

constexpr double kZ975 = 1.959963984540054;
constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

double variance_of(std::span<const double> values, double mean) {
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return values.size() > 1 ? sum / static_cast<double>(values.size() - 1) : kUndefined;
}

/// Centred rank sum of group 1 after a shift, over its tie-corrected standard deviation.
double shifted_z(std::span<const double> a, std::span<const double> b, double shift, bool correct) {
    std::vector<double> all;
    all.reserve(a.size() + b.size());
    for (const double value : a) all.push_back(value - shift);
    all.insert(all.end(), b.begin(), b.end());
    const std::vector<double> ranks = mid_ranks(all);
    const auto n1 = static_cast<double>(a.size()), n2 = static_cast<double>(b.size()), n = n1 + n2;
    double centred =
        std::accumulate(ranks.begin(), ranks.begin() + static_cast<long>(a.size()), 0.0) -
        n1 * (n1 + 1) / 2 - n1 * n2 / 2;
    if (correct) centred -= centred > 0 ? 0.5 : centred < 0 ? -0.5 : 0;
    const double sigma = std::sqrt(n1 * n2 / 12 * (n + 1 - tie_sum(all) / (n * (n - 1))));
    return sigma > 0 ? centred / sigma : kUndefined;
}

/// Brent's root finder with the steps and the stopping rule of R's `uniroot(tol = 1e-4)`. z(shift)
/// is a step function, so that a flat piece may be the root: which point of it is reported depends
/// on the steps, and published values come from R's. Source: R 4.2, src/library/stats/src/zeroin.c.
template <class F>
double uniroot(const F& f, double a, double b, double fa, double fb) {
    constexpr double kTolerance = 1e-4, kEpsilon = 2.220446049250313e-16;
    double c = a, fc = fa;
    for (int i = 0; i <= 1000; ++i) {
        const double previous = b - a;
        if (std::abs(fc) < std::abs(fb)) {
            a = b, b = c, c = a;
            fa = fb, fb = fc, fc = fa;
        }
        const double enough = 2 * kEpsilon * std::abs(b) + kTolerance / 2;
        double step = (c - b) / 2;
        if (std::abs(step) <= enough || fb == 0) return b;
        if (std::abs(previous) >= enough && std::abs(fa) > std::abs(fb)) {
            const double cb = c - b;
            double p = 0, q = 0;
            if (a == c) {  // linear interpolation
                p = cb * fb / fa;
                q = 1 - fb / fa;
            } else {  // inverse quadratic interpolation
                const double t1 = fb / fc, t2 = fb / fa;
                q = fa / fc;
                p = t2 * (cb * q * (q - t1) - (b - a) * (t1 - 1));
                q = (q - 1) * (t1 - 1) * (t2 - 1);
            }
            p > 0 ? q = -q : p = -p;
            if (p < 0.75 * cb * q - std::abs(enough * q) / 2 && p < std::abs(previous * q / 2))
                step = p / q;
        }
        if (std::abs(step) < enough) step = step > 0 ? enough : -enough;
        a = b, fa = fb;
        b += step;
        fb = f(b);
        if ((fb > 0 && fc > 0) || (fb < 0 && fc < 0)) c = a, fc = fa;
    }
    return b;
}

/// Shift at which the falling step function z(shift) - target changes sign.
double shift_where(std::span<const double> a, std::span<const double> b, double target,
                   bool correct) {
    const auto [a_min, a_max] = std::minmax_element(a.begin(), a.end());
    const auto [b_min, b_max] = std::minmax_element(b.begin(), b.end());
    const double low = *a_min - *b_max, high = *a_max - *b_min;
    const auto f = [&](double shift) { return shifted_z(a, b, shift, correct) - target; };
    const double f_low = f(low), f_high = f(high);
    if (f_low <= 0) return low;
    if (f_high >= 0) return high;
    return uniroot(f, low, high, f_low, f_high);
}

/// Two-sided permutation p: every choice of n1 of the pooled ranks is equally likely.
double exact_p(std::span<const double> ranks, size_t n1, double rank_sum) {
    size_t top = 0;
    for (const double rank : ranks) top += static_cast<size_t>(std::lround(2 * rank));
    // probability[j][s]: j values chosen so far with doubled rank sum s; scaled to stay finite.
    std::vector<std::vector<double>> orders(n1 + 1, std::vector<double>(top + 1, 0.0));
    orders[0][0] = 1;
    for (const double rank : ranks) {
        const auto step = static_cast<size_t>(std::lround(2 * rank));
        for (size_t j = n1; j-- > 0;) {
            for (size_t s = 0; s + step <= top; ++s) orders[j + 1][s + step] += orders[j][s];
        }
    }
    const double total = std::accumulate(orders[n1].begin(), orders[n1].end(), 0.0);
    const double expected =
        static_cast<double>(n1) * (static_cast<double>(ranks.size()) + 1);  // doubled
    const double distance = std::abs(2 * rank_sum - expected) - 1e-9;
    double extreme = 0;
    for (size_t s = 0; s <= top; ++s) {
        if (std::abs(static_cast<double>(s) - expected) >= distance) extreme += orders[n1][s];
    }
    return std::min(1.0, extreme / total);
}

/// Noncentrality at which the cdf of t equals p.
double noncentrality(double t, double df, double p) {
    if (t < 0) return -noncentrality(-t, df, 1 - p);
    // Far out the normal part of t is nothing beside the noncentrality: t = nc / sqrt(chi2 / df).
    if (t > 500)
        return t * std::sqrt(boost::math::quantile(boost::math::chi_squared(df), 1 - p) / df);
    // No more than 1.96 below 0, however far t lies: few degrees of freedom take the lower end to a
    // small share of t, and with one the upper end goes up to 2.24 t.
    double low = -40, high = 4 * t + 40;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        const double value = boost::math::cdf(boost::math::non_central_t(df, middle), t);
        (value > p ? low : high) = middle;  // the cdf falls with the noncentrality
    }
    return 0.5 * (low + high);
}

void effect_sizes(MannWhitney& result) {
    const double n1 = result.n1, n2 = result.n2, df = n1 + n2 - 2;
    const double v1 = result.sd1 * result.sd1, v2 = result.sd2 * result.sd2;
    // A single value has no variance of its own and adds none to the pooled one.
    const auto squares = [](double n, double v) { return n > 1 ? (n - 1) * v : 0; };
    const double pooled = df > 0 ? std::sqrt((squares(n1, v1) + squares(n2, v2)) / df) : 0;
    result.cohens_d = result.hedges_g = result.glass_delta = kUndefined;
    result.cohens_d_ci95 = result.hedges_g_ci95 = {kUndefined, kUndefined};
    result.welch_t = result.welch_df = result.welch_p = kUndefined;
    if (pooled > 0) {
        result.cohens_d = (result.mean1 - result.mean2) / pooled;
        const double j =
            std::exp(std::lgamma(df / 2) - 0.5 * std::log(df / 2) - std::lgamma((df - 1) / 2));
        const double scale = std::sqrt(1 / n1 + 1 / n2), t = result.cohens_d / scale;
        result.cohens_d_ci95 = {noncentrality(t, df, 0.975) * scale,
                                noncentrality(t, df, 0.025) * scale};
        result.hedges_g = j * result.cohens_d;
        result.hedges_g_ci95 = {j * result.cohens_d_ci95.low, j * result.cohens_d_ci95.high};
    }
    if (result.sd2 > 0) result.glass_delta = (result.mean1 - result.mean2) / result.sd2;
    const double a = v1 / n1, b = v2 / n2;
    if (a + b > 0) {
        result.welch_t = (result.mean1 - result.mean2) / std::sqrt(a + b);
        result.welch_df = (a + b) * (a + b) / (a * a / (n1 - 1) + b * b / (n2 - 1));
        result.welch_p =
            2 * boost::math::cdf(boost::math::complement(boost::math::students_t(result.welch_df),
                                                         std::abs(result.welch_t)));
    }
}

}  // namespace

MannWhitney mann_whitney(std::span<const double> group1, std::span<const double> group2) {
    if (group1.empty() || group2.empty())
        throw std::invalid_argument("mann-whitney: each group needs at least 1 value");
    std::vector<double> all(group1.begin(), group1.end());
    all.insert(all.end(), group2.begin(), group2.end());
    const std::vector<double> ranks = mid_ranks(all);
    const double rank_sum =
        std::accumulate(ranks.begin(), ranks.begin() + static_cast<long>(group1.size()), 0.0);
    MannWhitney result;
    result.n1 = static_cast<int>(group1.size());
    result.n2 = static_cast<int>(group2.size());
    const double n1 = result.n1, n2 = result.n2;
    result.u1 = rank_sum - n1 * (n1 + 1) / 2;
    result.u2 = n1 * n2 - result.u1;
    result.z = shifted_z(group1, group2, 0, false);
    result.p_asymptotic_nocc = normal_two_sided_p(result.z);
    result.p_asymptotic_cc = normal_two_sided_p(shifted_z(group1, group2, 0, true));
    if (all.size() <= 60) result.p_exact = exact_p(ranks, group1.size(), rank_sum);
    result.r = std::abs(result.z) / std::sqrt(n1 + n2);
    result.a12 = result.u1 / (n1 * n2);
    result.cliffs_delta = 2 * result.a12 - 1;
    result.hodges_lehmann = shift_where(group1, group2, 0, false);
    result.hodges_lehmann_ci95 = {shift_where(group1, group2, kZ975, true),
                                  shift_where(group1, group2, -kZ975, true)};
    result.mean1 = *mean_of(group1);
    result.mean2 = *mean_of(group2);
    result.sd1 = std::sqrt(variance_of(group1, result.mean1));
    result.sd2 = std::sqrt(variance_of(group2, result.mean2));
    effect_sizes(result);
    return result;
}

}  // namespace placode::assessment
