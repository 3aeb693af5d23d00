// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Physiological tremor: power of the hand's position between 8 and 12 Hz.

#include <optional>
#include <span>
#include <vector>

namespace placode::assessment {

/// Power of `signal` between `low_hz` and `high_hz`, both included [square of the signal's unit],
/// by Welch's method: Hann windows of 2 s, half overlapping, linear trend removed from each,
/// one-sided density, rectangle rule. Nothing for a signal shorter than 2 s. Use the unfiltered
/// signal. Source: Welch 1967; the definition of scipy.signal.welch.
[[nodiscard]] std::optional<double> band_power(std::span<const double> signal, double rate_hz,
                                               double low_hz = 8, double high_hz = 12);

/// Between 8 and 12 Hz, summed over the axes.
struct Tremor {
    double power = 0;               ///< Of the positions [square of their unit].
    double acceleration_power = 0;  ///< Of their second differences.
};

/// Of unfiltered positions, a signal an axis. Nothing for signals that band_power() finds too
/// short.
[[nodiscard]] std::optional<Tremor> tremor_of(std::span<const std::vector<double>> axes,
                                              double rate_hz);

}  // namespace placode::assessment
