// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who holds the needle in a scene: jaws that take it and let it go, alone or from other jaws, and
// what is told of it. Private to sim/step; @pre the scene has a needle.

#include "sim/core/event.h"
#include "sim/world/state.h"

namespace placode::sim {

struct Scene;

/// Opening at which jaws let go, in that at which they take.
inline constexpr float kLetGo = 1.25F;

/// Jaws of tool `t` hold it from now on, as the only ones or with those that hold it already.
/// Nothing where two hold it.
/// @param arc_m where, from the point.
void begin_hold(const Scene& scene, State& state, int t, double arc_m) noexcept;
/// Tool `t`, whose jaws hold it, holds it no more, whether it let go or it slid out of the jaws.
void end_hold(const Scene& scene, State& state, int t) noexcept;
/// Once a frame: how hard and how long it is held, how far it turns.
void count_holds(const Scene& scene, State& state, double dt) noexcept;

/// A slip is over, if there was one.
void end_jaw_slip(State& state, JawSlip& slip, EventKind kind, int tool) noexcept;

}  // namespace placode::sim
