// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The field after every hand has let go: what is judged at the end is what lies there by itself.

#include <memory>

#include "sim/world/state.h"

namespace placode::sim {

struct Scene;

/// Half a second later, without any hand: a copy, `state` itself goes on as if nobody had looked.
/// The same for the same state, whatever its number of threads and substeps. Allocates.
[[nodiscard]] std::unique_ptr<State> let_go(const Scene& scene, const State& state);

}  // namespace placode::sim
