// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The damage ledger: what a frame adds to it, read from the state only.
//
// Spans of time (energy in air, dwell, contact with the placode, too much force) are entered when
// they end, with their length; losses of tissue at once.

#include <span>

#include "sim/step.h"

namespace placode::sim {

/// Appends to the events of this frame; sets kEventsDropped when there is no room.
void add_event(State& state, const Event& event) noexcept;

/// Event at a tet: time, tissue, place at rest.
[[nodiscard]] Event tissue_event(const Scene& scene, const State& state, EventKind kind,
                                 int tet) noexcept;

/// Event of an instrument at the spot next to its bare metal.
[[nodiscard]] Event tool_event(const State& state, EventKind kind, int tool) noexcept;

/// End of a frame of `dt` seconds: energy, contacts, doses, phases, tethers, hash. `active[t]` =
/// the pedal of tool t drives current.
void update_ledger(const Scene& scene, State& state, std::span<const uint8_t> active,
                   double dt) noexcept;

}  // namespace placode::sim
