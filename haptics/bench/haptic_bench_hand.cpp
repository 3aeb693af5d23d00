// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/bench/haptic_bench_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::haptics {

namespace {

constexpr int kFine = 20;
constexpr double kArmKg = 0.554, kArmNsM = 6.45, kArmNM = 135;
constexpr double kDeviceKg = 0.045, kDeviceNsM = 0.1, kEncoderM = 55e-6, kCoulombN = 0.26;

}  // namespace

double sweep_phase(double t_s) noexcept {
    const double rate = std::log(kSweepToHz / kSweepFromHz) / kSweepS;
    const double since = std::clamp(t_s - kSweepStartS, 0.0, kSweepS);
    return 2 * std::numbers::pi * kSweepFromHz / rate * std::expm1(rate * since);
}

bool Trouble::step(int i) noexcept {
    if (i >= until_) now = Kind::kNone;
    if (i < next_) return false;
    constexpr int stalls[] = {5, 50, 500};
    now = static_cast<Kind>(1 + draw_() % 6);
    int length = 1;
    if (now == Kind::kStall) length = stalls[draw_() % 3];
    if (now == Kind::kGap) length = 2 + static_cast<int>(draw_() % 59);
    if (now == Kind::kUnplug) length = 100;
    until_ = i + length;
    next_ = until_ + 800 + static_cast<int>(draw_() % 2500);
    return true;
}

void HapticBenchHand::step(const Vec3& target_m, const Vec3& force_n) noexcept {
    const double dt = kHapticBenchTickS / kFine;
    for (int i = 0; i < kFine; ++i) {
        const Vec3 hold =
            grip_.stiffness_n_m * (arm_ - device_) + grip_.damping_ns_m * (arm_v_ - device_v_);
        const Vec3 pull = kArmNM * (target_m - arm_) - kArmNsM * arm_v_ - hold;
        arm_v_ += dt / kArmKg * pull;
        arm_ += dt * arm_v_;
        device_v_ += dt / kDeviceKg * (force_n + hold - kDeviceNsM * device_v_);
        if (friction_) {
            const double speed = device_v_.norm(), loss = dt / kDeviceKg * kCoulombN;
            device_v_ *= speed > loss ? 1 - loss / speed : 0.0;
        }
        device_ += dt * device_v_;
    }
}

Vec3 HapticBenchHand::encoder_m() const noexcept {
    return kEncoderM * (device_ / kEncoderM).array().round().matrix();
}

}  // namespace placode::haptics
