// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/needle_holds.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/turn.h"
#include "sim/cutting/grasp.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"

namespace placode::sim {
namespace {

// A hand trembles: what the needle turns is counted in steps of two degrees.
constexpr double kCountedTurn = 0.035;

void tell_grip(const Scene& scene, State& state, int t, double arc_m) noexcept {
    const Needle& needle = scene.suture->needle();
    const SutureState& held = state.suturing.needle[0];
    const Quat& q = state.tools[as_index(t)].proxy.q;
    const Vec3 wire = held.needle.q * needle.at(arc_m).back, normal = held.needle.q * Vec3::UnitZ();
    add_event(state, driver_event(state, EventKind::kNeedleGrip, t,
                                  static_cast<float>(std::abs(normal.dot(q * Vec3::UnitZ()))),
                                  static_cast<float>(std::abs(wire.dot(q * Vec3::UnitX())))));
}

/// From hand to hand: from jaws to jaws, or let go in between.
void tell_handover(State& state, int to, bool both) noexcept {
    Event between = driver_event(state, EventKind::kNeedleHandedOver, to, 0, 0);
    between.element = 0;
    const double held_ms = 1000 * static_cast<double>(state.suturing.handover.both_s);
    add_event(state,
              both ? held_by_both(state, to, std::max(1, static_cast<int32_t>(held_ms))) : between);
}

void count_turn(Suturing& s) noexcept {
    Handover& h = s.handover;
    const double turn = turn_between(h.counted, s.needle[0].needle.q).norm();
    if (turn < kCountedTurn) return;
    h.swung_rad += static_cast<float>(turn);
    h.counted = s.needle[0].needle.q;
}

/// How firmly both hold: jaws give way between the opening at which they hold and that at which
/// they let go.
double firmness(const Scene& scene, const State& state, int t) noexcept {
    const double meet = grip_angle(scene.tools[as_index(t)]);
    const double over = static_cast<double>(state.grasps[as_index(t)].jaw_rad) - meet;
    return std::clamp(1 - over / ((kLetGo - 1) * meet), 0.0, 1.0);
}

}  // namespace

void end_jaw_slip(State& state, JawSlip& slip, EventKind kind, int tool) noexcept {
    if (slip.s > 0) add_event(state, driver_event(state, kind, tool, slip.s, slip.peak));
    slip = {};
}

void begin_hold(const Scene& scene, State& state, int t, double arc_m) noexcept {
    Suturing& s = state.suturing;
    Handover& h = s.handover;
    if (h.second >= 0) return;
    const Pose& hand = state.tools[as_index(t)].proxy;
    const bool too = s.driver >= 0;
    if (too) {
        take_needle_too(*scene.suture, s.needle[0], hand, arc_m);
        h.second = static_cast<int8_t>(t);
        h.began = s.needle[0].needle.q;
        h.both_s = h.apart_n = 0;
    } else {
        take_needle(*scene.suture, s.needle[0], hand, arc_m);
        s.driver = static_cast<int8_t>(t);
        h.counted = s.needle[0].needle.q;
        h.swung_rad = 0;
    }
    ++s.taken;
    add_event(state, driver_event(state, EventKind::kNeedleTaken, t, static_cast<float>(arc_m),
                                  static_cast<float>(arc_m / scene.suture->needle().arc_m())));
    if (!has_two_drivers(scene)) return;
    tell_grip(scene, state, t, arc_m);
    if (!too && h.last >= 0 && h.last != t) tell_handover(state, t, false);
    if (!too) h.last = static_cast<int8_t>(t);
}

void end_hold(const Scene& scene, State& state, int t) noexcept {
    Suturing& s = state.suturing;
    Handover& h = s.handover;
    const bool first = s.driver == t;
    end_jaw_slip(state, first ? s.slide : h.slide, EventKind::kNeedleSlipped, t);
    end_jaw_slip(state, first ? s.turn : h.turn, EventKind::kNeedleTurned, t);
    add_event(state, driver_event(state, EventKind::kNeedleReleased, t, first ? s.held_s : h.held_s,
                                  first ? s.peak_n : h.peak_n));
    const int second = h.second;
    if (has_two_drivers(scene) && second < 0 && h.swung_rad > 0)
        add_event(state, driver_event(state, EventKind::kNeedleSwung, t, h.swung_rad, 0));
    if (first && second >= 0) {
        tell_handover(state, second, true);
        let_go_needle(s.needle[0]);  // the second is the only one now
        s.driver = h.second;
        s.held_s = h.held_s;
        s.peak_n = h.peak_n;
        s.slide = h.slide;
        s.turn = h.turn;
        h.last = h.second;
    } else if (first) {
        let_go_needle(s.needle[0]);
        s.driver = -1;
        s.held_s = s.peak_n = 0;
    } else {
        // What two hands did to it counts, though the first one has kept it.
        add_event(state, held_by_both(state, s.driver, -1));
        let_go_second(s.needle[0]);
    }
    if (first) s.locked = 0;
    h.second = -1;
    h.held_s = h.peak_n = 0;
    h.slide = h.turn = {};
}

void count_holds(const Scene& scene, State& state, double dt) noexcept {
    Suturing& s = state.suturing;
    Handover& h = s.handover;
    if (s.driver < 0) return;
    count_turn(s);
    if (h.second < 0) return;
    SutureState& needle = s.needle[0];
    const auto seconds = static_cast<float>(dt);
    h.held_s += seconds;
    h.both_s += seconds;
    const auto first_n = static_cast<float>(needle.hold.force_n.norm()),
               second_n = static_cast<float>(needle.second.hold.force_n.norm());
    h.peak_n = std::max(h.peak_n, second_n);
    h.apart_n = std::max(h.apart_n, std::min(first_n, second_n));
    needle.second.firm = {s.locked != 0 ? 1 : firmness(scene, state, s.driver),
                          firmness(scene, state, h.second)};
}

}  // namespace placode::sim
