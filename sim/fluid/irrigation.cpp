// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/fluid/irrigation.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/fluid/pool.h"
#include "sim/fluid/tip_flow.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kSweepsAFrame = 2, kLookFrames = 40;
constexpr double kFluidTellN = 1e-6;  // a change of load that wakes tissue [N]
constexpr float kSpellPauseS = 0.2F;  // a spell is over after so long
constexpr float kHeldShut = 0.5F;     // tissue takes so much of the suction: it is held
constexpr float kHeldS = 0.1F;        // and for so long: less is a touch
constexpr double kDriftM_s = 0.04;    // fastest that debris drifts
constexpr double kFloatM = 5e-5;      // fluid less deep carries nothing

void forget_loads(IrrigationState& now) noexcept {
    for (int32_t i = 0; i < now.loaded_count; ++i)
        now.load_n[as_index(now.loaded[as_index(i)])] = {};
}

/// Gives the tissue its loads, wakes it where they have changed, forgets those that are gone.
void give_fluid_loads(const Scene& scene, State& state) noexcept {
    IrrigationState& now = state.irrigation;
    int32_t kept = 0;
    for (int32_t i = 0; i < now.loaded_count; ++i) {
        const int32_t v = now.loaded[as_index(i)];
        const auto& load = now.load_n[as_index(v)];
        auto& told = now.told_n[as_index(v)];
        const Vec3f f(load[0], load[1], load[2]);
        set_load(scene.body, state.body, v, f, Vec3f::Zero(), Vec3f::Zero());
        if ((f - Vec3f(told[0], told[1], told[2])).norm() > static_cast<float>(kFluidTellN)) {
            told = load;
            rouse(state.body, v);
        }
        if (load == std::array<float, 3>{}) {
            if (told != load) rouse(state.body, v);
            told = {};
            now.listed[as_index(v)] = 0;
        } else {
            now.loaded[as_index(kept++)] = v;
        }
    }
    now.loaded_count = kept;
}

/// Crumbs go with the fluid that flows through their cell.
void drift(const Scene& scene, State& state, double dt_s) noexcept {
    const PoolGrid& grid = scene.irrigation->grid;
    IrrigationState& now = state.irrigation;
    const PoolFlux& flux = state.scratch->pool;
    for (DebrisNow& one : now.debris) {
        if (one.fate != DebrisFate::kLoose) continue;
        const int32_t c =
            grid.cell_at(static_cast<double>(one.at_m[0]), static_cast<double>(one.at_m[1]));
        if (c < 0 || grid.drain[as_index(c)] != 0) {
            one.fate = DebrisFate::kRunOff;
            continue;
        }
        const double depth = pool_depth_m(grid, now.pool, c);
        if (depth < kFloatM) continue;
        const int32_t left = c % grid.columns > 0 ? c - 1 : c,
                      below = c >= grid.columns ? c - grid.columns : c;
        Vec2 through(0.5 * (flux.x[as_index(c)] + flux.x[as_index(left)]),
                     0.5 * (flux.y[as_index(c)] + flux.y[as_index(below)]));
        Vec2 speed = through / (depth * grid.cell_m * dt_s);
        if (speed.norm() > kDriftM_s) speed *= kDriftM_s / speed.norm();
        for (int k = 0; k < 2; ++k) one.at_m[as_index(k)] += static_cast<float>(speed[k] * dt_s);
    }
}

Event spell_event(EventKind kind, const FluidSpell& spell, int t, double time_s) noexcept {
    Event e;
    e.kind = kind;
    e.time_s = time_s;
    e.tool = static_cast<int8_t>(t);
    e.tissue = spell.tissue;
    e.value = spell.seconds;
    e.value2 = spell.peak;
    e.rest_position_m = spell.rest_m;
    return e;
}

/// One frame longer, or nearer to its end: true when it is over.
bool follow_spell(FluidSpell& spell, bool on, float value, const std::array<float, 3>& rest,
                  float dt_s) noexcept {
    if (on) {
        spell.seconds += dt_s;
        spell.pause_s = 0;
        if (value > spell.peak) {
            spell.peak = value;
            spell.rest_m = rest;
        }
        return false;
    }
    if (spell.seconds <= 0) return false;
    spell.pause_s += dt_s;
    return spell.pause_s >= kSpellPauseS;
}

void follow_jet(State& state, double dt_s) noexcept {
    IrrigationState& now = state.irrigation;
    const bool on = now.placode_pa > kJetLimitPa;
    if (on) now.over_s += dt_s;
    now.pressed.tissue = Tissue::kPlacode;
    if (!follow_spell(now.pressed, on, static_cast<float>(now.placode_pa), now.peak_rest_m,
                      static_cast<float>(dt_s)))
        return;
    add_event(state, spell_event(EventKind::kJetOnPlacode, now.pressed, -1, state.time_s));
    now.pressed = {};
}

