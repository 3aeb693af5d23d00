// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/handover_operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::haptics {

const HandoverHabits& handover_habits(OperatorLevel level) noexcept {
    static const std::array habits{HandoverHabits{},
                                   HandoverHabits{0.012, 0.9, 1.1e-3, 0.25, 8e-4, 0, 1},
                                   HandoverHabits{0.014, 1.5, 1.6e-3, 0.4, 1.5e-3, 1, 2}};
    return habits[static_cast<size_t>(level)];
}

HandoverOperator::HandoverOperator(OperatorLevel level, uint64_t seed,
                                   const std::array<size_t, 2>& drivers,
                                   std::span<const sim::ToolSpec> tools,
                                   std::span<const Vec3> homes_m)
    : habits_(handover_habits(level)),
      profile_(operator_profile(level)),
      drivers_{
          Driver{drivers[0], tools[drivers[0]], HandMotion(profile_, seed, homes_m[drivers[0]])},
          Driver{drivers[1], tools[drivers[1]],
                 HandMotion(profile_, seed + 1, homes_m[drivers[1]])}},
      early_(habits_.early) {}

void HandoverOperator::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
}

size_t HandoverOperator::driver_of(sim::Hand hand) const noexcept {
    return drivers_[1].spec.hand == hand ? 1 : 0;
}

sim::Pose HandoverOperator::pose(const Driver& d, const Vec3& tip_m,
                                 const Vec3& across) const noexcept {
    const Vec3 shaft = (tip_m - d.spec.pivot_m).normalized();
    sim::Mat3 r;
    r.col(2) = shaft;
    r.col(0) = (across - across.dot(shaft) * shaft).normalized();
    r.col(1) = r.col(2).cross(r.col(0));
    return {tip_m, Quat(r)};
}

sim::Pose HandoverOperator::pose_now(const Driver& d) const noexcept {
    return seen_.tools[d.tool].proxy;
}

/// As its jaws stand when the handle is turned by so much.
sim::Pose HandoverOperator::turned(const Driver& d, double turn_rad) const noexcept {
    sim::Pose p = pose_now(d);
    p.q = p.q * Quat(Eigen::AngleAxisd(turn_rad, Vec3::UnitZ()));
    return p;
}

Vec3 HandoverOperator::wire_N(double arc_m) const noexcept {
    const double radius = seen_.needle_arc_m / std::numbers::pi, a = arc_m / radius;
    return radius * Vec3(std::cos(a), std::sin(a), 0);
}

/// Turned about its shaft while it goes there.
void HandoverOperator::carry(double dt_s) noexcept {
    Driver& d = drivers_[hand_];
    if (!seen_.holds_needle[d.tool]) {  // lost on the way
        ++tries_;
        stage(Stage::kPlan);
        return;
    }
    // Whoever has not learnt how the handle turns it, turns too far and back.
    const double goal = carry_.turn_rad * (swings_ > 0 ? 1.35 : 1);
    const double step =
        std::clamp(goal - carry_.turned_rad, -habits_.turn_rad_s * dt_s, habits_.turn_rad_s * dt_s);
    carry_.turned_rad += step;
    const bool round = std::abs(goal - carry_.turned_rad) < 1e-6;
    if (round && swings_ > 0) --swings_;
    const Vec3 tip = d.motion.tip_m(), shaft = (tip - d.spec.pivot_m).normalized();
    d.across = Eigen::AngleAxisd(step, shaft) * d.across;
    // Down to the tissue only once it is turned.
    const Vec3 goal_m = carry_.goal_m + (round ? 0 : kTurnedUpM) * Vec3::UnitZ();
    Vec3 goal_tip = tip;
    for (int i = 0; i < 3; ++i) {
        const sim::Pose there = pose(d, goal_tip, d.across);
        goal_tip = goal_m - there.q * (carry_.X_TN * carry_.at_N);
    }
    const bool there = d.motion.glide(goal_tip, habits_.speed_m_s, dt_s);
    if (!round || !there || swings_ > 0) return;
    if (after_ == Stage::kHover) {
        hand_ = 1 - hand_;
        Driver& taker = drivers_[hand_];
        const Vec3 goal = grip_goal(taker);
        taker.motion.reach(goal - kClearM * (goal - taker.spec.pivot_m).normalized());
    }
    stage(after_);
}

