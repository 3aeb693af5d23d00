// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the operator of a hand-over does next: where a needle is brought and how it is turned.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "haptics/operators/handover_operator.h"

namespace placode::haptics {

/// The turn of the handle, of all that fingers can do, at which a needle in its jaws lies best.
template <class Cost>
double HandoverOperator::best_turn(const Driver& d, Cost&& cost) const noexcept {
    double best = 0, least = 1e9;
    for (int i = 0; i <= kTurns; ++i) {
        const double turn = std::numbers::pi * (2.0 * i / kTurns - 1);
        const sim::Pose X_WN = turned(d, turn) * carry_.X_TN;
        const double here = cost(X_WN) + 0.02 * turn * turn;
        if (here >= least) continue;
        least = here;
        best = turn;
    }
    return best;
}

void HandoverOperator::begin_carry(double turn_rad, const Vec3& at_N, const Vec3& goal_m) noexcept {
    carry_.turn_rad = turn_rad;
    carry_.turned_rad = 0;
    carry_.at_N = at_N;
    carry_.goal_m = goal_m;
    swings_ = habits_.swings;
    drivers_[hand_].across = pose_now(drivers_[hand_]).q * Vec3::UnitX();
    stage(Stage::kLift);
}

/// The wire square to the other driver where this is to take it, which comes from outside of the
/// needle's circle.
void HandoverOperator::hold_out() noexcept {
    const Driver &holder = drivers_[hand_], &taker = drivers_[1 - hand_];
    const Vec3 place_N = wire_N(take_m_), out_N = place_N.normalized();
    const Vec3 back_N = Vec3::UnitZ().cross(out_N);
    const Vec3 shaft = (meeting_m() - taker.spec.pivot_m).normalized();
    const double turn = best_turn(holder, [&](const sim::Pose& X_WN) {
        const double askew = (X_WN.q * back_N).dot(shaft);
        const double inside = std::max(0.0, (X_WN.q * out_N).dot(shaft) + 0.2);
        return 4 * askew * askew + 2 * inside * inside;
    });
    begin_carry(turn + habits_.turn_error_rad * drivers_[hand_].motion.random().normal(),
                Vec3::Zero(), meeting_m());
    after_ = Stage::kHover;
}

/// The point lowest, and over its mark.
void HandoverOperator::show_point() noexcept {
    const double turn = best_turn(drivers_[hand_], [&](const sim::Pose& X_WN) {
        double lower = 0;
        const double point = (X_WN * wire_N(0)).z();
        for (int i = 1; i < kWirePlaces; ++i) {
            const Vec3 p = X_WN * wire_N(seen_.needle_arc_m * i / (kWirePlaces - 1));
            lower = std::max(lower, point - p.z());
        }
        const double jaws = std::max(0.0, point + 1e-3 - pose_now(drivers_[hand_]).p.z());
        return 1e3 * (lower + jaws);
    });
    begin_carry(turn, wire_N(0), seen_.practice.target_m[0] + Vec3(0, 0, kShownM));
    after_ = Stage::kWait;
}

/// As flat as it goes, its middle over the mark and its wire just over the tissue.
void HandoverOperator::lay_down() noexcept {
    const auto span = [&](const sim::Pose& X_WN) {
        double low = 1, high = -1;
        for (int i = 0; i < kWirePlaces; ++i) {
            const Vec3 p = X_WN * wire_N(seen_.needle_arc_m * i / (kWirePlaces - 1));
            low = std::min(low, p.z());
            high = std::max(high, p.z());
        }
        return std::array{low, high};
    };
    Driver& d = drivers_[hand_];
    const double tip = pose_now(d).p.z();
    const double turn = best_turn(d, [&](const sim::Pose& X_WN) {
        const auto [low, high] = span(X_WN);
        return 1e3 * (high - low + std::max(0.0, low + 3e-4 - tip));
    });
    const sim::Pose X_WN = turned(d, turn) * carry_.X_TN;
    const Vec3 middle_N(0, 2 / std::numbers::pi * seen_.needle_arc_m / std::numbers::pi, 0);
    const double under = (X_WN * middle_N).z() - span(X_WN)[0];
    begin_carry(turn, middle_N, seen_.practice.target_m[0] + Vec3(0, 0, kLaidM + under));
    after_ = Stage::kOpen;
}

void HandoverOperator::plan_take() noexcept {
    const size_t other = 1 - hand_;
    const Driver &taker = drivers_[hand_], &holder = drivers_[other];
    const double share = seen_.practice.step.take_share;
    take_m_ = (share > 0 ? share : 0.8) * seen_.needle_arc_m;
    take_m_ += habits_.aim_error_m * drivers_[hand_].motion.random().normal();
    take_m_ = std::clamp(take_m_, 5e-4, seen_.needle_arc_m - 5e-4);
    miss_rad_ = habits_.turn_error_rad * drivers_[hand_].motion.random().normal();
    if (seen_.holds_needle[taker.tool]) {  // at another place than the step wants
        stage(Stage::kOpen);
        return;
    }
    lying_ = !seen_.holds_needle[holder.tool];
    if (lying_) {
        stage(Stage::kHover);
        drivers_[hand_].motion.reach(grip_goal(drivers_[hand_]) + Vec3(0, 0, kHoverM),
                                     Vec3::UnitZ());
        return;
    }
    hand_ = other;  // until it is held out
    carry_.X_TN = pose_now(holder).inverse() * seen_.X_WN;
    hold_out();
}

void HandoverOperator::plan() noexcept {
    const sim::PracticeGoal& practice = seen_.practice;
    if (practice.index >= practice.count || tries_ > kMostTries) {
        stage(Stage::kDone);
        return;
    }
    if (practice.index != step_) tries_ = 0;
    step_ = practice.index;
    hand_ = driver_of(practice.step.hand);
    const Driver& d = drivers_[hand_];
    const bool held = seen_.holds_needle[d.tool];
    const sim::PracticeKind kind = practice.step.kind;
    if (kind == sim::PracticeKind::kRelease) {
        stage(habits_.tug_m > 0 ? Stage::kTug : Stage::kOpen);
        return;
    }
    if (kind == sim::PracticeKind::kNeedleTake || !held) {
        plan_take();
        return;
    }
    carry_.X_TN = pose_now(d).inverse() * seen_.X_WN;
    if (kind == sim::PracticeKind::kNeedleShow)
        show_point();
    else
        lay_down();
}

}  // namespace placode::haptics
