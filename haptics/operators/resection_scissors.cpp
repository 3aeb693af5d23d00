// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The right hand of a resection: the ring first, where there is a needle, then scissors that go
// along the outline snip by snip while the other hand keeps the tissue under tension.
#include <algorithm>
#include <cmath>

#include "haptics/operators/jaw_habits.h"
#include "haptics/operators/resection_operator.h"

namespace placode::haptics {

namespace {

constexpr double kRiseMS = 0.012;      // out of the tissue
constexpr double kEnterMS = 0.008;     // into it
constexpr double kChangeS = 2.0;       // another instrument through the port
constexpr double kAboutRestM = 0.003;  // where the outline is gone over again
constexpr size_t kNormalSpan = 4;

}  // namespace

bool ResectionOperator::open_at(size_t i) const noexcept {
    // Parted all along and yet not free: only what is near the rest is gone over again.
    const bool parted = trust_cut_ ? cut_[i] != 0 : (line_[i] - place_).norm() > kAboutRestM;
    return !parted && tries_[i] < jaw_habits(level_).passes;
}

/// The next piece of outline that still holds, the least tried first.
bool ResectionOperator::next_run() noexcept {
    const size_t n = line_.size();
    if (n == 0) return false;
    uint8_t least = 255;
    for (size_t i = 0; i < n; ++i) {
        if (open_at(i)) least = std::min(least, tries_[i]);
    }
    if (least == 255) return false;
    // From where the blades are, onwards.
    for (size_t k = 0; k < n; ++k) {
        const size_t i = (at_ + k) % n;
        if (!open_at(i) || tries_[i] > least) continue;
        at_ = i;
        return true;
    }
    return false;
}

/// Looks at the outline where the blades shall cut next: place, direction, normal.
void ResectionOperator::aim() noexcept {
    const size_t n = line_.size();
    point_ = line_[at_];
    up_.setZero();
    for (size_t k = 0; k < 2 * kNormalSpan + 1; ++k) {
        const Vec3& m = normal_[(at_ + n + k - kNormalSpan) % n];
        if (m.allFinite()) up_ += m;
    }
    up_ = up_.norm() > 0.1 ? Vec3(up_.normalized()) : Vec3(Vec3::UnitZ());
    along_ = line_[(at_ + kNormalSpan) % n] - line_[(at_ + n - kNormalSpan) % n];
    along_ -= along_.dot(up_) * up_;
    along_ = along_.norm() > 0 ? Vec3(along_.normalized()) : Vec3(Vec3::UnitX());
    beside_ = along_.cross(up_);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : line_) middle += p / static_cast<double>(n);
    if (beside_.dot(middle - point_) > 0) beside_ = -beside_;
}

/// Counts a try for all that the blades have covered.
void ResectionOperator::count_try() noexcept {
    const double covered_m = jaw_habits(level_).snip_step_m;
    for (size_t i = 0; i < line_.size(); ++i) {
        if ((line_[i] - point_).norm() < covered_m && tries_[i] < 255) ++tries_[i];
    }
}

Vec3 ResectionOperator::tip_goal(double above_m) const noexcept {
    return point_ + above_m * up_ + out_m_ * beside_;
}

void ResectionOperator::right(double dt_s, std::span<HandAction> hands) noexcept {
    if (right_ == Right::kRing) {
        burn_ring(dt_s, hands);
        return;
    }
    if (right_ == Right::kChange) {
        if (right_s_ > kChangeS) go(Right::kWait);
        return;  // the port is empty
    }
    cut(dt_s);
    HandAction& hand = hands[static_cast<size_t>(tools_.scissors)];
    hand = scissors_.action(time_s_);
    // Blades in the plane of cut and shaft.
    const Vec3 shaft = (hand.tip_m - scissors_pivot_).normalized();
    hand.opening = along_ - along_.dot(shaft) * shaft;
}

