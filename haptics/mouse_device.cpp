// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse: the pointer's motion is the tip's motion in the picture, at constant gain.
#include "haptics/mouse_mapping.h"
#include "haptics/window_hands.h"

namespace placode::haptics {

namespace {

class MouseDevice final : public WindowHands {
 public:
    explicit MouseDevice(const DeviceConfig& config) : WindowHands(config, "mouse") {}

 protected:
    void move(const sim::WindowInput& now, const sim::WindowInput& before, double,
              WindowHand& active, WindowHand* scope) noexcept override {
        const double gain = now.is_down(sim::Key::kControl) ? kMousePrecision : 1.0;
        const double dx = now.mouse_x - before.mouse_x, dy = now.mouse_y - before.mouse_y;
        // Wheel away from the user goes into the picture, away from the viewer (-z in D).
        const bool shift = now.is_down(sim::Key::kShift);
        const double notch = shift ? kMouseQuickNotchM : kMouseNotchM;
        const Vec3 step(kMouseCountM * dx, -kMouseCountM * dy, -notch * (now.wheel - before.wheel));
        if (now.middle && scope != nullptr) {
            scope->target_m += gain * step;
        } else if (shift) {
            active.roll_rad += gain * kMouseRollRad * dx;
            active.target_m.z() += gain * step.z();
        } else {
            active.target_m += gain * step;
        }
    }

    [[nodiscard]] uint8_t buttons(const sim::WindowInput& now) const noexcept override {
        const bool cut = now.left || now.is_down(sim::Key::kX);
        const bool coag = now.right || now.is_down(sim::Key::kC);
        return static_cast<uint8_t>((cut ? sim::kPedalCut : 0) | (coag ? sim::kPedalCoag : 0));
    }
};

}  // namespace

std::unique_ptr<DeviceGroup> open_mouse(const DeviceConfig& config) {
    return std::make_unique<MouseDevice>(config);
}

}  // namespace placode::haptics
