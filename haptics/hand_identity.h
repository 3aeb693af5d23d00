// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which arm is in the right hand: the person moves it or presses its button, and the other rests.

#include <array>
#include <span>
#include <string_view>

#include "haptics/device.h"

namespace placode::haptics {

struct IdentityState {
    bool asked = false;
    int arm = -1;  ///< The arm that answered; -1: none yet.
    std::array<double, sim::kMaxTools> moved_m{};
};

/// Looks for the arm that is moved at least 30 mm of way, and four times as far as any other, or
/// whose button is pressed. No allocation; nothing throws.
class HandIdentity {
 public:
    void ask() noexcept;
    void see(std::span<const DeviceState> arms) noexcept;
    [[nodiscard]] const IdentityState& state() const noexcept { return state_; }

 private:
    IdentityState state_;
    std::array<DeviceState, sim::kMaxTools> before_{};
    bool seen_ = false;
};

/// Gives the right hand the arm that was the left one, and the other way round, in the station's
/// settings for `device`. `arms`: what was found, right first; with one arm alone the hand that it
/// stands for changes. Throws DeviceError for a device without hands.
void swap_hands(Station& station, std::string_view device, std::span<const DeviceInfo> arms);

}  // namespace placode::haptics
