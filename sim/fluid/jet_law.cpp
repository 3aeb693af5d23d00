// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/fluid/jet_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/portable_math.h"

namespace placode::sim {
namespace {

constexpr double kPhares = 44.6;

}  // namespace

double jet_area_m2(const JetSpec& jet) noexcept {
    return std::numbers::pi / 4 * jet.bore_m * jet.bore_m;
}

double jet_flow_m3_s(const JetSpec& jet) noexcept { return jet.speed_m_s * jet_area_m2(jet); }

double jet_momentum_n(const JetSpec& jet) noexcept {
    return jet.density_kg_m3 * jet.speed_m_s * jet_flow_m3_s(jet);
}

double jet_core_m(const JetSpec& jet) noexcept { return jet.core_diameters * jet.bore_m; }

double jet_speed_m_s(const JetSpec& jet, double x_m) noexcept {
    const double core = jet_core_m(jet);
    return jet.speed_m_s * core / std::max(x_m, core);
}

double jet_width_m(const JetSpec& jet, double x_m) noexcept {
    return jet.bore_m / std::numbers::sqrt2 * jet.speed_m_s / jet_speed_m_s(jet, x_m);
}

double jet_pressure_pa(const JetSpec& jet, double x_m, double r_m, double cosine) noexcept {
    const double v = jet_speed_m_s(jet, x_m), s = r_m / jet_width_m(jet, x_m);
    return 0.5 * jet.density_kg_m3 * v * v * cosine * cosine * exp_portable(-s * s);
}

double jet_shear_pa(const JetSpec& jet, double x_m, double r_m) noexcept {
    const double s = r_m / jet_width_m(jet, x_m),
                 ratio = jet.bore_m / std::max(x_m, jet_core_m(jet));
    const double reynolds = jet.density_kg_m3 * jet.speed_m_s * jet.bore_m / jet.viscosity_pa_s;
    const double most = kPhares * jet.density_kg_m3 * jet.speed_m_s * jet.speed_m_s /
                        std::sqrt(reynolds) * ratio * ratio;
    const double profile = 2 * s / (1 + s * s);
    return most * profile * profile;
}

}  // namespace placode::sim
