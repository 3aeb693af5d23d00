// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the arms of all vendors share: which tool an arm holds, clutch, change of instrument, jaw
// from a button, pedals, and a fresh start wherever the hand was when it took hold. A variant only
// senses its arms and drives their motors.

#include <limits>
#include <string>
#include <vector>

#include "haptics/device.h"
#include "haptics/foot_pedals.h"
#include "haptics/trocar.h"
#include "haptics/window_hands.h"

namespace placode::haptics {

inline constexpr size_t kMaxArms = 2;  ///< Right and left.

/// One arm in one tick, as the variant senses it. Frame D.
struct ArmSample {
    DeviceStatus status = DeviceStatus::kLost;
    bool absolute = false;  ///< The arm is an instrument in a port: its position is the handle's.
    bool held = false;      ///< Out of its inkwell or cradle, a hand on it as far as it can tell.
    Vec3 position_m = Vec3::Zero();
    Quat orientation = Quat::Identity();
    double roll_rad = 0;
    double jaw = std::numeric_limits<double>::quiet_NaN();  ///< 0 closed to 1 open; NaN: none.
    uint32_t buttons = 0;  ///< Bit 0: close or cut; bit 1: clutch or change; bit 2: coagulate.
    uint8_t pedals = 0;    ///< Of the vendor's own box.
    float motor_heat = 0;
};

/// Force for one arm. Zero it after `valid_until_ns`.
struct ArmForce {
    Vec3 force_n = Vec3::Zero();     ///< In D.
    Vec3 position_m = Vec3::Zero();  ///< Of the arm in this tick, as it was sensed.
    int64_t valid_until_ns = 0;
};

/// Group of up to two arms. Servo thread after construction.
class ArmHands : public DeviceGroup {
 public:
    /// `hands`: which hand every arm stands for; one arm alone takes the tools of both in turn.
    ArmHands(const DeviceConfig& config, const std::vector<sim::Hand>& hands);
    void hold(bool paused) noexcept final { on_hold_ = paused; }
    void read(int64_t t_ns, std::span<DeviceState> states) noexcept final;
    void write(std::span<const DeviceCommand> commands) noexcept final;
    [[nodiscard]] std::vector<DeviceInfo> info() const final;

 protected:
    /// Fills one sample per arm for the tick at `t_ns`.
    virtual void sense(int64_t t_ns, std::span<ArmSample> samples) noexcept = 0;
    /// Sends one force per arm.
    virtual void drive(std::span<const ArmForce> forces) noexcept = 0;
    /// What was found, one per arm.
    [[nodiscard]] virtual std::vector<DeviceInfo> arm_info() const = 0;
    /// The tool that an arm holds now; -1: none.
    [[nodiscard]] int tool_of(size_t arm) const noexcept {
        const Arm& one = arms_[arm];
        return one.tools.empty() ? -1 : static_cast<int>(one.tools[one.turn]);
    }

 private:
    struct Arm {
        sim::Hand hand = sim::Hand::kRight;
        std::vector<size_t> tools;  // in the order in which they take turns
        size_t turn = 0;
        bool anchored = false, clutched = false;
        bool waits = false, met = false;  // absolute, behind a pause: see `wait_for_arm`
        Vec3 zero_m = Vec3::Zero();
        double roll_zero = 0;
        uint32_t buttons = 0;
        int64_t pressed_ns = 0;  // clutch
    };

    // Where the virtual handle of a tool is; it stays there while another tool is held.
    struct Handle {
        Vec3 position_m = Vec3::Zero();
        double roll_rad = 0, jaw_rad = 0, jaw_least_rad = 0;
        bool shares_port = false;
    };

    void change_tool(Arm& arm) noexcept;
    void wait_for_arm(Arm& arm, const ArmSample& sample) const noexcept;
    void clutch(Arm& arm, const ArmSample& sample, int64_t t_ns) noexcept;
    void follow(Arm& arm, const ArmSample& sample) noexcept;
    void fill(Arm& arm, const ArmSample& sample, uint8_t pedals, double dt_s,
              std::span<DeviceState> states) noexcept;

    std::vector<sim::ToolSpec> tools_;
    std::vector<Handle> handles_;
    std::vector<Arm> arms_;
    std::array<ArmSample, kMaxArms> samples_;
    std::array<ArmForce, kMaxArms> forces_;
    sim::Latest<sim::WindowInput>* window_;
    sim::WindowInput before_, idle_;
    WindowAge age_;
    bool window_seen_ = false, finished_ = false, on_hold_ = false;
    FootPedals feet_;
    PedalGuard guard_;
    int64_t last_ns_ = 0;
    uint64_t sequence_ = 0;
};

}  // namespace placode::haptics
