// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Virtual coupling between one hand and its tool, with everything that keeps a force safe: own
// velocity filter, passivity controller, limits, ramps, watchdog. The law is a spring and damper
// to the last published tool state, so its stability does not depend on the rate of the physics
// (Colgate, Stanley & Brown 1995; passivity control: Hannaford & Ryu 2002).

#include <cstdint>

#include "haptics/servo.h"

namespace placode::haptics {

/// What one tick of the coupling gives.
struct CouplingResult {
    Vec3 force_n = Vec3::Zero();  ///< For the device, in D.
    bool trusted = false;  ///< The hand may move the tool; false after a fault or a lost device.
    bool clamped = false, fault = false, stale = false;
};

/// One hand. Servo thread only; no allocation, never throws.
class Coupling {
 public:
    explicit Coupling(const CouplingSettings& settings) noexcept;

    /// One tick. `tip_m`: where the hand wants the tip, in W; `feedback`: newest tool state;
    /// `trocar`: maps the force to the device at the current pose.
    CouplingResult tick(int64_t t_ns, const DeviceState& device, const Vec3& tip_m,
                        const sim::ToolFeedback& feedback, const Trocar& trocar) noexcept;
    /// True when the state may be used: finite, ready, no jump since the last one. Ticks call it.
    [[nodiscard]] bool plausible(const DeviceState& device, double dt_s) const noexcept;
    /// Starts the ramp to zero that ends a session; takes 50 ms.
    void release() noexcept { releasing_ = true; }
    /// Energy that the virtual side has absorbed so far [J]; negative = it has created energy.
    [[nodiscard]] double observed_energy_j() const noexcept { return energy_j_; }

 private:
    [[nodiscard]] bool trust(int64_t t_ns, const DeviceState& device, const Vec3& tip_m,
                             double dt_s, bool& fault) noexcept;
    void follow_tool(int64_t t_ns, const sim::ToolFeedback& feedback) noexcept;
    void reanchor(const Vec3& tip_m) noexcept;
    void go_silent() noexcept;
    [[nodiscard]] Vec3 spring(const Vec3& tip_m, const Vec3& tip_velocity, double age_s) noexcept;
    [[nodiscard]] Vec3 passivity(const Vec3& force, double dt_s) noexcept;
    [[nodiscard]] Vec3 limit(Vec3 force, double dt_s, bool& clamped) noexcept;

    CouplingSettings settings_;
    // hand
    bool seen_ = false;  // a plausible state was seen
    int64_t last_ns_ = 0;
    Vec3 last_position_ = Vec3::Zero(), velocity_ = Vec3::Zero();  // in D
    Vec3 last_tip_ = Vec3::Zero(), tip_velocity_ = Vec3::Zero();   // in W
    double distrust_s_ = 0;                                        // left after a fault
    // tool
    bool tool_seen_ = false;
    double tool_time_s_ = -1;
    int64_t tool_ns_ = 0;
    Vec3 tool_ = Vec3::Zero(), tool_velocity_ = Vec3::Zero();
    // force
    bool silent_ = true, releasing_ = false;
    double ramp_ = 0, release_ = 1;
    Vec3 offset_ = Vec3::Zero();  // makes the force zero where the ramp starts
    Vec3 limited_ = Vec3::Zero(), sent_ = Vec3::Zero();
    double energy_j_ = 0, heat_n2_ = 0;
};

}  // namespace placode::haptics
