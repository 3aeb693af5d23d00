// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/signal.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace placode::assessment {

namespace {

constexpr double kLongestTrackS = 4 * 3600;
constexpr size_t kPadding = 9;  // scipy: 3 * max(len(a), len(b))
// Faster than this many times the analysis rate: the low pass comes before the resampling, or noise
// above half the analysis rate would fold into the movement. Recordings hold 100 Hz.
constexpr double kOversampled = 1.5;

/// Transposed direct form II with the given start state.
void run(const Biquad& f, std::vector<double>& x, double z0, double z1) {
    for (double& value : x) {
        const double in = value;
        value = f.b[0] * in + z0;
        z0 = f.b[1] * in - f.a[1] * value + z1;
        z1 = f.b[2] * in - f.a[2] * value;
    }
}

/// State in which a constant input of 1 gives a constant output of 1 (scipy lfilter_zi).
std::array<double, 2> rest_state(const Biquad& f) {
    const double gain = (f.b[0] + f.b[1] + f.b[2]) / (1 + f.a[1] + f.a[2]);
    const double z1 = f.b[2] - f.a[2] * gain;
    return {f.b[1] - f.a[1] * gain + z1, z1};
}

void filter_positions(std::vector<Vec3>& positions, double cutoff_hz, double rate_hz) {
    const Biquad filter = butterworth_low_pass(cutoff_hz, rate_hz);
    std::vector<double> axis(positions.size());
    for (int i = 0; i < 3; ++i) {
        for (size_t k = 0; k < axis.size(); ++k) axis[k] = positions[k][i];
        const std::vector<double> smooth = filter_forward_backward(filter, axis);
        for (size_t k = 0; k < axis.size(); ++k) positions[k][i] = smooth[k];
    }
}

/// Value at n times from start_s on, rate_hz apart, on the lines between what was sampled. Calls
/// take(k, i, u): the k-th lies the share u of the way from sample i to sample i + 1.
template <typename Take>
void resample(std::span<const double> time_s, double start_s, double rate_hz, size_t n,
              Take&& take) {
    for (size_t k = 0, i = 0; k < n; ++k) {
        const double t = start_s + static_cast<double>(k) / rate_hz;
        while (i + 2 < time_s.size() && time_s[i + 1] < t) ++i;
        take(k, i, std::clamp((t - time_s[i]) / (time_s[i + 1] - time_s[i]), 0.0, 1.0));
    }
}

/// Positions on even steps of the rate at which they came, low pass there.
void filter_as_recorded(std::vector<double>& time_s, std::vector<Vec3>& position_m,
                        double cutoff_hz) {
    const size_t n = time_s.size();
    const double start_s = time_s.front();
    const double rate_hz = static_cast<double>(n - 1) / (time_s.back() - start_s);
    std::vector<Vec3> even(n);
    resample(time_s, start_s, rate_hz, n, [&](size_t k, size_t i, double u) {
        even[k] = (1 - u) * position_m[i] + u * position_m[i + 1];
    });
    filter_positions(even, cutoff_hz, rate_hz);
    position_m = std::move(even);
    for (size_t k = 0; k < n; ++k) time_s[k] = start_s + static_cast<double>(k) / rate_hz;
}

}  // namespace

Biquad butterworth_low_pass(double cutoff_hz, double rate_hz) {
    assert(0 < cutoff_hz && cutoff_hz < rate_hz / 2);
    const double k = std::tan(std::numbers::pi * cutoff_hz / rate_hz);
    const double norm = 1 / (1 + std::numbers::sqrt2 * k + k * k);
    const double b0 = k * k * norm;
    return {{b0, 2 * b0, b0},
            {1, 2 * (k * k - 1) * norm, (1 - std::numbers::sqrt2 * k + k * k) * norm}};
}

