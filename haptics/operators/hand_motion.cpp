// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/hand_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/minimum_jerk.h"

namespace placode::haptics {

namespace {

constexpr double kLeastMotionS = 0.35;
constexpr double kArc = 0.15;  // height of the arc over the way

}  // namespace

HandMotion::HandMotion(const OperatorProfile& profile, uint64_t seed, const Vec3& home_m)
    : profile_(profile), random_(seed), home_m_(home_m), tip_m_(home_m), from_m_(home_m) {
    for (auto& phase : tremor_phase_) phase = 2 * std::numbers::pi * random_.uniform();
    for (auto& hz : tremor_hz_) hz = random_.uniform({8, 12});
}

void HandMotion::reach(const Vec3& goal_m, const Vec3& up) {
    from_m_ = tip_m_;
    up_ = up;
    spent_s_ = 0;
    whole_s_ = std::max(kLeastMotionS, (goal_m - tip_m_).norm() / profile_.free_speed_m_s);
}

bool HandMotion::reached(const Vec3& goal_m, double dt_s) noexcept {
    spent_s_ += dt_s;
    const double x = minimum_jerk(spent_s_ / whole_s_);
    const double arc = kArc * (goal_m - from_m_).norm() * 4 * x * (1 - x);
    tip_m_ = from_m_ + x * (goal_m - from_m_) + arc * up_;
    return spent_s_ >= whole_s_;
}

bool HandMotion::glide(const Vec3& goal_m, double speed_m_s, double dt_s) noexcept {
    const Vec3 offset = goal_m - tip_m_;
    const double length = offset.norm(), step = speed_m_s * dt_s;
    if (length <= step) {
        tip_m_ = goal_m;
        return true;
    }
    tip_m_ += offset * (step / length);
    return false;
}

bool HandMotion::jaw(double goal_rad, double rate, double dt_s) noexcept {
    const double path = goal_rad - jaw_rad_, step = rate * dt_s;
    jaw_rad_ += std::clamp(path, -step, step);
    return std::abs(path) <= step;
}

HandAction HandMotion::action(double time_s) const noexcept {
    HandAction out;
    out.tip_m = tip_m_;
    for (size_t i = 0; i < 3; ++i) {
        const auto wave = [&](size_t k) {
            return std::sin(2 * std::numbers::pi * tremor_hz_[k] * time_s + tremor_phase_[k]);
        };
        out.tip_m[static_cast<Eigen::Index>(i)] +=
            profile_.tremor_m * 0.5 * (wave(i) + wave(i + 3));
    }
    out.jaw_rad = jaw_rad_;
    out.engaged = true;
    return out;
}

}  // namespace placode::haptics
