// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The needle as a rigid body: one more block of the substep's descent, with six unknowns. Implicit
// Euler between its inertia, the hand's hold (a spring on place and direction at the grip, that
// slips where friction of the jaws ends) and all bonds with tissue.

#include "sim/suture/needle_bonds.h"

namespace placode::sim {

/// Start of a substep: the hand is at X_WH from now on.
void begin_needle(const Suture& suture, SutureState& state, SutureScratch& scratch,
                  const Pose& X_WH) noexcept;
/// Where a needle that lies in the open, out of all hands and tissue, meets a surface or the floor.
/// Its weight (0.2 mN) is nothing to the tissue, which is left alone.
void find_supports(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                   SutureScratch& scratch) noexcept;
/// Newton steps of the pose, with the tissue where it is, until bonds at their bounds have given
/// way.
void solve_needle(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  SutureScratch& scratch, double h_s) noexcept;
/// End of a substep: velocity, force of the hand and its work; slip in the jaws.
/// @param X_WH_before where the hand was at the substep's start.
void finish_needle(const Suture& suture, SutureState& state, const SutureScratch& scratch,
                   const Pose& X_WH_before, double h_s, SutureReport& report) noexcept;

/// Energy of the hand's hold [J].
[[nodiscard]] double hold_energy(const Suture& suture, const SutureState& state) noexcept;
/// Energy of motion [J].
[[nodiscard]] double kinetic_energy(const Needle& needle, const SutureState& state) noexcept;

/// Writes an event, or says that there was no room.
void tell(SutureReport& report, const SutureEvent& event) noexcept;

}  // namespace placode::sim
