// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/trocar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::haptics {

namespace {

constexpr double kMinOutsideM = 0.010;  // The handle never enters the port.
constexpr double kTinyM = 1e-6;         // Below this a direction means nothing.
constexpr double kSeenShare = 0.78;     // of half the field of view, from its axis: well inside
constexpr double kFarthestLookM = 0.040;

/// Above the lesion's edge on the instrument's own side, inside the picture.
Vec3 hand_home_m(const sim::ToolSpec& tool) {
    const double side = tool.pivot_m.y() < 0 ? -1 : 1;
    return {-0.003, 0.007 * side, 0.014};
}

}  // namespace

Trocar::Trocar(const sim::ToolSpec& tool, const TrocarSettings& settings)
    : tool_(tool), settings_(settings), tip_from_hand_(Mat3::Identity()) {
    const Vec3 inside = settings_.home_tip_m - tool_.pivot_m;
    const double depth = inside.norm();
    home_shaft_ = depth > kTinyM ? Vec3(inside / depth) : Vec3(0, 0, -1);
    home_handle_m_ = tool_.pivot_m - (tool_.length_m - depth) * home_shaft_;
    // Tool axes at home: z along the shaft, y away from cranial (down in the picture).
    Vec3 up = Vec3::UnitX() - Vec3::UnitX().dot(home_shaft_) * home_shaft_;
    if (up.norm() < 0.1) up = Vec3::UnitZ() - Vec3::UnitZ().dot(home_shaft_) * home_shaft_;
    Mat3 axes;
    axes.col(2) = home_shaft_;
    axes.col(1) = -up.normalized();
    axes.col(0) = axes.col(1).cross(axes.col(2));
    home_q_ = Quat(axes);
    last_ = {settings_.home_tip_m, home_q_};
    DeviceState home;
    last_ = tip_pose(home);
}

Quat Trocar::shaft_orientation(const Vec3& shaft, double roll_rad) const noexcept {
    // The shortest turn from home adds no roll and has no singular direction inside the body.
    const Quat turn = Quat::FromTwoVectors(home_shaft_, shaft);
    const Quat roll(Eigen::AngleAxisd(roll_rad, Vec3::UnitZ()));
    return (turn * home_q_ * roll).normalized();
}

// H outside, r = |P - H|, u = (P - H)/r, tip = P + (L - r) u. With dr = -u.dH and
// du = -(I - u u^T) dH / r follows d tip = [u u^T - (d/r)(I - u u^T)] dH, d = L - r: symmetric.
// At the stops of r the axial part of the motion vanishes, and with it the axial force.
void Trocar::map_handle(const Vec3& hand_m, Vec3& tip_m, Vec3& shaft) noexcept {
    const Vec3 to_port = tool_.pivot_m - hand_m;
    const double r = to_port.norm();
    if (r > kTinyM) shaft = to_port / r;
    const double r_max = tool_.length_m - settings_.min_depth_m;
    const double outside = std::clamp(r, kMinOutsideM, std::max(r_max, kMinOutsideM));
    const double depth = tool_.length_m - outside;
    tip_m = tool_.pivot_m + depth * shaft;
    const Mat3 axial = shaft * shaft.transpose();
    const double ratio = depth / std::max(r, kMinOutsideM);
    tip_from_hand_ = -ratio * (Mat3::Identity() - axial);
    if (outside == r) tip_from_hand_ += axial;
}

void Trocar::map_tip(const Vec3& hand_m, Vec3& tip_m, Vec3& shaft) noexcept {
    const Vec3 inside = hand_m - tool_.pivot_m;
    const double reach = inside.norm();
    if (reach > kTinyM) shaft = inside / reach;
    const double depth = std::clamp(reach, settings_.min_depth_m, tool_.length_m - kMinOutsideM);
    tip_m = tool_.pivot_m + depth * shaft;
    if (depth == reach) {
        tip_from_hand_ = Mat3::Identity();
        tip_m = hand_m;  // Bit for bit what was asked.
    } else {
        tip_from_hand_ =
            depth / std::max(reach, kMinOutsideM) * (Mat3::Identity() - shaft * shaft.transpose());
    }
}

sim::Pose Trocar::tip_pose(const DeviceState& state) noexcept {
    if (!state.position_m.allFinite() || !std::isfinite(state.roll_rad)) return last_;
    const Vec3 moved = settings_.scale * (settings_.R_WD * state.position_m);
    Vec3 shaft = last_.q * Vec3::UnitZ();
    Vec3 tip;
    if (settings_.mapping == Mapping::kHandle)
        map_handle(home_handle_m_ + moved, tip, shaft);
    else
        map_tip(settings_.home_tip_m + moved, tip, shaft);
    const sim::Pose pose{tip, shaft_orientation(shaft, state.roll_rad)};
    if (pose.p.allFinite() && pose.q.coeffs().allFinite()) last_ = pose;
    return last_;
}

Vec3 Trocar::device_position(const Vec3& tip_m) const noexcept {
    Vec3 moved = tip_m - settings_.home_tip_m;
    if (settings_.mapping == Mapping::kHandle) {
        const Vec3 inside = tip_m - tool_.pivot_m;
        const double depth = inside.norm();
        const Vec3 shaft = depth > kTinyM ? Vec3(inside / depth) : Vec3(last_.q * Vec3::UnitZ());
        moved = tool_.pivot_m - (tool_.length_m - depth) * shaft - home_handle_m_;
    }
    return settings_.R_WD.transpose() * moved / settings_.scale;
}

