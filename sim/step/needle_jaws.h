// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The jaws of a needle driver: which part of the wire they take, when they let go, and the events
// of needle and thread. Private to sim/step; @pre the scene has a needle.

#include "sim/core/tool.h"
#include "sim/suture/suture.h"

namespace placode::sim {

struct Scene;
struct State;

/// Arc coordinate of the wire between jaws that close at X_WT [m]; negative: none is.
[[nodiscard]] double wire_between(const ToolSpec& spec, const Pose& X_WT, const Needle& needle,
                                  const Pose& X_WN) noexcept;

/// The needle comes with the first driver that a hand has, locked in its jaws.
void place_in_jaws(const Scene& scene, State& state) noexcept;
/// End of a frame.
void update_needle_jaws(const Scene& scene, State& state, double dt) noexcept;
/// Events of the frame.
void tell_of_suture(const Scene& scene, State& state, double dt) noexcept;

}  // namespace placode::sim
