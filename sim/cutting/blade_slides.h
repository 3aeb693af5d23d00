// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where blades will pass between the vertices of the mesh, vertices slide onto the blades' plane
// before the faces part, so that the cut's edge is the path of the blades and not the mesh's.
// Of every edge that the plane crosses the end with the shorter way goes. It takes a few
// milliseconds from hinge to tip, a short stretch of the blades in each frame. What may not slide,
// or not so far, leaves a step of the mesh, which is counted.

#include "sim/world/scissors_state.h"

namespace placode::sim {

struct Scene;
struct State;

/// What the blades sweep, in frame T of scissors.h.
struct BladeReach {
    double length_m = 0;  ///< From hinge to tip.
    double slope = 0;     ///< tan of half the opening.
    double pad_m = 0;     ///< Tissue so far beyond is still theirs.
};

/// Blades that begin to close at `s.plane`: notes where they meet the tissue, and that slides
/// follow, if the scene wants them.
void begin_slides(const Scene& scene, const State& state, Scissors& s,
                  const BladeReach& reach) noexcept;

/// The slides of one frame. False when the tips are reached: faces may be planned.
bool slide_to_blades(const Scene& scene, State& state, Scissors& s,
                     const BladeReach& reach) noexcept;

}  // namespace placode::sim
