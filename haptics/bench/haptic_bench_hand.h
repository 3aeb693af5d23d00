// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands at the port instead of a person and a device: arm, grip and mechanics of a desktop
// arm, the sweep of a machine that moves it, and the troubles of a soak. Deterministic. Numbers and
// sources: haptic_bench.h.

#include <random>

#include "haptics/bench/haptic_bench.h"

namespace placode::haptics {

inline constexpr double kHapticBenchTickS = 1e-3;
inline constexpr double kSweepStartS = 1.5, kSweepS = 20, kSweepFromHz = 0.5, kSweepToHz = 50;

/// Phase of the sweep [rad]: its frequency grows by the same factor every second.
[[nodiscard]] double sweep_phase(double t_s) noexcept;

/// What goes wrong next in a soak, and when.
class Trouble {
 public:
    enum class Kind : uint8_t { kNone, kStall, kGap, kBack, kNan, kJump, kUnplug };
    explicit Trouble(uint64_t seed) noexcept : draw_(seed) {}
    /// Goes on to tick `i`; true when something begins there.
    bool step(int i) noexcept;
    Kind now = Kind::kNone;

 private:
    std::minstd_rand draw_;  // its numbers are the same everywhere
    int next_ = 1500, until_ = 0;
};

/// Arm, grip and device: three axes alike.
class HapticBenchHand {
 public:
    HapticBenchHand(const HandModel& grip, bool friction) : grip_(grip), friction_(friction) {}
    /// One tick of 1 ms with the arm aiming at `target_m` and the motors giving `force_n`.
    void step(const Vec3& target_m, const Vec3& force_n) noexcept;
    /// A machine moves the device.
    void place(const Vec3& device_m) noexcept { device_ = device_m; }
    [[nodiscard]] const Vec3& device_m() const noexcept { return device_; }
    [[nodiscard]] Vec3 encoder_m() const noexcept;  ///< The device's place in its encoder's steps.

 private:
    HandModel grip_;
    bool friction_;
    Vec3 arm_ = Vec3::Zero(), arm_v_ = Vec3::Zero();
    Vec3 device_ = Vec3::Zero(), device_v_ = Vec3::Zero();
};

}  // namespace placode::haptics
