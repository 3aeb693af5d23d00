// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Gamepad: rate control; axes and buttons in the order of GLFW's standard mapping.
#include <algorithm>
#include <cmath>

#include "haptics/gamepad_search.h"
#include "haptics/window_hands.h"

namespace placode::haptics {

namespace {

constexpr double kSpeedMS = 0.060, kPrecision = 0.1, kDeadZone = 0.12, kRollRadS = 2.0;
constexpr uint16_t kButtonA = 1u << 0, kButtonB = 1u << 1, kLeftBumper = 1u << 4,
                   kButtonStart = 1u << 7;

// Dead zone, then a cubic curve: fine near the middle.
double curve(float axis) noexcept {
    const double size = std::abs(static_cast<double>(axis));
    if (!(size > kDeadZone)) return 0;
    const double x = std::min(1.0, (size - kDeadZone) / (1 - kDeadZone));
    return std::copysign(x * x * x, static_cast<double>(axis));
}

class GamepadDevice final : public WindowHands {
 public:
    explicit GamepadDevice(const DeviceConfig& config) : WindowHands(config, "gamepad") {}

 protected:
    void move(const sim::WindowInput& now, const sim::WindowInput&, double dt_s, WindowHand& active,
              WindowHand*) noexcept override {
        if (!now.gamepad) {
            ease(active, Vec3::Zero(), dt_s);
            return;
        }
        const auto& axis = now.gamepad_axis;
        // Triggers rest at -1; the right one goes into the picture.
        const auto trigger = [](float value) { return curve((value + 1) / 2); };
        const Vec3 direction(curve(axis[0]), -curve(axis[1]), trigger(axis[4]) - trigger(axis[5]));
        const bool fine = (now.gamepad_buttons & kLeftBumper) != 0;
        ease(active, kSpeedMS * (fine ? kPrecision : 1.0) * direction, dt_s);
        active.roll_rad += kRollRadS * dt_s * curve(axis[2]);
    }

    [[nodiscard]] uint8_t buttons(const sim::WindowInput& now) const noexcept override {
        if (!now.gamepad) return 0;
        return static_cast<uint8_t>(((now.gamepad_buttons & kButtonA) ? sim::kPedalCut : 0) |
                                    ((now.gamepad_buttons & kButtonB) ? sim::kPedalCoag : 0));
    }
    [[nodiscard]] bool present(const sim::WindowInput& now) const noexcept override {
        return now.gamepad;
    }
    [[nodiscard]] bool finish(const sim::WindowInput& now) const noexcept override {
        return now.gamepad && (now.gamepad_buttons & kButtonStart) != 0;
    }
};

}  // namespace

std::unique_ptr<DeviceGroup> open_gamepad(const DeviceConfig& config) {
    // A window takes a pad that is plugged in later; without one there is nothing to wait for.
    if (config.window == nullptr) need_gamepad();
    return std::make_unique<GamepadDevice>(config);
}

}  // namespace placode::haptics