Vec3 Trocar::device_vector(const Vec3& v_T) const noexcept {
    return settings_.R_WD.transpose() * (last_.q * v_T) / settings_.scale;
}

Vec3 Trocar::device_force(const Vec3& tip_force_n) const noexcept {
    Mat3 map = tip_from_hand_;
    if (settings_.mapping == Mapping::kHandle) {
        // Near the port's inside end the lever grows without bound: the lateral part is limited.
        const Vec3 shaft = last_.q * Vec3::UnitZ();
        const Vec3 axial = shaft * shaft.dot(map.transpose() * tip_force_n);
        const Vec3 lateral = map.transpose() * tip_force_n - axial;
        const double limit = settings_.max_lateral_gain * tip_force_n.norm();
        const double size = lateral.norm();
        const Vec3 hand = axial + (size > limit ? Vec3(lateral * (limit / size)) : lateral);
        return settings_.scale * (settings_.R_WD.transpose() * hand);
    }
    return settings_.scale * (settings_.R_WD.transpose() * (map.transpose() * tip_force_n));
}

Mat3 camera_basis(const Vec3& to_port_m) {
    const Vec3 towards = to_port_m.normalized();
    Vec3 up = Vec3::UnitX() - Vec3::UnitX().dot(towards) * towards;
    if (up.norm() < 0.1) up = Vec3::UnitZ() - Vec3::UnitZ().dot(towards) * towards;
    Mat3 basis;
    basis.col(2) = towards;
    basis.col(1) = up.normalized();
    basis.col(0) = basis.col(1).cross(basis.col(2));
    return basis;
}

Vec3 scope_home_m(std::span<const sim::ToolSpec> tools, const sim::ToolSpec& scope) {
    const Vec3 back = (scope.pivot_m - scope.look_at_m).normalized();
    const double half_rad = scope.field_of_view_deg / 2 * std::numbers::pi / 180;
    const double slope = std::tan(kSeenShare * half_rad);
    double needed = 0;
    for (const auto& tool : tools) {
        if (tool.kind == sim::ToolKind::kScope) continue;
        const Vec3 home = hand_home_m(tool) - scope.look_at_m;
        const double along = home.dot(back);
        needed = std::max(needed, along + (home - along * back).norm() / slope);
    }
    return scope.look_at_m + std::max(scope.look_from_m, std::min(needed, kFarthestLookM)) * back;
}

std::vector<TrocarSettings> default_trocars(std::span<const sim::ToolSpec> tools,
                                            std::string_view device) {
    if (device == "script:mouse") device = "mouse";  // a script that moves a mouse
    const bool tip =
        device == "mouse" || device == "keyboard" || device == "gamepad" || device == "spacemouse";
    Vec3 to_port(-0.045, 0, 0.075);
    for (const auto& tool : tools)
        if (tool.kind == sim::ToolKind::kScope) to_port = tool.pivot_m - tool.look_at_m;
    const Mat3 camera = camera_basis(to_port);
    // An arm on the desk is level with the operator, who stands at the caudal side.
    Mat3 desk;
    desk.col(0) = -Vec3::UnitY();
    desk.col(1) = Vec3::UnitZ();
    desk.col(2) = -Vec3::UnitX();

    // A mouse knows two directions: along the tissue, not along the picture, which the scope sees
    // at a slant; otherwise every motion up in the picture would lift the tip by half its way.
    Mat3 level;
    level.col(0) = -Vec3::UnitY();
    level.col(1) = Vec3::UnitX();
    level.col(2) = Vec3::UnitZ();
    const bool flat = device == "mouse" || device == "keyboard" || device == "gamepad";

    std::vector<TrocarSettings> out;
    for (const auto& tool : tools) {
        TrocarSettings settings;
        settings.mapping = tip ? Mapping::kTip : Mapping::kHandle;
        settings.R_WD = tip ? camera : desk;
        if (flat && tool.kind != sim::ToolKind::kScope) settings.R_WD = level;
        settings.home_tip_m =
            tool.kind == sim::ToolKind::kScope ? scope_home_m(tools, tool) : hand_home_m(tool);
        out.push_back(settings);
    }
    return out;
}

uint32_t others_in_port(std::span<const sim::ToolSpec> tools, size_t i) noexcept {
    uint32_t others = 0;
    if (tools[i].kind == sim::ToolKind::kScope) return others;
    for (size_t k = 0; k < tools.size(); ++k) {
        if (k != i && tools[k].kind != sim::ToolKind::kScope && tools[k].hand == tools[i].hand)
            others |= 1U << k;
    }
    return others;
}

std::vector<TrocarSettings> default_trocars(std::span<const sim::ToolSpec> tools,
                                            std::string_view device, const Station& station) {
    std::vector<TrocarSettings> out = default_trocars(tools, device);
    // An instrument in a port (avatar) is as it is.
    if (device != "openhaptics" && device != "haply" && device != "forcedimension") return out;
    for (size_t i = 0; i < out.size(); ++i) {
        if (tools[i].kind == sim::ToolKind::kScope) continue;
        out[i].scale = station.number("arm.scale");
        if (station.text("arm.mapping") == "tip") out[i].mapping = Mapping::kTip;
    }
    return out;
}

}  // namespace placode::haptics