std::vector<double> filter_forward_backward(const Biquad& filter, std::span<const double> signal) {
    const size_t n = signal.size();
    if (n <= kPadding) return {signal.begin(), signal.end()};
    // Odd reflection about the end points keeps value and slope there.
    std::vector<double> x(n + 2 * kPadding);
    for (size_t i = 0; i < kPadding; ++i) {
        x[i] = 2 * signal[0] - signal[kPadding - i];
        x[n + kPadding + i] = 2 * signal[n - 1] - signal[n - 2 - i];
    }
    std::copy(signal.begin(), signal.end(), x.begin() + kPadding);
    const auto [z0, z1] = rest_state(filter);
    for (int pass = 0; pass < 2; ++pass) {
        const double first = x.front();
        run(filter, x, z0 * first, z1 * first);
        std::reverse(x.begin(), x.end());
    }
    return {x.begin() + kPadding, x.end() - kPadding};
}

std::vector<double> derivative(std::span<const double> signal, double dt_s) {
    const size_t n = signal.size();
    std::vector<double> d(n, 0.0);
    if (n < 2) return d;
    d[0] = (signal[1] - signal[0]) / dt_s;
    d[n - 1] = (signal[n - 1] - signal[n - 2]) / dt_s;
    for (size_t k = 1; k + 1 < n; ++k) d[k] = (signal[k + 1] - signal[k - 1]) / (2 * dt_s);
    return d;
}

Track make_track(std::span<const double> time_s, std::span<const Vec3> position_m,
                 std::span<const Quat> orientation, double rate_hz, double cutoff_hz) {
    Track track;
    track.dt_s = 1 / rate_hz;
    const bool turns = orientation.size() == position_m.size();
    std::vector<double> time;
    std::vector<Vec3> position;
    std::vector<Quat> turn;
    for (size_t k = 0; k < std::min(time_s.size(), position_m.size()); ++k) {
        if (!std::isfinite(time_s[k]) || !position_m[k].allFinite()) continue;
        if (turns && !(orientation[k].norm() > 0.5)) continue;
        // A clock that jumped by hours says nothing of the movement, and would fill the memory.
        if (!time.empty() && time_s[k] - time.front() > kLongestTrackS) continue;
        if (!time.empty() && !(time_s[k] > time.back())) continue;
        time.push_back(time_s[k]);
        position.push_back(position_m[k]);
        if (turns) turn.push_back(orientation[k].normalized());
    }
    if (time.size() < 2) return track;

    track.start_s = time.front();
    const double span_s = time.back() - track.start_s;
    // The small allowance keeps the last sample when the input already has this rate.
    const size_t n = static_cast<size_t>(std::floor(span_s * rate_hz + 1e-6)) + 1;
    track.orientation.resize(turns ? n : 0);
    if (turns)
        resample(time, track.start_s, rate_hz, n, [&](size_t k, size_t i, double u) {
            track.orientation[k] = turn[i].slerp(u, turn[i + 1]);
        });
    const bool filtered = cutoff_hz > 0 && cutoff_hz < rate_hz / 2;
    const bool before =
        filtered && static_cast<double>(time.size() - 1) > kOversampled * rate_hz * span_s;
    if (before) filter_as_recorded(time, position, cutoff_hz);
    track.position_m.resize(n);
    resample(time, track.start_s, rate_hz, n, [&](size_t k, size_t i, double u) {
        track.position_m[k] = (1 - u) * position[i] + u * position[i + 1];
    });
    if (filtered && !before) filter_positions(track.position_m, cutoff_hz, rate_hz);

    // The vector is differentiated first, then its norm is taken.
    track.velocity_m_s.assign(n, Vec3::Zero());
    std::vector<double> axis(n);
    for (int i = 0; i < 3; ++i) {
        for (size_t k = 0; k < n; ++k) axis[k] = track.position_m[k][i];
        const std::vector<double> d = derivative(axis, track.dt_s);
        for (size_t k = 0; k < n; ++k) track.velocity_m_s[k][i] = d[k];
    }
    for (const Vec3& v : track.velocity_m_s) track.speed_m_s.push_back(v.norm());
    return track;
}

}  // namespace placode::assessment
