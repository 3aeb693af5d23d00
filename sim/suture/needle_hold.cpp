// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/needle_hold.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/turn.h"

namespace placode::sim {
namespace {

double energy_of(const JawSpec& jaws, const HoldError& e) noexcept {
    return 0.5 * jaws.pull_n_m * e.offset.squaredNorm() +
           0.5 * jaws.turn_n_m_rad * e.turn.squaredNorm();
}

void feel(const JawSpec& jaws, NeedleHold& hold, const HoldError& e) noexcept {
    hold.force_n = -jaws.pull_n_m * e.offset;
    hold.torque_n_m = -jaws.turn_n_m_rad * e.turn;
}

}  // namespace

/// Along the wire: the needle runs on its arc through the jaws, about its own centre.
void Jaws::slip_along() const noexcept {
    const JawSpec& jaws = suture.spec().jaws;
    const double pull = hold.force_n.dot(state.needle.q * hold.back_N);
    const double most = 2 * jaws.friction * force_n;
    if (std::abs(pull) <= most) return;
    // The hand pulls the grip towards the swage: the target comes after it, towards the point.
    const double slip = std::copysign((std::abs(pull) - most) / jaws.pull_n_m, pull);
    const double before = energy();
    const double angle = slip / suture.needle().radius_m();
    Quat turn = Quat::Identity();
    turn_by(turn, Vec3(0, 0, -angle));
    hold.X_HN.q = hold.X_HN.q * turn;
    hold.arc_m += slip;
    hold.held_N = turn.conjugate() * hold.held_N;
    hold.back_N = turn.conjugate() * hold.back_N;
    feel(jaws, hold, HoldError(hold, state.needle));
    state.work.jaws += before - energy();
    say(SutureEventKind::kSlipped, std::abs(pull));
    if (hold.arc_m >= 0 && hold.arc_m <= suture.needle().arc_m()) return;
    state.work.jaws += energy();  // drawn out of the jaws
    hold.held = 0;
    hold.force_n = hold.torque_n_m = Vec3::Zero();
}

/// About the grip.
void Jaws::slip_round() const noexcept {
    const JawSpec& jaws = suture.spec().jaws;
    const double torque = hold.torque_n_m.norm();
    const double most = jaws.friction * force_n * jaws.width_m;
    if (torque <= most) return;
    const double before = energy();
    const HoldError e(hold, state.needle);
    Pose target = e.target;
    turn_by(target.q, (1 - most / torque) * e.turn);
    target.p = e.grip - e.offset - target.q * hold.held_N;  // the grip's target stays
    hold.X_HN = hold.hand.inverse() * target;
    hold.X_HN.q.normalize();
    feel(jaws, hold, HoldError(hold, state.needle));
    state.work.jaws += before - energy();
    say(SutureEventKind::kTurned, torque);
}

void Jaws::finish(const Pose& X_WH_before) const noexcept {
    if (hold.held == 0) return;
    const HoldError e(hold, state.needle);
    const Vec3 force = hold.force_n, torque = hold.torque_n_m;
    feel(suture.spec().jaws, hold, e);
    // Both ends of the offset with half the force: exact for a spring.
    const Pose before = X_WH_before * hold.X_HN;
    state.work.hand +=
        0.5 * (force + hold.force_n).dot(e.target * hold.held_N - before * hold.held_N) +
        0.5 * (torque + hold.torque_n_m).dot(turn_between(before.q, e.target.q));
    slip_along();
    if (hold.held != 0) slip_round();
}

void tell(SutureReport& report, const SutureEvent& event) noexcept {
    // A slip tells of every substep: the hardest is enough, or bites would find no room.
    if (event.kind == SutureEventKind::kSlipped || event.kind == SutureEventKind::kTurned) {
        for (int i = 0; i < report.event_count; ++i) {
            SutureEvent& told = report.events[as_index(i)];
            if (told.kind != event.kind || told.hold != event.hold) continue;
            told.force_n = std::max(told.force_n, event.force_n);
            return;
        }
    }
    if (report.event_count == kMostSutureEvents)
        report.dropped = true;
    else
        report.events[as_index(report.event_count++)] = event;
}

double hold_energy(const Suture& suture, const NeedleHold& hold, const Pose& X_WN) noexcept {
    if (hold.held == 0) return 0;
    return energy_of(suture.spec().jaws, HoldError(hold, X_WN));
}

double hold_energy(const Suture& suture, const SutureState& state) noexcept {
    return hold_energy(suture, state.hold, state.needle) +
           hold_energy(suture, state.second.hold, state.needle);
}

}  // namespace placode::sim
