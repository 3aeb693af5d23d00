// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/needle_jaws.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/cutting/grasp.h"
#include "sim/suture/needle_motion.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kWirePlaces = 129;    // looked at along the arc: every 0.13 mm of 17
constexpr double kReach = 0.0006;   // wire this far beyond the tips is still bitten [m]
constexpr float kLetGo = 1.25F;     // opening at which jaws let go, in that at which they take
constexpr double kCentring = 0.05;  // of its way to the jaws' middle that the wire goes in a frame
constexpr float kSlipEnds = 0.1F;   // without slipping this long, the slip is over [s]

void end_jaw_slip(State& state, JawSlip& slip, EventKind kind) noexcept {
    if (slip.s > 0)
        add_event(state, driver_event(state, kind, state.suturing.driver, slip.s, slip.peak));
    slip = {};
}

/// Whoever held the needle holds it no more.
void end_hold(State& state) noexcept {
    Suturing& s = state.suturing;
    end_jaw_slip(state, s.slide, EventKind::kNeedleSlipped);
    end_jaw_slip(state, s.turn, EventKind::kNeedleTurned);
    add_event(state, driver_event(state, EventKind::kNeedleReleased, s.driver, s.held_s, s.peak_n));
    s.driver = -1;
    s.locked = 0;
    s.held_s = s.peak_n = 0;
}

void begin_hold(const Scene& scene, State& state, int t, double arc_m) noexcept {
    Suturing& s = state.suturing;
    if (s.driver >= 0) end_hold(state);  // from jaws to jaws
    take_needle(*scene.suture, s.needle[0], state.tools[as_index(t)].proxy, arc_m);
    s.driver = static_cast<int8_t>(t);
    ++s.taken;
    add_event(state, driver_event(state, EventKind::kNeedleTaken, t, static_cast<float>(arc_m),
                                  static_cast<float>(arc_m / scene.suture->needle().arc_m())));
}

/// Closed jaws bring the wire to their middle.
void centre_wire(const Scene& scene, SutureState& needle) noexcept {
    NeedleHold& hold = needle.hold;
    const double before = hold_energy(*scene.suture, needle);
    hold.X_HN.p.y() -= kCentring * (hold.X_HN * hold.held_N).y();
    needle.work.hand += hold_energy(*scene.suture, needle) - before;
}

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

void pause(State& state, JawSlip& slip, EventKind kind, double dt) noexcept {
    slip.pause_s += static_cast<float>(dt);
    if (slip.s > 0 && slip.pause_s > kSlipEnds) end_jaw_slip(state, slip, kind);
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

double wire_between(const ToolSpec& spec, const Pose& X_WT, const Needle& needle,
                    const Pose& X_WN) noexcept {
    const Pose X_TN = X_WT.inverse() * X_WN;
    // As tissue between jaws (sim/cutting/grasp.cpp): they meet at an angle.
    const double half_angle = std::max(0.0, grip_angle(spec)) / 2;
    const double slope = half_angle + half_angle * half_angle * half_angle / 3;
    double best_m = -1, best2 = 0;
    for (int i = 0; i < kWirePlaces; ++i) {
        const double s = needle.arc_m() * i / (kWirePlaces - 1);
        const Vec3 p = X_TN * needle.at(s).place_m;
        if (p.z() > kReach || p.z() < -spec.tip_length_m) continue;
        if (std::abs(p.x()) > spec.jaw_width_m / 2) continue;
        const double gap = std::max(slope * (spec.tip_length_m + p.z()), 0.25 * spec.jaw_touch_m);
        if (std::abs(p.y()) > gap + needle.spec().wire_radius_m) continue;
        const double off2 = p.x() * p.x() + p.y() * p.y();
        if (best_m >= 0 && off2 >= best2) continue;
        best_m = s;
        best2 = off2;
    }
    return best_m;
}

void place_in_jaws(const Scene& scene, State& state) noexcept {
    assert(scene.suture && !state.suturing.needle.empty());
    Suturing& s = state.suturing;
    for (size_t t = 0; t < scene.tools.size(); ++t) {
        if (scene.tools[t].kind != ToolKind::kNeedleDriver || state.tools[t].engaged == 0) continue;
        s.needle[0].needle = state.tools[t].proxy * scene.needle_start.X_TN;
        s.needle[0].needle.q.normalize();
        s.placed = 1;
        s.locked = kLockedUntilClosed;
        begin_hold(scene, state, static_cast<int>(t), scene.needle_start.held_arc_m);
        return;
    }
}

void update_needle_jaws(const Scene& scene, State& state, double dt) noexcept {
    assert(scene.suture && !state.suturing.needle.empty());
    Suturing& s = state.suturing;
    if (s.placed == 0) return;
    SutureState& needle = s.needle[0];
    if (s.driver >= 0 && needle.hold.held == 0) end_hold(state);  // it slid out of the jaws
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const ToolSpec& spec = scene.tools[as_index(t)];
        if (spec.kind != ToolKind::kNeedleDriver) continue;
        const ToolState& tool = state.tools[as_index(t)];
        Grasp& jaws = state.grasps[as_index(t)];
        const auto meet = static_cast<float>(grip_angle(spec));
        const float jaw = std::isfinite(tool.jaw_rad) ? std::max(0.0F, tool.jaw_rad) : jaws.jaw_rad;
        const bool closed = jaw <= meet, open = jaw > kLetGo * meet;
        if (s.driver == t) {
            const bool awaits = s.locked == kLockedUntilEngaged && tool.engaged == 0;
            if (!awaits && s.locked == kLockedUntilEngaged) s.locked = kLockedUntilClosed;
            if (closed && !awaits) s.locked = 0;
            if (!awaits && (tool.engaged == 0 || (open && s.locked == 0))) {
                let_go_needle(needle);
                end_hold(state);
            } else {
                s.held_s += static_cast<float>(dt);
                s.peak_n = std::max(s.peak_n, static_cast<float>(needle.hold.force_n.norm()));
                centre_wire(scene, needle);
            }
        }
        if (open) {
            jaws.shut = 0;
        } else if (closed && jaws.shut == 0 && tool.engaged != 0) {
            jaws.shut = 1;
            const double at = s.driver == t ? -1
                                            : wire_between(spec, tool.proxy, scene.suture->needle(),
                                                           needle.needle);
            if (at >= 0) begin_hold(scene, state, t, at);
        }
        jaws.jaw_rad = jaw;
    }
}

void tell_of_suture(const Scene& scene, State& state, double dt) noexcept {
    assert(scene.suture && !state.suturing.needle.empty());
    Suturing& s = state.suturing;
    const SutureReport& report = state.scratch->suture_report;
    if (report.dropped) state.flags |= kEventsDropped;
    if (report.not_finite) state.flags |= kNotFinite;
    pause(state, s.slide, EventKind::kNeedleSlipped, dt);
    pause(state, s.turn, EventKind::kNeedleTurned, dt);
    for (int i = 0; i < report.event_count; ++i) {
        const SutureEvent& told = report.events[as_index(i)];
        if (told.kind == SutureEventKind::kSlipped)
            note_slip(s.slide, told.force_n, dt);
        else if (told.kind == SutureEventKind::kTurned)
            note_slip(s.turn, told.force_n, dt);
        else
            tell_one(scene, state, told);
    }
}

}  // namespace placode::sim
