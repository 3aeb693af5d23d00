// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Irrigators at work: the yellow pedal opens the jet, the blue one the suction, both at the tip.
// The jet pushes on what it hits first, loosens debris and fills the pool; suction empties it,
// takes what floats near the mouth, and pulls tissue that is nearer than the mouth's radius. Only
// for scenes with Scene::irrigation; others skip it.

#include <vector>

#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// Start of a frame of `dt_s`, after collect_candidates() and before sleepers are woken. Never
/// allocates.
void update_irrigation(const Scene& scene, State& state, double dt_s) noexcept;

/// After the last frame: open spells, sums, debris that is left. Nothing without irrigation.
/// Allocates.
[[nodiscard]] std::vector<Event> irrigation_events(const Scene& scene, const State& state);

}  // namespace placode::sim
