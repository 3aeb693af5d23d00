// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/ledger/ledger.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/cutting/attempt_progress.h"
#include "sim/cutting/cutting.h"
#include "sim/cutting/diathermy.h"
#include "sim/cutting/grasp.h"
#include "sim/ledger/damage.h"
#include "sim/ledger/energy_use.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr float kDebounceS = 0.05f;      // a contact ends when it has been away this long
constexpr float kOverForceS = 0.05f;     // shorter peaks are not a way of working
constexpr float kOverheatPauseS = 1.0f;  // between entries for one burn that grows
constexpr float kCheckAfterS = 2.0f;     // hands off after the ring is complete: checking
constexpr double kNeedleTailM = 2e-3;    // less of a needle in tissue is drawn through
constexpr double kRingComplete = 0.99;
constexpr double kResected = 0.9;  // of the marked volume: what is left is not worth a phase

Event contact_event(const State& state, int t) noexcept {
    const ToolLedger& spell = state.ledger.tools[t];
    Event e = tool_event(state, EventKind::kPlacodeContact, t);
    e.tissue = Tissue::kPlacode;
    e.value = spell.contact_s;
    e.value2 = spell.peak_force_n;
    return e;
}

Event over_force_event(const State& state, int t) noexcept {
    const ToolLedger& spell = state.ledger.tools[t];
    Event e = tool_event(state, EventKind::kOverForce, t);
    e.value = spell.over_force_s;
    e.value2 = spell.over_force_peak_n;
    return e;
}

/// Contact with the placode and too much force.
void ledger_force(const Scene& scene, State& state, int t, double dt) noexcept {
    const ToolState& tool = state.tools[t];
    ToolLedger& spell = state.ledger.tools[t];
    const auto seconds = static_cast<float>(dt);
    if (tool.placode_force_n > scene.contact.placode_warn_force_n) {
        spell.contact_s += seconds;
        spell.quiet_s = 0;
        spell.peak_force_n = std::max(spell.peak_force_n, static_cast<float>(tool.placode_force_n));
    } else if (spell.contact_s > 0) {
        spell.quiet_s += seconds;
        if (spell.quiet_s >= kDebounceS || !tool.engaged) {
            add_event(state, contact_event(state, t));
            spell.contact_s = spell.peak_force_n = spell.quiet_s = 0;
        }
    }
    const double force =
        (between_hands(state) ? Vec3(tool.force_n - tool.needle_n) : tool.force_n).norm();
    if (force > scene.contact.over_force_n) {
        spell.over_force_s += seconds;
        spell.over_force_peak_n = std::max(spell.over_force_peak_n, static_cast<float>(force));
    } else if (spell.over_force_s > 0) {
        if (spell.over_force_s >= kOverForceS) add_event(state, over_force_event(state, t));
        spell.over_force_s = spell.over_force_peak_n = 0;
    }
}

Event dose_event(const Scene& scene, const State& state, EventKind kind, int v) noexcept {
    const HeatState& heat = state.heat[0];
    Event e;
    e.time_s = state.time_s;
    e.kind = kind;
    e.tissue = Tissue::kPlacode;
    e.element = v;
    e.value = heat.cem43_min[v];
    e.value2 = heat.temperature_c[v];
    for (int i = 0; i < 3; ++i) {
        e.rest_position_m[i] = static_cast<float>(scene.body.mesh().rest[v][i]);
    }
    return e;
}

