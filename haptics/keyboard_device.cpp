// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard only: rate control in the picture's axes.
#include "haptics/window_hands.h"

namespace placode::haptics {

namespace {

constexpr double kSpeedMS = 0.040;
// A key has one speed. The tip of a needle cuts at a few mm/s, so the pedal slows the hand as well.
constexpr double kPrecision = 0.1;
constexpr double kRollRadS = 1.5;
constexpr double kScopeSpeedMS = 0.010;

class KeyboardDevice final : public WindowHands {
 public:
    explicit KeyboardDevice(const DeviceConfig& config) : WindowHands(config, "keyboard") {}

 protected:
    void move(const sim::WindowInput& now, const sim::WindowInput&, double dt_s, WindowHand& active,
              WindowHand* scope) noexcept override {
        using sim::Key;
        const auto axis = [&now](Key plus, Key minus) {
            return (now.is_down(plus) ? 1.0 : 0.0) - (now.is_down(minus) ? 1.0 : 0.0);
        };
        const bool fine = now.is_down(Key::kControl) || buttons(now) != 0;
        const Vec3 direction(axis(Key::kD, Key::kA), axis(Key::kW, Key::kS),
                             axis(Key::kR, Key::kF));
        ease(active, kSpeedMS * (fine ? kPrecision : 1.0) * direction, dt_s);
        if (scope != nullptr) {
            const Vec3 look(axis(Key::kRight, Key::kLeft), axis(Key::kUp, Key::kDown), 0);
            ease(*scope, kScopeSpeedMS * (fine ? kPrecision : 1.0) * look, dt_s);
        }
        active.roll_rad += kRollRadS * dt_s * axis(Key::kE, Key::kQ);
    }

    [[nodiscard]] uint8_t buttons(const sim::WindowInput& now) const noexcept override {
        return static_cast<uint8_t>((now.is_down(sim::Key::kX) ? sim::kPedalCut : 0) |
                                    (now.is_down(sim::Key::kC) ? sim::kPedalCoag : 0));
    }
};

}  // namespace

std::unique_ptr<DeviceGroup> open_keyboard(const DeviceConfig& config) {
    return std::make_unique<KeyboardDevice>(config);
}

}  // namespace placode::haptics
