// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A patch (Scene::patch) on tissue and under instruments.
//
// On tissue: every vertex of the patch looks for the nearest face of the tissue now and then. Where
// it comes nearer than half of the patch's thickness, it is tied for a substep to where it touches,
// by a spring along the normal and a softer one, with Coulomb's limit, to the place where friction
// holds it. These springs are part of the kernels' sweep (set_spring), so a patch that lies costs
// little more than one that hangs. The tissue gets the opposite force as a load (set_load) in the
// next substep; it was where it was at this one's start, moved on by its velocity. What tissue does
// to a patch of 0.1 g needs no more, and the springs are soft enough for that (kPressPaM).
//
// Under instruments: its triangles are candidates like those of the tissue, from both sides
// (contact.cpp). Against itself: patch_fold.h; as a whole: patch_modes.h. Not here yet: vertices of
// the tissue against the middle of its triangles. docs/patch.md

#include "sim/mesh/surface.h"

namespace placode::sim {

struct Scene;
struct State;

inline constexpr int kMostPatchVertices = 1200;

/// Candidates of contact from here on are triangles of the patch.
inline constexpr int32_t kPatchCandidate = 1 << 24;

/// The triangle that a candidate names (number of the candidate / 4).
[[nodiscard]] const SurfaceTriangle& touched_triangle(const Scene& scene, const State& state,
                                                      int32_t number) noexcept;

/// It is at rest and not solved (sim/solver/sleep.h): the three calls below do nothing, its ties
/// and what the tissue bears of it stay as they are.
[[nodiscard]] bool patch_sleeps(const Scene& scene, const State& state) noexcept;
/// Whether something of the tissue that is next to it is awake.
[[nodiscard]] bool patch_shaken(const Scene& scene, const State& state) noexcept;

/// Start of a frame, after collect_candidates(): looks up nearest faces of one group of vertices,
/// by the number of the frame.
void collect_patch_faces(const Scene& scene, State& state, int64_t frame) noexcept;

/// Within a substep, between begin_substep() and the first sweep: ties the patch to what it
/// touches. h [s].
void press_patch(const Scene& scene, State& state, double h) noexcept;

/// After the last sweep: friction slips, and the tissue bears what has pressed on it. h [s].
void bear_patch(const Scene& scene, State& state, double h) noexcept;

}  // namespace placode::sim
