// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the needle's point does to the tissue: presses on a surface until it opens, cuts a channel
// whose passages it leaves behind, comes out on the far side, or is drawn back.
//
//   kFree -> kPresses       the point has met a surface from outside
//   kPresses -> kInside     its force along the needle has reached the tissue's puncture force
//   kInside                 force above the cutting force moves the point through the tissue
//   kInside -> kAtFarSide   it has come to a surface from inside, which has to be punctured too
//   kAtFarSide -> kFree     as before: the second peak
// Drawn back, the point closes the channel behind itself; going on then cuts anew.

#include "sim/suture/needle_motion.h"

namespace placode::sim {

/// Start of a substep: a free point may have met a surface; passages whose tissue is gone are given
/// up.
void begin_point(const Suture& suture, SutureState& state, const SuturedTissue& tissue, double h_s,
                 SutureReport& report) noexcept;

/// End of a substep, with tissue and needle where they are: punctures, cuts, lets friction slip,
/// and takes away the passages that the needle has left at either end.
void finish_point(const Suture& suture, SutureState& state, const SuturedTissue& tissue, double h_s,
                  SutureReport& report) noexcept;

}  // namespace placode::sim
