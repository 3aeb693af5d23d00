// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Physiological tremor: power of the hand's position between 8 and 12 Hz.

#include <optional>
#include <span>

namespace placode::assessment {

/// Power of `signal` between `low_hz` and `high_hz`, both included [square of the signal's unit],
/// by Welch's method: Hann windows of 2 s, half overlapping, linear trend removed from each,
/// one-sided density, rectangle rule. Nothing for a signal shorter than 2 s. Use the unfiltered
/// signal. Source: Welch 1967; the definition of scipy.signal.welch.
[[nodiscard]] std::optional<double> band_power(std::span<const double> signal, double rate_hz,
                                               double low_hz = 8, double high_hz = 12);

}  // namespace placode::assessment
