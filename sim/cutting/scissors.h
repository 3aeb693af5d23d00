// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Blades. When they begin to close, the faces of the mesh that lie nearest to the blades' plane
// between them are planned, in the order in which the crossing of the blades will reach them; while
// they close, the crossing runs from the hinge to the tips and parts the faces that it passes.
// Tissue that moves meanwhile is cut where the blades met it. Opening begins anew.
//
// Frame T: z distal, blades open along y, their plane is x = 0.

#include "sim/world/scissors_state.h"

namespace placode::sim {

struct Scene;
struct State;

/// One frame of all scissors; writes a finished snip into the ledger.
void run_scissors(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim
