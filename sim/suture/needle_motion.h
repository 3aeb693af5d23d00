// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The needle as a rigid body: one more block of the substep's descent, with six unknowns. Implicit
// Euler between its inertia, the hands' holds (each a spring on place and direction at its grip,
// that slips where friction of its jaws ends) and all bonds with tissue.

#include "sim/suture/needle_bonds.h"

namespace placode::sim {

/// Start of a substep: the hand is at X_WH from now on.
void begin_needle(const Suture& suture, SutureState& state, SutureScratch& scratch,
                  const Pose& X_WH) noexcept;
/// Before begin_suture() of a substep, where two hands hold the needle: the second is at X_WH from
/// now on.
void move_second_hand(SutureState& state, SutureScratch& scratch, const Pose& X_WH) noexcept;
/// Where a needle that lies in the open, out of all hands and tissue, meets a surface or the floor.
/// Its weight (0.2 mN) is nothing to the tissue, which is left alone.
void find_supports(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                   SutureScratch& scratch) noexcept;
/// Newton steps of the pose, with the tissue where it is, until bonds at their bounds have given
/// way.
void solve_needle(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  SutureScratch& scratch, double h_s) noexcept;
/// End of a substep: velocity, force of the hands and their work; slip in the jaws.
/// @param X_WH_before where the hand was at the substep's start.
void finish_needle(const Suture& suture, SutureState& state, const SutureScratch& scratch,
                   const Pose& X_WH_before, double h_s, SutureReport& report) noexcept;

/// Energy of the hands' holds [J].
[[nodiscard]] double hold_energy(const Suture& suture, const SutureState& state) noexcept;
/// Of one of them, with the needle at X_WN.
[[nodiscard]] double hold_energy(const Suture& suture, const NeedleHold& hold,
                                 const Pose& X_WN) noexcept;
/// Energy of motion [J].
[[nodiscard]] double kinetic_energy(const Needle& needle, const SutureState& state) noexcept;

/// Writes an event, or says that there was no room.
void tell(SutureReport& report, const SutureEvent& event) noexcept;

}  // namespace placode::sim
