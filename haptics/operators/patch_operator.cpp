// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/patch_operator.h"

#include <algorithm>
#include <cmath>

#include "haptics/operators/jaw_habits.h"

namespace placode::haptics {
namespace {

constexpr double kOverPatchM = 0.005, kBelowPatchM = 0.0025, kPatchRiseM_s = 0.01,
                 kPatchDownM_s = 0.004;
constexpr double kInsideRimM = 4e-4;   // of the rim: jaws take hold of it, not of its last thread
constexpr double kPatchThereM = 1e-4;  // between where its middle is and where it belongs
constexpr double kPatchSlowM = 0.003;  // before it is there a hand slows down
constexpr double kLeastShare = 0.15;   // of its speed
constexpr double kDrawPatienceS = 20;  // of drawing
constexpr double kPatchLooksS = 0.4;   // at what it has done
constexpr double kPatchJawRadS = 0.8;
constexpr int kMostPatchMisses = 3;  // of the jaws, before it gives up

PatchHabits patch_intermediate() {
    PatchHabits h;
    h.beside_m = 0.0015;
    h.aside_m = 5e-4;
    h.lift_m = 0.003;
    h.draw_m_s = 0.010;
    h.aim_m = 8e-4;
    h.aim_bias_m = 1.2e-3;
    h.drop_m = 0.001;
    h.press_m = 3e-4;
    h.corrections = 1;
    h.content = 0.8;
    return h;
}

PatchHabits patch_novice() {
    PatchHabits h;
    h.beside_m = 0.0045;
    h.aside_m = 1e-3;
    h.lift_m = 0.009;
    h.draw_m_s = 0.020;
    h.aim_m = 1.5e-3;
    h.aim_bias_m = 4e-3;
    h.drop_m = 0.006;
    h.press_m = 1.2e-3;
    h.corrections = 0;
    h.content = 0;
    return h;
}

Vec3 in_plane(const Vec3& v) noexcept { return {v.x(), v.y(), 0}; }

}  // namespace

const PatchHabits& patch_habits(OperatorLevel level) noexcept {
    static const std::array habits{PatchHabits{}, patch_intermediate(), patch_novice()};
    return habits[static_cast<size_t>(level)];
}

PatchOperator::PatchOperator(OperatorLevel level, uint64_t seed, size_t tool, const Vec3& home_m)
    : level_(level),
      habits_(patch_habits(level)),
      profile_(operator_profile(level)),
      hand_(profile_, seed, home_m),
      tool_(tool) {}

void PatchOperator::see(const Perception& seen) {
    goal_ = seen.practice;
    patch_ = seen.patch && seen.practice.margin;
    corner_ = seen.patch_corner_m;
    touches_ = seen.touches[tool_];
    holds_ = seen.holds[tool_];
}

void PatchOperator::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
}

Vec3 PatchOperator::patch_middle() const noexcept {
    return 0.25 * (corner_[0] + corner_[1] + corner_[2] + corner_[3]);
}

/// Middle of the line that the patch shall reach, at the patch's height.
Vec3 PatchOperator::wanted_middle() const noexcept {
    Vec3 sum = Vec3::Zero();
    for (const auto& p : goal_.margin_m)
        sum += Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), 0);
    return sum / static_cast<double>(goal_.margin_m.size());
}

double PatchOperator::laid_share() const noexcept {
    return static_cast<double>(std::count(goal_.traced.begin(), goal_.traced.end(), 1)) /
           static_cast<double>(goal_.traced.size());
}

/// Where the way from its middle crosses the patch's rim, a little inside.
Vec3 PatchOperator::rim_towards(const Vec3& offset) const noexcept {
    const Vec3 middle = patch_middle();
    const Vec3 along = in_plane(offset).normalized();
    double nearest = 1;
    Vec3 rim = middle;
    for (size_t i = 0; i < corner_.size(); ++i) {
        const Vec3 a = corner_[i] - middle, side = corner_[(i + 1) % corner_.size()] - corner_[i];
        const double turn = along.x() * side.y() - along.y() * side.x();
        if (std::abs(turn) < 1e-9) continue;  // parallel [m]
        const double out = (a.x() * side.y() - a.y() * side.x()) / turn;
        const double at = (a.x() * along.y() - a.y() * along.x()) / turn;
        if (out <= 0 || at < 0 || at > 1 || out >= nearest) continue;
        nearest = out;
        rim = corner_[i] + at * side;
    }
    return rim - kInsideRimM * along;
}

