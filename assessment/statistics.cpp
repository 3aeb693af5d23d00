// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace placode::assessment {

double quantile(std::span<const double> sorted, double q) {
    assert(!sorted.empty() && std::ranges::is_sorted(sorted) && 0 <= q && q <= 1);
    const double rank = std::clamp(q, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    const size_t below = static_cast<size_t>(rank);
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double quantile_type6(std::span<const double> sorted, double q) {
    assert(!sorted.empty() && std::ranges::is_sorted(sorted) && 0 <= q && q <= 1);
    const auto n = static_cast<double>(sorted.size());
    const double at = std::clamp(q * (n + 1), 1.0, n);
    const auto below = static_cast<size_t>(at) - 1;
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

double median_of(std::span<const double> values) {
    assert(!values.empty());
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const size_t n = sorted.size();
    return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
}

std::optional<double> mean_of(std::span<const double> values) {
    if (values.empty()) return std::nullopt;
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

std::optional<double> sample_sd(std::span<const double> values) {
    if (values.size() < 2) return std::nullopt;
    const double mean = *mean_of(values);
    double square = 0;
    for (const double value : values) square += (value - mean) * (value - mean);
    return std::sqrt(square / static_cast<double>(values.size() - 1));
}

LikertSummary summarise_likert(std::span<const std::optional<int>> answers, int scale_min,
                               int scale_max) {
    assert(scale_min < scale_max);
    LikertSummary summary;
    summary.scale_min = scale_min;
    summary.scale_max = scale_max;
    summary.counts.assign(static_cast<size_t>(scale_max - scale_min + 1), 0);
    std::vector<double> values;
    for (const std::optional<int>& answer : answers) {
        if (!answer || *answer < scale_min || *answer > scale_max) {
            ++summary.missing;
            continue;
        }
        ++summary.counts[static_cast<size_t>(*answer - scale_min)];
        values.push_back(*answer);
        if (*answer >= scale_max - 1) ++summary.top2;
    }
    summary.n = static_cast<int>(values.size());
    if (values.empty()) return summary;
    std::sort(values.begin(), values.end());
    summary.mean = mean_of(values);
    summary.sd = sample_sd(values);
    summary.lower_quartile = quantile(values, 0.25);
    summary.median = quantile(values, 0.5);
    summary.upper_quartile = quantile(values, 0.75);
    summary.lower_quartile_type6 = quantile_type6(values, 0.25);
    summary.upper_quartile_type6 = quantile_type6(values, 0.75);
    double squares = 0;
    std::vector<double> distances;
    for (const double value : values) {
        squares += (value - *summary.mean) * (value - *summary.mean);
        distances.push_back(std::abs(value - *summary.median));
    }
    std::sort(distances.begin(), distances.end());
    summary.sd_population = std::sqrt(squares / summary.n);
    summary.mad = quantile(distances, 0.5);
    summary.top2_percent = 100.0 * summary.top2 / summary.n;
    return summary;
}

}  // namespace placode::assessment
