// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/ledger/energy_use.h"

#include <algorithm>

#include "sim/cutting/diathermy.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr float kNoticeS = 1.0f;  // energy in air or on one spot counts from here on
constexpr double kPauseS = 1.0;   // without current for longer, that spell is over: taps are one

Event spell_event(const State& state, int t, EventKind kind, float seconds) noexcept {
    Event e = tool_event(state, kind, t);
    e.value = seconds;
    return e;
}

Event placode_energised_event(const State& state, int t) noexcept {
    const ToolLedger& spell = state.ledger.tools[t];
    Event e = spell_event(state, t, EventKind::kPlacodeEnergised, spell.placode_energised_s);
    e.tissue = Tissue::kPlacode;
    e.value2 = spell.energised_peak_c;
    return e;
}

/// Ends with the last current, wherever the instrument is by now.
Event air_event(const State& state, int t) noexcept {
    const ToolLedger& spell = state.ledger.tools[t];
    Event e = spell_event(state, t, EventKind::kEnergyInAir, spell.air_s);
    e.time_s = spell.air_until_s;
    return e;
}

Event dwell_event(const State& state, int t) noexcept {
    const ToolLedger& spell = state.ledger.tools[t];
    Event e = spell_event(state, t, EventKind::kDwell, spell.dwell_s);
    e.time_s = spell.dwell_until_s;
    e.tissue = spell.dwell_tissue;
    e.element = spell.dwell_tet;
    set_rest_position(e, spell.dwell_rest);
    return e;
}

/// Enters a spell that lasted long enough, and begins anew.
void end_dwell(State& state, int t) noexcept {
    float& lasted = state.ledger.tools[t].dwell_s;
    if (lasted > kNoticeS) add_event(state, dwell_event(state, t));
    lasted = 0;
}

void end_air(State& state, int t) noexcept {
    float& lasted = state.ledger.tools[t].air_s;
    if (lasted > kNoticeS) add_event(state, air_event(state, t));
    lasted = 0;
}

/// Spells outlast a pedal that is up for a moment.
void end_after_pause(State& state, int t) noexcept {
    const ToolLedger& spell = state.ledger.tools[t];
    if (state.time_s - spell.air_until_s > kPauseS) end_air(state, t);
    if (state.time_s - spell.dwell_until_s > kPauseS) end_dwell(state, t);
}

void begin_dwell(ToolLedger& spell, const ToolState& tool) noexcept {
    spell.dwell_centre = tool.spot;
    spell.dwell_rest = tool.rest_spot;
    spell.dwell_tet = tool.spot_tet;
    spell.dwell_tissue = tool.touched;
}

void end_placode_energised(State& state, int t) noexcept {
    ToolLedger& spell = state.ledger.tools[t];
    if (spell.placode_energised_s > 0) add_event(state, placode_energised_event(state, t));
    spell.placode_energised_s = 0;
    spell.energised_peak_c = 0;
}

void switch_off(State& state, int t) noexcept {
    const ToolLedger& spell = state.ledger.tools[t];
    end_placode_energised(state, t);
    Event e = tool_event(state, EventKind::kEnergyOff, t);
    e.value = spell.energy_on_s;
    e.value2 = spell.energy_j;
    add_event(state, e);
}

/// Seconds of current: through tissue and there on one spot or on the placode, or in air.
void where_it_goes(const Scene& scene, State& state, int t, float seconds) noexcept {
    const ToolState& tool = state.tools[t];
    ToolLedger& spell = state.ledger.tools[t];
    const bool in_tissue = tool.power_in_tissue_w > 0;
    if (in_tissue) {
        end_air(state, t);
        if (spell.dwell_s == 0 ||
            (tool.spot - spell.dwell_centre).norm() > scene.heat->settings().dwell_radius_m) {
            end_dwell(state, t);
            begin_dwell(spell, tool);
        }
        spell.dwell_s += seconds;
        spell.dwell_until_s = state.time_s;
    } else {
        // What a tap meets is known from its first step of heat on: until then nothing is over.
        if (spell.energy_on_s > static_cast<float>(heat_interval(scene)) * seconds)
            end_dwell(state, t);
        spell.air_s += seconds;
        spell.air_until_s = state.time_s;
    }
    if (in_tissue && tool.touched == Tissue::kPlacode) {
        spell.placode_energised_s += seconds;
        spell.energised_peak_c = std::max(spell.energised_peak_c, state.ledger.placode_now_c);
    } else {
        end_placode_energised(state, t);
    }
}

}  // namespace

void open_energy(const State& state, int t, std::vector<Event>& events) {
    const ToolLedger& spell = state.ledger.tools[t];
    if (spell.air_s > kNoticeS) events.push_back(air_event(state, t));
    if (spell.dwell_s > kNoticeS) events.push_back(dwell_event(state, t));
    if (spell.placode_energised_s > 0) events.push_back(placode_energised_event(state, t));
}

void ledger_energy(const Scene& scene, State& state, int t, bool active, double dt) noexcept {
    ToolState& tool = state.tools[t];
    ToolLedger& spell = state.ledger.tools[t];
    const ToolSpec& spec = scene.tools[t];
    const auto seconds = static_cast<float>(dt);
    if (active && !tool.energised) {
        Event e = tool_event(state, EventKind::kEnergyOn, t);
        e.value = static_cast<float>(spec.cut_power_w);
        if (tool.coagulating) e.value = static_cast<float>(spec.coag_power_w);
        add_event(state, e);
        spell.energy_on_s = spell.energy_j = 0;
    }
    if (active) {
        spell.energy_on_s += seconds;
        spell.energy_j += static_cast<float>(tool.power_in_tissue_w * dt);
        where_it_goes(scene, state, t, seconds);
    } else {
        end_after_pause(state, t);
        if (tool.energised) switch_off(state, t);
    }
    tool.energised = active ? 1 : 0;
}

}  // namespace placode::sim
