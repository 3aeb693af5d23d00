// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Heat of the diathermy tip: conduction, latent heat, drying, vaporisation, damage.
// Enthalpy per vertex (lumped), only where it is warm. Sources: docs/heat.md.
//
// Enthalpy H is counted from body temperature, in double, so that the balance
// energy_in = stored + vapour + lost holds to rounding. It heats to 100 C, then boils the water
// (the latent heat leaves with the steam), then heats the dry rest, which keeps the heat capacity
// of wet tissue.
// Blood perfusion is left out: its time constant is minutes, an activation lasts seconds.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/fields.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

struct HeatSettings {
    double body_temperature_c = 37.0;
    double gas_temperature_c = 34.0;
    double surface_cooling_w_m2k =
        15.0;  ///< Acts on the excess over the warmer of body and gas: untouched tissue is at rest.
    double latent_heat_j_kg = 2.257e6;
    double char_start_c = 150, char_full_c = 220;
    double arrhenius_a_per_s = 7.39e39,
           arrhenius_ea_j_mol = 2.577e5;  ///< Visible coagulation (liver set).
    double arrhenius_gate_c = 43;         ///< No damage below.
    double dwell_radius_m = 0.001;        ///< Energy on one spot of this radius counts as dwell.
    double vaporise_dried = 0.5;  ///< A tet goes when its corners have boiled this much on average:
                                  ///< steam bursts tissue before the last water has boiled.
};

/// Rate of the thermal dose, R^(43-T) with R = 0.5 from 43 C on and 0.25 below [min/min].
/// Source: Sapareto & Dewey 1984.
[[nodiscard]] double cem43_rate(double temperature_c) noexcept;

/// Rate of the Arrhenius damage integral A exp(-Ea/(Rg T)) [1/s].
[[nodiscard]] double arrhenius_rate(double a_per_s, double ea_j_mol, double temperature_c) noexcept;

/// Constant part: lumped heat capacities and conductances of the rest mesh.
class HeatModel {
 public:
    HeatModel(const TetMesh& mesh, const MaterialTable& materials, const HeatSettings& settings);
    [[nodiscard]] const HeatSettings& settings() const noexcept { return settings_; }
    /// Largest stable explicit step [s], also after any tets have gone: the largest eigenvalue of
    /// the whole is no larger than that of its worst element (Irons & Treharne 1971).
    [[nodiscard]] double stable_step_s() const noexcept { return stable_step_s_; }
    [[nodiscard]] std::span<const float> capacity_j_k() const noexcept { return capacity_j_k_; }

 private:
    friend struct HeatStepper;
    friend struct HeatState;
    HeatSettings settings_;
    double stable_step_s_ = 0;
    std::vector<float> capacity_j_k_;            // (V)
    std::vector<float> latent_j_;                // (V)
    std::vector<int32_t> edge_start_, edge_to_;  // vertex graph, CSR
    std::vector<float> edge_w_k_;                // conductance [W/K]
    std::vector<float> exposed_area_m2_;         // (V) at rest
    std::array<float, kTissueCount> capacity_j_m3k_{}, latent_j_m3_{}, conductivity_w_mk_{};
};

/// Changing part. Vertices are "warm" from the first joule on.
struct HeatState {
    explicit HeatState(const HeatModel& model, int vertices, int tets);
    std::vector<float> temperature_c;  ///< (V)
    std::vector<float> dried;          ///< (V) fraction of the water that has boiled, 0..1
    std::vector<float> cem43_min;      ///< (V) thermal dose
    std::vector<float> arrhenius;      ///< (V) Omega, frozen at 10
    std::vector<float> charred;        ///< (V) 0..1
    std::vector<uint8_t> warm;         ///< (V)
    std::vector<int32_t> warm_list;    ///< Warm vertices, first `warm_count`.
    int warm_count = 0;
    /// The same vertices in rising order, kept by step_heat(): memory is read forwards.
    std::vector<int32_t> in_order;
    int ordered_count = 0;
    std::vector<uint8_t> wakes;        ///< (V) bits: 1 = warm beside what is not; 2 = drier around
    std::vector<double> power_w;       ///< (V) source of this step, cleared by it
    std::vector<double> enthalpy_j;    ///< (V) above body temperature: the state proper
    std::vector<double> capacity_j_k;  ///< (V) of the tets still there
    std::vector<double> latent_j;      ///< (V) of the tets still there
    std::vector<double> flux_w;        ///< (V) scratch of one step
    std::vector<float> edge_w_k;       ///< Conductance of the tets still there [W/K]
    std::vector<float> exposed_m2;     ///< (V) free surface
    double energy_in_j = 0;            ///< Total delivered.
    double energy_vapour_j = 0;        ///< Carried away by removed tissue and vapour.
    double energy_lost_j = 0;          ///< Cooled away at the surface.
};
template <class Visit>
void fields(Of<HeatState> auto& s, Visit&& visit) {
    auto& [temperature_c, dried, cem43_min, arrhenius, charred, warm, warm_list, warm_count,
           in_order, ordered_count, wakes, power_w, enthalpy_j, capacity_j_k, latent_j, flux_w,
           edge_w_k, exposed_m2, energy_in_j, energy_vapour_j, energy_lost_j] = s;
    visit.state(dried, cem43_min, arrhenius, charred, warm_list, warm_count, power_w, enthalpy_j,
                energy_in_j, energy_vapour_j, energy_lost_j);
    visit.kept(temperature_c, warm, in_order, ordered_count, wakes, capacity_j_k, latent_j,
               edge_w_k, exposed_m2);
    visit.constant(flux_w);
}

/// One explicit step of `dt` seconds (at most stable_step_s()). Writes the tets whose water is gone
/// into `vaporised` and returns how many (never more than vaporised.size()).
int step_heat(const SoftBody& body, const HeatModel& model, HeatState& state,
              std::span<const uint8_t> tet_alive, double dt, std::span<int32_t> vaporised) noexcept;

/// Takes the share of a tet out of the lumped model: capacity, latent heat, conductance and the
/// enthalpy they hold; faces that it uncovers begin to cool. Temperatures stay.
/// @pre tet_alive[tet] is already 0. `neighbours` as in Surface (T x 4).
void remove_heat_of_tet(const SoftBody& body, const HeatModel& model, HeatState& state,
                        std::span<const std::array<int32_t, 4>> neighbours,
                        std::span<const uint8_t> tet_alive, int tet) noexcept;

/// Heat above body temperature that the tissue holds now [J].
[[nodiscard]] double stored_energy_j(const HeatState& state) noexcept;

/// How a current may act.
struct DepositLimits {
    double step_s = 1e-3;    ///< Length of the heat step that will use the power [s].
    double dried_limit = 1;  ///< Vertices dried so far take no more (1: up to `peak_c`).
    double peak_c = 250;     ///< Dry tissue takes power up to this temperature [C].
    double body_temperature_c = 37;
};

/// Spreads `power_w` around `tip` as P a / (2 pi r^4), r in [a, 4a], normalised on the mesh
/// (nearer vertices count as r = a). A dried vertex conducts 1 % of a wet one, and none takes more
/// than half of what boils it in one step; what they refuse is not delivered. Returns the power
/// that found tissue [W].
double deposit_power(const SoftBody& body, const SoftBodyState& tissue, HeatState& state,
                     std::span<const int32_t> candidates, const Vec3& tip, double a_m,
                     double power_w, const DepositLimits& limits = {}) noexcept;

}  // namespace placode::sim
