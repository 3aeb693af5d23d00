// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::sim {
namespace {

constexpr double kNearMm = 1.0, kFarMm = 300.0;

void level(Camera& camera, const Vec3& fallback) {
    // Half outward, half cranial: well defined for every direction from which a scope looks at a
    // back, and it puts the right hand's port on the right of the picture.
    Vec3 hint = Vec3(1, 0, 1).normalized();
    Vec3 up = hint - hint.dot(camera.forward) * camera.forward;
    if (up.norm() < 0.05) up = fallback - fallback.dot(camera.forward) * camera.forward;
    camera.up = up.normalized();
    camera.right = camera.forward.cross(camera.up).normalized();
}

}  // namespace

Mat4f Camera::view_projection() const {
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.block<1, 3>(0, 0) = right.transpose();
    view.block<1, 3>(1, 0) = up.transpose();
    view.block<1, 3>(2, 0) = -forward.transpose();
    view.block<3, 1>(0, 3) = -(view.block<3, 3>(0, 0) * position_mm);
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
    const double f = 1.0 / std::tan(half_angle_rad);
    projection(0, 0) = projection(1, 1) = f;
    projection(2, 2) = (kFarMm + kNearMm) / (kNearMm - kFarMm);
    projection(2, 3) = 2 * kFarMm * kNearMm / (kNearMm - kFarMm);
    projection(3, 2) = -1;
    return (projection * view).cast<float>();
}

Camera look_at(const Vec3& eye_mm, const Vec3& target_mm, double field_of_view_deg) {
    Camera camera;
    camera.position_mm = eye_mm;
    camera.forward = (target_mm - eye_mm).normalized();
    camera.half_angle_rad = std::clamp(field_of_view_deg, 20.0, 120.0) * std::numbers::pi / 360.0;
    level(camera, Vec3::UnitY());
    return camera;
}

Camera camera_of(const Snapshot& snapshot, const std::vector<ToolSpec>& tools) {
    for (int i = 0; i < snapshot.tool_count; ++i) {
        const ToolSnapshot& tool = snapshot.tools[static_cast<size_t>(i)];
        if (tool.kind != ToolKind::kScope) continue;
        const ToolSpec spec =
            static_cast<size_t>(i) < tools.size() ? tools[static_cast<size_t>(i)] : ToolSpec{};
        const Vec3 axis = tool.pose.q * Vec3::UnitZ();
        Camera camera =
            look_at(tool.pose.p * 1000, tool.pose.p * 1000 + axis, spec.field_of_view_deg);
        if (std::abs(spec.scope_angle_deg) > 0.01) {
            // An oblique optic looks down past its own axis.
            const double angle = -spec.scope_angle_deg * std::numbers::pi / 180.0;
            camera.forward = Eigen::AngleAxisd(angle, camera.right) * camera.forward;
            level(camera, Vec3::UnitY());
        }
        return camera;
    }
    return look_at(Vec3(-24, 0, 40), Vec3(0, 0, 0), 70);
}

}  // namespace placode::sim
