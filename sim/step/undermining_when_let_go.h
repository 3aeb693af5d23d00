// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far skin is undermined when hands have let go, and what it takes to close the wound now.

#include <vector>

#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// kUndermined and kClosingTension half a second after every hand has let go, on a copy of the
/// state; nothing without a plane. The same for the same state, whatever its number of threads and
/// substeps. Allocates.
[[nodiscard]] std::vector<Event> undermining_when_let_go(const Scene& scene, const State& state);

}  // namespace placode::sim
