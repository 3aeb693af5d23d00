// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sac of a cystic lesion: its walls and floor, constant, and what it holds.
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"

namespace placode::sim {

/// What scene files say. No pressure, no sac.
struct SacSettings {
    double pressure_pa = 0;             ///< Over that of the gas, before anything is cut.
    double stiffness_pa_m3 = 1.1e9;     ///< Pressure lost with every volume of fluid lost.
    double discharge = 0.6;             ///< Coefficient of the orifice [-].
    double fluid_density_kg_m3 = 1007;  ///< Cerebrospinal fluid.
    double floor_n_m = 20;              ///< Stiffness of the floor's answer at one vertex [N/m].
    double floor_drag_n_m = 2;          ///< What a resting vertex drags on, per frame [N/m].
};

/// Height of the canal's floor over the plane, at rest.
struct CanalFloor {
    double x_m = 0, y_m = 0, cell_m = 1;  ///< First node, distance of nodes.
    int columns = 0, rows = 0;
    std::vector<float> height_m;  ///< (columns x rows), far below where there is no floor.
    [[nodiscard]] double at(double x, double y) const noexcept;
};

/// Constant part. Vertices are those of the mesh; each has an anchor spring without stiffness.
struct Sac {
    SacSettings settings;
    std::vector<std::array<int32_t, 3>> triangles;  ///< Underside, seen from inside clockwise.
    std::vector<std::array<int32_t, 6>> above;      ///< Tets over each: open when all are gone.
    std::vector<int32_t> vertices;                  ///< Off the rim, ascending.
    std::vector<int32_t> around_start, around;      ///< Triangles of each of `vertices`.
    CanalFloor floor;

    [[nodiscard]] bool present() const noexcept { return !triangles.empty(); }
    /// Lists `vertices` and `around`; `rim` = vertices that get no load. Call once.
    void connect(const std::vector<uint8_t>& rim);
};

/// Changing part.
struct SacState {
    double pressure_pa = 0;  ///< [Pa]
    double content_m3 = 0;   ///< Fluid, on the scale of sac_volume() [m^3].
    double hole_m2 = 0;      ///< Open area at rest [m^2].
    double leaked_m3 = 0;
    double roused_pa = 0;   ///< Pressure when the tissue was last woken for it.
    uint32_t looked = ~0U;  ///< Surface version and splits at the last look for holes.
    uint8_t filled = 0;     ///< 1 = content is known.
    uint8_t opened = 0;     ///< 1 = the opening is in the ledger.
};
template <class Visit>
void fields(Of<SacState> auto& s, Visit&& visit) {
    auto& [pressure_pa, content_m3, hole_m2, leaked_m3, roused_pa, looked, filled, opened] = s;
    visit.state(pressure_pa, content_m3, hole_m2, leaked_m3, roused_pa, looked, filled, opened);
}

}  // namespace placode::sim
