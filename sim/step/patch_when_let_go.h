// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a patch lies over the lesion when hands have let go: held up or pressed flat it is not laid.

#include <vector>

#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// kPatchEdge and kPatchFold half a second after every hand has let go, on a copy of the state;
/// nothing without a patch and a placode. The same for the same state, whatever its number of
/// threads and substeps. Allocates.
[[nodiscard]] std::vector<Event> patch_when_let_go(const Scene& scene, const State& state);

}  // namespace placode::sim
