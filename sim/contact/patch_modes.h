// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a patch moves as a whole. One sweep a substep carries what acts on a stiff sheet over a few
// of its vertices only: on a slope it would slide a hundredth of the way that it should. To move
// and turn it as it is costs no elastic energy, so that six unknowns settle it: momentum and
// angular momentum change by what tissue, instruments and gravity give, and by nothing else
// (whole_body.h).

namespace placode::sim {

struct Scene;
struct State;

/// After the last sweep of a substep, between press_patch() and bear_patch(): moves the patch,
/// where no jaws hold it. h [s].
void move_patch_whole(const Scene& scene, State& state, double h) noexcept;

}  // namespace placode::sim
