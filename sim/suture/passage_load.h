// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a needle's wire and its thread do to a kind of tissue that they run through: placode that is
// pulled at from within is touched as well as placode that an instrument presses on.

#include "sim/suture/needle_bonds.h"

namespace placode::sim {

/// Sum of the sizes of the forces at all passages in tissue of this kind [N], as they are when a
/// substep is solved: before finish_suture(), which lets go of the bonds. The point's is not in it.
[[nodiscard]] double passage_load_n(const Suture& suture, const SutureState& state,
                                    const SuturedTissue& tissue, const SutureScratch& scratch,
                                    Tissue kind) noexcept;

}  // namespace placode::sim
