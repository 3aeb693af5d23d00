// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/rcm_device_map.h"

#include <cmath>

namespace placode::haptics {

RcmMap::RcmMap(const sim::ToolSpec& tool, const TrocarSettings& settings)
    : tool_(tool), settings_(settings) {
    const Vec3 inside = settings.home_tip_m - tool.pivot_m;
    ahead_ = inside.normalized();
    home_handle_m_ = tool.pivot_m - (tool.length_m - inside.norm()) * ahead_;
    // Up and right as the operator sees them, at right angles to the shaft.
    const Vec3 up = settings.R_WD.col(1);
    up_ = (up - up.dot(ahead_) * ahead_);
    if (up_.norm() < 0.1) up_ = settings.R_WD.col(2) - settings.R_WD.col(2).dot(ahead_) * ahead_;
    up_.normalize();
    right_ = ahead_.cross(up_);
}

Vec3 RcmMap::shaft(const RcmPose& pose) const noexcept {
    return std::cos(pose.pitch_rad) *
               (std::cos(pose.yaw_rad) * ahead_ + std::sin(pose.yaw_rad) * right_) +
           std::sin(pose.pitch_rad) * up_;
}

Vec3 RcmMap::handle_m(const RcmPose& pose) const noexcept {
    const Vec3 handle = tool_.pivot_m - (tool_.length_m - pose.depth_m) * shaft(pose);
    return settings_.R_WD.transpose() * (handle - home_handle_m_) / settings_.scale;
}

RcmForce RcmMap::force(const RcmPose& pose, const Vec3& handle_force_n) const noexcept {
    const Vec3 force = settings_.R_WD * handle_force_n / settings_.scale;
    const double lever = -(tool_.length_m - pose.depth_m);
    const Vec3 by_yaw = std::cos(pose.pitch_rad) *
                        (-std::sin(pose.yaw_rad) * ahead_ + std::cos(pose.yaw_rad) * right_);
    const Vec3 by_pitch = -std::sin(pose.pitch_rad) *
                              (std::cos(pose.yaw_rad) * ahead_ + std::sin(pose.yaw_rad) * right_) +
                          std::cos(pose.pitch_rad) * up_;
    return {lever * by_yaw.dot(force), lever * by_pitch.dot(force), shaft(pose).dot(force)};
}

}  // namespace placode::haptics
