// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What mouse, keyboard and gamepad share: hands that move in the picture's plane and keep still
// when the window loses focus or says nothing for a second, pedals that let go by themselves,
// clutch and finish key. A variant only says how far the hand wants to go.

#include <span>
#include <string>
#include <vector>

#include "haptics/device.h"
#include "haptics/foot_pedals.h"

namespace placode::haptics {

/// Pedals from buttons: released after 10 s without a break, and when motion is not allowed.
class PedalGuard {
 public:
    /// `pressed`: what is held now; `endless`: it closes jaws, which may hold for minutes. Returns
    /// what counts.
    [[nodiscard]] uint8_t update(uint8_t pressed, int64_t t_ns, bool allowed,
                                 bool endless = false) noexcept;

 private:
    uint8_t before_ = 0;
    bool spent_ = false;  // timed out or lost focus: wait for the release
    int64_t since_ns_ = 0;
};

/// How old what the window said last is, on the servo's clock. A main thread that stands still (a
/// disk, a driver of graphics, a debugger) leaves keys held that were let go long ago.
class WindowAge {
 public:
    /// Twice the slowest window that was seen, 2 pictures a second on a processor that draws: the
    /// main thread publishes once a picture. Such an attempt counts for nothing, but works.
    static constexpr int64_t kStaleNs = 1'000'000'000;

    void heard(int64_t t_ns) noexcept {
        heard_ns_ = t_ns;
        spoke_ = true;
    }
    /// A window that never spoke holds no key.
    [[nodiscard]] bool stale(int64_t t_ns) const noexcept {
        return spoke_ && t_ns - heard_ns_ >= kStaleNs;
    }

 private:
    int64_t heard_ns_ = 0;
    bool spoke_ = false;
};

/// One hand at a virtual device, in D.
struct WindowHand {
    Vec3 target_m = Vec3::Zero();  ///< Where it wants to go; followed smoothly.
    Vec3 rate_m_s = Vec3::Zero();  ///< Eased velocity of rate-controlled variants.
    Vec3 position_m = Vec3::Zero(), velocity_m_s = Vec3::Zero();
    double roll_rad = 0, jaw_rad = 0;
    double turned_rad = 0;      ///< Follows `roll_rad`: at once, with a needle smoothly.
    Vec3 arm_m = Vec3::Zero();  ///< From the tip to what it turns about; zero = its shaft.
    Vec3 axis = Vec3::UnitZ();
    bool scope = false, energy = false, endless = true;
    uint32_t others_in_port = 0;  ///< By bits: they take turns.
    bool out = false;             ///< Waits outside.
    bool holds = false;           ///< Its jaws hold something: closed, they stay in their port.
    double jaw_least_rad = 0;     ///< A ratchet holds jaws from squeezing further.
    double jaw_open_rad = 0;      ///< As wide as the button lets them open.
    bool latched = false;         ///< Left closed, or in a pause: so until the next press.
};

/// Group of virtual hands driven from the window. Servo thread only.
class WindowHands : public DeviceGroup {
 public:
    WindowHands(const DeviceConfig& config, std::string model);
    [[nodiscard]] std::vector<DeviceInfo> info() const override;
    /// A needle in the jaws is turned about its own axis, as a wrist would: one hand on a mouse
    /// cannot turn and carry at once.
    void turn_about(size_t tool, const Vec3& arm_m, const Vec3& axis) noexcept final;
    void hold(bool paused) noexcept final { on_hold_ = paused; }
    void read(int64_t t_ns, std::span<DeviceState> states) noexcept final;
    void write(std::span<const DeviceCommand>) noexcept override {}

 protected:
    /// Called first in every tick, whatever the window says: to empty a device's queue.
    virtual void before_read(int64_t) noexcept {}
    /// Moves `target_m` (and roll) of the active hand or the scope for this tick.
    virtual void move(const sim::WindowInput& now, const sim::WindowInput& before, double dt_s,
                      WindowHand& active, WindowHand* scope) noexcept = 0;
    /// Buttons that stand for pedals or, for tools without energy, for closing the jaw (kPedalCut).
    [[nodiscard]] virtual uint8_t buttons(const sim::WindowInput& now) const noexcept = 0;
    [[nodiscard]] virtual bool finish(const sim::WindowInput&) const noexcept { return false; }
    /// False while the hardware behind the window is absent: the hand is lost, its pedals let go.
    [[nodiscard]] virtual bool present(const sim::WindowInput&) const noexcept { return true; }
    /// Velocity of a rate-controlled hand, eased over 150 ms, then integrated into the target.
    static void ease(WindowHand& hand, const Vec3& wished_m_s, double dt_s) noexcept;

 private:
    void move_hands(const sim::WindowInput& now, double dt_s) noexcept;
    void stand_still() noexcept;
    [[nodiscard]] uint8_t pedals_down(const sim::WindowInput& now, int64_t t_ns, bool attended,
                                      bool allowed) noexcept;
    [[nodiscard]] DeviceState state_of(size_t hand, int64_t t_ns, uint8_t held,
                                       bool there) const noexcept;
    void follow(WindowHand& hand, double dt_s) noexcept;
    static void turn(WindowHand& hand, double dt_s) noexcept;
    void next_hand(uint32_t presses) noexcept;
    [[nodiscard]] bool kept_out(size_t hand) const noexcept;
    [[nodiscard]] uint8_t own_press(uint8_t held) noexcept;
    [[nodiscard]] uint8_t keep_jaws(uint8_t held) noexcept;
    void move_jaw(WindowHand& hand, bool pressed, double dt_s) const noexcept;

    std::string model_;
    sim::Latest<sim::WindowInput>* window_;
    sim::WindowInput before_, idle_;
    WindowAge age_;
    bool seen_ = false;
    std::vector<WindowHand> hands_;
    size_t active_ = 0, pressed_by_ = 0;
    uint8_t held_before_ = 0;
    FootPedals feet_;
    PedalGuard pedals_;
    int64_t last_ns_ = 0;
    uint64_t sequence_ = 0;
    bool finished_ = false, on_hold_ = false;
};

}  // namespace placode::haptics
