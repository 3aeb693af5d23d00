// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/heat/heat.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/heat/heat_parts.h"
#include "sim/mesh/surface.h"

namespace placode::sim {
namespace {

constexpr double kSpreadK = 0.001;  // a vertex this warm wakes its neighbours
constexpr double kDoseFloorC = 38;  // below, a dose grows by less than 0.001 min/min
constexpr float kOmegaFrozen = 10;
constexpr double kDoseFrozenMin = 1e30;     // tissue that glows: floats end not far above
constexpr uint8_t kWakes = 1, kDrying = 2;  // bits of HeatState::wakes

}  // namespace

HeatState::HeatState(const HeatModel& model, int vertices, int)
    : temperature_c(vertices, static_cast<float>(model.settings_.body_temperature_c)),
      dried(vertices, 0.0f),
      cem43_min(vertices, 0.0f),
      arrhenius(vertices, 0.0f),
      charred(vertices, 0.0f),
      warm(vertices, 0),
      warm_list(vertices, -1),
      in_order(vertices, -1),
      wakes(vertices, 0),
      power_w(vertices, 0.0),
      enthalpy_j(vertices, 0.0),
      capacity_j_k(model.capacity_j_k_.begin(), model.capacity_j_k_.end()),
      latent_j(model.latent_j_.begin(), model.latent_j_.end()),
      flux_w(vertices, 0.0),
      edge_w_k(model.edge_w_k_),
      exposed_m2(model.exposed_area_m2_) {}

/// The steps of the method; a struct, because HeatModel opens its arrays to it.
struct HeatStepper {
    const SoftBody& body;
    const HeatModel& model;
    HeatState& state;

    /// A look at every vertex: a sort of what has come in would not be cheaper.
    void put_in_order() const noexcept {
        if (state.ordered_count == state.warm_count) return;
        int count = 0;
        for (int v = 0; v < static_cast<int>(state.warm.size()); ++v) {
            if (state.warm[v] == 1) state.in_order[count++] = v;
        }
        state.ordered_count = count;
    }

    /// Boils what is above 100 C while there is water, then temperature from enthalpy. The latent
    /// heat leaves with the steam at once, so that dry tissue cools like any other.
    void update_temperature(int v) const noexcept {
        const double c = state.capacity_j_k[v];
        if (c <= 0) return;
        const double base = model.settings_.body_temperature_c;
        double& h = state.enthalpy_j[v];
        const double excess = h - c * (kBoilC - base);
        if (excess > 0 && state.dried[v] < 1 && state.latent_j[v] > 0) {
            const double water = state.latent_j[v] * (1.0 - state.dried[v]);
            const double boiled = std::min(excess, water);
            state.dried[v] = boiled == water
                                 ? 1.0f
                                 : static_cast<float>(state.dried[v] + boiled / state.latent_j[v]);
            h -= boiled;
            state.energy_vapour_j += boiled;
        }
        state.temperature_c[v] = static_cast<float>(base + h / c);
    }

    /// Heat flow into every warm vertex. Both ends of an edge use the same number, so nothing is
    /// lost on the way.
    void conduct() const noexcept {
        const double base = model.settings_.body_temperature_c;
        const double reference = std::max(base, model.settings_.gas_temperature_c);
        for (int n = 0; n < state.ordered_count; ++n) {
            const int i = state.in_order[n];
            const float ti = state.temperature_c[i];
            const bool wakes = std::abs(ti - base) > kSpreadK;
            double sum = 0;
            bool at_edge = false;
            for (int e = model.edge_start_[i]; e < model.edge_start_[i + 1]; ++e) {
                const int j = model.edge_to_[e];
                if (state.warm[j] == 1)
                    sum += static_cast<double>(state.edge_w_k[e]) * (state.temperature_c[j] - ti);
                else
                    at_edge = true;
            }
            const double excess = ti - reference;
            const double cooling =
                excess > 0 ? model.settings_.surface_cooling_w_m2k * state.exposed_m2[i] * excess
                           : 0.0;
            state.wakes[i] =
                static_cast<uint8_t>((state.wakes[i] & kDrying) | (wakes && at_edge ? kWakes : 0));
            state.flux_w[i] = sum - cooling;
            state.power_w[i] = std::max(state.power_w[i], 0.0);
            cooling_w += cooling;
        }
    }

