// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A round jet on a surface, in closed form. With v0 and d at the nozzle:
//   speed on the axis    v = v0 min(1, L / x), L = core_diameters d (a jet in fluid of its kind)
//   pressure             p = 1/2 rho v^2 c^2 exp(-r^2 / b^2), b = d / sqrt(2) v0 / v
//   shear at the wall    t = T 4 s^2 / (1 + s^2)^2, s = r / b, T = 44.6 rho v0^2 Re^-1/2 (d / y)^2,
//                        y = max(x, L)
// x = way from the nozzle, r = distance from the axis, c = cosine between axis and normal. The
// width b is what the momentum asks for: on a plane at any angle the pressure adds up to the
// momentum flux rho v0^2 A along the normal, c rho v0^2 A.
// Sources: L and 1/x of a free round jet, Pope, Turbulent Flows (2000), 5.1; T: Phares, Smedley &
// Flagan, J Fluid Mech 2000;418:351 (normal impingement; there the maximum lies at r = 0.09 x, here
// at 0.11 x). The profile of the shear is ours: zero on the axis, falling with 1/r^2.

#include "sim/world/irrigation.h"

namespace placode::sim {

[[nodiscard]] double jet_area_m2(const JetSpec& jet) noexcept;
[[nodiscard]] double jet_flow_m3_s(const JetSpec& jet) noexcept;
/// rho v0^2 A [N].
[[nodiscard]] double jet_momentum_n(const JetSpec& jet) noexcept;
[[nodiscard]] double jet_core_m(const JetSpec& jet) noexcept;
/// On the axis [m/s].
[[nodiscard]] double jet_speed_m_s(const JetSpec& jet, double x_m) noexcept;
/// b [m].
[[nodiscard]] double jet_width_m(const JetSpec& jet, double x_m) noexcept;
[[nodiscard]] double jet_pressure_pa(const JetSpec& jet, double x_m, double r_m,
                                     double cosine) noexcept;
[[nodiscard]] double jet_shear_pa(const JetSpec& jet, double x_m, double r_m) noexcept;

}  // namespace placode::sim