/// Thermal dose of the placode. Every vertex counts once per limit; the ledger gets one entry for
/// the first of them, and another when the burn is still growing a second later.
void ledger_dose(const Scene& scene, State& state, double dt) noexcept {
    if (state.heat.empty()) return;
    const HeatState& heat = state.heat[0];
    const ContactSettings& limit = scene.contact;
    const auto& volume = state.scratch->placode_volume_m3;
    state.ledger.overheat_pause_s =
        std::max(0.0f, state.ledger.overheat_pause_s - static_cast<float>(dt));
    state.ledger.burn_pause_s = std::max(0.0f, state.ledger.burn_pause_s - static_cast<float>(dt));
    if (!state.scratch->heat_stepped) return;
    float now = static_cast<float>(scene.heat->settings().body_temperature_c);
    for (int n = 0; n < heat.warm_count; ++n) {
        const int v = heat.warm_list[n];
        if (volume[v] <= 0) continue;
        const float t = heat.temperature_c[v], dose = heat.cem43_min[v];
        now = std::max(now, t);
        state.ledger.placode_peak_cem43_min = std::max(state.ledger.placode_peak_cem43_min, dose);
        uint8_t& reported = state.ledger.dose_reported[v];
        if (dose >= limit.warn_dose_cem43_min && !(reported & 1)) {
            reported |= 1;
            if (state.ledger.overheat_pause_s <= 0) {
                add_event(state, dose_event(scene, state, EventKind::kPlacodeOverheated, v));
                state.ledger.overheat_pause_s = kOverheatPauseS;
            }
        }
        if ((dose >= limit.injury_dose_cem43_min || t >= limit.injury_temperature_c) &&
            !(reported & 2)) {
            reported |= 2;
            state.ledger.placode_burned_m3 += volume[v];
            if (state.ledger.burn_pause_s <= 0) {
                add_event(state, dose_event(scene, state, EventKind::kPlacodeBurned, v));
                state.ledger.burn_pause_s = kOverheatPauseS;
            }
        }
    }
    state.ledger.placode_now_c = now;
    state.ledger.placode_peak_c = std::max(state.ledger.placode_peak_c, now);
}

void enter_phase(State& state, Phase phase) noexcept {
    state.phase = phase;
    Event e;
    e.time_s = state.time_s;
    e.kind = EventKind::kPhase;
    e.value = static_cast<float>(phase);
    add_event(state, e);
}

/// Inspect until the first touch or current of a working instrument; incise (where an instrument
/// carries current) until the ring is complete; release until every sector of the placode is free
/// (or, where nothing is marked for resection, until the hands have been off for two seconds);
/// resect until the marked tissue is out and the hands are off; then check. Back to release at the
/// next current.
void ledger_phase(const Scene& scene, State& state, double dt) noexcept {
    bool busy = false, current = false, incises = false;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        if (scene.tools[t].kind == ToolKind::kScope) continue;
        incises = incises || conducts(scene.tools[t].kind);
        current = current || state.tools[t].energised;
        busy = busy || state.tools[t].energised || state.tools[t].in_contact;
    }
    state.ledger.idle_s = busy ? 0.0f : state.ledger.idle_s + static_cast<float>(dt);
    const double points = static_cast<double>(state.progress.cut.size());
    const bool marked = scene.marked_volume_m3 > 0;
    if (state.phase == Phase::kInspect && busy) {
        enter_phase(state, incises || !marked ? Phase::kIncise : Phase::kResect);
    }
    const bool free = points > 0 && state.release.free_count == kSectors;
    if (state.phase == Phase::kIncise && points > 0 &&
        (free || state.progress.cut_count >= kRingComplete * points)) {
        enter_phase(state, Phase::kRelease);
    }
    if (state.phase == Phase::kRelease && free && marked) enter_phase(state, Phase::kResect);
    const bool resected =
        state.pieces.marked_gone_m3 >= kResected * scene.marked_volume_m3 && state.pieces.out > 0;
    const bool dissected =
        (state.phase == Phase::kResect && resected) || (state.phase == Phase::kRelease && !marked);
    if (dissected && state.ledger.idle_s >= kCheckAfterS) {
        enter_phase(state, Phase::kCheck);
    } else if (state.phase == Phase::kCheck && current) {
        enter_phase(state, Phase::kRelease);
    }
}

/// Broken tethers, recovered elements, substeps.
void ledger_body(const Scene& scene, State& state) noexcept {
    const auto& tethers = scene.body.spec().tethers;
    auto& before = state.ledger.tether_known;
    for (size_t i = 0; i < tethers.size(); ++i) {
        if (before[i] && !state.body.tether_alive[i]) {
            Event e;
            e.time_s = state.time_s;
            e.kind = EventKind::kTetherBroken;
            e.value = state.body.tether_lambda_n[i];
            e.element = static_cast<int32_t>(i);
            const Vec3& at = scene.body.mesh().rest[tethers[i].vertex[0]];
            for (int k = 0; k < 3; ++k) e.rest_position_m[k] = static_cast<float>(at[k]);
            add_event(state, e);
        }
        before[i] = state.body.tether_alive[i];
    }
    if (state.substeps != state.ledger.last_substeps) {
        state.ledger.last_substeps = state.substeps;
        Event e;
        e.time_s = state.time_s;
        e.kind = EventKind::kSubsteps;
        e.value = static_cast<float>(state.substeps);
        add_event(state, e);
    }
    if (state.flags & kRestShapeRestored) {
        Event e;
        e.time_s = state.time_s;
        e.kind = EventKind::kRestored;
        add_event(state, e);
    }
}