    /// Neighbours of warm vertices take part from the next step on, in the order in which warmth
    /// came to the vertices.
    void spread() const noexcept {
        const int count = state.warm_count;
        for (int n = 0; n < count; ++n) {
            const int i = state.warm_list[n];
            if ((state.wakes[i] & kWakes) == 0) continue;
            for (int e = model.edge_start_[i]; e < model.edge_start_[i + 1]; ++e) {
                const int j = model.edge_to_[e];
                if (state.warm[j] != 0 || state.edge_w_k[e] == 0) continue;
                state.warm[j] = 1;
                state.warm_list[state.warm_count++] = j;
            }
        }
    }

    /// New enthalpies, temperatures and damage of the vertices that were warm.
    void advance(double dt) const noexcept {
        Exposed exposed;
        for (int n = 0; n < state.ordered_count; ++n) {
            const int v = state.in_order[n];
            if (state.capacity_j_k[v] <= 0) continue;  // its tissue is gone
            state.enthalpy_j[v] += dt * (state.flux_w[v] + state.power_w[v]);
            state.energy_in_j += dt * state.power_w[v];
            const double before = state.temperature_c[v];
            const float dried = state.dried[v];
            update_temperature(v);
            if (state.dried[v] != dried) note_drying(v);
            const double middle = 0.5 * (before + state.temperature_c[v]);
            if (middle < kDoseFloorC) continue;
            exposed.vertex[exposed.count] = v;
            exposed.middle_c[exposed.count++] = middle;
            if (exposed.count == kPowers) harm(exposed, dt);
        }
        harm(exposed, dt);
    }

    /// Tets around a vertex that dries have to be looked at: its neighbours are told, too, because
    /// a tet is looked at from one corner only.
    void note_drying(int v) const noexcept {
        state.wakes[v] |= kDrying;
        for (int e = model.edge_start_[v]; e < model.edge_start_[v + 1]; ++e) {
            state.wakes[model.edge_to_[e]] |= kDrying;
        }
    }

    /// Vertices that are hot enough to be harmed, as many as powers are worked out side by side.
    struct Exposed {
        std::array<int, kPowers> vertex{};
        Powers middle_c{};  ///< Temperature in the middle of the step.
        int count = 0;
    };

    /// Dose, damage and char of these vertices; none are left.
    void harm(Exposed& exposed, double dt) const noexcept {
        const HeatSettings& s = model.settings_;
        Powers dose{}, damage{};
        bool gated = false;
        for (int i = 0; i < exposed.count; ++i) {
            const double middle = exposed.middle_c[i];
            dose[i] = cem43_exponent(middle);
            damage[i] = arrhenius_exponent(s.arrhenius_ea_j_mol, middle);
            gated = gated || middle > s.arrhenius_gate_c;
        }
        exp2_portable(dose);
        if (gated) exp2_portable(damage);
        for (int i = 0; i < exposed.count; ++i) {
            const int v = exposed.vertex[i];
            const double middle = exposed.middle_c[i];
            const double added = std::min(dose[i] * dt / 60, kDoseFrozenMin);
            state.cem43_min[v] = std::min(state.cem43_min[v] + static_cast<float>(added),
                                          static_cast<float>(kDoseFrozenMin));
            if (middle > s.arrhenius_gate_c && state.arrhenius[v] < kOmegaFrozen) {
                const double rate = s.arrhenius_a_per_s * damage[i];
                state.arrhenius[v] =
                    std::min(kOmegaFrozen, state.arrhenius[v] + static_cast<float>(rate * dt));
            }
            if (middle > s.char_start_c && state.dried[v] >= 1) {
                state.charred[v] =
                    std::max(state.charred[v],
                             static_cast<float>(smoothstep(s.char_start_c, s.char_full_c, middle)));
            }
        }
        exposed.count = 0;
    }

    /// Tets whose corners have boiled dry enough, where something has dried since they were looked
    /// at. Each is seen once, from the lowest number among its corners that have boiled at all.
    int find_vaporised(std::span<const uint8_t> alive, std::span<int32_t> out) const noexcept {
        const auto threshold = static_cast<float>(4 * model.settings_.vaporise_dried);
        int found = 0;
        const int room = static_cast<int>(out.size());
        for (int n = 0; n < state.warm_count && found < room; ++n) {
            const int v = state.warm_list[n];
            if (state.dried[v] <= 0 || (state.wakes[v] & kDrying) == 0) continue;
            for (const int32_t t : body.tets_of(v)) {
                if (!alive[t]) continue;
                const auto& c = body.mesh().tets[t];
                if (std::any_of(c.begin(), c.end(),
                                [&](int32_t o) { return o < v && state.dried[o] > 0; })) {
                    continue;
                }
                const float sum =
                    state.dried[c[0]] + state.dried[c[1]] + state.dried[c[2]] + state.dried[c[3]];
                if (sum < threshold) continue;
                out[found++] = t;
                if (found == room) return found;  // the rest in the next step
            }
            state.wakes[v] &= static_cast<uint8_t>(~kDrying);
        }
        return found;
    }

