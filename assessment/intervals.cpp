// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/intervals.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "assessment/roc.h"
#include "assessment/statistics.h"

namespace placode::assessment {

Interval wilson_interval(int count, int n) {
    assert(n > 0 && 0 <= count && count <= n);
    constexpr double kZ = 1.959963984540054;
    const double p = static_cast<double>(count) / n, z2 = kZ * kZ / n;
    const double centre = (p + z2 / 2) / (1 + z2);
    const double half = kZ * std::sqrt(p * (1 - p) / n + z2 / (4 * n)) / (1 + z2);
    return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

std::optional<Interval> mean_interval(std::span<const double> values) {
    const std::optional<double> sd = sample_sd(values);
    if (!sd) return std::nullopt;
    const auto n = static_cast<double>(values.size());
    const double t = boost::math::quantile(boost::math::students_t(n - 1), 0.975);
    const double half = t * *sd / std::sqrt(n);
    return Interval{*mean_of(values) - half, *mean_of(values) + half};
}

CliffsDelta cliffs_delta(std::span<const double> group1, std::span<const double> group2) {
    if (group1.size() < 2 || group2.size() < 2)
        throw std::invalid_argument("cliffs delta: needs at least 2 values a group");
    std::vector<double> values(group1.begin(), group1.end());
    values.insert(values.end(), group2.begin(), group2.end());
    std::vector<bool> positive(values.size(), false);
    std::fill_n(positive.begin(), group1.size(), true);
    const Roc area = roc(values, positive);
    CliffsDelta result;
    result.delta = 2 * area.auc - 1;
    result.ci95 = {2 * area.delong_ci95.low - 1, 2 * area.delong_ci95.high - 1};
    result.separated = area.delong_se == 0;
    return result;
}

}  // namespace placode::assessment
