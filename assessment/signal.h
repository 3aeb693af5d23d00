// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What every motion metric does first: one time base, one filter, one derivative. Decided once
// (docs/training.md, "Metrics"), because speed and jerk depend on rate and filter.

#include <array>
#include <span>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::assessment {

using sim::Quat;
using sim::Vec3;

/// Raised when time base, filter or derivative change: stored with every score, because scores of
/// different pre-processing are not comparable.
inline constexpr int kPreprocessingVersion = 1;
inline constexpr double kAnalysisRateHz = 100;  ///< All motion metrics are computed at this rate.
inline constexpr double kCutoffHz = 10;         ///< Low pass before speed, jerk and path length.

/// Second-order section y = b x - a y, a[0] = 1.
struct Biquad {
    std::array<double, 3> b{}, a{};
};

/// Second-order Butterworth low pass by the bilinear transform with prewarping.
/// @pre 0 < cutoff_hz < rate_hz / 2.
[[nodiscard]] Biquad butterworth_low_pass(double cutoff_hz, double rate_hz);

/// Zero phase: forward and backward, odd reflection of 9 samples at each end, start state at rest
/// for the first sample. Signals of up to 9 samples come back unchanged.
/// Source: scipy.signal.filtfilt with its defaults, Gustafsson's initial state.
[[nodiscard]] std::vector<double> filter_forward_backward(const Biquad& filter,
                                                          std::span<const double> signal);

/// Central differences inside, one-sided at the ends (numpy.gradient) [1/s].
[[nodiscard]] std::vector<double> derivative(std::span<const double> signal, double dt_s);

/// One tool's motion on the common time base.
struct Track {
    double start_s = 0, dt_s = 1 / kAnalysisRateHz;
    std::vector<Vec3> position_m;   ///< Filtered unless `raw`.
    std::vector<Quat> orientation;  ///< Normalised, not filtered.
    std::vector<Vec3> velocity_m_s;
    std::vector<double> speed_m_s;
    [[nodiscard]] bool empty() const noexcept { return position_m.size() < 2; }
    [[nodiscard]] double time_s(size_t k) const noexcept {
        return start_s + dt_s * static_cast<double>(k);
    }
};

/// Drops samples whose time does not grow, resamples (positions linearly, orientations by slerp) to
/// `rate_hz`, filters, differentiates. Orientations may be empty. Not finite samples are dropped.
[[nodiscard]] Track make_track(std::span<const double> time_s, std::span<const Vec3> position_m,
                               std::span<const Quat> orientation, double rate_hz = kAnalysisRateHz,
                               double cutoff_hz = kCutoffHz);

}  // namespace placode::assessment
