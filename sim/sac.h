// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The fluid of a cystic lesion (meningomyelocele): no fluid solver, one pressure. The membrane with
// the placode on it closes a sac over the canal. Its pressure follows from what the sac holds and
// the volume under the membrane, pushes on the underside, and drops as fluid leaves through what
// has been cut open (orifice flow). Empty, the membrane sinks onto the canal's floor.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh.h"

namespace placode::sim {

struct Scene;
struct State;

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
    uint32_t looked = ~0U;  ///< Surface version of the last look for holes.
    uint8_t filled = 0;     ///< 1 = content is known.
    uint8_t opened = 0;     ///< 1 = the opening is in the ledger.
};

/// Volume between the underside and the origin's fan [m^3]: differences count, and the gradient in
/// a vertex off the rim is a third of the area vectors around it.
[[nodiscard]] double sac_volume(const Sac& sac, const State& state) noexcept;

/// Start of a frame of `dt_s`: pressure, leak, loads on the underside, floor. While `held`, the
/// pressure stays what the scene says (the field settles). Never allocates.
void update_sac(const Scene& scene, State& state, double dt_s, bool held) noexcept;

}  // namespace placode::sim
