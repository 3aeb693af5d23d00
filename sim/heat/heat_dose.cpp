// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal dose and Arrhenius damage: rates from portable powers.
#include <bit>
#include <cmath>
#include <numbers>

#include "sim/heat/heat_parts.h"

namespace placode::sim {
namespace {

constexpr double kKelvin = 273.15;
constexpr double kGasConstant = 8.314462618;  // J/(mol K)

double exp2_portable(double x) noexcept {
    Powers all{x};
    placode::sim::exp2_portable(all);
    return all[0];
}

}  // namespace

// Range reduction and a Taylor polynomial: relative error below 1e-13.
void exp2_portable(Powers& x) noexcept {
    Powers whole, y, sum;
    for (int i = 0; i < kPowers; ++i) {
        x[i] = std::clamp(x[i], -1000.0, 1000.0);
        whole[i] = std::floor(x[i] + 0.5);
        y[i] = (x[i] - whole[i]) * std::numbers::ln2;
        sum[i] = 1;
    }
    for (int n = 12; n >= 1; --n) {
        for (int i = 0; i < kPowers; ++i) sum[i] = 1 + sum[i] * y[i] / n;
    }
    for (int i = 0; i < kPowers; ++i) {
        const auto exponent = static_cast<uint64_t>(static_cast<int64_t>(whole[i]) + 1023);
        x[i] = sum[i] * std::bit_cast<double>(exponent << 52);
    }
}

double cem43_exponent(double temperature_c) noexcept {
    return (temperature_c >= 43 ? 1.0 : 2.0) * (temperature_c - 43);
}

double arrhenius_exponent(double ea_j_mol, double temperature_c) noexcept {
    return -ea_j_mol / (kGasConstant * (temperature_c + kKelvin)) * std::numbers::log2e;
}

double cem43_rate(double temperature_c) noexcept {
    return exp2_portable(cem43_exponent(temperature_c));
}

double arrhenius_rate(double a_per_s, double ea_j_mol, double temperature_c) noexcept {
    return a_per_s * exp2_portable(arrhenius_exponent(ea_j_mol, temperature_c));
}

}  // namespace placode::sim
