// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From faces that part to vertices that part. A cut marks faces; a vertex whose living tets fall
// into several groups, each hanging together over uncut faces, gets one copy for each further
// group. What is left is a mesh in which tissue that shares a vertex also shares faces, so that
// nothing hangs by a point.

#include "sim/world/separation_state.h"

namespace placode::sim {

struct Scene;
struct State;

/// Parts two living tets over the face of `tet` opposite to local vertex `f`. False when the face
/// is boundary already, and, with kCutRefused among the flags, where there are no spare vertices
/// for it.
bool cut_face(const Scene& scene, State& state, int tet, int f) noexcept;

/// Looks at a vertex again (a tet around it went away).
void queue_separation(const Scene& scene, State& state, int vertex) noexcept;

/// Splits waiting vertices; no more than about a quarter of a millisecond of work a frame, the rest
/// waits for the next. Call once a frame, after everything that cuts.
void separate(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim
