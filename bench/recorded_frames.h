// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the frames of a recorded attempt cost, simulated again with the same inputs: step by step of
// a practice task, as a whole otherwise.

#include <vector>

#include "bench/frame_parts.h"
#include "sim/step/recording.h"

namespace placode::bench {

/// Nothing is recorded, so that part costs nothing; frames with a state hash to compare cost some
/// more than in an attempt. Throws DefinitionError when the task cannot be built, and
/// std::runtime_error where the simulation differs from what was recorded.
[[nodiscard]] std::vector<FrameParts> measure_recording(const sim::Recording& recording,
                                                        int threads);

}  // namespace placode::bench
