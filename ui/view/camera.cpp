// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/trocar.h"

namespace placode::view {

using namespace sim;
namespace {

constexpr double kNearMm = 1.0, kFarMm = 300.0;

double half_angle(double field_of_view_deg) {
    return std::clamp(field_of_view_deg, 20.0, 120.0) * std::numbers::pi / 360.0;
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
    camera.half_angle_rad = half_angle(field_of_view_deg);
    // Cranial is up, or outward where the scope looks along the back.
    Vec3 up = Vec3::UnitX() - camera.forward.x() * camera.forward;
    if (up.norm() < 0.1) up = Vec3::UnitZ() - camera.forward.z() * camera.forward;
    camera.up = up.normalized();
    camera.right = camera.forward.cross(camera.up);
    return camera;
}

bool is_nowhere(const ToolSnapshot& tool) { return tool.pose.p.isZero(1e-9); }

Camera camera_of(const Snapshot& snapshot, const std::vector<ToolSpec>& tools) {
    for (int i = 0; i < snapshot.tool_count; ++i) {
        const ToolSnapshot& tool = snapshot.tools[static_cast<size_t>(i)];
        if (tool.kind != ToolKind::kScope) continue;
        const ToolSpec spec =
            static_cast<size_t>(i) < tools.size() ? tools[static_cast<size_t>(i)] : ToolSpec{};
        // It would look from inside the tissue.
        if (is_nowhere(tool)) {
            if (spec.kind != ToolKind::kScope) break;
            return look_at(1000 * haptics::scope_home_m(tools, spec), 1000 * spec.look_at_m,
                           spec.field_of_view_deg);
        }
        Camera camera;
        camera.position_mm = 1000 * tool.pose.p;
        camera.half_angle_rad = half_angle(spec.field_of_view_deg);
        // Tool axes: x right, y down, z into the picture. An oblique optic looks down past its
        // axis.
        const double oblique = -spec.scope_angle_deg * std::numbers::pi / 180.0;
        const Quat q = tool.pose.q.normalized() * Quat(Eigen::AngleAxisd(oblique, Vec3::UnitX()));
        camera.right = q * Vec3::UnitX();
        camera.up = -(q * Vec3::UnitY());
        camera.forward = q * Vec3::UnitZ();
        return camera;
    }
    return look_at(Vec3(-15.4, 0, 25.7), Vec3(0, 0, 0), 70);
}

std::optional<Vec2> place_in_picture(const Camera& camera, const Vec3& mm) {
    const Eigen::Vector4f clip = camera.view_projection() * mm.cast<float>().homogeneous();
    if (clip.w() <= 0.1F) return std::nullopt;
    const Vec2 seen = (clip.head<2>() / clip.w()).cast<double>();
    // The lens of compose.glsl, the other way round: r (1 + k1 r^2 + k2 r^4) = kRim |seen|.
    constexpr double k1 = 0.20, k2 = 0.03, rim = 1 + k1 + k2;
    const double wanted = rim * seen.norm();
    double r = std::min(wanted, 2.0);
    for (int i = 0; i < 8; ++i) {
        const double r2 = r * r;
        r -= (r * (1 + k1 * r2 + k2 * r2 * r2) - wanted) / (1 + 3 * k1 * r2 + 5 * k2 * r2 * r2);
    }
    return seen.norm() > 1e-9 ? Vec2(seen.normalized() * r) : Vec2(Vec2::Zero());
}

}  // namespace placode::view