void ResectionOperator::burn_ring(double dt_s, std::span<HandAction> hands) noexcept {
    const OperatorAction a = ring_->act(dt_s);
    HandAction& hand = hands[static_cast<size_t>(tools_.needle)];
    hand.tip_m = a.tip_m;
    hand.pedals = a.pedals;
    hand.engaged = true;
    if (a.finish) go(Right::kChange);
}

/// One tick of the scissors, by their stage.
void ResectionOperator::cut(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    switch (right_) {
        case Right::kWait:
            go_to_the_outline();
            break;
        case Right::kReach:
            static_cast<void>(scissors_.jaw(habit.blade_rad, 2.0, dt_s));
            if (scissors_.reached(tip_goal(kHoverM), dt_s)) enter_beside_the_line();
            break;
        case Right::kEnter:
            enter(dt_s);
            break;
        case Right::kSnip:
            if (scissors_.jaw(0, habit.snip_rad_s, dt_s) && right_s_ > 0.05) {
                count_try();
                go(Right::kOpen);
            }
            break;
        case Right::kOpen:
            // Out of the slit before the blades open: open blades inside would cut at random.
            static_cast<void>(scissors_.glide(tip_goal(0.0008), kRiseMS, dt_s));
            if (right_s_ < 0.12) break;
            if (scissors_.jaw(habit.blade_rad, 3.0, dt_s)) go(Right::kAdvance);
            break;
        case Right::kAdvance:
            advance();
            break;
        case Right::kRise:
            if (scissors_.glide(tip_goal(kHoverM), kRiseMS, dt_s)) look_for_more();
            break;
        case Right::kAway:
            static_cast<void>(scissors_.jaw(0, 2.0, dt_s));
            if (scissors_.reached(scissors_.home_m(), dt_s)) go(Right::kWait);
            break;
        case Right::kRing:
        case Right::kChange:
            break;
    }
}

/// Waits until the tissue is under tension and something of the outline is left to part.
void ResectionOperator::go_to_the_outline() noexcept {
    if (!wanted_ || cutting_done_) return;
    if (!next_run()) {
        cutting_done_ = true;
        return;
    }
    aim();
    scissors_.reach(tip_goal(kHoverM), up_);
    go(Right::kReach);
}

/// How far beside the line this snip goes: a habit, and a hand that wanders.
void ResectionOperator::enter_beside_the_line() noexcept {
    const JawHabits& habit = jaw_habits(level_);
    out_m_ = habit.outward_m + habit.wander_m * scissors_.random().normal();
    go(Right::kEnter);
}

void ResectionOperator::enter(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    aim();
    if (!scissors_.glide(tip_goal(-habit.depth_m), kEnterMS, dt_s)) return;
    if (placode_gap_m_ < habit.clear_m) {
        count_try();  // not here: the placode would come between the blades
        go(Right::kOpen);
    } else {
        go(Right::kSnip);
    }
}

/// One snip further along the outline, or out of the tissue.
void ResectionOperator::advance() noexcept {
    const size_t n = line_.size();
    double path = 0;
    size_t steps = 0;
    while (steps < n && path < jaw_habits(level_).snip_step_m) {
        path += (line_[(at_ + steps + 1) % n] - line_[(at_ + steps) % n]).norm();
        ++steps;
    }
    const size_t next = (at_ + steps) % n;
    if (piece_free_ || !open_at(next) || !wanted_) {
        go(Right::kRise);
        return;
    }
    at_ = next;
    aim();
    enter_beside_the_line();
}

/// Above the tissue: the next piece of outline, or home.
void ResectionOperator::look_for_more() noexcept {
    if (piece_free_) cutting_done_ = true;
    go(Right::kWait);
    if (!next_run()) cutting_done_ = true;
    if (!cutting_done_) return;
    scissors_.reach(scissors_.home_m(), Vec3::UnitZ());
    go(Right::kAway);
}

}  // namespace placode::haptics
