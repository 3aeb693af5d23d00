// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Instruments against tissue. Vertices of triangles next to an instrument form the "contact
// colour": the kernels' sweep leaves them out, and they are solved here one by one with their full
// Hessian plus k b^2 n n^T of every closest-point contact and a tangential spring for dry friction.
// The same holds for bodies solved by XPBD: their contact vertices take a vertex step instead of
// constraint projections, so that the force is read from one place.
//
// The instrument is held by a hand of finite stiffness (ToolSpec::hand_n_m) and yields to the
// force: its proxy is what touches. Every instrument touches, the scope as a capsule of its shaft.

#include <span>

#include "sim/world/contact_state.h"

namespace placode::sim {

struct Scene;
struct State;
struct VertexSystem;

/// Start of a frame: refits the tree of the surface and collects the triangles that any instrument
/// can reach before the frame's end.
void collect_candidates(const Scene& scene, State& state) noexcept;

/// Start of a substep: moves the proxies towards where the hand is after `share` of the frame (no
/// farther than a part of the tip's radius while tissue is near, so that nothing is jumped over).
void move_tools(const Scene& scene, State& state, std::span<const Pose> from,
                std::span<const Pose> to, double share) noexcept;

/// Closest points of the candidates; marks the contact colour in `contact_vertex`.
void find_contacts(const Scene& scene, State& state) noexcept;

/// One pass over the contact colour, there or back: the two together are symmetric, as sweeps that
/// carry momentum must be to stay calm. h [s].
void solve_contacts(const Scene& scene, State& state, double h, bool backward) noexcept;

/// What instruments and other tissue ask of a vertex of the colour that needle or thread are bonded
/// to as well: it is solved with these (sim/suture), not by solve_contacts(). Nothing for others.
void add_contacts(State& state, int32_t vertex, VertexSystem& system) noexcept;

/// End of a substep: forces on the instruments, friction's memory.
void finish_contacts(State& state) noexcept;

}  // namespace placode::sim
