// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/tremor.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace placode::assessment {
namespace {

constexpr double kWindowS = 2;

/// Least-squares line taken out.
std::vector<double> without_trend(std::span<const double> y) {
    const auto n = static_cast<double>(y.size());
    const double middle = (n - 1) / 2;
    double mean = 0, slope = 0;
    for (const double v : y) mean += v / n;
    for (size_t i = 0; i < y.size(); ++i) slope += (static_cast<double>(i) - middle) * y[i];
    slope /= n * (n * n - 1) / 12;
    std::vector<double> out(y.size());
    for (size_t i = 0; i < y.size(); ++i) {
        out[i] = y[i] - mean - slope * (static_cast<double>(i) - middle);
    }
    return out;
}

/// |DFT|^2 at one bin. Few bins of a short window: no FFT needed.
double power_at(std::span<const double> y, size_t bin) {
    std::complex<double> sum = 0;
    const double turn =
        -2 * std::numbers::pi * static_cast<double>(bin) / static_cast<double>(y.size());
    for (size_t i = 0; i < y.size(); ++i) {
        sum += y[i] * std::polar(1.0, turn * static_cast<double>(i));
    }
    return std::norm(sum);
}

}  // namespace

std::optional<double> band_power(std::span<const double> signal, double rate_hz, double low_hz,
                                 double high_hz) {
    const auto n = static_cast<size_t>(std::lround(kWindowS * rate_hz));
    if (n < 8 || signal.size() < n) return std::nullopt;
    std::vector<double> window(n);
    double square = 0;
    for (size_t i = 0; i < n; ++i) {
        window[i] = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) /
                                         static_cast<double>(n));
        square += window[i] * window[i];
    }
    const double step_hz = rate_hz / static_cast<double>(n);
    double sum = 0;
    int segments = 0;
    for (size_t first = 0; first + n <= signal.size(); first += n - n / 2, ++segments) {
        std::vector<double> part = without_trend(signal.subspan(first, n));
        for (size_t i = 0; i < n; ++i) part[i] *= window[i];
        for (size_t bin = 1; 2 * bin < n; ++bin) {
            const double f = static_cast<double>(bin) * step_hz;
            // A hair of tolerance: 8 and 12 Hz are bins themselves.
            if (f < low_hz - 1e-9 || f > high_hz + 1e-9) continue;
            sum += 2 * power_at(part, bin) / (rate_hz * square) * step_hz;
        }
    }
    return sum / segments;
}

std::optional<Tremor> tremor_of(std::span<const std::vector<double>> axes, double rate_hz) {
    Tremor tremor;
    for (const std::vector<double>& x : axes) {
        std::vector<double> second;
        for (size_t k = 1; k + 1 < x.size(); ++k)
            second.push_back((x[k + 1] - 2 * x[k] + x[k - 1]) * rate_hz * rate_hz);
        const std::optional<double> power = band_power(x, rate_hz);
        const std::optional<double> acceleration = band_power(second, rate_hz);
        if (!power || !acceleration) return std::nullopt;
        tremor.power += *power;
        tremor.acceleration_power += *acceleration;
    }
    return tremor;
}

}  // namespace placode::assessment
