// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Kinematics of a rigid shaft through a port (fulcrum): from hand to tip and back. The maps of
// motion and force are transposes of each other, otherwise energy would be created.

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
    /// Device force for a tip force in W, by the transpose of the motion map at the last pose.
    [[nodiscard]] Vec3 device_force(const Vec3& tip_force_n) const noexcept;
    [[nodiscard]] const TrocarSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] double insertion_depth_m() const noexcept;

 private:
    sim::ToolSpec tool_;
    TrocarSettings settings_;
    sim::Pose last_;
    Vec3 home_handle_m_;
};

}  // namespace placode::haptics
