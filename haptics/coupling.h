// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Virtual coupling between one hand and its tool, with everything that keeps a force safe. The law
// is a spring and damper to the last published tool state, so its stability does not depend on the
// rate of the physics (Colgate, Stanley & Brown 1995). Zero force on any doubt.

#include <cstdint>

#include "haptics/safety.h"
#include "haptics/trocar.h"

namespace placode::haptics {

/// What one tick of the coupling gives.
struct CouplingResult {
    Vec3 force_n = Vec3::Zero();  ///< For the device, in D.
    bool trusted = false;    ///< The hand may move the tool; false after a fault or a lost device.
    bool clamped = false;    ///< The ceiling of the force acted.
    bool slewed = false;     ///< The limit of its rise acted.
    bool fault = false;      ///< A doubt began in this tick.
    bool stale = false;      ///< The tool state is old; the force fades.
    bool passive = false;    ///< The passivity controller took energy back.
    bool silent = false;     ///< No force on purpose: a doubt, no tool, or the way back.
    bool hot = false;        ///< Motor heat has lowered the ceiling.
    bool compared = false;   ///< At rest: the force was held against the solver's,
    bool differing = false;  ///< and is more than 5 % from it.
    double tool_age_s = 0;
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
    /// Least energy that the virtual side had absorbed at any time [J]; negative = it created some.
    [[nodiscard]] double least_energy_j() const noexcept { return passivity_.least_j(); }
    [[nodiscard]] double rms_force_n() const noexcept { return heat_.rms_n(); }
    [[nodiscard]] const CouplingSettings& settings() const noexcept { return settings_; }

 private:
    [[nodiscard]] bool trust(int64_t t_ns, const DeviceState& device, const Vec3& tip_m,
                             double dt_s, bool& fault) noexcept;
    void follow_tool(int64_t t_ns, const sim::ToolFeedback& feedback) noexcept;
    void clock_jumped(int64_t t_ns) noexcept;
    void reanchor(const Vec3& tip_m) noexcept;
    void go_silent() noexcept;
    [[nodiscard]] Vec3 spring(const Vec3& tip_m, const Vec3& tip_velocity, double age_s) noexcept;
    void compare(const Vec3& tip_m, const Vec3& solver_n, CouplingResult& out) const noexcept;
    [[nodiscard]] Vec3 limit(const Vec3& force, float motor_heat, double dt_s,
                             CouplingResult& out) noexcept;

    CouplingSettings settings_;
    // hand
    bool seen_ = false;  // a plausible state was seen
    int64_t last_ns_ = 0;
    Vec3 last_position_ = Vec3::Zero();  // in D
    Vec3 last_tip_ = Vec3::Zero();       // in W
    VelocityFilter velocity_, tip_velocity_;
    double distrust_s_ = 0;  // left after a fault
    double uneven_s_ = 0;    // left after a gap of the servo
    // tool
    Watchdog watchdog_;
    double tool_time_s_ = -1;
    LatencyMeter latency_;
    Vec3 tool_ = Vec3::Zero();
    VelocityFilter tool_velocity_;
    // force
    bool silent_ = true, releasing_ = false;
    bool apart_ = true;  // hand and tool have to meet before a force may begin
    double ramp_ = 0, release_ = 1;
    Vec3 offset_ = Vec3::Zero();  // makes the force zero where the ramp starts
    Vec3 sent_ = Vec3::Zero();
    ForceLimiter limiter_;
    PassivityController passivity_;
    ThermalBudget heat_;
};

}  // namespace placode::haptics
