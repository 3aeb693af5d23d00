// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What hangs together. Two questions, both answered over uncut faces of living tets:
//
// Release: does a path through placode, zone and skin still lead from the placode to the skin?
// Asked for each of 72 sectors of 5 degrees, inside the sector and three neighbours to either side;
// one sector a frame, and only after the surface has changed.
//
// Loose pieces: tets that no path leads to from the bed. A flood from the bed runs over some frames
// whenever the surface has changed. A crumb is washed away; a piece lies where it came loose (wet
// tissue sticks) until jaws take it, falls when they let it go, and is out when they have drawn it
// back towards the port.

#include "sim/core/geometry.h"
#include "sim/world/pieces_state.h"

namespace placode::sim {

struct Scene;
struct State;

/// Sector of a place at rest: 0 begins at +x (cranial), counting towards +y (left).
[[nodiscard]] int sector_of(const Vec3& rest) noexcept;

/// One frame of both. Call after everything that cuts.
void update_pieces(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim
