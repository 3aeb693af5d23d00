// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Jaws that hold tissue. Closing jaws take the vertices that lie between them; these are held in
// place in the jaws' frame, so that the hand carries them, and the force is read from the elastic
// residual of what they pull on. Friction of the jaw force holds up to 2 mu N; above that the
// tissue slides out. Too much pressure crushes, too much traction is noted, over-stretched tissue
// tears (sim/cutting/cutting.h).
//
// Frame T: z distal, jaws open along y (half the angle each), x across their width.

#include <optional>

#include "sim/core/event.h"
#include "sim/core/tool.h"
#include "sim/world/grasp_state.h"

namespace placode::sim {

struct Scene;
struct State;

/// Angle below which jaws meet tissue of usual thickness [rad].
[[nodiscard]] double grip_angle(const ToolSpec& spec) noexcept;

/// Start of a substep, after the instruments moved: carries what is held.
void carry_grasped(const Scene& scene, State& state) noexcept;

/// End of a substep: force of the held tissue on the jaws; slips where friction does not hold it.
void feel_grasped(const Scene& scene, State& state) noexcept;

/// End of a frame of `dt` seconds: closes, opens, crushes, and writes what happened.
void update_grasps(const Scene& scene, State& state, double dt) noexcept;

/// The entry for a slip that is not over: what slid before the jaws began to open.
[[nodiscard]] std::optional<Event> open_slip(const State& state, int t) noexcept;

/// The entry for a pull above the tissue's limit that is not over, long enough to count. Its time
/// is the last moment above the limit.
[[nodiscard]] std::optional<Event> open_traction(const State& state, int t) noexcept;

/// A held vertex was split: the jaws hold its copy as well.
void hold_copy(const Scene& scene, State& state, int vertex, int copy) noexcept;

/// Takes a vertex out of any jaws (it died, or its tissue was cut away).
void let_go_vertex(const Scene& scene, State& state, int vertex) noexcept;

}  // namespace placode::sim
