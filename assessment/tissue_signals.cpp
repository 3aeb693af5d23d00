// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Heat and force of single signals.

#include <algorithm>
#include <cmath>

#include "assessment/tissue_metrics.h"

namespace placode::assessment {

namespace {

constexpr double kGasConstant = 8.314462618, kKelvin = 273.15;

double dose_rate(double temperature_c) {
    return std::pow(temperature_c >= 43 ? 0.5 : 0.25, 43 - temperature_c);
}

}  // namespace

double cem43_min(std::span<const double> time_s, std::span<const double> temperature_c) {
    double dose = 0;
    for (size_t k = 1; k < std::min(time_s.size(), temperature_c.size()); ++k) {
        const double rate = (dose_rate(temperature_c[k - 1]) + dose_rate(temperature_c[k])) / 2;
        dose += (time_s[k] - time_s[k - 1]) / 60 * rate;
    }
    return dose;
}

double arrhenius_damage(std::span<const double> time_s, std::span<const double> temperature_c,
                        double a_per_s, double ea_j_mol) {
    const auto rate = [&](double celsius) {
        return a_per_s * std::exp(-ea_j_mol / (kGasConstant * (celsius + kKelvin)));
    };
    double omega = 0;
    for (size_t k = 1; k < std::min(time_s.size(), temperature_c.size()); ++k) {
        omega +=
            (time_s[k] - time_s[k - 1]) * (rate(temperature_c[k - 1]) + rate(temperature_c[k])) / 2;
    }
    return omega;
}

ForceSummary summarise_force(std::span<const double> time_s, std::span<const double> force_n,
                             double threshold_n) {
    ForceSummary f;
    const size_t n = std::min(time_s.size(), force_n.size());
    if (n == 0) return f;
    double square = 0;
    f.peak_n = *std::max_element(force_n.begin(), force_n.begin() + static_cast<long>(n));
    for (size_t k = 1; k < n; ++k) {
        const double dt = time_s[k] - time_s[k - 1], a = force_n[k - 1], b = force_n[k];
        f.impulse_n_s += dt * (a + b) / 2;
        square += dt * (a * a + b * b) / 2;
        // The crossing inside a step is taken from the line between its ends.
        const double high = std::max(a, b), low = std::min(a, b);
        if (high <= threshold_n) continue;
        const double share = low >= threshold_n ? 1 : (high - threshold_n) / (high - low);
        f.over_s += share * dt;
        f.excess_impulse_n_s +=
            share * dt * (high - threshold_n + std::max(0.0, low - threshold_n)) / 2;
    }
    const double duration = time_s[n - 1] - time_s[0];
    if (duration > 0) {
        f.mean_n = f.impulse_n_s / duration;
        f.rms_n = std::sqrt(square / duration);
    }
    return f;
}

}  // namespace placode::assessment
