// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the tests of all drivers share: why a device does not open, and a device that is ticked by
// the test.

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "haptics/catalogue/open_device.h"
#include "haptics/real_time.h"

namespace placode::test {

/// The message of the DeviceError that opening throws.
inline std::string error_of(const haptics::DeviceConfig& what) {
    try {
        haptics::open_device(what)->stop();
    } catch (const haptics::DeviceError& error) {
        return error.what();
    }
    return "no error";
}

/// An open device with `Hands` hands.
template <size_t Hands>
struct DeviceSession {
    explicit DeviceSession(const haptics::DeviceConfig& what)
        : device(haptics::open_device(what)) {}
    ~DeviceSession() { device->stop(); }
    DeviceSession(const DeviceSession&) = delete;
    DeviceSession& operator=(const DeviceSession&) = delete;

    /// One tick at `t_ns` with the same force for every hand.
    void tick_at(int64_t t_ns, const haptics::Vec3& force) {
        device->read(t_ns, states);
        for (auto& command : commands) {
            command.force_n = force;
            command.valid_until_ns = t_ns + 10'000'000;
        }
        device->write(commands);
    }
    void tick(const haptics::Vec3& force = haptics::Vec3::Zero()) {
        tick_at(haptics::monotonic_ns(), force);
    }
    /// Ticks until `done`; the limit only keeps a broken build from hanging.
    bool until(const std::function<bool()>& done,
               const haptics::Vec3& force = haptics::Vec3::Zero()) {
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (std::chrono::steady_clock::now() < limit) {
            tick(force);
            if (done()) return true;
            haptics::sleep_until(haptics::monotonic_ns() + 400'000);
        }
        return false;
    }

    std::unique_ptr<haptics::DeviceGroup> device;
    std::array<haptics::DeviceState, Hands> states;
    std::array<haptics::DeviceCommand, Hands> commands;
};

}  // namespace placode::test
