// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Intervals by resampling: every resample where that is few, seeded Monte Carlo where it is many.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "assessment/rank_tests.h"

namespace placode::assessment {

struct Bootstrap {
    int n = 0;
    int64_t resamples = 0;
    bool exact = false;  ///< All n^n resamples were enumerated.
    double estimate = 0, boot_sd = 0;
    Interval percentile95;  ///< Quantiles of type 7.
    double bca_z0 = 0, bca_a = 0;
    Interval bca95;
};

/// @param statistic of a resample; called often, must not keep the span.
/// Enumerates when n^n <= 1e6, else draws `resamples` with the seed. @pre n >= 2.
[[nodiscard]] Bootstrap bootstrap(std::span<const double> values,
                                  const std::function<double(std::span<const double>)>& statistic,
                                  int64_t resamples = 20000, uint64_t seed = 1);

}  // namespace placode::assessment
