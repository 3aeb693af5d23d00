// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Needle and thread (sim/suture) in an operative scene: the parts of a substep around those of
// contact and sweep, the jaws that take the needle and let it go, and what is told of it. A scene
// without a needle returns at once from all of these.

namespace placode::sim {

struct Scene;
struct State;

/// Start of a frame, after the hands' poses: a needle that begins in a driver's jaws comes with it.
void begin_suturing(const Scene& scene, State& state) noexcept;

/// After find_contacts(): vertices with bonds leave the sweep, and those that an instrument touches
/// as well leave solve_contacts().
void begin_suture_substep(const Scene& scene, State& state, double h_s) noexcept;
/// Next to the sweep, one pass there or back.
void solve_suture_substep(const Scene& scene, State& state, double h_s, bool backward) noexcept;
/// Before end_substep(): what the driver feels.
void finish_suture_substep(const Scene& scene, State& state, double h_s) noexcept;

/// End of a frame of `dt` seconds: jaws take and let go, and events.
void update_suturing(const Scene& scene, State& state, double dt) noexcept;

}  // namespace placode::sim
