// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cheese-wiring. Where thread presses sideways on its channel by more than the tissue carries per
// length, it cuts through: the passage at the mouth is given up, and the thread goes straight to
// the next one. A channel is eaten from its mouths; when the last passage goes, it has torn out.
// What the tissue carries is a planning value (SutureStrength::tear_n_m).

#include "sim/suture/thread_channel.h"

namespace placode::sim {

/// End of a substep, with pieces stored and the line as it is. One passage a mouth at most.
void tear_channels(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   const ThreadLine& line, SutureReport& report) noexcept;

/// Sideways load on a mouth of channel `c` (0 entry, 1 exit), by the length of tissue at rest: a
/// thread that is drawn tight shortens it [N/m].
[[nodiscard]] double mouth_load_n_m(const SuturedTissue& tissue, const ThreadState& thread,
                                    const ThreadLine& line, int c, int mouth) noexcept;

}  // namespace placode::sim
