// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An attempt that begins with work that was done before it: tissue, needle and thread are as they
// were left; clock, ledger and what instruments have done so far begin anew.

#include "sim/world/state.h"

namespace placode::sim {

/// Makes `state` the first of an attempt: frame and time 0, nothing entered in the ledger (harm
/// that it knew of is not entered a second time), no hand in the field. A needle in jaws stays in
/// them until a hand has come and closed them once. Scratch is forgotten. Allocates: between
/// attempts. @pre `state` was built for `scene`.
void begin_here(const Scene& scene, State& state);

}  // namespace placode::sim
