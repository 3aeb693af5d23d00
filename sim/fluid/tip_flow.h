// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The jet and the suction of one irrigator in one frame. Private to fluid.

#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

/// Opens the jet of tool `t`: pushes tissue, fills the pool, loosens debris. The jet is 37 lines
/// that carry equal shares of the momentum; each acts on the triangle that it meets first.
void run_jet(const Scene& scene, State& state, int t, double dt_s) noexcept;

/// Opens the suction of tool `t`.
void run_suction(const Scene& scene, State& state, int t, double dt_s) noexcept;

/// Adds to what a vertex of the tissue bears in this frame; nothing where it cannot bear.
void load_vertex(const Scene& scene, State& state, int32_t vertex, const Vec3& force_n) noexcept;

}  // namespace placode::sim