/// More of it than its tail, which a hand that has drawn it through may let back.
bool needle_is_in(const Scene& scene, const Suturing& s) noexcept {
    if (!scene.suture || s.needle.empty()) return false;
    const auto passages =
        std::span(s.needle[0].passages).first(static_cast<size_t>(s.needle[0].passage_count));
    return std::any_of(passages.begin(), passages.end(), [&](const Passage& p) {
        return p.sticks_at_m < scene.suture->needle().arc_m() - kNeedleTailM;
    });
}

/// A needle that slides or turns in its jaws, one that hands hold, and one in tissue.
void open_needle_spells(const Scene& scene, const State& state, std::vector<Event>& events) {
    const Suturing& s = state.suturing;
    const auto add = [&](const JawSlip& slip, EventKind kind, int tool) {
        if (slip.s > 0) events.push_back(driver_event(state, kind, tool, slip.s, slip.peak));
    };
    add(s.slide, EventKind::kNeedleSlipped, s.driver);
    add(s.turn, EventKind::kNeedleTurned, s.driver);
    add(s.handover.slide, EventKind::kNeedleSlipped, s.handover.second);
    add(s.handover.turn, EventKind::kNeedleTurned, s.handover.second);
    if (needle_is_in(scene, s)) {
        Event left_in = driver_event(state, EventKind::kNeedleLeftIn, -1, 0, 0);
        left_in.rest_position_m = s.entry_m;
        events.push_back(left_in);
    }
    if (!has_two_drivers(scene) || s.driver < 0) return;
    if (s.handover.second >= 0) events.push_back(held_by_both(state, s.driver, -1));
    if (s.handover.swung_rad > 0)
        events.push_back(
            driver_event(state, EventKind::kNeedleSwung, s.driver, s.handover.swung_rad, 0));
}

/// Says what this ledger has, also where that is nothing: sums of over-stretch, tissue taken out.
void begin_ledger(const Scene& scene, State& state) noexcept {
    Event e;
    e.time_s = state.time_s;
    e.kind = EventKind::kStretchSum;
    add_event(state, e);
    e.kind = EventKind::kLedgerWritten;
    e.value = kLedgerVersion;
    add_event(state, e);
    if (scene.marked_volume_m3 > 0) add_event(state, taken_out_event(scene, state));
}

}  // namespace

std::vector<Event> open_spells(const Scene& scene, const State& state) {
    std::vector<Event> events;
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const ToolLedger& spell = state.ledger.tools[t];
        if (scene.heat) open_energy(state, t, events);
        if (spell.contact_s > 0) events.push_back(contact_event(state, t));
        if (spell.over_force_s >= kOverForceS) events.push_back(over_force_event(state, t));
        if (const auto pull = open_traction(state, t)) events.push_back(*pull);
        if (const auto slip = open_slip(state, t)) events.push_back(*slip);
    }
    open_needle_spells(scene, state, events);
    return events;
}

void update_ledger(const Scene& scene, State& state, std::span<const uint8_t> active,
                   double dt) noexcept {
    ledger_dose(scene, state, dt);
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        if (scene.heat) ledger_energy(scene, state, t, active[t] != 0, dt);
        ledger_force(scene, state, t, dt);
    }
    for (float& pause : state.ledger.over_stretch_pause_s) {
        pause = std::max(0.0f, pause - static_cast<float>(dt));
    }
    ledger_phase(scene, state, dt);
    ledger_body(scene, state);
    const auto per_second = static_cast<int64_t>(std::lround(1 / dt));
    if (state.frame == 1) begin_ledger(scene, state);
    if (per_second > 0 && state.frame % per_second == 0) {
        ledger_stretch(scene, state);
        Event e;
        e.time_s = state.time_s;
        e.kind = EventKind::kStateHash;
        e.hash = state_hash(state);
        add_event(state, e);
    }
}

}  // namespace placode::sim
