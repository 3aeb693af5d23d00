// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/irrigate_operator.h"

#include <algorithm>
#include <cmath>

namespace placode::haptics {
namespace {

constexpr double kBesideM = 0.0010;  // the jet scours most a little beside where it lands
constexpr double kOverFluidM = 0.004, kFluidDownM_s = 0.004, kFluidRiseM_s = 0.012;
constexpr double kLeastAwayM = 0.003;
constexpr double kSuckS = 2.5;  // at one place
constexpr double kSuckMoveM_s = 0.003;
constexpr int kMostSucks = 14, kMostTries = 4;

IrrigateHabits irrigate_intermediate() {
    IrrigateHabits h;
    h.away_m = 0.0072;
    h.away_noise_m = 8e-4;
    h.aim_m = 7e-4;
    h.suck_gap_m = 4.5e-4;
    h.suck_noise_m = 1e-4;
    h.blind = 0.5;
    h.content_m3 = 4e-8;
    h.run_on_s = 0.4;
    return h;
}

IrrigateHabits irrigate_novice() {
    IrrigateHabits h;
    h.away_m = 0.0045;
    h.away_noise_m = 1.2e-3;
    h.aim_m = 1.3e-3;
    h.wash_s = 1.5;
    h.suck_gap_m = 1e-4;
    h.suck_noise_m = 2e-4;
    h.bite_m = 4e-4;
    h.blind = 1;
    h.left_behind = 2;
    h.content_m3 = 3e-8;
    h.run_on_s = 1;
    return h;
}

}  // namespace

const IrrigateHabits& irrigate_habits(OperatorLevel level) noexcept {
    static const std::array habits{IrrigateHabits{}, irrigate_intermediate(), irrigate_novice()};
    return habits[static_cast<size_t>(level)];
}

IrrigateOperator::IrrigateOperator(OperatorLevel level, uint64_t seed, size_t tool,
                                   const sim::ToolSpec& spec, const Vec3& home_m)
    : habits_(irrigate_habits(level)),
      profile_(operator_profile(level)),
      hand_(profile_, seed, home_m),
      tool_(tool),
      pivot_(spec.pivot_m) {}

void IrrigateOperator::see(const Perception& seen) {
    stuck_ = seen.stuck_left;
    floating_ = seen.floating_left;
    standing_m3_ = seen.standing_m3;
    hidden_ = seen.hidden;
    stuck_m_ = seen.stuck_m;
    fluid_m_ = seen.fluid_m;
    tip_gap_m_ = seen.tip_gap_m;
    touches_ = seen.touches[tool_];
}

void IrrigateOperator::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
}

Vec3 IrrigateOperator::jet_place(const Vec3& target, double away_m) const noexcept {
    const Vec3 along = (target - pivot_).normalized();
    return target - away_m * along;
}

/// What is next: the jet while debris is stuck and not too much fluid stands, else the sucker.
void IrrigateOperator::choose() noexcept {
    pedals_ = 0;
    const bool wash = stuck_ > habits_.left_behind && tries_ < kMostTries * 20;
    const bool flooded = hidden_ > habits_.blind && standing_m3_ > habits_.content_m3;
    if (wash && !flooded) {
        // Beside it, on the near side: the jet runs over it.
        Vec3 away = pivot_ - stuck_m_;
        away.z() = 0;
        for (int k = 0; k < 2; ++k) error_[k] = habits_.aim_m * hand_.random().normal();
        target_ = stuck_m_ + kBesideM * away.normalized() + error_;
        away_m_ =
            std::max(kLeastAwayM, habits_.away_m + habits_.away_noise_m * hand_.random().normal() -
                                      habits_.nearer_m * (tries_ % kMostTries));
        stuck_before_ = stuck_;
        place_ = jet_place(target_, away_m_);
        hand_.reach(place_);
        stage(Stage::kAim);
        return;
    }
    const bool wet = standing_m3_ > habits_.content_m3 || floating_ > habits_.left_behind;
    if ((wet || flooded) && sucks_ < kMostSucks) {
        ++sucks_;
        place_ = fluid_m_ + Vec3(0, 0, kOverFluidM);
        gap_m_ = std::max(0.0, habits_.suck_gap_m + habits_.suck_noise_m * hand_.random().normal());
        hand_.reach(place_);
        stage(Stage::kOver);
        return;
    }
    hand_.reach(hand_.home_m());
    stage(Stage::kLeave);
}

void IrrigateOperator::wash(double dt_s) noexcept {
    pedals_ = sim::kPedalCut;
    static_cast<void>(hand_.glide(place_, 0.004, dt_s));
    const bool off = stuck_ < stuck_before_;
    if (!off && stage_s_ < habits_.wash_s) return;
    tries_ = off ? 0 : tries_ + 1;
    stage(Stage::kChoose);
}

/// Follows the fluid along the ground.
void IrrigateOperator::suck(double dt_s) noexcept {
    pedals_ = sim::kPedalCoag;
    const double wanted = gap_m_ - (std::fmod(stage_s_, 1.0) > 0.6 ? habits_.bite_m : 0);
    // Up first where the ground rises.
    const double most = kSuckMoveM_s * dt_s, care = tip_gap_m_ < 0.7 * wanted ? 0.2 : 1;
    Vec3 along = fluid_m_ - hand_.tip_m();
    along.z() = 0;
    if (along.norm() > care * most) along *= care * most / along.norm();
    along.z() = std::clamp(wanted - tip_gap_m_, -most, 1.5 * most);
    static_cast<void>(hand_.glide(hand_.tip_m() + along, 1, dt_s));
    const bool dry = standing_m3_ <= habits_.content_m3 && floating_ <= habits_.left_behind;
    if (!dry && stage_s_ < kSuckS) return;
    stage(Stage::kRise);
}

bool IrrigateOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    switch (stage_) {
        case Stage::kLook:
            if (stage_s_ > profile_.look_s) stage(Stage::kChoose);
            break;
        case Stage::kChoose:
            if (stage_s_ > habits_.run_on_s) choose();
            break;
        case Stage::kAim:
            if (hand_.reached(place_, dt_s)) stage(Stage::kWash);
            break;
        case Stage::kWash:
            wash(dt_s);
            break;
        case Stage::kOver:
            if (hand_.reached(place_, dt_s)) stage(Stage::kDown);
            break;
        case Stage::kDown:
            pedals_ = sim::kPedalCoag;
            static_cast<void>(hand_.glide(hand_.tip_m() - Vec3(0, 0, 2 * kFluidDownM_s * dt_s),
                                          kFluidDownM_s, dt_s));
            if (tip_gap_m_ < gap_m_ + 3e-4 || touches_ || stage_s_ > 3) stage(Stage::kSuck);
            break;
        case Stage::kSuck:
            suck(dt_s);
            break;
        case Stage::kRise:
            pedals_ = 0;
            static_cast<void>(hand_.glide(hand_.tip_m() + Vec3(0, 0, 2 * kFluidRiseM_s * dt_s),
                                          kFluidRiseM_s, dt_s));
            if (stage_s_ > 0.3) stage(Stage::kChoose);
            break;
        case Stage::kLeave:
            if (hand_.reached(hand_.home_m(), dt_s) && stage_s_ > 1) stage(Stage::kDone);
            break;
        case Stage::kDone:
            break;
    }
    hands[tool_] = hand_.action(time_s_);
    hands[tool_].pedals = pedals_;
    return stage_ == Stage::kDone;
}

}  // namespace placode::haptics
