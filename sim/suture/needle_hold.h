// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Jaws on the wire: the spring with which a hand holds the needle, and where its friction ends. Two
// of them may hold at once, each by itself. Private to sim/suture.

#include "sim/core/turn.h"
#include "sim/suture/needle_motion.h"

namespace placode::sim {

/// Where the hold wants the needle, and how far it is from there.
struct HoldError {
    HoldError(const NeedleHold& hold, const Pose& X_WN) noexcept {
        target = hold.hand * hold.X_HN;
        grip = X_WN * hold.held_N;
        offset = grip - target * hold.held_N;
        turn = turn_between(target.q, X_WN.q);
    }
    Pose target;
    Vec3 grip, offset, turn;
};

/// One pair of jaws at the end of a substep.
struct Jaws {
    const Suture& suture;
    SutureState& state;
    NeedleHold& hold;
    double force_n;  ///< Of one jaw on the other.
    int which;       ///< As SutureEvent::hold.
    SutureReport& report;

    /// What the hand feels and has done; then they slip. Nothing where they hold nothing.
    /// @param X_WH_before where the hand was at the substep's start.
    void finish(const Pose& X_WH_before) const noexcept;

 private:
    void slip_along() const noexcept;
    void slip_round() const noexcept;
    [[nodiscard]] double energy() const noexcept { return hold_energy(suture, hold, state.needle); }
    void say(SutureEventKind kind, double force) const noexcept {
        SutureEvent event{kind, Tissue::kSkin, force, Vec3::Zero(), -1};
        event.hold = which;
        tell(report, event);
    }
};

}  // namespace placode::sim
