// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Moments of a recorded attempt, as far apart as a screen shows them.

#include <vector>

#include "curriculum/replay.h"
#include "sim/step/snapshot.h"

namespace placode::bench {

inline constexpr double kScreenS = 1.0 / 60;  ///< From one picture of most screens to the next.

/// What a screen would show one after another from `from_s` on, at most `count` moments; fewer
/// where the attempt ends before. Steps `replay` up to the last.
/// @throws std::runtime_error where the simulation differs from what was recorded.
[[nodiscard]] std::vector<sim::Snapshot> screen_moments(curriculum::Replay& replay, double from_s,
                                                        int count);

}  // namespace placode::bench
