// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/passage_load.h"

#include "sim/core/as_index.h"

namespace placode::sim {

double passage_load_n(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                      const SutureScratch& scratch, Tissue kind) noexcept {
    const auto lies_in_it = [&](const Passage& passage) noexcept {
        return tissue.body.mesh().tissue[as_index(passage.at.tet)] == kind;
    };
    const PosedNeedle needle(suture.needle(), state.needle);
    double sum = 0;
    for (int n = 0; n < scratch.bond_count; ++n) {
        const NeedleBond& bond = scratch.bonds[as_index(n)];
        if (bond.passage < 0 || !lies_in_it(state.passages[as_index(bond.passage)])) continue;
        sum += force_of(needle, bond, place_of(tissue.state, bond), false).gradient.norm();
    }
    if (!scratch.thread.active()) return sum;
    for (int i = 0; i < state.thread.passage_count; ++i) {
        if (!lies_in_it(state.thread.passages[as_index(i)])) continue;
        sum += scratch.thread.force_on(scratch.thread.node_of(i)).norm();
    }
    return sum;
}

}  // namespace placode::sim
