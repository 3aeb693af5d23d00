// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/correlation.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace placode::assessment {
namespace {

double t_p(double r, double n) {
    if (std::abs(r) >= 1) return 0;
    const double t = r * std::sqrt((n - 2) / (1 - r * r));
    return 2 *
           boost::math::cdf(boost::math::complement(boost::math::students_t(n - 2), std::abs(t)));
}

Interval fisher(double r, double se) {
    constexpr double kZ975 = 1.959963984540054;
    if (!std::isfinite(se))
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    if (std::abs(r) >= 1) return {r, r};
    return {std::tanh(std::atanh(r) - kZ975 * se), std::tanh(std::atanh(r) + kZ975 * se)};
}

/// Sums over groups of t tied values: t(t-1), t(t-1)(t-2), t(t-1)(2t+5).
struct TieSums {
    double two = 0, three = 0, variance = 0;
};
TieSums ties_of(std::span<const double> values) {
    std::map<double, double> counts;
    for (const double value : values) counts[value] += 1;
    TieSums sums;
    for (const auto& [value, t] : counts) {
        sums.two += t * (t - 1);
        sums.three += t * (t - 1) * (t - 2);
        sums.variance += t * (t - 1) * (2 * t + 5);
    }
    return sums;
}

void kendall(std::span<const double> x, std::span<const double> y, Correlation& result) {
    double s = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        for (size_t j = i + 1; j < x.size(); ++j) {
            const double product = (x[i] - x[j]) * (y[i] - y[j]);
            s += product > 0 ? 1 : product < 0 ? -1 : 0;
        }
    }
    const auto n = static_cast<double>(x.size());
    const TieSums tx = ties_of(x), ty = ties_of(y);
    const double pairs = n * (n - 1) / 2;
    result.kendall_tau_b = s / std::sqrt((pairs - tx.two / 2) * (pairs - ty.two / 2));
    const double variance = (n * (n - 1) * (2 * n + 5) - tx.variance - ty.variance) / 18 +
                            tx.two * ty.two / (2 * n * (n - 1)) +
                            tx.three * ty.three / (9 * n * (n - 1) * (n - 2));
    result.kendall_p = 2 * boost::math::cdf(boost::math::complement(
                               boost::math::normal(), std::abs(s) / std::sqrt(variance)));
}

}  // namespace

double pearson(std::span<const double> x, std::span<const double> y) {
    const auto n = static_cast<double>(x.size());
    const double mx = std::accumulate(x.begin(), x.end(), 0.0) / n,
                 my = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double sxx = 0, syy = 0, sxy = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        sxx += (x[i] - mx) * (x[i] - mx);
        syy += (y[i] - my) * (y[i] - my);
        sxy += (x[i] - mx) * (y[i] - my);
    }
    return std::clamp(sxy / std::sqrt(sxx * syy), -1.0, 1.0);
}

Correlation correlation(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size() || x.size() < 3) {
        throw std::invalid_argument(
            "correlation: needs two columns of equal length with at least 3 pairs");
    }
    const auto constant = [](std::span<const double> v) {
        return std::all_of(v.begin(), v.end(), [&](double value) { return value == v[0]; });
    };
    if (constant(x) || constant(y))
        throw std::invalid_argument("correlation: a column is constant");
    Correlation result;
    result.n = static_cast<int>(x.size());
    const double n = result.n;
    result.pearson = pearson(x, y);
    result.pearson_p = t_p(result.pearson, n);
    result.pearson_ci95 = fisher(result.pearson, 1 / std::sqrt(n - 3));
    result.spearman = pearson(mid_ranks(x), mid_ranks(y));
    result.spearman_p_t_approx = t_p(result.spearman, n);
    result.spearman_s = (n * n * n - n) * (1 - result.spearman) / 6;
    result.spearman_ci95 =
        fisher(result.spearman, std::sqrt((1 + result.spearman * result.spearman / 2) / (n - 3)));
    kendall(x, y, result);
    return result;
}

}  // namespace placode::assessment
