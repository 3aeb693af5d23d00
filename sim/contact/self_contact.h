// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tissue against tissue, for scenes that list it (ContactSettings::self_contact): a piece that the
// jaws let go lies on the field, and a flap that is folded over does not sink into it.
//
// Only tissue that has come away from its place at rest can meet other tissue, and the walls of a
// slit each other. Its surface vertices, and those of what lies next to it, look for the nearest
// face now and then; the pair is a contact of the contact colour like that with an instrument, with
// the vertex on one side and the face's corners on the other, so that action and reaction are equal
// by construction. Edges against edges are left out: the gap of kTissueGapM hides them.

#include "sim/world/contact_state.h"

namespace placode::sim {

struct Scene;
struct State;

/// Between two surfaces that touch. What asks whether a wound is closed subtracts it.
inline constexpr double kTissueGapM = 5e-5;

/// Start of a frame, after collect_candidates(): nearest faces of one group of vertices.
void collect_tissue_pairs(const Scene& scene, State& state) noexcept;

/// Within find_contacts(): adds the pairs that touch. False when a list is full.
bool touch_tissue(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim
