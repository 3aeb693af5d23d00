// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Irrigation and suction: what never changes of it. Laws: sim/fluid, docs/irrigation.md. All
// numbers are planning values that a fetal surgeon must confirm.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::sim {

/// Pressure of a jet on the placode that counts as injury [Pa].
inline constexpr double kJetLimitPa = 500;
/// A share of the lesion that is hidden by blood: more than that is working blind.
inline constexpr double kBlindShare = 0.3;

/// A round jet out of the tip of an irrigator, along its shaft.
struct JetSpec {
    double speed_m_s = 1.2;  ///< At the nozzle: 36 ml/min out of 0.8 mm.
    double bore_m = 0.0008;
    double density_kg_m3 = 1000;
    double viscosity_pa_s = 7e-4;  ///< Of saline at 37 C.
    double core_diameters = 6.2;   ///< The jet keeps its speed so far, then it falls with distance.
};

/// The sucker is the same tip.
struct SuctionSpec {
    double pressure_pa = 4000;  ///< Below that of the gas: 30 mmHg.
    double bore_m = 0.0015;
    double flow_m3_s = 2e-6;  ///< Most fluid that the tube takes.
};

enum class DebrisKind : uint8_t { kChar, kBlood };
inline constexpr int kDebrisKinds = 2;

/// What a jet needs to loosen debris, by kind.
struct DebrisLaw {
    std::array<double, kDebrisKinds> adhesion_pa{8, 5};  ///< Wall shear that it stands.
    std::array<double, kDebrisKinds> hold_s{0.3, 0.6};   ///< More than that for so long loosens it.
    double blood_m3 = 1e-9;  ///< What a spot of blood gives to the fluid that loosens it.
};

/// One crumb or spot, stuck to the surface.
struct Debris {
    DebrisKind kind = DebrisKind::kChar;
    std::array<int32_t, 3> vertex{};  ///< Of the surface.
    std::array<float, 3> weight{};    ///< Barycentric.
    float radius_m = 0.0005F;         ///< For the picture.
};

/// Cells over the field in which fluid stands. Beyond its rim fluid is lost.
struct PoolGrid {
    double x_m = 0, y_m = 0;  ///< Corner of the first cell.
    double cell_m = 0.0005;
    int columns = 0, rows = 0;
    std::vector<float> ground_m;  ///< (columns x rows) Surface at rest in the middle of each cell.
    std::vector<uint8_t> drain;   ///< 1 = outside of the field: what comes here has run off.

    [[nodiscard]] size_t cells() const noexcept { return ground_m.size(); }
    [[nodiscard]] double cell_m2() const noexcept { return cell_m * cell_m; }
    /// -1 outside of the grid.
    [[nodiscard]] int32_t cell_at(double x, double y) const noexcept {
        const double i = (x - x_m) / cell_m, j = (y - y_m) / cell_m;
        if (!(i >= 0 && j >= 0 && i < columns && j < rows)) return -1;
        return static_cast<int32_t>(j) * columns + static_cast<int32_t>(i);
    }
    [[nodiscard]] Vec2 middle(int32_t cell) const noexcept {
        const int32_t row = cell / columns;
        return {x_m + cell_m * (cell % columns + 0.5), y_m + cell_m * (row + 0.5)};
    }
};

struct Irrigation {
    JetSpec jet;
    SuctionSpec suction;
    DebrisLaw law;
    PoolGrid grid;
    double start_m3 = 0, start_blood_m3 = 0;  ///< Of fluid, and of blood in it, at the start.
    std::vector<Debris> debris;
    std::vector<int32_t> view;   ///< Cells of the lesion: what has to be seen.
    std::vector<uint8_t> bears;  ///< (V) 1 = set_load() works there.
};

}  // namespace placode::sim
