// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/hand_identity.h"

#include <algorithm>
#include <string>

namespace placode::haptics {

namespace {

constexpr double kWayM = 0.030, kTimes = 4;
constexpr double kNoiseM = 5e-5;  // an encoder's step at rest is no way

}  // namespace

void HandIdentity::ask() noexcept {
    state_ = {};
    state_.asked = true;
    seen_ = false;
}

void HandIdentity::see(std::span<const DeviceState> arms) noexcept {
    if (!state_.asked || state_.arm >= 0) return;
    const size_t n = std::min(arms.size(), before_.size());
    for (size_t i = 0; i < n; ++i) {
        const DeviceState& now = arms[i];
        if (now.status != DeviceStatus::kReady || !now.position_m.allFinite()) continue;
        if (seen_) {
            const double step = (now.position_m - before_[i].position_m).norm();
            if (step < kNoiseM) continue;  // adds up with the next
            state_.moved_m[i] += step;
        }
        before_[i] = now;
    }
    for (size_t i = 0; seen_ && i < n; ++i) {
        double others = 0;
        bool pressed_elsewhere = false;
        for (size_t k = 0; k < n; ++k) {
            if (k == i) continue;
            others = std::max(others, state_.moved_m[k]);
            pressed_elsewhere = pressed_elsewhere || arms[k].buttons != 0;
        }
        const bool moved = state_.moved_m[i] > kWayM && state_.moved_m[i] > kTimes * others;
        if (moved || (arms[i].buttons != 0 && !pressed_elsewhere)) state_.arm = static_cast<int>(i);
    }
    seen_ = true;
}

void swap_hands(Station& station, std::string_view device, std::span<const DeviceInfo> arms) {
    const std::string right = std::string(device) + ".right", left = std::string(device) + ".left";
    if (arms.size() < 2) {
        station.set("arm.one_hand", station.text("arm.one_hand") == "left" ? "right" : "left");
    } else if (device == "forcedimension") {
        station.set("forcedimension.swap_hands",
                    station.number("forcedimension.swap_hands") != 0 ? "0" : "1");
    } else if (device == "haply") {
        // By name, whatever stood there before: "auto" or nothing would find the same again.
        station.set(right, arms[1].serial);
        station.set(left, arms[0].serial);
    } else if (device == "openhaptics" || device == "avatar") {
        const std::string was = station.text(right);
        station.set(right, station.text(left));
        station.set(left, was);
    } else {
        throw DeviceError(std::string(device) + ": has no arms for two hands");
    }
}

}  // namespace placode::haptics
