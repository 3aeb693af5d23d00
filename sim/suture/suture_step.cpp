// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/suture_step.h"

namespace placode::sim {

void begin_suture(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  SutureScratch& scratch, const Pose& X_WH, double h_s,
                  SutureReport& report) noexcept {
    scratch.hand_before = state.hold.hand;
    begin_point(suture, state, tissue, h_s, report);
    begin_needle(suture, state, scratch, X_WH);
    find_supports(suture, state, tissue, scratch);
    // Passages whose tissue is gone must not be collected, and the line stands on vertices that are
    // back where they were.
    drop_lost_passages(suture, state, tissue, report);
    collect_bonds(suture, state, tissue, scratch);
    scratch.thread.begin(suture, state, tissue);
}

void solve_suture(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  SutureScratch& scratch, double h_s, bool backward) noexcept {
    if (!backward) solve_needle(suture, state, tissue, scratch, h_s);
    solve_bonded_vertices(suture, state, tissue, scratch, h_s, backward);
    if (backward) solve_needle(suture, state, tissue, scratch, h_s);
}

void finish_suture(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   SutureScratch& scratch, double h_s, SutureReport& report) noexcept {
    report.point_force_n = report.wall_force_n = report.deepest_m = 0;
    finish_needle(suture, state, scratch, scratch.hand_before, h_s, report);
    finish_thread(suture, state, tissue, scratch.thread, report);
    finish_point(suture, state, tissue, h_s, report);
    release_bonds(tissue, scratch);
}

double suture_energy(const Suture& suture, const SutureState& state,
                     const SuturedTissue& tissue) noexcept {
    const PosedNeedle needle(suture.needle(), state.needle);
    double energy = hold_energy(suture, state) + thread_energy(state.thread);
    for (int i = 0; i < state.passage_count; ++i) {
        const NeedleBond bond = passage_bond(suture, state, tissue, i);
        energy += energy_of(needle, bond, place_of(tissue.state, bond));
    }
    if (state.point.mode != PointMode::kFree) {
        const NeedleBond bond = point_bond(suture, state, tissue);
        energy += energy_of(needle, bond, place_of(tissue.state, bond));
    }
    return energy;
}

}  // namespace placode::sim
