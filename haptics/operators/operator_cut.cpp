// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How the scripted operator cuts along the line: depth by touch, habits of the pedal, a pace that
// waits for the tissue to part, slips, and the unrest of a hand.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/operators/operator_model.h"

namespace placode::haptics {

namespace {

constexpr double kWatchBehindM = 8e-4;  // Where the eye checks the cut: behind the needle's width.
constexpr double kNextPieceM = 2.5e-3;  // The next piece is this close: go on without lifting.
constexpr double kSlipS = 0.7;          // A slip, out and back.
constexpr double kSlideMS = 0.006;      // Over what is cut already, pedal up,
constexpr double kMostSlideM = 1e-3;    // and over an opened sac no further than that.
constexpr double kMostClearM = 6e-4, kClearS = 0.2;  // how far and how fast the tip makes room
constexpr double kHandMS = 0.03;                     // no hand is faster at the tissue,
constexpr double kOffLineM = 3e-4;  // and this far from where it should be it gives no energy

}  // namespace

// On a second pass most of the line is done: energy only where something is left.
bool OperatorModel::wanted() const noexcept {
    return passes_ == 0 || line_.left_near(s_m_, kOverrunM);
}

// Heat goes on spreading for seconds: who goes over a place again lets it cool first.
bool OperatorModel::cooling() const noexcept {
    if (passes_ == 0 || !wanted()) return false;
    return line_.warm_ahead(s_m_, kOverrunM, time_s_, profile_.cool_s);
}

// Depth by touch: deeper where there is no contact, back where the force is too high.
void OperatorModel::press(double dt_s) noexcept {
    if (!wanted() || cooling() || too_near())
        press_ = std::max(press_ - 0.004 * dt_s, -2e-4);
    else if (force_n_ > profile_.force_limit_n)
        press_ -= 0.004 * dt_s;
    else if (!contact_)
        press_ += 0.0015 * dt_s;
    else
        press_ += std::clamp(profile_.press_m - press_, -0.001 * dt_s, 0.001 * dt_s);
    press_ = std::clamp(press_, -0.0005, profile_.press_limit_m);
    lift_m_ = -press_;
}

void OperatorModel::pedal_habits(double dt_s) noexcept {
    contact_s_ = contact_ ? contact_s_ + dt_s : 0;
    if (pause_s_ > 0) {
        pause_s_ -= dt_s;
        pedal_ = pedal_ && stage_s_ < profile_.settle_s;  // Energised early: stays on.
        burst_s_ = 0;
        return;
    }
    pedal_ = skip_m_ <= 0 && wanted() && !cooling() && !too_near();
    burst_s_ += dt_s;
    if (burst_s_ > profile_.burst_s) pause_s_ = profile_.pause_s;
    if (hold_s_ <= 0 && random_.uniform() < profile_.hesitate_hz * dt_s)
        hold_s_ = random_.uniform(profile_.hesitate_s);
}

void OperatorModel::advance(double dt_s) noexcept {
    double goal = profile_.cut_speed_m_s * std::max(0.0, 1 + speed_noise_);
    if (!wanted()) goal = std::max(goal, kSlideMS);
    if (pause_s_ > 0 || cooling()) goal = 0;
    if (hold_s_ > 0) {
        hold_s_ -= dt_s;
        goal = 0;
    }
    // The eye behind the tip: slower where the tissue has not parted, but not for ever.
    const bool first_bit = s_m_ - run_.begin_m < kWatchBehindM && passes_ == 0;
    const bool parted = first_bit || line_.cut(s_m_ - kWatchBehindM);
    if (!parted && wanted() && waited_s_ < profile_.wait_s) {
        goal *= 1 - profile_.watch;
        waited_s_ += pedal_ ? dt_s : 0;
    }
    if (parted) waited_s_ = 0;
    speed_ += (goal - speed_) * std::min(1.0, dt_s / 0.12);
    const size_t before = line_.index(s_m_);
    const double step = speed_ * dt_s;
    s_m_ += step;
    slid_m_ = wanted() ? 0 : slid_m_ + step;
    if (line_.index(s_m_) != before) {
        if (pedal_ || too_near()) line_.count_try(before);
        if (pedal_) line_.note_heat(before, time_s_);
        if (skip_m_ <= 0 && waited_s_ >= profile_.wait_s) waited_s_ = 0;
    }
    skip_m_ -= step;
    if (skip_m_ <= 0 && random_.uniform() < profile_.skip_per_m * step)
        skip_m_ = random_.uniform(profile_.skip_m);
}

// A slip towards the placode: out and back in a bell, with the pedal released too late.
void OperatorModel::slip(double dt_s) noexcept {
    if (slip_s_ < 0 && slips_left_ > 0 && passes_ == 0) {
        if (slip_at_m_ < 0)
            slip_at_m_ =
                s_m_ + line_.length_m() / (profile_.overshoots + 1) * random_.uniform({0.6, 1.1});
        if (s_m_ >= slip_at_m_) {
            slip_s_ = 0;
            slip_at_m_ = -1;
            --slips_left_;
        }
    }
    slip_offset_ = 0;
    if (slip_s_ < 0) return;
    slip_s_ += dt_s;
    slip_offset_ =
        profile_.overshoot_m * std::pow(std::sin(std::numbers::pi * slip_s_ / kSlipS), 2);
    if (slip_s_ > profile_.overshoot_notice_s) pedal_ = false;
    if (slip_s_ >= kSlipS) {
        slip_s_ = -1;
        slip_offset_ = 0;
        pause_s_ = profile_.pause_s;
    }
}

double OperatorModel::short_of_m() const noexcept {
    return std::max(profile_.clear_m - placode_gap_m_, profile_.clear_metal_m - metal_gap_m_);
}

// Over an opened sac the placode may lie closer to the line than planned: the tip goes further out.
void OperatorModel::keep_clear(double dt_s) noexcept {
    const double short_of = std::clamp(short_of_m(), 0.0, kMostClearM);
    clear_out_m_ += (short_of - clear_out_m_) * std::min(1.0, dt_s / kClearS);
}

void OperatorModel::do_cut(double dt_s) noexcept {
    press(dt_s);
    keep_clear(dt_s);
    pedal_habits(dt_s);
    slip(dt_s);
    if (slip_s_ < 0) advance(dt_s);
    const IncisionLine::Place f = line_.place(s_m_);
    const double lean = std::max(0.0, f.inward.dot((home_m_ - f.point).normalized()));
    const double offset = wander_smooth_ + slip_offset_ - profile_.lean_out_m * lean -
                          (passes_ > 0 ? profile_.second_out_m : 0) - clear_out_m_;
    follow(f.point + (lift_m_ + profile_.lean_up_m * lean) * f.normal + offset * f.inward, dt_s);
    // What came free meanwhile is not slid along: over an opened sac it lies elsewhere by now.
    const bool stop = line_.has_sunk() && slid_m_ > kMostSlideM;
    if (s_m_ < run_.end_m + kOverrunM && !stop) return;
    // End of the piece: the next one may be near enough to go on.
    const double here = s_m_;
    ++passes_;
    if (plan_run(here - kOverrunM) && passes_ > 1) {
        const double ahead = line_.wrapped(run_.begin_m - here + kOverrunM) - kOverrunM;
        if (ahead < kNextPieceM && !stop) {
            const double length = run_.end_m - run_.begin_m;
            run_.begin_m = here + ahead;
            run_.end_m = run_.begin_m + length;
            return;
        }
    }
    stage(Stage::kLift);
}

// Where the line jumps (from one side of a parted edge to the other) the hand has to travel, and
// what lies between is not meant to be cut.
void OperatorModel::follow(const Vec3& goal_m, double dt_s) noexcept {
    const Vec3 offset = goal_m - tip_m_;
    const double far = offset.norm(), most = kHandMS * dt_s;
    tip_m_ = far > most ? Vec3(tip_m_ + most / far * offset) : goal_m;
    if (far > kOffLineM) pedal_ = false;
}

void OperatorModel::noise(double dt_s) noexcept {
    // Ornstein-Uhlenbeck, smoothed once, so that a hand never jumps. A hand that hesitates stands
    // nearly still, and who goes over a place again takes more care.
    const double care = passes_ > 0 ? profile_.second_care : 1;
    const double pace = hold_s_ > 0 && stage_ == Stage::kCut ? 0.1 : 1;
    const auto walk = [&](double x, double sigma, double tau) {
        return x - x * dt_s / tau + sigma * std::sqrt(2 * dt_s / tau) * random_.normal();
    };
    wander_ = walk(wander_, profile_.wander_m * 1.2, profile_.wander_s / pace);
    wander_smooth_ += (care * (wander_ + profile_.wander_inward_m) - wander_smooth_) *
                      std::min(1.0, pace * dt_s / (0.4 * profile_.wander_s));
    speed_noise_ = walk(speed_noise_, profile_.speed_noise, 0.2);
}

Vec3 OperatorModel::tremor() const noexcept {
    Vec3 shake;
    for (size_t i = 0; i < 3; ++i) {
        const auto wave = [&](size_t k) {
            return std::sin(2 * std::numbers::pi * tremor_hz_[k] * time_s_ + tremor_phase_[k]);
        };
        shake[static_cast<Eigen::Index>(i)] = 0.5 * (wave(i) + wave(i + 3));
    }
    // Across the tissue less than along it: the tip leans on it.
    return profile_.tremor_m *
           (stage_ == Stage::kCut ? Vec3(shake.cwiseProduct(Vec3(1, 1, 0.4))) : shake);
}

}  // namespace placode::haptics
