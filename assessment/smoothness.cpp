// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How smooth a movement is: the length of its speed's spectrum (SPARC) and the logarithm of its
// dimensionless jerk (LDLJ), declared with their sources in motion_metrics.h.
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include "assessment/motion_metrics.h"

namespace placode::assessment {

namespace {

constexpr double kSparcCutoffHz = 10, kSparcAmplitude = 0.05;
constexpr int kSparcPadLevel = 4;

/// In-place radix-2 transform. @pre the size is a power of two.
void fourier_transform(std::vector<std::complex<double>>& x) {
    const size_t n = x.size();
    for (size_t i = 1, j = 0; i < n; ++i) {
        size_t bit = n >> 1;
        for (; j & bit; bit >>= 1) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(x[i], x[j]);
    }
    for (size_t length = 2; length <= n; length *= 2) {
        // Twiddles from the angle each time: a running product loses digits on long signals.
        std::vector<std::complex<double>> w(length / 2);
        for (size_t k = 0; k < w.size(); ++k) {
            w[k] = std::polar(
                1.0, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
        }
        for (size_t i = 0; i < n; i += length) {
            for (size_t k = 0; k < length / 2; ++k) {
                const std::complex<double> u = x[i + k], v = x[i + k + length / 2] * w[k];
                x[i + k] = u + v;
                x[i + k + length / 2] = u - v;
            }
        }
    }
}

/// Shared tail of both LDLJ forms: sum of squared jerk, peak speed and sample count.
std::optional<double> ldlj(double jerk_squared_sum, double peak, size_t n, double rate_hz) {
    const double dt = 1 / rate_hz, duration = static_cast<double>(n) * dt;
    // A second difference of 1e-12 of the speed is rounding, not jerk: at constant speed the value
    // would be noise. A movement of 1000 s still has 6e-10.
    const double rounding = 1e-12 * peak * rate_hz * rate_hz;
    if (!(jerk_squared_sum > static_cast<double>(n) * rounding * rounding)) return std::nullopt;
    const double dimensionless =
        duration * duration * duration / (peak * peak) * jerk_squared_sum * dt;
    if (!(dimensionless > 0) || !std::isfinite(dimensionless)) return std::nullopt;
    return -std::log(dimensionless);
}

}  // namespace

std::optional<double> sparc(std::span<const double> speed, double rate_hz) {
    if (speed.size() < 3) return std::nullopt;
    const size_t nfft = std::bit_ceil(speed.size()) << kSparcPadLevel;
    std::vector<std::complex<double>> spectrum(nfft);
    std::copy(speed.begin(), speed.end(), spectrum.begin());
    fourier_transform(spectrum);
    std::vector<double> magnitude(nfft);
    for (size_t i = 0; i < nfft; ++i) magnitude[i] = std::abs(spectrum[i]);
    const double peak = *std::max_element(magnitude.begin(), magnitude.end());
    if (!(peak > 0) || !std::isfinite(peak)) return std::nullopt;
    // Keep up to the cut-off, then from the first to the last bin above the amplitude threshold.
    const double df = rate_hz / static_cast<double>(nfft);
    size_t first = nfft, last = 0;
    for (size_t i = 0; i < nfft && static_cast<double>(i) * df <= kSparcCutoffHz; ++i) {
        if (magnitude[i] / peak < kSparcAmplitude) continue;
        if (first == nfft) first = i;
        last = i;
    }
    if (first >= last) return std::nullopt;
    double arc = 0;
    for (size_t i = first + 1; i <= last; ++i) {
        arc += std::hypot(1 / static_cast<double>(last - first),
                          (magnitude[i] - magnitude[i - 1]) / peak);
    }
    return -arc;
}

std::optional<double> ldlj_speed(std::span<const double> speed, double rate_hz) {
    if (speed.size() < 3) return std::nullopt;
    double peak = 0, sum = 0;
    for (const double v : speed) peak = std::max(peak, std::abs(v));
    for (size_t k = 2; k < speed.size(); ++k) {
        const double jerk = (speed[k] - 2 * speed[k - 1] + speed[k - 2]) * rate_hz * rate_hz;
        sum += jerk * jerk;
    }
    return ldlj(sum, peak, speed.size(), rate_hz);
}

std::optional<double> ldlj_vector(std::span<const Vec3> velocity, double rate_hz) {
    if (velocity.size() < 3) return std::nullopt;
    double peak = 0, sum = 0;
    for (const Vec3& v : velocity) peak = std::max(peak, v.norm());
    for (size_t k = 2; k < velocity.size(); ++k) {
        sum += ((velocity[k] - 2 * velocity[k - 1] + velocity[k - 2]) * rate_hz * rate_hz)
                   .squaredNorm();
    }
    return ldlj(sum, peak, velocity.size(), rate_hz);
}

}  // namespace placode::assessment
