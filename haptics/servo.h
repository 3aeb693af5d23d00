// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From hands to tool inputs and from tool feedback to forces. In lock step (scripts, replay) the
// caller ticks it; otherwise a 1 kHz thread does. Force is zero on any doubt.

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "haptics/device.h"
#include "haptics/trocar.h"

namespace placode::haptics {

/// Limits of the force law; defaults for a desktop arm of the Touch class.
struct CouplingSettings {
    double stiffness_n_m = 300;
    double damping_ns_m = 1.5;
    double velocity_cutoff_hz = 100;
    double max_force_n = 3.0;
    double slew_n_s = 200, slew_ramping_n_s = 30;
    double ramp_s = 0.5;
    double fade_after_s = 0.010, zero_after_s = 0.050;  ///< Age of the tool state.
    double jump_m = 0.005;                              ///< Per ms; more is a fault.
    double continuous_force_n = 0.88;                   ///< Allowed rms over `thermal_window_s`.
    double thermal_window_s = 60, thermal_floor_n = 0.8;
    double extrapolate_s = 0.004;      ///< Longest extrapolation of the tool state.
    double recover_s = 0.1;            ///< Good ticks needed after a fault.
    double servo_gap_s = 0.005;        ///< A longer gap between ticks ramps in again.
    double passivity_ns_m = 20;        ///< Largest damping that the passivity controller adds.
    double passivity_store_j = 0.005;  ///< Cap of the observed surplus, so that it is forgotten.
};

/// Counters of the loop, stored with the attempt as its haptic certificate.
struct ServoHealth {
    uint64_t ticks = 0, overruns = 0, clamped = 0, faults = 0, stale = 0;
    double period_p50_us = 0, period_p99_us = 0, period_p999_us = 0, period_max_us = 0;
    bool real_time = false;  ///< SCHED_FIFO was granted.
    std::string remark;      ///< What is missing and how to grant it.
};

/// Owns the device group and one trocar and coupling per hand.
class Servo {
 public:
    Servo(std::unique_ptr<DeviceGroup> devices, std::span<const sim::ToolSpec> tools,
          std::span<const TrocarSettings> trocars, const CouplingSettings& coupling);
    ~Servo();

    /// One tick at `t_ns`: read, map, couple, limit, write. noexcept, no lock, no allocation.
    void tick(int64_t t_ns, std::span<sim::ToolInput> inputs,
              std::span<const sim::ToolFeedback> feedback) noexcept;
    /// Starts the 1 kHz thread; inputs and feedback then go through `exchange()`. Does nothing for
    /// a group in lock step: there the caller ticks.
    void start();
    /// Ramps the force down (50 ms in the thread), ends the thread and releases the devices.
    void stop() noexcept;

    struct Exchange {
        sim::Latest<std::array<sim::ToolInput, sim::kMaxTools>> inputs;
        sim::Latest<std::array<sim::ToolFeedback, sim::kMaxTools>> feedback;
    };
    [[nodiscard]] Exchange& exchange() noexcept;
    [[nodiscard]] DeviceGroup& devices() noexcept;
    [[nodiscard]] ServoHealth health() const;
    [[nodiscard]] bool finish_requested() const noexcept;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::haptics
