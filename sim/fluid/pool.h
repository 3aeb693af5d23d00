// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fluid that stands on the field: a height in every cell of a grid. Every sweep moves a fifth of
// the difference of level from cell to cell, at most a quarter of what the giver has above a film
// that sticks. It finds its level and makes no waves; what one cell gives the other gets, so the
// volume is kept to rounding. Blood goes with it in proportion.

#include "sim/core/geometry.h"
#include "sim/world/irrigation.h"
#include "sim/world/irrigation_state.h"
#include "sim/world/pool_flux.h"

namespace placode::sim {

/// So much wets the surface and stays [m].
inline constexpr double kFilmM = 2e-5;
/// Fluid that is less deep counts as wet surface and not as standing fluid [m].
inline constexpr double kStandingM = 2e-4;

[[nodiscard]] double pool_level_m(const PoolGrid& grid, const Pool& pool, int32_t cell) noexcept;
[[nodiscard]] inline double pool_depth_m(const PoolGrid& grid, const Pool& pool,
                                         int32_t cell) noexcept {
    return pool.volume_m3[static_cast<size_t>(cell)] / grid.cell_m2();
}

/// Adds fluid, of which `blood_m3` is blood; a cell outside, -1, has run off at once.
void add_fluid(Pool& pool, int32_t cell, double volume_m3, double blood_m3) noexcept;
/// Lets it flow once. Fluid that has come to rest costs nothing until somebody adds or takes some;
/// `flux` is zero then.
void sweep_pool(const PoolGrid& grid, Pool& pool, PoolFlux& flux) noexcept;
/// Takes up to `most_m3` from cells within `radius_m` of a place whose level lies above `low_m`,
/// from each the same share. Returns what it got [m3].
double drain_pool(const PoolGrid& grid, Pool& pool, const Vec2& place, double radius_m,
                  double low_m, double most_m3) noexcept;

/// All that stands deeper than kStandingM [m3].
[[nodiscard]] double standing_m3(const PoolGrid& grid, const Pool& pool) noexcept;
/// In all cells [m3].
[[nodiscard]] double stored_m3(const Pool& pool) noexcept;
/// Share of light that blood in a cell takes: 1 - exp(-kBloodPerM depth of blood).
[[nodiscard]] double cell_hidden(const PoolGrid& grid, const Pool& pool, int32_t cell) noexcept;
/// Mean of it over the cells that have to be seen.
[[nodiscard]] double view_hidden(const Irrigation& irrigation, const Pool& pool) noexcept;

}  // namespace placode::sim
