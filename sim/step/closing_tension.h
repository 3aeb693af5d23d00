// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How hard the edges of a wound in the skin must be pulled to meet: both are drawn to the plane
// half way between them, through the wound's tips, as by sutures set close together, and what they
// pull back is read. docs/cutting.md

#include <vector>

#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

struct ClosingTension {
    double n_per_m = 0;              ///< Pull of an edge over its length, mean of both edges.
    std::vector<double> at_station;  ///< The same of each station of the slit [N/m].
};

/// The skin's share of the walls is drawn together: the layers above the subcutis. Spoils this
/// state, in which no hand touches the tissue. The same on every number of threads. Allocates.
/// @pre scene.slit.present().
[[nodiscard]] ClosingTension closing_tension(const Scene& scene, State& state);

/// Of each station: half of the way to its neighbours [m].
[[nodiscard]] std::vector<double> station_lengths(const Scene& scene);

}  // namespace placode::sim
