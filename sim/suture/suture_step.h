// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The needle's part of a substep, around that of the tissue. Per frame: refit the surface's tree.
// Per substep:
//
//   begin_substep(body) ; begin_suture ; solve_suture(forward) ; sweep(body) ;
//   solve_suture(backward) ; finish_suture ; end_substep(body)
//
// Nothing here throws, allocates or locks, and all of it runs on the caller's thread in an order
// that depends on indices only: the same input gives the same bits at any number of threads. A
// scene without a needle calls nothing.

#include "sim/suture/puncture.h"
#include "sim/suture/thread_step.h"

namespace placode::sim {

/// After begin_substep() of the body. @param X_WH where the hand is at the end of the substep;
/// without meaning while it does not hold the needle.
void begin_suture(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  SutureScratch& scratch, const Pose& X_WH, double h_s,
                  SutureReport& report) noexcept;

/// One pass: the needle and the vertices bonded to it, or the other way round.
void solve_suture(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  SutureScratch& scratch, double h_s, bool backward) noexcept;

/// Before end_substep() of the body: velocities, work, slip, puncture. Adds to `report`, whose
/// forces are those of this substep.
void finish_suture(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   SutureScratch& scratch, double h_s, SutureReport& report) noexcept;

/// Stored in all bonds, in the thread and in the hand's hold [J]; not in the tissue.
[[nodiscard]] double suture_energy(const Suture& suture, const SutureState& state,
                                   const SuturedTissue& tissue) noexcept;

}  // namespace placode::sim
