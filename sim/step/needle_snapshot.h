// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Needle and thread as they are seen. The simulation has the thread straight from mouth to mouth,
// without weight and touching nothing; here it lies on the tissue, and what is slack between two
// bites stands up as an arch, because a suture is stiff. Nothing of this goes back into the
// simulation.

#include "sim/step/snapshot.h"

namespace placode::sim {

/// Reuses the capacity of `out`: allocates on first use only. @pre scene.suture.
void fill_needle(const Scene& scene, const State& state, NeedleSnapshot& out);

}  // namespace placode::sim
