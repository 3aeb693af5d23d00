// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/operator_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/minimum_jerk.h"

namespace placode::haptics {

namespace {

constexpr double kTraceHoverM = 0.004;  // Height of free motion over the contour.
constexpr double kMostSinkS = 10;       // a line that sinks and does not come to rest
constexpr double kSeekBridgesS = 0.3;   // one look at what still hangs on
constexpr double kForgetContourS = 4;   // Nothing to do is noticed after this.

}  // namespace

OperatorModel::OperatorModel(const OperatorProfile& profile, uint64_t seed, const Vec3& home_tip_m)
    : profile_(profile), random_(seed), home_m_(home_tip_m), tip_m_(home_tip_m) {
    for (auto& phase : tremor_phase_) phase = 2 * std::numbers::pi * random_.uniform();
    for (auto& hz : tremor_hz_) hz = random_.uniform({8, 12});
    slips_left_ = profile_.overshoots;
    press_ = profile_.press_m;
}

void OperatorModel::see(const Perception& seen, const sim::ToolFeedback& own) {
    line_.see(seen, tip_m_, stage_ == Stage::kWatch ? stage_s_ : -1);
    contact_ = seen.in_contact;
    force_n_ = own.force_n.allFinite() ? own.force_n.norm() : 0;
    placode_gap_m_ = seen.placode_gap_m[0];
    metal_gap_m_ = seen.placode_metal_gap_m[0];
}

bool OperatorModel::plan_run(double from_m) noexcept {
    return line_.next_run(from_m, profile_.tries, profile_.notice_gap_m, run_);
}

void OperatorModel::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
}

void OperatorModel::begin_move(const Vec3& from_m) noexcept {
    move_from_ = from_m;
    s_m_ = run_.begin_m - (passes_ > 0 ? kOverrunM : 0);
    const IncisionLine::Place f = line_.place(s_m_);
    const double distance = (f.point + kTraceHoverM * f.normal - from_m).norm();
    if (stage_ != Stage::kMove) pieces_left_ = profile_.submovements;
    --pieces_left_;
    move_s_ = std::max(0.35, distance / profile_.free_speed_m_s);
    move_error_.setZero();
    if (pieces_left_ > 0)
        for (int i = 0; i < 3; ++i) move_error_[i] = profile_.aim_error_m * random_.normal() / 1.7;
    lift_m_ = kTraceHoverM;
    stage(Stage::kMove);
}

void OperatorModel::do_move(double) noexcept {
    const IncisionLine::Place f = line_.place(s_m_);
    const Vec3 goal = f.point + kTraceHoverM * f.normal + move_error_;
    const double x = minimum_jerk(stage_s_ / move_s_);
    // A small arc: the tip is carried over the tissue, not through it.
    const double arc = 0.15 * (goal - move_from_).norm() * 4 * x * (1 - x);
    tip_m_ = move_from_ + x * (goal - move_from_) + arc * f.normal;
    if (stage_s_ < move_s_ + (pieces_left_ > 0 ? 0.25 : 0.05)) return;
    if (pieces_left_ > 0) {
        begin_move(tip_m_);
        return;
    }
    wander_ = wander_smooth_ = 0;
    // Who energises too early does so at a height from which the descent takes that long.
    early_lift_m_ =
        random_.uniform() < profile_.early_chance ? profile_.early_s * profile_.descend_m_s : -1;
    stage(Stage::kDescend);
}

void OperatorModel::do_descend(double dt_s) noexcept {
    // Slower near the tissue; stops at contact.
    const double speed = std::min(profile_.descend_m_s * 2,
                                  profile_.descend_m_s * (0.4 + 300 * std::max(0.0, lift_m_)));
    lift_m_ = std::max(lift_m_ - speed * dt_s, -profile_.press_limit_m);
    pedal_ = lift_m_ < early_lift_m_;
    contact_s_ = contact_ ? contact_s_ + dt_s : 0;
    const bool bottom = lift_m_ <= -profile_.press_limit_m;
    const IncisionLine::Place f = line_.place(s_m_);
    tip_m_ = f.point + lift_m_ * f.normal;
    if (contact_s_ < 0.02 && !bottom) return;
    press_ = -lift_m_;
    burst_s_ = 0;
    pause_s_ = profile_.settle_s;
    speed_ = waited_s_ = hold_s_ = skip_m_ = slid_m_ = 0;
    stage(Stage::kCut);
}

void OperatorModel::do_lift(double dt_s) noexcept {
    pedal_ = false;
    // From where the tip is: it may have been led beside the line.
    const double rise = std::min(0.03, 0.1 * stage_s_) * dt_s;
    lift_m_ += rise;
    tip_m_ += rise * line_.place(s_m_).normal;
    if (lift_m_ < kTraceHoverM) return;
    if (line_.sinks() && !line_.freed()) {
        stage(Stage::kWatch);
        return;
    }
    if (time_s_ < profile_.patience_s && !line_.freed())
        next_or_leave(s_m_);
    else
        leave();
}

void OperatorModel::next_or_leave(double from_m) noexcept {
    if (plan_run(from_m)) {
        begin_move(tip_m_);
    } else if (profile_.seeks_bridges && line_.placode_hangs_on() && !line_.by_bridges()) {
        line_.seek_bridges();
        stage(Stage::kWatch);
    } else {
        leave();
    }
}

void OperatorModel::leave() noexcept {
    move_from_ = tip_m_;
    move_s_ = std::max(0.5, (home_m_ - tip_m_).norm() / profile_.free_speed_m_s);
    stage(Stage::kLeave);
}

OperatorAction OperatorModel::act(double dt_s) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    noise(dt_s);
    const bool work = stage_ == Stage::kMove || stage_ == Stage::kDescend || stage_ == Stage::kCut;
    if (work && (time_s_ > profile_.patience_s || line_.sinks() || line_.freed()))
        stage(Stage::kLift);
    if (!line_.known() && stage_ != Stage::kLook) stage(Stage::kDone);
    switch (stage_) {
        case Stage::kLook:
            if (stage_s_ > profile_.look_s && line_.start_m() >= 0 && plan_run(line_.start_m()))
                begin_move(tip_m_);
            else if (stage_s_ > profile_.look_s + kForgetContourS)
                stage(Stage::kDone);
            break;
        case Stage::kMove:
            do_move(dt_s);
            break;
        case Stage::kDescend:
            do_descend(dt_s);
            break;
        case Stage::kCut:
            do_cut(dt_s);
            break;
        case Stage::kLift:
            do_lift(dt_s);
            break;
        case Stage::kWatch:
            if (line_.sinks() && stage_s_ < kMostSinkS) break;
            if (line_.by_bridges() && stage_s_ < kSeekBridgesS) break;
            next_or_leave(line_.start_m());
            break;
        case Stage::kLeave:
            tip_m_ = move_from_ + minimum_jerk(stage_s_ / move_s_) * (home_m_ - move_from_);
            if (stage_s_ > move_s_ + 0.3) stage(Stage::kDone);
            break;
        case Stage::kDone:
            break;
    }
    OperatorAction action;
    action.tip_m = tip_m_ + tremor();
    const bool energy = stage_ == Stage::kDescend || stage_ == Stage::kCut;
    action.pedals = energy && pedal_ ? sim::kPedalCut : 0;
    action.finish = stage_ == Stage::kDone;
    return action;
}

}  // namespace placode::haptics
