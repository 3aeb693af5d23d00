// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What scripted hands share: free motion of minimum jerk (Flash & Hogan 1985), steady motion at a
// speed, jaws that open and close at the speed of fingers, tremor of 8 to 12 Hz.

#include "haptics/device.h"
#include "haptics/operators/operator_profile.h"
#include "haptics/operators/operator_random.h"

namespace placode::haptics {

/// What one hand does now with one instrument.
struct HandAction {
    Vec3 tip_m = Vec3::Zero();    ///< Tip in W, with tremor.
    Vec3 opening = Vec3::Zero();  ///< Direction in which jaws open, in W; zero = as it comes.
    Vec3 across = Vec3::Zero();  ///< Direction of the jaws' width (+x of T): says it without doubt.
    double jaw_rad = 0;
    uint8_t pedals = 0;
    bool engaged = false;  ///< False: this instrument is outside, its port is free.
};

/// One hand in motion.
class HandMotion {
 public:
    HandMotion(const OperatorProfile& profile, uint64_t seed, const Vec3& home_m);

    /// Begins a free motion, carried over the tissue in a small arc along `up`.
    void reach(const Vec3& goal_m, const Vec3& up = Vec3::Zero());
    /// Goes on with a free motion towards a goal that may have moved. True when it is there.
    [[nodiscard]] bool reached(const Vec3& goal_m, double dt_s) noexcept;
    /// Straight on at a speed. True when there.
    [[nodiscard]] bool glide(const Vec3& goal_m, double speed_m_s, double dt_s) noexcept;
    /// Jaws towards an opening at `rate` [rad/s]. True when there.
    [[nodiscard]] bool jaw(double goal_rad, double rate, double dt_s) noexcept;

    [[nodiscard]] const Vec3& tip_m() const noexcept { return tip_m_; }
    [[nodiscard]] const Vec3& home_m() const noexcept { return home_m_; }
    [[nodiscard]] double jaw_rad() const noexcept { return jaw_rad_; }
    [[nodiscard]] OperatorRandom& random() noexcept { return random_; }
    /// Tip with tremor, jaws.
    [[nodiscard]] HandAction action(double time_s) const noexcept;

 private:
    OperatorProfile profile_;
    OperatorRandom random_;
    Vec3 home_m_, tip_m_, from_m_, up_ = Vec3::Zero();
    double jaw_rad_ = 0, spent_s_ = 0, whole_s_ = 1;
    std::array<double, 6> tremor_phase_{}, tremor_hz_{};
};

/// A scripted operator: sees what a person sees, moves all hands.
class ScriptedOperator {
 public:
    virtual ~ScriptedOperator() = default;
    virtual void see(const Perception& seen) = 0;
    /// Next wish of all hands (one per tool), `dt_s` after the last. True = done with the task.
    [[nodiscard]] virtual bool act(double dt_s, std::span<HandAction> hands) noexcept = 0;
};

}  // namespace placode::haptics
