// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Events of needle and thread, as a scene tells them.
#include <algorithm>
#include <cassert>

#include "sim/core/as_index.h"
#include "sim/step/needle_holds.h"
#include "sim/step/needle_jaws.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr float kSlipEnds = 0.1F;  // without slipping this long, the slip is over [s]

/// Largest depth of a channel's passages below the surface at rest [m].
double depth_of(const Scene& scene, const State& state, int32_t channel) noexcept {
    const SutureState& needle = state.suturing.needle[0];
    double deepest = 0;
    const auto look = [&](const Passage& p) {
        if (p.channel != channel || scene.field.depth_m.empty()) return;
        const auto& c = corners(scene.body, state.body, p.at.tet);
        double depth = 0;
        for (size_t k = 0; k < 4; ++k)
            depth += p.at.b[k] * static_cast<double>(
                                     scene.field.depth_m[as_index(origin_of(state.body, c[k]))]);
        deepest = std::max(deepest, depth);
    };
    for (int i = 0; i < needle.passage_count; ++i) look(needle.passages[as_index(i)]);
    for (int i = 0; i < needle.thread.passage_count; ++i) look(needle.thread.passages[as_index(i)]);
    return deepest;
}

EventKind kind_of(SutureEventKind kind) noexcept {
    switch (kind) {
        case SutureEventKind::kEntered:
            return EventKind::kNeedleEntered;
        case SutureEventKind::kLeft:
            return EventKind::kNeedleLeft;
        case SutureEventKind::kWithdrawn:
            return EventKind::kNeedleWithdrawn;
        case SutureEventKind::kSlipped:
            return EventKind::kNeedleSlipped;
        case SutureEventKind::kTurned:
            return EventKind::kNeedleTurned;
        case SutureEventKind::kLost:
            return EventKind::kPassageLost;
        case SutureEventKind::kRanOff:
            return EventKind::kNeedleThrough;
        case SutureEventKind::kThreaded:
            return EventKind::kThreaded;
        case SutureEventKind::kThreadOut:
            return EventKind::kThreadOut;
        case SutureEventKind::kCutThrough:
            return EventKind::kThreadCut;
        case SutureEventKind::kToreOut:
            return EventKind::kThreadToreOut;
    }
    return EventKind::kPassageLost;
}

void note_slip(JawSlip& slip, double force, double dt) noexcept {
    // Several substeps of a frame may tell of it.
    if (slip.pause_s > 0 || slip.s == 0) slip.s += static_cast<float>(dt);
    slip.peak = std::max(slip.peak, static_cast<float>(force));
    slip.pause_s = 0;
}

void pause(State& state, JawSlip& slip, EventKind kind, int tool, double dt) noexcept {
    slip.pause_s += static_cast<float>(dt);
    if (slip.s > 0 && slip.pause_s > kSlipEnds) end_jaw_slip(state, slip, kind, tool);
}

void tell_one(const Scene& scene, State& state, const SutureEvent& told) noexcept {
    Event e;
    e.time_s = state.time_s;
    e.kind = kind_of(told.kind);
    e.tool = state.suturing.driver;
    e.tissue = told.tissue;
    e.value = static_cast<float>(told.force_n);
    if (told.kind == SutureEventKind::kEntered) e.value2 = static_cast<float>(told.sine);
    if (told.kind == SutureEventKind::kLeft)
        e.value2 = static_cast<float>(depth_of(scene, state, told.channel));
    set_rest_position(e, told.rest_place_m);
    Suturing& s = state.suturing;
    if (told.kind == SutureEventKind::kEntered) {
        ++s.entered;
        s.entry_m = e.rest_position_m;
    } else if (told.kind == SutureEventKind::kLeft) {
        ++s.left;
        s.exit_m = e.rest_position_m;
    } else if (told.kind == SutureEventKind::kRanOff) {
        ++s.through;
    }
    e.element = told.tet;
    e.hash = static_cast<uint64_t>(std::max(told.channel, 0));
    add_event(state, e);
}

}  // namespace

void tell_of_suture(const Scene& scene, State& state, double dt) noexcept {
    assert(scene.suture && !state.suturing.needle.empty());
    Suturing& s = state.suturing;
    const SutureReport& report = state.scratch->suture_report;
    if (report.dropped) state.flags |= kEventsDropped;
    if (report.not_finite) state.flags |= kNotFinite;
    Handover& other = s.handover;
    pause(state, s.slide, EventKind::kNeedleSlipped, s.driver, dt);
    pause(state, s.turn, EventKind::kNeedleTurned, s.driver, dt);
    pause(state, other.slide, EventKind::kNeedleSlipped, other.second, dt);
    pause(state, other.turn, EventKind::kNeedleTurned, other.second, dt);
    for (int i = 0; i < report.event_count; ++i) {
        const SutureEvent& told = report.events[as_index(i)];
        // Jaws that open let it slide: so it is handed over, and that is no fault.
        const bool slides =
            told.kind == SutureEventKind::kSlipped || told.kind == SutureEventKind::kTurned;
        if (slides && s.needle[0].second.firm[as_index(told.hold)] < 1) continue;
        if (told.kind == SutureEventKind::kSlipped)
            note_slip(told.hold == 0 ? s.slide : other.slide, told.force_n, dt);
        else if (told.kind == SutureEventKind::kTurned)
            note_slip(told.hold == 0 ? s.turn : other.turn, told.force_n, dt);
        else
            tell_one(scene, state, told);
    }
}

}  // namespace placode::sim
