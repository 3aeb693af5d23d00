// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The damage ledger: what a frame adds to it, read from the state only.
//
// Spans of time (energy in air, dwell, contact with the placode, too much force) are entered when
// they end, at the latest with the attempt, with their length; losses of tissue at once.

#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// End of a frame of `dt` seconds: energy, contacts, doses, phases, tethers, hash. `active[t]` =
/// the pedal of tool t drives current.
void update_ledger(const Scene& scene, State& state, std::span<const uint8_t> active,
                   double dt) noexcept;

/// Entries for what is still going on when the attempt ends: whoever stops while pressing, pulling
/// or burning has done it all the same. The state stays as it is. Allocates: after the last frame.
[[nodiscard]] std::vector<Event> open_spells(const Scene& scene, const State& state);

}  // namespace placode::sim
