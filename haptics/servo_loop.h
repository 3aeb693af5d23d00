// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the servo keeps, and what it counts while it runs: for servo.cpp and servo_account.cpp only.

#include <atomic>
#include <thread>

#include "haptics/coupling.h"
#include "haptics/histogram.h"
#include "haptics/servo.h"

namespace placode::haptics {

// Atomics that one thread writes: a plain store is enough and never locks the bus.
using Counter = std::atomic<uint64_t>;
inline void count(Counter& counter, bool happened = true, uint64_t n = 1) noexcept {
    if (happened)
        counter.store(counter.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
}

struct Counters {
    Counter ticks{0}, missed{0}, late{0}, gaps{0}, tool_states{0}, saturated{0}, slewed{0}, hot{0},
        stale{0}, silent{0}, passivity{0}, faults{0}, compared{0}, differing{0};
    std::atomic<double> peak_n{0}, rms_n{0}, least_j{0};
    std::atomic<int64_t> first_ns{0}, last_ns{0};
    DurationHistogram periods, ages;
};

struct Servo::Impl {
    struct HandLoop {
        Trocar trocar;
        Coupling coupling;
        sim::ToolInput held;     // Last trusted input.
        double tool_time_s = 0;  // Of the last tool state, to count distinct ones.
        bool force = false;      // The device of this hand has motors.
        bool doubted = false;    // A fault began while none counts, and may outlast that.
    };

    std::unique_ptr<DeviceGroup> devices;
    std::string device_names;
    bool force = false;
    // Servo thread (or the caller in lock step).
    std::vector<HandLoop> hands;
    std::vector<DeviceState> states;
    std::vector<DeviceCommand> commands;
    std::array<sim::ToolInput, sim::kMaxTools> inputs{};
    int64_t previous_ns = 0;
    int release_ticks = -1;
    bool begun = false;  // A tool state was seen: the attempt's clock runs.
    // Crosses threads.
    Exchange exchange;
    Counters counters;
    std::atomic<bool> finish{false}, running{false}, releasing{false}, released{false},
        real_time{false}, paused{false}, locked{false}, own_scheduler{false}, lost{false};
    std::atomic<int> in_hand{-1};
    // Owner.
    std::thread thread;
    bool was_started = false, stopped = false;

    void tick_hand(size_t i, int64_t t_ns, sim::ToolInput& input,
                   const sim::ToolFeedback& feedback) noexcept;
    void note(size_t i, const CouplingResult& result, const sim::ToolFeedback& feedback) noexcept;
    void note_doubt(size_t i, const CouplingResult& result, bool counted) noexcept;
    void note_time(int64_t now_ns) noexcept;
    void step_release() noexcept;
    void read(int64_t t_ns) noexcept;
    bool tick_all(int64_t now_ns) noexcept;
    void run() noexcept;
};

}  // namespace placode::haptics