/// Of the tip, so that the wire lies in the jaws; they lie along it.
Vec3 HandoverOperator::grip_goal(Driver& d) noexcept {
    const Vec3 place_N = wire_N(take_m_);
    const Vec3 wire = seen_.X_WN * place_N;
    const Vec3 shaft = (wire - d.spec.pivot_m).normalized();
    Vec3 along = seen_.X_WN.q * Vec3::UnitZ().cross(place_N).normalized();
    if (along.dot(pose_now(d).q * Vec3::UnitX()) < 0) along = -along;
    d.across = Eigen::AngleAxisd(lying_ ? 0 : miss_rad_, shaft) * along;
    const double share = lying_ ? kLyingShare : kHeldShare;
    return wire + share * d.spec.tip_length_m * shaft + (lying_ ? kLyingUpM : 0) * Vec3::UnitZ();
}

void HandoverOperator::hover(double dt_s) noexcept {
    Driver& d = drivers_[hand_];
    const Vec3 goal = grip_goal(d);
    const Vec3 from = lying_ ? Vec3(kHoverM * Vec3::UnitZ())
                             : Vec3(-kClearM * (goal - d.spec.pivot_m).normalized());
    const bool open = d.motion.jaw(kOpenRad, kJawRadS, dt_s);
    if (d.motion.reached(goal + from, dt_s) && open && stage_s_ > 1) stage(Stage::kCome);
}

void HandoverOperator::come(double dt_s) noexcept {
    Driver& d = drivers_[hand_];
    if (!d.motion.glide(grip_goal(d), lying_ ? kLowerM_s : kApproachM_s, dt_s)) return;
    if (!lying_ && early_ > 0 && !drivers_[1 - hand_].motion.jaw(kOpenRad, kJawRadS, dt_s))
        return;  // it is let go before this hand has it
    if (!lying_ && early_ > 0) --early_;
    stage(Stage::kClose);
}

void HandoverOperator::close(double dt_s) noexcept {
    Driver& d = drivers_[hand_];
    if (!d.motion.jaw(0, kJawRadS, dt_s) || stage_s_ < 0.4) return;
    if (seen_.practice.index != step_) {
        tries_ = 0;
        stage(Stage::kPlan);
    } else if (stage_s_ > 1) {
        try_again();
    }
}

void HandoverOperator::try_again() noexcept {
    ++tries_;
    stage(Stage::kOpen);
}

void HandoverOperator::go_on(double dt_s) noexcept {
    Driver& d = drivers_[hand_];
    const Vec3 shaft = (d.motion.tip_m() - d.spec.pivot_m).normalized();
    switch (stage_) {
        case Stage::kLook:
            if (stage_s_ > profile_.look_s && seen_.needle && seen_.practice.count > 0)
                stage(Stage::kPlan);
            break;
        case Stage::kPlan:
            plan();
            break;
        case Stage::kLift: {
            const double low = kClearNeedleM - (seen_.X_WN.p).z();
            if (low <= 0 ||
                d.motion.glide(d.motion.tip_m() + Vec3(0, 0, low), habits_.speed_m_s, dt_s))
                stage(Stage::kCarry);
            break;
        }
        case Stage::kCarry:
            carry(dt_s);
            break;
        case Stage::kHover:
            hover(dt_s);
            break;
        case Stage::kCome:
            come(dt_s);
            break;
        case Stage::kClose:
            close(dt_s);
            break;
        case Stage::kTug: {
            Driver& taker = drivers_[1 - hand_];
            const Vec3 back = (taker.spec.pivot_m - taker.motion.tip_m()).normalized();
            const Vec3 goal = taker.motion.tip_m() + habits_.speed_m_s * dt_s * back;
            if (stage_s_ * habits_.speed_m_s >= habits_.tug_m)
                stage(Stage::kOpen);
            else
                static_cast<void>(taker.motion.glide(goal, habits_.speed_m_s, dt_s));
            break;
        }
        case Stage::kOpen:
            if (d.motion.jaw(kOpenRad, kJawRadS, dt_s)) {
                goal_ = d.motion.tip_m() - kClearM * shaft + Vec3(0, 0, 0.002);
                stage(Stage::kBack);
            }
            break;
        case Stage::kBack:
            if (d.motion.glide(goal_, profile_.free_speed_m_s, dt_s)) stage(Stage::kWait);
            break;
        case Stage::kWait:
            if (seen_.practice.index != step_) {
                tries_ = 0;
                stage(Stage::kPlan);
            } else if (stage_s_ > 1.5) {
                ++tries_;
                stage(Stage::kPlan);
            }
            break;
        case Stage::kDone:
            break;
    }
}

bool HandoverOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    go_on(dt_s);
    if (stage_s_ > kPatienceS && stage_ != Stage::kDone) stage(Stage::kDone);
    for (const Driver& d : drivers_) {
        hands[d.tool] = d.motion.action(time_s_);
        hands[d.tool].across = d.across;
    }
    return stage_ == Stage::kDone;
}

}  // namespace placode::haptics
