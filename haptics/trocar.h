// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Kinematics of a rigid shaft through a port (fulcrum): from hand to tip and back. The maps of
// motion and force are transposes of each other, otherwise energy would be created.

#include <span>
#include <string_view>
#include <vector>

#include "haptics/device.h"

namespace placode::haptics {

enum class Mapping : uint8_t {
    kHandle,  ///< The device is the handle outside: the fulcrum inverts. Default for haptic
              ///< devices.
    kTip,     ///< The device is the tip: for mouse, keyboard and beginners.
};

struct TrocarSettings {
    Mapping mapping = Mapping::kHandle;
    double scale = 1.0;                   ///< s_x, device to world.
    Mat3 R_WD = Mat3::Identity();         ///< Device axes in W (camera basis for tip mapping).
    Vec3 home_tip_m = Vec3(0, 0, 0.015);  ///< Tip in W when the device is at its centre.
    double min_depth_m = 0.015;           ///< Nearest that the tip comes to the port.
    double max_lateral_gain = 3.0;        ///< Limit of the lateral force ratio d/(L-d).
};

/// One hand through one port.
class Trocar {
 public:
    Trocar(const sim::ToolSpec& tool, const TrocarSettings& settings);

    /// Tip pose in W for a device state. Never NaN: degenerate input keeps the last pose.
    [[nodiscard]] sim::Pose tip_pose(const DeviceState& state) noexcept;
    /// Device position that puts the tip at `tip_m` (inverse of `tip_pose`).
    [[nodiscard]] Vec3 device_position(const Vec3& tip_m) const noexcept;
    /// A vector of the tool's frame T at the last pose, in D, in the device's scale.
    [[nodiscard]] Vec3 device_vector(const Vec3& v_T) const noexcept;
    /// Device force for a tip force in W, by the transpose of the motion map at the last pose.
    [[nodiscard]] Vec3 device_force(const Vec3& tip_force_n) const noexcept;
    [[nodiscard]] const TrocarSettings& settings() const noexcept { return settings_; }

 private:
    sim::ToolSpec tool_;
    TrocarSettings settings_;
    sim::Pose last_;
    Vec3 home_handle_m_;
    Vec3 home_shaft_;     // unit, port to tip, at home
    Quat home_q_;         // tool axes at home: +y points down in the image
    Mat3 tip_from_hand_;  // d tip / d hand in W at the last pose; its transpose carries the force

    [[nodiscard]] Quat shaft_orientation(const Vec3& shaft, double roll_rad) const noexcept;
    void map_handle(const Vec3& hand_m, Vec3& tip_m, Vec3& shaft) noexcept;
    void map_tip(const Vec3& hand_m, Vec3& tip_m, Vec3& shaft) noexcept;
};

/// Axes of the endoscope's picture in W, as columns: right, up, towards the viewer. `to_port_m`:
/// from what the scope looks at to its port. Cranial is up (which puts the fetus' right side
/// right).
[[nodiscard]] Mat3 camera_basis(const Vec3& to_port_m);

/// Where the tip of `scope` is at home: between its port and `look_at_m`, `look_from_m` away, or as
/// much farther (40 mm at most) as it takes to see where the other tools begin.
[[nodiscard]] Vec3 scope_home_m(std::span<const sim::ToolSpec> tools, const sim::ToolSpec& scope);

/// Tools that go in and out through the port of `tools[i]`, in turns with it: bit k for tool k. A
/// scope has its port for itself.
[[nodiscard]] uint32_t others_in_port(std::span<const sim::ToolSpec> tools, size_t i) noexcept;

/// Mapping and home pose of every tool for a device: mouse, keyboard and gamepad move the tip in
/// the image plane; scripts and haptic arms hold the handle outside, so that the port inverts.
[[nodiscard]] std::vector<TrocarSettings> default_trocars(std::span<const sim::ToolSpec> tools,
                                                          std::string_view device);
/// The same with what the station says about arms: mapping and scale.
[[nodiscard]] std::vector<TrocarSettings> default_trocars(std::span<const sim::ToolSpec> tools,
                                                          std::string_view device,
                                                          const Station& station);

}  // namespace placode::haptics
