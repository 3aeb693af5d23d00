// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What experts do, and how far from it an attempt is: proficiency benchmarks and item scores.

#include <optional>
#include <span>
#include <vector>

#include "assessment/metrics.h"

namespace placode::assessment {

inline constexpr double kOutlierZ = 1.96;  ///< Experts further from their mean are left out.
inline constexpr double kItemZ0 = 4;       ///< This many SD worse than the experts is 0 points.

/// Mean and SD of a group in one metric.
struct Benchmark {
    int n = 0;                     ///< Values used.
    bool log = false;              ///< mean and sd are of ln(value): time, path, force are skewed.
    double mean = 0, sd = 0;       ///< Sample SD (n - 1) of the values used.
    std::vector<size_t> left_out;  ///< Places of the outliers in the input.
    double q25 = 0, q50 = 0, q75 = 0;  ///< Type 7, of the values used, never of logarithms.
};

/// Outliers by |z| > outlier_z about mean and SD of all values, once. Nothing below three finite
/// values. With `log`, values that are not positive switch the logarithm off.
/// Source: experts with |z| > 1.96 are excluded, ANZ J Surg 10.1111/ans.14474.
[[nodiscard]] std::optional<Benchmark> make_benchmark(std::span<const double> values, bool log,
                                                      double outlier_z = kOutlierZ);

/// Metrics whose benchmark is taken of logarithms: times, ways and forces, which are right-skewed.
[[nodiscard]] bool is_log_metric(std::string_view metric_id);

/// z against the benchmark, positive = better. Nothing when the benchmark does not vary, the value
/// is not finite (or not positive under a logarithm), or the direction is neutral.
[[nodiscard]] std::optional<double> benchmark_z(const Benchmark& benchmark, double value,
                                                Direction direction);

/// 100 clip((z + z0) / z0, 0, 1): the experts' mean and better gives 100. A choice of this project.
[[nodiscard]] double item_score(double z, double z0 = kItemZ0) noexcept;

}  // namespace placode::assessment
