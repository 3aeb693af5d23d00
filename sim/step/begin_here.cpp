// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/begin_here.h"

#include <algorithm>
#include <utility>

#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

/// What was entered of tissue stays known: a tether does not break twice.
void begin_ledger_anew(const Scene& scene, LedgerState& ledger) {
    LedgerState anew(scene);
    anew.tether_known = std::move(ledger.tether_known);
    anew.stretch_reported = std::move(ledger.stretch_reported);
    anew.dose_reported = std::move(ledger.dose_reported);
    anew.placode_now_c = ledger.placode_now_c;
    ledger = std::move(anew);
}

/// Who holds it and where it has been stay; how often it was taken, went in and came out begins
/// anew.
void begin_suturing_anew(Suturing& s) noexcept {
    if (s.driver >= 0) s.locked = kLockedUntilEngaged;
    s.held_s = s.peak_n = s.point_n = s.thread_n = 0;
    s.slide = s.turn = {};
    s.taken = s.entered = s.left = s.through = 0;
    s.entry_m = s.exit_m = {};
    Handover& h = s.handover;
    h.held_s = h.peak_n = h.both_s = h.apart_n = h.swung_rad = 0;
    h.slide = h.turn = {};
}

void begin_irrigation_anew(IrrigationState& s) noexcept {
    s.peak_pa = s.over_s = s.hidden_s = s.held_s = s.placode_held_s = 0;
    s.peak_rest_m = {};
    s.pressed = {};
    s.held = {};
}

/// As instruments that are not in the field yet: the first hand places them.
void take_hands_out(State& state) noexcept {
    for (ToolState& tool : state.tools) {
        tool.engaged = tool.pedals = tool.energised = tool.in_contact = 0;
        tool.force_n = tool.steel_n = tool.needle_n = tool.substep_force_n = Vec3::Zero();
        tool.substep_stiffness_n_m = tool.substep_overlap_m = 0;
        tool.power_in_tissue_w = 0;
    }
}

}  // namespace

void begin_here(const Scene& scene, State& state) {
    // Times that are counted in frames, from the frame that is the first now.
    for (int64_t& until : state.self_contact.near_moved_until)
        until = std::max<int64_t>(-1, until - state.frame);
    state.frame = 0;
    state.time_s = 0;
    state.substeps = scene.body.spec().solver.substeps;
    state.phase = Phase::kInspect;
    state.event_count = 0;
    state.flags = 0;
    begin_ledger_anew(scene, state.ledger);
    begin_suturing_anew(state.suturing);
    begin_irrigation_anew(state.irrigation);
    take_hands_out(state);
    state.scratch->forget();
}

}  // namespace placode::sim
