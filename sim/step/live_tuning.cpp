// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/live_tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/cutting/diathermy.h"
#include "sim/solver/kernel_layout_parts.h"
#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

namespace {

// SoftBody shows its data as constant to everybody; here the scene is not.
Material& material_of(Scene& scene, Tissue tissue) noexcept {
    auto& spec = const_cast<SoftBodySpec&>(scene.body.spec());
    return spec.materials[as_index(static_cast<int>(tissue))];
}

KernelLayout& packed_for_change(Scene& scene, State& state) noexcept {
    return const_cast<KernelLayout&>(packed_of(scene.body, state.body));
}

/// All constants of a tet grow with its modulus: mu and lambda do, gamma does not.
void scale_stiffness(Scene& scene, State& state, Tissue tissue, float factor) noexcept {
    KernelLayout& packed = packed_for_change(scene, state);
    auto& lanes = state.body.lanes;
    const auto& label = scene.body.mesh().tissue;
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        if (label[as_index(t)] != tissue) continue;
        for (size_t e = 0; e < 6; ++e) packed.edge_weight_n_m[6 * as_index(t) + e] *= factor;
        if (state.body.tet_alive[as_index(t)] == 0) continue;
        for (size_t k = 0; k < 4; ++k)
            lanes[as_index(packed.corner_lane[4 * as_index(t) + k])] *= factor;
    }
    const int vertices =
        state.body.topology ? state.body.topology->vertices : scene.body.vertex_count();
    for (int v = 0; v < vertices; ++v) {
        if (packed.slot[as_index(v)] < 0) continue;
        if (state.body.topology) {
            reweigh(state.body, v);
        } else {
            set_vertex_weights(scene.body, packed, state.body.tet_alive, v, lanes.data());
        }
    }
}

/// Mass-weighted mean over the tets around each vertex, as when the body was packed.
void spread_damping(Scene& scene, State& state) noexcept {
    KernelLayout& packed = packed_for_change(scene, state);
    const auto& materials = scene.body.spec().materials;
    const int vertices =
        state.body.topology ? state.body.topology->vertices : scene.body.vertex_count();
    for (int v = 0; v < vertices; ++v) {
        double damping = 0, mass = 0;
        for (const int32_t t : tets_around(scene.body, state.body, v)) {
            const Material& m =
                materials[as_index(static_cast<int>(scene.body.mesh().tissue[as_index(t)]))];
            const double share =
                m.density_kg_m3 * static_cast<double>(scene.body.volume_m3()[as_index(t)]);
            damping += share * m.damping_per_s;
            mass += share;
        }
        if (mass > 0) packed.damping_per_s[as_index(v)] = static_cast<float>(damping / mass);
    }
}

}  // namespace

const TuneRange& tune_range(TuneParameter parameter) noexcept {
    // Ranges of the reference, doubled where clinicians asked for more room.
    static constexpr std::array<TuneRange, kTuneParameters + 1> ranges{
        {{"youngs_modulus_pa", 200, 600000, 0.15, true},
         {"damping_per_s", 0, 60, 2, false},
         {"friction", 0, 0.6, 0.02, false},
         {"fail_stretch", 1.05, 3, 0.05, false},
         {"cut_power_w", 1, 40, 1, false},
         {"coag_power_w", 1, 40, 1, false},
         {"preset", 0, 1, 1, false}}};
    return ranges[as_index(static_cast<int32_t>(parameter))];
}

double tuned_value(const Scene& scene, TuneParameter parameter, Tissue tissue) noexcept {
    const Material& m = scene.body.spec().materials[as_index(static_cast<int>(tissue))];
    switch (parameter) {
        case TuneParameter::kStiffness:
            return m.youngs_modulus_pa;
        case TuneParameter::kDamping:
            return m.damping_per_s;
        case TuneParameter::kFriction:
            return m.friction;
        case TuneParameter::kFailStretch:
            return m.fail_stretch;
        case TuneParameter::kCutPower:
        case TuneParameter::kCoagPower:
            for (const ToolSpec& tool : scene.tools) {
                if (conducts(tool.kind))
                    return parameter == TuneParameter::kCutPower ? tool.cut_power_w
                                                                 : tool.coag_power_w;
            }
            return 0;
        case TuneParameter::kPreset:
            break;
    }
    return 0;
}

bool tune_live(Scene& scene, State& state, const Event& event) noexcept {
    if (event.kind != EventKind::kTuned || event.element < 0 || event.element >= kTuneParameters ||
        static_cast<int>(event.tissue) >= kTissueCount || !std::isfinite(event.value))
        return false;
    const auto parameter = static_cast<TuneParameter>(event.element);
    const TuneRange& range = tune_range(parameter);
    const double value = std::clamp(static_cast<double>(event.value), range.low, range.high);
    const double before = tuned_value(scene, parameter, event.tissue);
    if (value == before) return false;
    Material& material = material_of(scene, event.tissue);
    switch (parameter) {
        case TuneParameter::kStiffness:
            if (scene.body.spec().solver.method != Method::kVbd || !(before > 0)) return false;
            scale_stiffness(scene, state, event.tissue, static_cast<float>(value / before));
            material.youngs_modulus_pa = value;
            break;
        case TuneParameter::kDamping:
            material.damping_per_s = value;
            spread_damping(scene, state);
            break;
        case TuneParameter::kFriction:
            material.friction = value;
            break;
        case TuneParameter::kFailStretch:
            // What injures stands in the same proportion below what tears.
            material.injury_stretch =
                1 + (material.injury_stretch - 1) * (value - 1) / (before - 1);
            material.fail_stretch = value;
            break;
        case TuneParameter::kCutPower:
        case TuneParameter::kCoagPower:
            for (ToolSpec& tool : scene.tools) {
                if (!conducts(tool.kind)) continue;
                (parameter == TuneParameter::kCutPower ? tool.cut_power_w : tool.coag_power_w) =
                    value;
            }
            break;
        case TuneParameter::kPreset:
            return false;
    }
    rouse_all(state.body);
    return true;
}

}  // namespace placode::sim
