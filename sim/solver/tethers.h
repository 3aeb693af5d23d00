// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tethers and sheets inside a substep: few, so one by one on the calling thread.
// Internal to the solver.

#include "sim/solver/soft_body.h"

namespace placode::sim {

/// Newton step of every tethered vertex and every vertex of a sheet (they are left out of the
/// sweep), then the force of each tether. h [s]. Returns StepFlag bits.
uint32_t solve_singles_vbd(const SoftBody& body, SoftBodyState& state, double h) noexcept;

/// One pass over the tethers as one-sided distance constraints with compliance.
void solve_tethers_xpbd(const SoftBody& body, SoftBodyState& state, double h) noexcept;

/// Switches off tethers whose force is above their limit. True when one broke.
bool break_overloaded_tethers(const SoftBody& body, SoftBodyState& state) noexcept;

}  // namespace placode::sim