void follow_suction(const Scene& scene, State& state, int t, double dt_s) noexcept {
    IrrigationState& now = state.irrigation;
    const ToolState& tool = state.tools[as_index(t)];
    FluidSpell& spell = now.held[as_index(t)];
    const float shut = now.tips[as_index(t)].shut;
    const bool on = shut > kHeldShut;
    if (on) {
        now.held_s += dt_s;
        if (tool.touched == Tissue::kPlacode) now.placode_held_s += dt_s;
        if (spell.seconds <= 0 || tool.touched == Tissue::kPlacode) spell.tissue = tool.touched;
    }
    std::array<float, 3> rest{};
    for (int k = 0; k < 3; ++k) rest[as_index(k)] = static_cast<float>(tool.rest_spot[k]);
    const SuctionSpec& spec = scene.irrigation->suction;
    const double mouth_n = spec.pressure_pa * 0.7853981633974483 * spec.bore_m * spec.bore_m;
    if (!follow_spell(spell, on, static_cast<float>(mouth_n) * shut, rest,
                      static_cast<float>(dt_s)))
        return;
    if (spell.seconds > kHeldS)
        add_event(state, spell_event(EventKind::kSuctionHeld, spell, t, state.time_s));
    spell = {};
}

Event sum_event(const State& state, IrrigationSum what, double value, double value2) {
    Event e;
    e.kind = EventKind::kIrrigated;
    e.time_s = state.time_s;
    e.element = static_cast<int32_t>(what);
    e.value = static_cast<float>(value);
    e.value2 = static_cast<float>(value2);
    return e;
}

}  // namespace

void update_irrigation(const Scene& scene, State& state, double dt_s) noexcept {
    if (!scene.irrigation) return;
    IrrigationState& now = state.irrigation;
    forget_loads(now);
    now.placode_pa = 0;
    for (size_t t = 0; t < now.tips.size(); ++t) {
        const bool sucks = (state.tools[t].pedals & kPedalCoag) != 0 && state.tools[t].engaged != 0;
        now.tips[t] = {0, sucks ? now.tips[t].shut : 0, 0};
    }
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const ToolState& tool = state.tools[as_index(t)];
        if (scene.tools[as_index(t)].kind != ToolKind::kIrrigator) continue;
        if (tool.engaged != 0 && (tool.pedals & kPedalCut) != 0) run_jet(scene, state, t, dt_s);
        if (tool.engaged != 0 && (tool.pedals & kPedalCoag) != 0)
            run_suction(scene, state, t, dt_s);
        follow_suction(scene, state, t, dt_s);
    }
    follow_jet(state, dt_s);
    give_fluid_loads(scene, state);
    for (int i = 0; i < kSweepsAFrame; ++i) {
        sweep_pool(scene.irrigation->grid, now.pool, state.scratch->pool);
        drift(scene, state, dt_s / kSweepsAFrame);
    }
    if (state.frame % kLookFrames == 0) now.hidden = view_hidden(*scene.irrigation, now.pool);
    if (now.hidden > kBlindShare) now.hidden_s += dt_s;
}

std::vector<Event> irrigation_events(const Scene& scene, const State& state) {
    std::vector<Event> all;
    if (!scene.irrigation) return all;
    const IrrigationState& now = state.irrigation;
    if (now.pressed.seconds > 0)
        all.push_back(spell_event(EventKind::kJetOnPlacode, now.pressed, -1, state.time_s));
    for (size_t t = 0; t < now.held.size(); ++t)
        if (now.held[t].seconds > kHeldS)
            all.push_back(spell_event(EventKind::kSuctionHeld, now.held[t], static_cast<int>(t),
                                      state.time_s));
    Event jet = sum_event(state, IrrigationSum::kJet, now.peak_pa, now.over_s);
    jet.rest_position_m = now.peak_rest_m;
    all.push_back(jet);
    all.push_back(sum_event(state, IrrigationSum::kFluid,
                            standing_m3(scene.irrigation->grid, now.pool), now.jet_m3));
    all.push_back(sum_event(state, IrrigationSum::kView, view_hidden(*scene.irrigation, now.pool),
                            now.hidden_s));
    all.push_back(sum_event(state, IrrigationSum::kSuction, now.held_s, now.placode_held_s));
    double stuck = 0, loose = 0;
    std::vector<Event> left;
    for (size_t i = 0; i < now.debris.size(); ++i) {
        const DebrisFate fate = now.debris[i].fate;
        if (fate != DebrisFate::kStuck && fate != DebrisFate::kLoose) continue;
        (fate == DebrisFate::kStuck ? stuck : loose) += 1;
        Event e = sum_event(state, IrrigationSum::kJet, 0, 0);
        e.kind = EventKind::kDebrisLeft;
        e.element = static_cast<int32_t>(i);
        e.value = static_cast<float>(scene.irrigation->debris[i].kind);
        e.value2 = static_cast<float>(fate);
        set_rest_position(e, debris_place(scene, state, i));
        left.push_back(e);
    }
    all.push_back(sum_event(state, IrrigationSum::kDebris, static_cast<double>(now.debris.size()),
                            stuck + loose));
    all.insert(all.end(), left.begin(), left.end());
    return all;
}

}  // namespace placode::sim
