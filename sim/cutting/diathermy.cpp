// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/diathermy.h"

#include <algorithm>
#include <cmath>

#include "sim/cutting/cutting.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kSparkGap = 0.0002;  // cutting voltage bridges this much gas [m]
constexpr double kLeastSource = 0.00025, kMostSource = 0.0008;  // contact radius a [m]
// Coagulation current comes in short bursts (some 6 % of the time) from a voltage that does not
// keep an arc: the same mean power spreads over a wider spot and dries tissue without removing it.
constexpr double kCoagSpread = 2.5;  // source radius against cutting
constexpr double kCoagDried = 0.7;   // of HeatSettings::vaporise_dried: nothing is removed
constexpr int kMostInterval = 4;
constexpr double kShareWhileCutting = 0.003;  // of the contact force: see ToolState::contact_share

/// Living vertices within `reach` of a point.
int gather(const State& state, const Vec3& centre, double reach) noexcept {
    auto& out = state.scratch->candidates;
    const HeatState& heat = state.heat[0];
    int count = 0;
    const float limit = static_cast<float>(reach * reach);
    const Vec3f c = centre.cast<float>();
    for (int v = 0; v < static_cast<int>(heat.capacity_j_k.size()); ++v) {
        const Float4& x = state.body.x[v];
        const float dx = x.x - c.x(), dy = x.y - c.y(), dz = x.z - c.z();
        if (dx * dx + dy * dy + dz * dz > limit || heat.capacity_j_k[v] <= 0) continue;
        out[count++] = v;
    }
    return count;
}

/// Power of one instrument into the tissue at its bare metal [W].
double deposit(const Scene& scene, State& state, int t, double step_s) noexcept {
    const ToolState& tool = state.tools[t];
    const ToolSpec& spec = scene.tools[t];
    const bool coag = tool.coagulating != 0;
    if (tool.bare_gap_m > (coag ? 0.0 : kSparkGap)) return 0;
    double a = std::clamp(spec.tip_radius_m, kLeastSource, kMostSource);
    if (coag) a = std::min(kCoagSpread * a, kMostSource);
    DepositLimits limits;
    limits.step_s = step_s;
    limits.dried_limit = coag ? kCoagDried * scene.heat->settings().vaporise_dried : 1.0;
    limits.body_temperature_c = scene.heat->settings().body_temperature_c;
    // Centre of the end sphere where the tip itself is in reach, else the touching flank.
    const Vec3 tip = tool.proxy * Vec3(0, 0, -spec.tip_radius_m);
    const bool at_tip = (tool.spot - tip).norm() < spec.tip_radius_m + kSparkGap;
    const Vec3 centre = at_tip ? tip : tool.spot;
    const int count = gather(state, centre, 4 * a);
    const double power = spec.efficiency * (coag ? spec.coag_power_w : spec.cut_power_w);
    return deposit_power(scene.body, state.body, state.heat[0],
                         std::span(state.scratch->candidates).first(static_cast<size_t>(count)),
                         centre, a, power, limits);
}

}  // namespace

bool conducts(ToolKind kind) noexcept {
    return kind == ToolKind::kNeedle || kind == ToolKind::kHook;
}

int heat_interval(const Scene& scene) noexcept {
    const double frame = scene.body.spec().solver.frame_s;
    const double fit = std::floor(0.5 * scene.heat->stable_step_s() / frame);
    return std::clamp(static_cast<int>(std::min(fit, 1e6)), 1, kMostInterval);
}

int run_diathermy(const Scene& scene, State& state, std::span<const ToolInput> inputs,
                  std::span<uint8_t> active, double frame_s) noexcept {
    state.scratch->heat_stepped = false;
    if (!scene.heat) return 0;
    HeatState& heat = state.heat[0];
    const int interval = heat_interval(scene);
    const bool due = state.frame % interval == 0;
    const double step_s = interval * frame_s;
    int burner = -1;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        ToolState& tool = state.tools[t];
        const uint8_t pedals = inputs[t].pedals;
        active[t] = tool.engaged && conducts(scene.tools[t].kind) &&
                    (pedals & (kPedalCut | kPedalCoag)) != 0;
        tool.coagulating = (pedals & kPedalCut) == 0;
        if (!active[t]) {
            tool.power_in_tissue_w = 0;
            continue;
        }
        // Boiling tissue does not push a cutting needle away.
        if (!tool.coagulating) tool.contact_share = kShareWhileCutting;
        if (due) tool.power_in_tissue_w = deposit(scene, state, t, step_s);
        if (tool.power_in_tissue_w > 0) burner = t;
    }
    if (!due || heat.warm_count == 0) return 0;
    state.scratch->heat_stepped = true;
    auto& gone = state.scratch->vaporised;
    const int count = step_heat(scene.body, *scene.heat, heat, state.body.tet_alive, step_s, gone);
    double volume = 0;
    for (int i = 0; i < count; ++i) {
        volume += scene.body.volume_m3()[gone[i]];
        remove_tissue(scene, state, gone[i], EventKind::kVaporised, burner,
                      tet_depth(scene, gone[i]));
    }
    // Smoke follows with a time constant of a tenth of a second.
    const double rate = volume / step_s, mix = std::min(1.0, step_s / 0.1);
    state.vapour_rate_m3_s += static_cast<float>(mix * (rate - state.vapour_rate_m3_s));
    return count;
}

}  // namespace placode::sim