/// Where to take it now, and where its middle shall come to.
void PatchOperator::begin() noexcept {
    const Vec3 offset = in_plane(wanted_middle() - patch_middle());
    const Vec3 along = offset.normalized(), across = Vec3::UnitZ().cross(along);
    const double care = corrected_ > 0 ? 0.3 : 1;  // who looks again looks better
    const double end = hand_.random().uniform() < 0.5 ? -1 : 1;
    const double beside =
        care * (end * habits_.beside_m + habits_.aside_m * hand_.random().normal());
    grip_ = rim_towards(offset) + beside * across;
    error_ = -care * habits_.aim_bias_m * along;
    for (int k = 0; k < 2; ++k) error_[k] += care * habits_.aim_m * hand_.random().normal();
    hand_.reach(grip_ + kOverPatchM * Vec3::UnitZ(), Vec3::UnitZ());
    stage(Stage::kReach);
}

void PatchOperator::down(double dt_s) noexcept {
    const bool deepest = hand_.tip_m().z() < grip_.z() - kBelowPatchM;
    if (touches_ || deepest) {
        touched_z_ = hand_.tip_m().z();
        stage(Stage::kClose);
        return;
    }
    static_cast<void>(
        hand_.glide(hand_.tip_m() - Vec3(0, 0, 2 * kPatchDownM_s * dt_s), kPatchDownM_s, dt_s));
}

void PatchOperator::close(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    Vec3 goal = hand_.tip_m();
    goal.z() = touched_z_ - habits_.press_m;
    static_cast<void>(hand_.glide(goal, 0.002, dt_s));
    if (!hand_.jaw(habit.squeezed_rad(), kPatchJawRadS, dt_s)) return;
    if (holds_) {
        gripped_z_ = touched_z_;
        stage(Stage::kLift);
    } else if (stage_s_ > 1.2) {
        ++misses_;
        stage(Stage::kOpen);
    }
}

/// With its side lifted, until its middle is seen where it belongs.
void PatchOperator::draw(double dt_s) noexcept {
    const Vec3 left = in_plane(wanted_middle() + error_ - patch_middle());
    const double away = left.norm();
    if (away < kPatchThereM || stage_s_ > kDrawPatienceS || !holds_) {
        stage(Stage::kLay);
        return;
    }
    const double speed = habits_.draw_m_s * std::clamp(away / kPatchSlowM, kLeastShare, 1.0);
    static_cast<void>(hand_.glide(hand_.tip_m() + left, speed, dt_s));
}

void PatchOperator::lay(double dt_s) noexcept {
    Vec3 goal = hand_.tip_m();
    goal.z() = gripped_z_ + habits_.drop_m;
    if (hand_.glide(goal, kPatchDownM_s, dt_s)) stage(Stage::kOpen);
}

void PatchOperator::rise(double dt_s) noexcept {
    static_cast<void>(
        hand_.glide(hand_.tip_m() + Vec3(0, 0, 2 * kPatchRiseM_s * dt_s), kPatchRiseM_s, dt_s));
    if (hand_.tip_m().z() < grip_.z() + kOverPatchM) return;
    stage(Stage::kJudge);
}

void PatchOperator::judge() noexcept {
    if (stage_s_ < kPatchLooksS) return;
    const bool missed = misses_ > 0 && goal_.step.kind == sim::PracticeKind::kPatchTake;
    if (missed && misses_ < kMostPatchMisses) {
        begin();
    } else if (!missed && corrected_ < habits_.corrections && laid_share() < habits_.content) {
        ++corrected_;
        begin();
    } else {
        hand_.reach(hand_.home_m());
        stage(Stage::kLeave);
    }
}

bool PatchOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    const double open_rad = jaw_habits(level_).open_rad;
    switch (stage_) {
        case Stage::kLook:
            if (stage_s_ > profile_.look_s && patch_) begin();
            if (stage_s_ > profile_.look_s + kDrawPatienceS) stage(Stage::kDone);
            break;
        case Stage::kReach:
            static_cast<void>(hand_.jaw(open_rad, 1.5, dt_s));
            if (hand_.reached(grip_ + kOverPatchM * Vec3::UnitZ(), dt_s)) stage(Stage::kDown);
            break;
        case Stage::kDown:
            down(dt_s);
            break;
        case Stage::kClose:
            close(dt_s);
            break;
        case Stage::kLift:
            static_cast<void>(
                hand_.glide(hand_.tip_m() + Vec3(0, 0, habits_.lift_m), habits_.draw_m_s, dt_s));
            if (hand_.tip_m().z() > gripped_z_ + habits_.lift_m) stage(Stage::kDraw);
            break;
        case Stage::kDraw:
            draw(dt_s);
            break;
        case Stage::kLay:
            lay(dt_s);
            break;
        case Stage::kOpen:
            if (hand_.jaw(open_rad, 2.0, dt_s)) stage(Stage::kRise);
            break;
        case Stage::kRise:
            rise(dt_s);
            break;
        case Stage::kJudge:
            judge();
            break;
        case Stage::kLeave:
            if (hand_.reached(hand_.home_m(), dt_s) && stage_s_ > 2) stage(Stage::kDone);
            break;
        case Stage::kDone:
            break;
    }
    hands[tool_] = hand_.action(time_s_);
    return stage_ == Stage::kDone;
}

}  // namespace placode::haptics
