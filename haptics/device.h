// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Input devices, with or without force: one interface for a group of devices that share a tick.
// Variants stand in `<name>_device.cpp` and need no header: SDK types cannot leak.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/real_time.h"
#include "haptics/station.h"
#include "haptics/window_input.h"
#include "sim/core/exchange.h"
#include "sim/core/geometry.h"
#include "sim/core/practice.h"
#include "sim/core/tool.h"
#include "sim/step/snapshot.h"
#include "sim/world/scene.h"

namespace placode::haptics {

using sim::Mat3;
using sim::Quat;
using sim::Vec3;

enum class DeviceStatus : uint8_t { kReady, kNotCalibrated, kLost, kFault };

/// What was found. Fixed after `open`.
struct DeviceInfo {
    std::string vendor, model, serial, driver;
    uint8_t dof_sensed = 0, dof_force = 0, dof_torque = 0;
    bool gripper = false, left_hand = false, owns_servo = false;
    double max_force_n = 0, continuous_force_n = 0;
    double max_stiffness_n_m = 0, max_damping_ns_m = 0;
    double rate_hz = 1000;
};

/// One device in one tick. Frame D: x right, y up, z towards the operator.
struct DeviceState {
    uint64_t sequence = 0;
    int64_t t_ns = 0;                ///< CLOCK_MONOTONIC at the sample.
    Vec3 position_m = Vec3::Zero();  ///< Handle in D.
    Vec3 velocity_m_s = Vec3::Zero();
    Quat orientation = Quat::Identity();
    double roll_rad = 0;  ///< About the shaft.
    double jaw_rad = 0;
    uint32_t buttons = 0;
    uint8_t pedals = 0;  ///< sim::kPedalCut | sim::kPedalCoag
    DeviceStatus status = DeviceStatus::kReady;
    bool engaged = true;    ///< false: hand off, inkwell, clutch at start.
    bool in_hand = false;   ///< Of several instruments for one hand at a window: this one now.
    bool finish = false;    ///< The operator declares the task done.
    bool clutched = false;  ///< The tool is held where it is, the hand is free: no force.
    float motor_heat = 0;   ///< What the device says of its motors, 0 to 1.
};

/// Force for one device in one tick.
struct DeviceCommand {
    Vec3 force_n = Vec3::Zero();  ///< In D.
    double roll_torque_nm = 0, grip_force_n = 0;
    int64_t valid_until_ns = 0;  ///< The servo, and a driver with a loop, send none later.
};

/// What a scripted operator is allowed to see: what a person sees on the screen.
struct Perception {
    double time_s = 0;
    std::span<const Vec3> contour;         ///< Planned contour where it lies now, in W [m].
    std::span<const Vec3> contour_normal;  ///< Outward surface normals there.
    std::span<const uint8_t> contour_cut;  ///< 1 = cut there.
    std::span<const sim::ToolFeedback> tools;
    float cut_fraction = 0;
    std::span<const uint8_t> sector_free;  ///< 1 = free, by sim::sector_of.
    float released = 0;                    ///< Share of the placode's circumference that is free.
    bool in_contact = false;               ///< Needle tip touches tissue.
    double tip_gap_m = 1;
    // With jaws and blades.
    std::span<const Vec3> outline;         ///< Of the marked tissue where it lies now, in W [m].
    std::span<const Vec3> outline_normal;  ///< Outward surface normals there.
    std::span<const uint8_t> outline_cut;  ///< 1 = parted there.
    Vec3 grasp_place_m = Vec3::Zero();     ///< Where to take hold of the marked tissue.
    double marked_left = 1;                ///< Share of the marked tissue that still hangs on.
    double marked_held = 0;                ///< Share of it that lies loose in the jaws.
    std::array<bool, sim::kMaxTools> touches{}, holds{};  ///< Per tool.
    /// Distance of the placode to each tip, or to what lies between blades [m]; far where none is
    /// seen.
    std::array<double, sim::kMaxTools> placode_gap_m{1, 1, 1, 1};
    /// Distance of the placode to the whole bare metal of a needle or hook, likewise [m].
    std::array<double, sim::kMaxTools> placode_metal_gap_m{1, 1, 1, 1};
    std::array<double, sim::kMaxTools> pull_n{};  ///< Traction of jaws that hold.
    bool piece_free = false;                      ///< What the jaws hold hangs on nothing any more.
    int pieces_out = 0;
    bool needle = false, needle_held = false;  ///< A suture needle is there; in somebody's jaws.
    std::array<bool, sim::kMaxTools> holds_needle{};  ///< In whose.
    sim::Pose X_WN;                                   ///< Where it lies.
    double needle_arc_m = 0;                          ///< Point to swage along its half circle.
    int bites = 0, exits = 0, drawn_through = 0;      ///< Times that it went in, came out, left.
    bool patch = false;                               ///< A patch is there.
    std::array<Vec3, 4> patch_corner_m{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                       Vec3::Zero()};  ///< Its corners, round it.
    sim::PracticeGoal practice;  ///< Steps of a practice task: what to do now, and where.
    double stuck_left = 0, floating_left = 0;  ///< Debris on the lesion, and in the fluid.
    double standing_m3 = 0;                    ///< Fluid over it, as far as one can judge that.
    double hidden = 0;                         ///< Share of the lesion that blood hides.
    Vec3 stuck_m = Vec3::Zero(), fluid_m = Vec3::Zero();  ///< Next debris; deepest fluid.
};

/// Settings of `open_device` (haptics/catalogue/open_device.h), from command line, station and
/// task.
struct DeviceConfig {
    std::string name;  ///< "mouse", "keyboard", "gamepad", "script:expert", ...
    uint64_t seed = 1;
    std::vector<sim::ToolSpec> tools;  ///< One hand per tool.
    sim::Latest<sim::WindowInput>* window =
        nullptr;  ///< For mouse, keyboard and gamepad; may be null.
    double frame_s = 1e-3;
    bool practice = false;  ///< The task has steps (for scripts).
    bool patch = false;     ///< Steps with a patch are among them.
    Station station;        ///< What this computer says about its devices.
    /// Clock of groups with a scheduler of their own [ns]; null: CLOCK_MONOTONIC. For tests.
    int64_t (*clock_ns)() noexcept = nullptr;
};

/// A group: one scheduler, one tick, one state per hand (same order as the tools).
class DeviceGroup {
 public:
    virtual ~DeviceGroup() = default;
    [[nodiscard]] virtual std::vector<DeviceInfo> info() const = 0;
    /// Reads all hands for the tick at `t_ns`. Never blocks, allocates or throws.
    virtual void read(int64_t t_ns, std::span<DeviceState> states) noexcept = 0;
    /// Sends the forces of this tick.
    virtual void write(std::span<const DeviceCommand> commands) noexcept = 0;
    /// Before a tick is read: what turning tool `tool` shall turn about, from its tip, and along
    /// which axis, in D; a zero arm is its own shaft. Devices whose hand turns by itself ignore it.
    virtual void turn_about(size_t /*tool*/, const Vec3& /*arm_m*/, const Vec3& /*axis*/) noexcept {
    }
    /// Before a tick is read: true while the attempt is paused. The instruments then stay where
    /// they are, and go on from there, wherever the hands have gone meanwhile. Scripts, which wait
    /// with the simulation, ignore it.
    virtual void hold(bool /*paused*/) noexcept {}
    /// Only scripted operators look.
    virtual void perceive(const Perception&) noexcept {}
    /// A group with a scheduler of its own (`DeviceInfo::owns_servo`) begins to call `tick` on its
    /// thread once a period and says true; within the call it is read and written as usual. `tick`
    /// answers false when the session is over. Any other group says false.
    using ServoTick = bool (*)(void* context, int64_t t_ns) noexcept;
    [[nodiscard]] virtual bool start(ServoTick, void* /*context*/) { return false; }
    /// The clock of the times that its ticks carry [ns]. Any thread.
    [[nodiscard]] virtual int64_t now_ns() const noexcept { return monotonic_ns(); }
    /// The last error that the device or its library reported, code and words; empty: none yet.
    /// Any thread.
    [[nodiscard]] virtual std::string last_error() const { return {}; }
    /// True when the group must run in step with the simulation (scripts, recordings): then
    /// simulated time is its clock and no servo thread is started.
    [[nodiscard]] virtual bool lock_step() const noexcept { return false; }
    /// Force to zero and devices released. Called once.
    virtual void stop() noexcept {}
};

}  // namespace placode::haptics
