// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/roc.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

namespace placode::assessment {
namespace {

double covariance(std::span<const double> a, std::span<const double> b) {
    const auto n = static_cast<double>(a.size());
    if (n < 2) return 0;
    const double ma = std::accumulate(a.begin(), a.end(), 0.0) / n,
                 mb = std::accumulate(b.begin(), b.end(), 0.0) / n;
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - ma) * (b[i] - mb);
    return sum / (n - 1);
}

/// Share of `others` that x beats; ties count half.
double placement(double x, std::span<const double> others, double direction) {
    double sum = 0;
    for (const double other : others) {
        const double difference = direction * (x - other);
        sum += difference > 0 ? 1 : difference == 0 ? 0.5 : 0;
    }
    return sum / static_cast<double>(others.size());
}

void best_threshold(Roc& result, std::span<const double> above, std::span<const double> below) {
    std::set<double> values(above.begin(), above.end());
    values.insert(below.begin(), below.end());
    // As pROC's `coords`: below all values everybody is called positive.
    double best = 1, previous = *values.begin();
    result.youden_threshold = -std::numeric_limits<double>::infinity();
    result.sensitivity = 1;
    result.specificity = 0;
    for (const double value : values) {
        if (value == previous) continue;
        const double threshold = 0.5 * (previous + value);
        previous = value;
        const auto share = [&](std::span<const double> v, bool over) {
            const auto count = std::count_if(v.begin(), v.end(),
                                             [&](double x) { return (x > threshold) == over; });
            return static_cast<double>(count) / static_cast<double>(v.size());
        };
        const double sensitivity = share(above, true), specificity = share(below, false);
        if (sensitivity + specificity > best + 1e-12) {
            best = sensitivity + specificity;
            result.youden_threshold = threshold;
            result.sensitivity = sensitivity;
            result.specificity = specificity;
        }
    }
}

}  // namespace

Roc roc(std::span<const double> values, const std::vector<bool>& positive) {
    std::vector<double> above, below;
    for (size_t i = 0; i < values.size(); ++i) (positive[i] ? above : below).push_back(values[i]);
    if (above.empty() || below.empty()) {
        throw std::invalid_argument("roc: both classes must be present, found " +
                                    std::to_string(above.size()) + " positive and " +
                                    std::to_string(below.size()) + " negative");
    }
    Roc result;
    result.positives = static_cast<int>(above.size());
    result.negatives = static_cast<int>(below.size());
    for (const double x : above) result.positive_placements.push_back(placement(x, below, 1));
    for (const double x : below) result.negative_placements.push_back(placement(x, above, -1));
    const auto& placements = result.positive_placements;
    result.auc = std::accumulate(placements.begin(), placements.end(), 0.0) /
                 static_cast<double>(above.size());
    const double variance = covariance(placements, placements) / static_cast<double>(above.size()) +
                            covariance(result.negative_placements, result.negative_placements) /
                                static_cast<double>(below.size());
    result.delong_se = std::sqrt(variance);
    constexpr double kZ975 = 1.959963984540054;
    result.delong_ci95_unclipped = {result.auc - kZ975 * result.delong_se,
                                    result.auc + kZ975 * result.delong_se};
    result.delong_ci95 = {std::max(0.0, result.delong_ci95_unclipped.low),
                          std::min(1.0, result.delong_ci95_unclipped.high)};
    best_threshold(result, above, below);
    return result;
}

RocComparison compare_paired(const Roc& first, const Roc& second) {
    if (first.positives != second.positives || first.negatives != second.negatives) {
        throw std::invalid_argument("roc: the two predictors must be measured on the same cases");
    }
    const double covariance_of_areas =
        covariance(first.positive_placements, second.positive_placements) / first.positives +
        covariance(first.negative_placements, second.negative_placements) / first.negatives;
    const double variance = first.delong_se * first.delong_se +
                            second.delong_se * second.delong_se - 2 * covariance_of_areas;
    RocComparison result;
    if (variance > 0) result.z = (first.auc - second.auc) / std::sqrt(variance);
    result.p =
        2 * boost::math::cdf(boost::math::complement(boost::math::normal(), std::abs(result.z)));
    return result;
}

}  // namespace placode::assessment