    /// Takes `share` out of the directed edge i -> j.
    void lower_edge(int i, int j, double share) const noexcept {
        for (int e = model.edge_start_[i]; e < model.edge_start_[i + 1]; ++e) {
            if (model.edge_to_[e] == j) state.edge_w_k[e] -= static_cast<float>(share);
        }
    }

    void remove_tet(std::span<const std::array<int32_t, 4>> neighbours,
                    std::span<const uint8_t> alive, int tet) const noexcept {
        const TetMesh& mesh = body.mesh();
        const auto& c = mesh.tets[tet];
        const int tissue = static_cast<int>(mesh.tissue[tet]);
        double volume = 0;
        const Eigen::Matrix<double, 3, 4> g = shape_gradients(mesh, tet, volume);
        for (int i = 0; i < 4; ++i) {
            const int v = c[i];
            bool last = true;
            for (const int32_t t : body.tets_of(v)) last = last && !alive[t];
            const double before = state.enthalpy_j[v];
            if (last) {
                // Nothing is left there that could be hot: the dose stays as it was.
                state.capacity_j_k[v] = state.latent_j[v] = state.enthalpy_j[v] = 0;
                state.temperature_c[v] = static_cast<float>(model.settings_.body_temperature_c);
            } else {
                const double whole = state.capacity_j_k[v];
                state.capacity_j_k[v] -= model.capacity_j_m3k_[tissue] * volume / 4;
                state.latent_j[v] -= model.latent_j_m3_[tissue] * volume / 4;
                // What stays keeps its temperature and its dryness.
                state.enthalpy_j[v] = before * (state.capacity_j_k[v] / whole);
            }
            state.energy_vapour_j += before - state.enthalpy_j[v];
            for (int j = 0; j < 4; ++j) {
                if (j == i) continue;
                lower_edge(v, c[j],
                           -model.conductivity_w_mk_[tissue] * volume * g.col(i).dot(g.col(j)));
            }
        }
        for (int f = 0; f < 4; ++f) {
            const int other = neighbours[tet][f];
            const bool uncovers = other >= 0 && alive[other];
            const auto area = static_cast<float>(face_area(mesh, tet, f) / 3);
            for (const int k : kTetFaces[f]) {
                float& exposed = state.exposed_m2[c[k]];
                exposed = std::max(0.0f, exposed + (uncovers ? area : -area));
            }
        }
    }

    mutable double cooling_w = 0;
};

int step_heat(const SoftBody& body, const HeatModel& model, HeatState& state,
              std::span<const uint8_t> tet_alive, double dt,
              std::span<int32_t> vaporised) noexcept {
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / model.stable_step_s())));
    HeatStepper stepper{body, model, state};
    for (int n = 0; n < steps; ++n) {
        stepper.put_in_order();
        stepper.cooling_w = 0;
        stepper.conduct();
        stepper.spread();
        stepper.advance(dt / steps);
        state.energy_lost_j += stepper.cooling_w * dt / steps;
    }
    for (int n = 0; n < state.warm_count; ++n) state.power_w[state.warm_list[n]] = 0;
    return stepper.find_vaporised(tet_alive, vaporised);
}

void remove_heat_of_tet(const SoftBody& body, const HeatModel& model, HeatState& state,
                        std::span<const std::array<int32_t, 4>> neighbours,
                        std::span<const uint8_t> tet_alive, int tet) noexcept {
    assert(!tet_alive[tet]);
    HeatStepper{body, model, state}.remove_tet(neighbours, tet_alive, tet);
}

double stored_energy_j(const HeatState& state) noexcept {
    double sum = 0;
    for (int n = 0; n < state.warm_count; ++n) sum += state.enthalpy_j[state.warm_list[n]];
    return sum;
}

}  // namespace placode::sim
