// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A device that is itself an instrument in a port (4 degrees of freedom: yaw, pitch, depth, roll):
// its angles as a virtual handle in D, and forces on that handle as torques and thrust of the
// device. Both ways are transposes of each other.

#include "haptics/trocar.h"

namespace placode::haptics {

struct RcmPose {
    double yaw_rad = 0, pitch_rad = 0;  ///< From the home direction of the shaft.
    double depth_m = 0;                 ///< Port to tip.
    double roll_rad = 0;
};

/// Generalised force of the device.
struct RcmForce {
    double yaw_nm = 0, pitch_nm = 0, depth_n = 0;
};

/// One tool and its port, handle mapping.
class RcmMap {
 public:
    RcmMap(const sim::ToolSpec& tool, const TrocarSettings& settings);
    /// Virtual handle in D, as a `Trocar` with handle mapping wants it.
    [[nodiscard]] Vec3 handle_m(const RcmPose& pose) const noexcept;
    /// Torques and thrust for a force on the virtual handle in D: its Jacobian, transposed.
    [[nodiscard]] RcmForce force(const RcmPose& pose, const Vec3& handle_force_n) const noexcept;

 private:
    [[nodiscard]] Vec3 shaft(const RcmPose& pose) const noexcept;

    sim::ToolSpec tool_;
    TrocarSettings settings_;
    Vec3 home_handle_m_, ahead_, right_, up_;  // in W
};

}  // namespace placode::haptics
