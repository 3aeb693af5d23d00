// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is left of a slit when hands have let go, and whether it is watertight: pressed or held
// together it is not sewn up.

#include <vector>

#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// kSlitGap half a second after every hand has let go, on a copy of the state, and then
/// watertight_events() where the scene tests it; nothing without a slit. The same for the same
/// state, whatever its number of threads and substeps. Allocates.
[[nodiscard]] std::vector<Event> slit_when_let_go(const Scene& scene, const State& state);

}  // namespace placode::sim
