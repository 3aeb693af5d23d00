// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fluid that presses through a stretch of a slit, and what it presses on the walls meanwhile.

#include <array>

#include "sim/world/slit.h"

namespace placode::sim {

/// Amniotic and cerebrospinal fluid at 37 C.
inline constexpr double kFluidPaS = 0.7e-3, kFluidKgM3 = 1005;
inline constexpr double kSlitDischarge = 0.6;  ///< Of a sharp-edged orifice.

/// A stretch of a slit with the walls straight between levels, from the surface (0) to the floor,
/// where the fluid comes from.
struct SlitStretch {
    double length_m = 0;                                       ///< Along the slit.
    int layers = 0;                                            ///< Levels less one.
    std::array<double, Slit::kMostLevels> gap_m{}, depth_m{};  ///< At each level.
};

struct SlitFlow {
    double flow_m3_s = 0;
    /// Mean between each level and the next, on the walls.
    std::array<double, Slit::kMostLevels> pressure_pa{};
};

/// Viscous between the walls and through the neck as through an orifice, in series. Nothing where
/// it is shut at any level: below, the walls bear the whole pressure, above none.
/// Source: Reynolds' lubrication, 12 mu L Q / (w g^3), its integrals over a taper; Torricelli.
[[nodiscard]] SlitFlow flow_through(const SlitStretch& stretch, double pressure_pa) noexcept;

}  // namespace placode::sim
