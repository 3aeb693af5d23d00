// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where the current of an electrode turns to heat.
#include <cmath>

#include "sim/heat/heat_parts.h"

namespace placode::sim {
namespace {

constexpr double kDryConduction = 0.01;  // electrical conductivity of dry against wet tissue
constexpr double kStillWet = 0.6;        // dried fraction from which conduction falls

}  // namespace

double deposit_power(const SoftBody&, const SoftBodyState& tissue, HeatState& state,
                     std::span<const int32_t> candidates, const Vec3& tip, double a_m,
                     double power_w, const DepositLimits& limits) noexcept {
    const double reach = 4 * a_m;
    // Weight of a vertex: density of the source times what the vertex stands for.
    const auto weight = [&](int v) noexcept {
        const Float4& x = tissue.x[v];
        const double c = state.capacity_j_k[v];
        const double r = (Vec3(x.x, x.y, x.z) - tip).norm();
        if (r > reach || c <= 0 || state.dried[v] > limits.dried_limit) return 0.0;
        const double s = a_m / std::max(r, a_m);
        return c * s * s * s * s;
    };
    // Most that the vertex may hold, and most that it may take in one step.
    const auto room_w = [&](int v) noexcept {
        const double c = state.capacity_j_k[v];
        const double sensible = c * (kBoilC - limits.body_temperature_c);
        const double room = sensible - state.enthalpy_j[v] +
                            std::max(0.0, limits.dried_limit - state.dried[v]) * state.latent_j[v] +
                            (limits.dried_limit >= 1 ? c * (limits.peak_c - kBoilC) : 0.0);
        const double rise = std::min(room, 0.5 * (sensible + state.latent_j[v]));
        return std::max(0.0, rise / limits.step_s - state.power_w[v]);
    };
    // Shares are those of wet tissue: what dried tissue does not conduct is not pressed into its
    // neighbours; the generator sees a higher resistance and delivers less.
    double total = 0;
    for (const int32_t v : candidates) total += weight(v);
    if (total <= 0) return 0;
    double taken = 0;
    for (const int32_t v : candidates) {
        const double dry = smoothstep(kStillWet, 1, state.dried[v]);
        const double conducts = 1 - (1 - kDryConduction) * dry;
        const double p = std::min(power_w * conducts * (weight(v) / total), room_w(v));
        if (p <= 0) continue;
        state.power_w[v] += p;
        taken += p;
        if (state.warm[v] == 0) {
            state.warm[v] = 1;
            state.warm_list[state.warm_count++] = v;
        }
    }
    return taken;
}

}  // namespace placode::sim
