// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an instrument does with its current, as the ledger tells it: switched on and off, in air, on
// one spot for long, on the placode. In air and on one spot taps are one spell: it ends where the
// current goes elsewhere, or has been off for over a second.

#include <vector>

#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// One frame of `dt` seconds of tool `t`; `active` = its pedal drives current.
void ledger_energy(const Scene& scene, State& state, int t, bool active, double dt) noexcept;

/// Adds entries for spells that are not over after the last frame: current flows, or has paused.
void open_energy(const State& state, int t, std::vector<Event>& events);

}  // namespace placode::sim
