// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/benchmark.h"

#include <algorithm>
#include <cmath>

#include "assessment/statistics.h"

namespace placode::assessment {

std::optional<Benchmark> make_benchmark(std::span<const double> values, bool log,
                                        double outlier_z) {
    std::vector<size_t> places;
    for (size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i])) places.push_back(i);
        if (std::isfinite(values[i]) && !(values[i] > 0)) log = false;
    }
    if (places.size() < 3) return std::nullopt;
    const auto scaled = [&](size_t i) { return log ? std::log(values[i]) : values[i]; };
    std::vector<double> all;
    for (const size_t i : places) all.push_back(scaled(i));
    const double mean = *mean_of(all), sd = *sample_sd(all);
    Benchmark made;
    made.log = log;
    std::vector<double> used, plain;
    for (const size_t i : places) {
        if (sd > 0 && std::abs(scaled(i) - mean) > outlier_z * sd) {
            made.left_out.push_back(i);
            continue;
        }
        used.push_back(scaled(i));
        plain.push_back(values[i]);
    }
    std::sort(plain.begin(), plain.end());
    made.n = static_cast<int>(used.size());
    made.mean = *mean_of(used);
    made.sd = sample_sd(used).value_or(0);
    made.q25 = quantile(plain, 0.25);
    made.q50 = quantile(plain, 0.5);
    made.q75 = quantile(plain, 0.75);
    return made;
}

bool is_log_metric(std::string_view id) {
    // Counts, shares and contacts may be 0, and dimensionless measures are no lengths or times.
    constexpr std::string_view kLog[]{"task_time_s",   "path_length_mm",   "depth_path_mm",
                                      "peak_force_mn", "angular_path_deg", "peak_traction_mn"};
    return std::find(std::begin(kLog), std::end(kLog), id) != std::end(kLog);
}

std::optional<double> benchmark_z(const Benchmark& benchmark, double value, Direction direction) {
    if (direction == Direction::kNeutral || !(benchmark.sd > 0) || !std::isfinite(value) ||
        (benchmark.log && !(value > 0)))
        return std::nullopt;
    const double sign = direction == Direction::kHigherIsBetter ? 1 : -1;
    return sign * ((benchmark.log ? std::log(value) : value) - benchmark.mean) / benchmark.sd;
}

double item_score(double z, double z0) noexcept {
    return 100 * std::clamp((z + z0) / z0, 0.0, 1.0);
}

}  // namespace placode::assessment
