// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/slit_flow.h"

#include <cmath>

namespace placode::sim {
namespace {

/// Pressure lost a m3/s between a level and the next [Pa s/m3].
double resistance(const SlitStretch& s, size_t level) noexcept {
    const double a = s.gap_m[level], b = s.gap_m[level + 1];
    const double path = s.depth_m[level + 1] - s.depth_m[level];
    return 12 * kFluidPaS * path * (a + b) / (2 * a * a * b * b * s.length_m);
}

/// Of p = orifice Q^2 + viscous Q, without a difference of near numbers.
double flow_at(double pressure_pa, double orifice, double viscous) noexcept {
    return 2 * pressure_pa / (viscous + std::sqrt(viscous * viscous + 4 * orifice * pressure_pa));
}

/// Between two levels most of the pressure is lost where the walls are near each other: the mean of
/// p over a taper is (g_a p_a + g_b p_b) / (g_a + g_b).
double mean_over_taper(double gap_a, double pa_a, double gap_b, double pa_b) noexcept {
    const double sum = gap_a + gap_b;
    return sum > 0 ? (gap_a * pa_a + gap_b * pa_b) / sum : 0.5 * (pa_a + pa_b);
}

}  // namespace

SlitFlow flow_through(const SlitStretch& s, double pressure_pa) noexcept {
    SlitFlow out;
    const auto floor = static_cast<size_t>(s.layers);
    size_t neck = 0, shut = floor + 1;  // the deepest level that is shut
    for (size_t level = 0; level <= floor; ++level) {
        if (s.gap_m[level] < s.gap_m[neck]) neck = level;
        if (!(s.gap_m[level] > 0)) shut = level;
    }
    if (!(pressure_pa > 0) || !(s.length_m > 0)) return out;
    if (shut <= floor) {
        for (size_t level = shut; level < floor; ++level) out.pressure_pa[level] = pressure_pa;
        return out;
    }
    double viscous = 0;
    for (size_t level = 0; level < floor; ++level) viscous += resistance(s, level);
    const double area = kSlitDischarge * s.length_m * s.gap_m[neck];
    const double orifice = kFluidKgM3 / (2 * area * area);
    const double q = out.flow_m3_s = flow_at(pressure_pa, orifice, viscous);
    // From the floor up; what the orifice takes is gone from the neck on.
    double below_pa = pressure_pa - (neck == floor ? orifice * q * q : 0);
    for (size_t level = floor; level-- > 0;) {
        const double pa =
            below_pa - resistance(s, level) * q - (level == neck ? orifice * q * q : 0);
        out.pressure_pa[level] = mean_over_taper(s.gap_m[level], pa, s.gap_m[level + 1], below_pa);
        below_pa = pa;
    }
    return out;
}

}  // namespace placode::sim
