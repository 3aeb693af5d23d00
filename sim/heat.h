// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Heat of the diathermy tip: conduction, latent heat, drying, vaporisation, damage.
// Enthalpy per vertex (lumped), only where it is warm. Sources: ARCHITECTURE.md, "Heat".

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/soft_body.h"

namespace placode::sim {

struct HeatSettings {
    double body_temperature_c = 37.0;
    double gas_temperature_c = 34.0;
    double surface_cooling_w_m2k = 15.0;
    double latent_heat_j_kg = 2.257e6;
    double char_start_c = 150, char_full_c = 220;
    double arrhenius_a_per_s = 7.39e39,
           arrhenius_ea_j_mol = 2.577e5;  ///< Visible coagulation (liver set).
    double arrhenius_gate_c = 43;         ///< No damage below.
    double dwell_radius_m = 0.001;        ///< Energy on one spot of this radius counts as dwell.
};

/// Constant part: lumped heat capacities and conductances of the rest mesh.
class HeatModel {
 public:
    HeatModel(const TetMesh& mesh, const MaterialTable& materials, const HeatSettings& settings);
    [[nodiscard]] const HeatSettings& settings() const noexcept { return settings_; }
    /// Largest stable explicit step [s].
    [[nodiscard]] double stable_step_s() const noexcept { return stable_step_s_; }

 private:
    friend struct HeatStepper;
    HeatSettings settings_;
    double stable_step_s_ = 0;
    std::vector<float> capacity_j_k_;            // (V)
    std::vector<float> latent_j_;                // (V)
    std::vector<int32_t> edge_start_, edge_to_;  // vertex graph, CSR
    std::vector<float> edge_w_k_;                // conductance [W/K]
    std::vector<float> exposed_area_m2_;         // (V) at rest
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
    std::vector<double> power_w;  ///< (V) source of this step, cleared by it
    double energy_in_j = 0;       ///< Total delivered.
    double energy_vapour_j = 0;   ///< Carried away by removed tissue and vapour.
    double energy_lost_j = 0;     ///< Cooled away at the surface.
};

/// One explicit step of `dt` seconds (at most stable_step_s()). Writes the tets whose water is gone
/// into `vaporised` and returns how many (never more than vaporised.size()).
int step_heat(const SoftBody& body, const HeatModel& model, HeatState& state,
              std::span<const uint8_t> tet_alive, double dt, std::span<int32_t> vaporised) noexcept;

/// Spreads `power_w` around `tip` as P a / (2 pi r^4), r in [a, 4a], normalised on the mesh;
/// returns the power that found tissue [W].
double deposit_power(const SoftBody& body, const SoftBodyState& tissue, HeatState& state,
                     std::span<const int32_t> candidates, const Vec3& tip, double a_m,
                     double power_w) noexcept;

}  // namespace placode::sim
