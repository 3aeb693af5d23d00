// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tissue that goes: tets that heat vaporised or traction tore leave body, surface and heat
// together; the incision's progress is counted from them (see CutProgress).

#include <cstdint>

#include "sim/core/event.h"
#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// Takes a tet out of body, surface, heat and contour columns and writes its event. `tool` = who
/// did it, `value2` as in EventKind.
void remove_tissue(const Scene& scene, State& state, int tet, EventKind cause, int tool,
                   double value2) noexcept;

/// The same without an event and without counting as removed by heat or force.
void take_out(const Scene& scene, State& state, int tet) noexcept;

/// Tears what is stretched beyond its limit in several checks in a row: tets at the contact colour
/// every frame, the others in turn, 1/64 a frame. At most 8 tets a frame.
void tear(const Scene& scene, State& state) noexcept;

/// Mean depth of a tet below the rest surface [m]; 0 where the scene does not say.
[[nodiscard]] double tet_depth(const Scene& scene, int tet) noexcept;

/// Neighbour of a tet across its face `face` while they hang together; -1 = the face is free, cut,
/// or the neighbour has gone.
[[nodiscard]] int32_t linked_across(const Scene& scene, const State& state, int tet,
                                    int face) noexcept;

}  // namespace placode::sim
