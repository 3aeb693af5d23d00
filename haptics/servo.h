// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From hands to tool inputs and from tool feedback to forces. In lock step (scripts, replay) the
// caller ticks it; otherwise a 1 kHz thread does. Force is zero on any doubt.

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "haptics/certificate.h"
#include "haptics/device.h"
#include "haptics/safety.h"
#include "haptics/trocar.h"

namespace placode::haptics {

/// Counters of the loop, for a status line; the haptic certificate says more.
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
    /// Starts the 1 kHz thread, or the scheduler of a group that has one; inputs and feedback then
    /// go through `exchange()`. Does nothing for a group in lock step: there the caller ticks.
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
    /// What the loop has done so far; nothing counts against it before the first tool state. Any
    /// thread but the servo's.
    [[nodiscard]] HapticCertificate certificate() const;
    /// The window closes or the attempt ends: force down to zero within 50 ms, and it stays so. Any
    /// thread.
    void release() noexcept;
    /// While the simulation is paused its tool states age on purpose: that is not counted against
    /// the certificate; a fault of a device is, once it outlasts the pause. The devices hold their
    /// instruments meanwhile (`DeviceGroup::hold`). The force has faded by then like in any stall.
    /// Any thread.
    void set_paused(bool paused) noexcept;
    [[nodiscard]] bool finish_requested() const noexcept;
    [[nodiscard]] bool device_lost() const noexcept;  ///< Every hand was, in the last tick.
    /// The tool that one hand at a window moved in the last tick; -1 = every tool has its own.
    [[nodiscard]] int in_hand() const noexcept;
    [[nodiscard]] bool renders_force() const noexcept;  ///< One of the devices has motors.
    /// Stiffness of the spring between hand and tool in W [N/m], within what the device bears; 0
    /// for a hand without force. The physics holds the tool with the same, or the hand would feel
    /// another force than the tissue's.
    [[nodiscard]] double stiffness_n_m(size_t hand) const noexcept;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::haptics
