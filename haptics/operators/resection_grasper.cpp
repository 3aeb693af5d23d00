// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The left hand of a resection: the grasper takes hold of the marked tissue, keeps it under tension
// while the scissors work, lifts what came free and carries it out through the port.
#include <algorithm>
#include <cmath>

#include "haptics/operators/jaw_habits.h"
#include "haptics/operators/resection_operator.h"

namespace placode::haptics {

namespace {

constexpr double kGraspPressM = 0.0002, kGraspDeepestM = 0.0014;
constexpr double kPullM = 0.007;  // how far a piece is lifted before it must be free
constexpr double kPullMS = 0.004;
constexpr double kCarryMS = 0.025;  // out through the port
constexpr double kCarryS = 3;
constexpr double kSlackN = 0.004;  // of traction: what is held hangs on nothing
constexpr int kGrasps = 6;

}  // namespace

/// Worth another grasp.
bool ResectionOperator::unfinished() const noexcept {
    return placed_ && marked_left_ > jaw_habits(level_).leaves && grasps_ < kGrasps;
}

/// Takes hold of what is left and goes round it once more.
void ResectionOperator::grasp_again() noexcept {
    std::fill(tries_.begin(), tries_.end(), uint8_t{0});
    if (std::find(cut_.begin(), cut_.end(), 0) == cut_.end()) trust_cut_ = false;
    cutting_done_ = false;
    passes_ = 0;
    ++grasps_;
    grasper_.reach(hold_place(kHoverM), Vec3::UnitZ());
    go(Left::kReach);
}

Vec3 ResectionOperator::hold_place(double above_m) const noexcept {
    return place_ + place_error_ + above_m * place_normal_;
}

void ResectionOperator::carry() noexcept {
    out_before_ = pieces_out_;
    wanted_ = false;
    go(Left::kCarry);
}

/// One tick of the grasper, by its stage.
void ResectionOperator::left(double dt_s, std::span<HandAction> hands) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    switch (left_) {
        case Left::kLook:
            choose_hold();
            break;
        case Left::kReach:
            static_cast<void>(grasper_.jaw(habit.open_rad, 1.5, dt_s));
            height_m_ = kHoverM;
            if (grasper_.reached(hold_place(kHoverM), dt_s)) go(Left::kLower);
            break;
        case Left::kLower:
            lower(dt_s);
            break;
        case Left::kClose:
            close(dt_s);
            break;
        case Left::kTension:
            height_m_ += habit.lift_m_s * dt_s;
            static_cast<void>(grasper_.glide(hold_place(height_m_), 0.03, dt_s));
            if (height_m_ < habit.tension_m) break;
            wanted_ = true;
            go(Left::kHold);
            break;
        case Left::kHold:
            hold();
            break;
        case Left::kLift:
            lift(dt_s);
            break;
        case Left::kCarry:
            carry_out(dt_s);
            break;
        case Left::kOpen:
            if (grasper_.jaw(habit.open_rad, 2.0, dt_s)) let_go();
            break;
        case Left::kBack:
            go_back(dt_s);
            break;
        case Left::kDone:
            break;
    }
    hands[static_cast<size_t>(tools_.grasper)] = grasper_.action(time_s_);
}

void ResectionOperator::choose_hold() noexcept {
    const bool ready = right_ != Right::kRing && right_ != Right::kChange;
    if (!ready || !placed_ || left_s_ < profile_.look_s) return;
    for (int k = 0; k < 2; ++k) {
        place_error_[k] = jaw_habits(level_).aim_error_m * grasper_.random().normal();
    }
    grasper_.reach(hold_place(kHoverM), Vec3::UnitZ());
    ++grasps_;
    go(Left::kReach);
}

void ResectionOperator::lower(double dt_s) noexcept {
    height_m_ -= profile_.descend_m_s * dt_s;
    static_cast<void>(grasper_.glide(hold_place(height_m_), 0.02, dt_s));
    if (touches_ || height_m_ < -kGraspDeepestM) {
        low_m_ = std::max(height_m_ - kGraspPressM, -kGraspDeepestM);
        go(Left::kClose);
    }
}

void ResectionOperator::close(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    height_m_ = std::max(height_m_ - 0.002 * dt_s, low_m_);
    static_cast<void>(grasper_.glide(hold_place(height_m_), 0.02, dt_s));
    if (!grasper_.jaw(habit.squeezed_rad(), habit.close_rad_s, dt_s) || left_s_ < 0.8) return;
    go(holds_ ? Left::kTension : Left::kOpen);
}

/// Still, while the scissors cut.
void ResectionOperator::hold() noexcept {
    if (!holds_) {
        wanted_ = false;
        go(Left::kOpen);
    } else if (cutting_done_ && right_ == Right::kWait) {
        go(Left::kLift);
    }
}

/// Whether what was parted comes along, and what is done if not.
void ResectionOperator::lift(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    height_m_ += kPullMS * dt_s;
    static_cast<void>(grasper_.glide(hold_place(height_m_), 0.03, dt_s));
    if (!holds_) {
        go(Left::kOpen);
    } else if (piece_free_ && height_m_ > 0.004) {
        carry();
    } else if (height_m_ > kPullM) {
        if (pull_n_ < kSlackN) {  // only part of it came along: out with that
            carry();
        } else if (++passes_ < habit.passes) {
            // Something still holds it: back, and along the outline again.
            std::fill(tries_.begin(), tries_.end(), uint8_t{0});
            cutting_done_ = false;
            go(Left::kTension);
            height_m_ = habit.tension_m;
        } else {
            go(Left::kOpen);
        }
    }
}

void ResectionOperator::carry_out(double dt_s) noexcept {
    const Vec3 away = (grasper_pivot_ - grasper_.tip_m()).normalized();
    static_cast<void>(grasper_.glide(grasper_.tip_m() + 0.01 * away, kCarryMS, dt_s));
    const bool out = pieces_out_ > out_before_ && marked_held_ <= 0;
    if (out || !holds_ || left_s_ > kCarryS) go(Left::kOpen);
}

/// Jaws open: another grasp, or home.
void ResectionOperator::let_go() noexcept {
    if (unfinished()) {
        grasp_again();
        return;
    }
    grasper_.reach(grasper_.home_m(), Vec3::UnitZ());
    go(Left::kBack);
}

void ResectionOperator::go_back(double dt_s) noexcept {
    static_cast<void>(grasper_.jaw(0, 1.0, dt_s));
    wanted_ = false;
    if (grasper_.reached(grasper_.home_m(), dt_s) &&
        (right_ == Right::kWait || right_ == Right::kAway) && left_s_ > 2.5) {
        go(Left::kDone);
    }
}

}  // namespace placode::haptics
