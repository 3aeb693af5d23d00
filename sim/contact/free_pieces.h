// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a piece of tissue moves that has come loose and that nothing holds (sim/cutting/pieces.h),
// while it falls or is pushed. One sweep a substep carries what acts on it over some of its
// vertices only: by itself a bar that spins turns a third too far or a fifth too little, and its
// momentum does not stay. Six unknowns of each piece mend that (whole_body.h): momentum and angular
// momentum change by what instruments and gravity give, and by nothing else.
//
// Left alone: what rests, sleeps, lies on other tissue (by sweeps alone it comes to rest there), is
// washed away or hangs in jaws, on roots or on a thread. Frames without a loose piece that moves do
// nothing here but look at the list of pieces.

namespace placode::sim {

struct Scene;
struct State;

/// Start of a frame, after wake_tissue(): which vertices belong to which free piece.
void collect_free_pieces(const Scene& scene, State& state) noexcept;

/// After the last sweep of a substep, before finish_contacts(): moves the free pieces. h [s].
void move_free_pieces(const Scene& scene, State& state, double h) noexcept;

}  // namespace placode::sim
