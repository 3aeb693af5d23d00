// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/bootstrap.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <stdexcept>

#include "assessment/statistics.h"
#include "sim/core/random.h"

namespace placode::assessment {
namespace {

std::vector<double> enumerate(std::span<const double> values,
                              const std::function<double(std::span<const double>)>& statistic) {
    std::vector<double> results, resample(values.begin(), values.end());
    std::vector<size_t> digit(values.size(), 0);
    for (;;) {
        for (size_t i = 0; i < digit.size(); ++i) resample[i] = values[digit[i]];
        results.push_back(statistic(resample));
        size_t place = 0;
        while (place < digit.size() && ++digit[place] == values.size()) digit[place++] = 0;
        if (place == digit.size()) return results;
    }
}

std::vector<double> draw(std::span<const double> values,
                         const std::function<double(std::span<const double>)>& statistic,
                         int64_t resamples, uint64_t seed) {
    sim::SplitMix64 random(seed);
    std::vector<double> results, resample(values.size());
    results.reserve(static_cast<size_t>(resamples));
    for (int64_t i = 0; i < resamples; ++i) {
        // The remainder's bias is below n / 2^64.
        for (double& value : resample) value = values[random.next() % values.size()];
        results.push_back(statistic(resample));
    }
    return results;
}

/// Acceleration from the jackknife.
double acceleration(std::span<const double> values,
                    const std::function<double(std::span<const double>)>& statistic) {
    std::vector<double> left_out;
    for (size_t i = 0; i < values.size(); ++i) {
        std::vector<double> rest(values.begin(), values.end());
        rest.erase(rest.begin() + static_cast<long>(i));
        left_out.push_back(statistic(rest));
    }
    const double mean = *mean_of(left_out);
    double squares = 0, cubes = 0;
    for (const double value : left_out) {
        squares += (mean - value) * (mean - value);
        cubes += (mean - value) * (mean - value) * (mean - value);
    }
    return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

}  // namespace

Bootstrap bootstrap(std::span<const double> values,
                    const std::function<double(std::span<const double>)>& statistic,
                    int64_t resamples, uint64_t seed) {
    if (values.size() < 2) throw std::invalid_argument("bootstrap: needs at least 2 values");
    if (resamples < 100) throw std::invalid_argument("bootstrap: needs at least 100 resamples");
    Bootstrap result;
    result.n = static_cast<int>(values.size());
    result.exact = values.size() <= 7;  // 7^7 = 823,543
    std::vector<double> results =
        result.exact ? enumerate(values, statistic) : draw(values, statistic, resamples, seed);
    result.resamples = static_cast<int64_t>(results.size());
    result.estimate = statistic(values);
    std::sort(results.begin(), results.end());
    const auto n = static_cast<double>(results.size());
    const double mean = *mean_of(results);
    double squares = 0;
    for (const double value : results) squares += (value - mean) * (value - mean);
    result.boot_sd = std::sqrt(squares / (result.exact ? n : n - 1));
    result.percentile95 = {quantile(results, 0.025), quantile(results, 0.975)};

    // BCa (Efron 1987). Sums of the same values in another order differ in the last bits: "below"
    // leaves those out.
    const double tie = 1e-12 * (std::abs(result.estimate) + result.boot_sd);
    const auto below =
        std::lower_bound(results.begin(), results.end(), result.estimate - tie) - results.begin();
    const double share = std::clamp(static_cast<double>(below) / n, 0.5 / n, 1 - 0.5 / n);
    const boost::math::normal normal;
    result.bca_z0 = boost::math::quantile(normal, share);
    result.bca_a = acceleration(values, statistic);
    const auto adjusted = [&](double z) {
        const double shifted = result.bca_z0 + z;
        return boost::math::cdf(normal, result.bca_z0 + shifted / (1 - result.bca_a * shifted));
    };
    constexpr double kZ975 = 1.959963984540054;
    result.bca95 = {quantile(results, adjusted(-kZ975)), quantile(results, adjusted(kZ975))};
    return result;
}

}  // namespace placode::assessment
