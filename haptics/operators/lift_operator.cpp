// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/lift_operator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/operators/jaw_habits.h"

namespace placode::haptics {

namespace {

constexpr int kRounds = 3, kTries = 3;
constexpr double kHoverM = 0.004, kOutsideM = 0.0019, kPressM = 0.0002, kDeepestM = 0.0012;

}  // namespace

LiftOperator::LiftOperator(OperatorLevel level, uint64_t seed, size_t tool, const Vec3& home_m)
    : level_(level),
      profile_(operator_profile(level)),
      hand_(profile_, seed, home_m),
      tool_(tool) {}

void LiftOperator::see(const Perception& seen) {
    if (contour_.size() != seen.contour.size()) {
        contour_.assign(seen.contour.begin(), seen.contour.end());
        normal_.assign(seen.contour_normal.begin(), seen.contour_normal.end());
        normal_.resize(contour_.size(), Vec3::UnitZ());
        centre_.setZero();
        for (const Vec3& p : contour_) centre_ += p / static_cast<double>(contour_.size());
    }
    touches_ = seen.touches[tool_];
    holds_ = seen.holds[tool_];
}

void LiftOperator::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
}

/// A little outside the planned line, at three places around the placode, at the height of the hand
/// over the tissue.
Vec3 LiftOperator::place() const noexcept {
    // Three directions on the instrument's own side, so that its shaft does not cross the placode.
    constexpr std::array<std::array<double, 2>, kRounds> offsets{
        {{-0.8, 0.6}, {0.0, 1.0}, {0.8, 0.6}}};
    const auto& offset = offsets[static_cast<size_t>(std::min(round_, kRounds - 1))];
    const Vec3 wanted(offset[0], offset[1] * (hand_.home_m().y() < 0 ? -1 : 1), 0);
    size_t i = 0;
    double best = -1;
    for (size_t k = 0; k < contour_.size(); ++k) {
        const double along = (contour_[k] - centre_).normalized().dot(wanted);
        if (along > best) {
            best = along;
            i = k;
        }
    }
    Vec3 out = contour_[i] - centre_;
    out -= out.dot(normal_[i]) * normal_[i];
    return contour_[i] + kOutsideM * out.normalized() + error_ + height_m_ * normal_[i];
}

void LiftOperator::go_to_the_place() noexcept {
    for (int k = 0; k < 2; ++k) {
        error_[k] = jaw_habits(level_).aim_error_m * hand_.random().normal();
    }
    height_m_ = kHoverM;
    hand_.reach(place(), Vec3::UnitZ());
    stage(Stage::kReach);
}

/// Out of the tissue: the next place, or home after the last one.
void LiftOperator::rise(double dt_s) noexcept {
    height_m_ += 0.01 * dt_s;
    static_cast<void>(hand_.glide(place(), 0.02, dt_s));
    if (height_m_ < kHoverM) return;
    if (round_ == kRounds) {
        hand_.reach(hand_.home_m());
        stage(Stage::kLeave);
        return;
    }
    go_to_the_place();
}

void LiftOperator::lower(double dt_s) noexcept {
    height_m_ -= profile_.descend_m_s * dt_s;
    static_cast<void>(hand_.glide(place(), 0.02, dt_s));
    if (touches_ || height_m_ < -kDeepestM) {
        low_m_ = std::max(height_m_ - kPressM, -kDeepestM);
        stage(Stage::kClose);
    }
}

void LiftOperator::close(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    height_m_ = std::max(height_m_ - 0.002 * dt_s, low_m_);
    static_cast<void>(hand_.glide(place(), 0.02, dt_s));
    if (!hand_.jaw(habit.squeezed_rad(), habit.close_rad_s, dt_s)) return;
    if (holds_) {
        stage(Stage::kLift);
    } else if (stage_s_ > 1 && ++tries_ < kTries) {
        stage(Stage::kOpen);  // nothing between the jaws: once more
    } else if (stage_s_ > 1) {
        next_round();
    }
}

void LiftOperator::lay(double dt_s) noexcept {
    height_m_ -= jaw_habits(level_).lift_m_s * dt_s;
    static_cast<void>(hand_.glide(place(), 0.03, dt_s));
    if (height_m_ <= 1e-4) next_round();
}

void LiftOperator::next_round() noexcept {
    ++round_;
    tries_ = 0;
    stage(Stage::kOpen);
}

/// One tick, by the stage of the hand.
void LiftOperator::move(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    switch (stage_) {
        case Stage::kLook:
            if (stage_s_ < profile_.look_s) break;
            if (contour_.size() < 3) {
                stage(Stage::kDone);
                break;
            }
            go_to_the_place();
            break;
        case Stage::kRise:
            rise(dt_s);
            break;
        case Stage::kReach:
            static_cast<void>(hand_.jaw(habit.open_rad, 1.5, dt_s));
            if (hand_.reached(place(), dt_s)) stage(Stage::kLower);
            break;
        case Stage::kLower:
            lower(dt_s);
            break;
        case Stage::kClose:
            close(dt_s);
            break;
        case Stage::kLift:
            height_m_ += habit.lift_m_s * dt_s;
            static_cast<void>(hand_.glide(place(), 0.03, dt_s));
            if (height_m_ >= habit.lift_m) stage(Stage::kHold);
            break;
        case Stage::kHold:
            if (stage_s_ > habit.hold_s || !holds_) stage(Stage::kLay);
            break;
        case Stage::kLay:
            lay(dt_s);
            break;
        case Stage::kOpen:
            if (hand_.jaw(habit.open_rad, 2.0, dt_s)) stage(Stage::kRise);
            break;
        case Stage::kLeave:
            static_cast<void>(hand_.jaw(0, 1.0, dt_s));
            if (hand_.reached(hand_.home_m(), dt_s)) stage(Stage::kDone);
            break;
        case Stage::kDone:
            break;
    }
}

bool LiftOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    move(dt_s);
    if (time_s_ > profile_.patience_s && stage_ < Stage::kOpen) stage(Stage::kLay);
    hands[tool_] = hand_.action(time_s_);
    return stage_ == Stage::kDone;
}

}  // namespace placode::haptics
