// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Entries of the damage ledger, written by every subsystem into the events of its frame.

#include "sim/core/event.h"
#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// Appends to the events of this frame; sets kEventsDropped when there is no room.
void add_event(State& state, const Event& event) noexcept;

/// Event at a tet: time, tissue, place at rest.
[[nodiscard]] Event tissue_event(const Scene& scene, const State& state, EventKind kind,
                                 int tet) noexcept;

/// Event of an instrument at the spot next to its bare metal.
[[nodiscard]] Event tool_event(const State& state, EventKind kind, int tool) noexcept;

/// Place of an event that belongs to no tet, at rest [m].
void set_rest_position(Event& event, const Vec3& place) noexcept;

/// Centroid of a tet at rest [m].
[[nodiscard]] Vec3 rest_centroid(const Scene& scene, int tet) noexcept;

}  // namespace placode::sim
