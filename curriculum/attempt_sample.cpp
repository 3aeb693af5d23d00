// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_sample.h"

#include <cmath>
#include <numbers>

namespace placode::curriculum {

using sim::Vec3;

bool tip_in_view(const sim::Scene& scene, const sim::State& state, size_t tool) noexcept {
    for (size_t i = 0; i < scene.tools.size(); ++i) {
        const sim::ToolSpec& scope = scene.tools[i];
        if (scope.kind != sim::ToolKind::kScope) continue;
        if (i == tool) return true;
        const sim::Pose& pose = state.tools[i].proxy;
        // An oblique scope looks down in its own picture (+y of the camera is down).
        const double tilt = scope.scope_angle_deg * std::numbers::pi / 180;
        const Vec3 axis = pose.q * Vec3(0, std::sin(tilt), std::cos(tilt));
        const Vec3 away = state.tools[tool].proxy.p - pose.p;
        const double half = scope.field_of_view_deg / 2 * std::numbers::pi / 180;
        return away.dot(axis) >= away.norm() * std::cos(half);
    }
    return true;
}

sim::Sample sample_of(const sim::Scene& scene, const sim::State& state,
                      std::span<const sim::ToolInput> inputs) noexcept {
    sim::Sample sample;
    sample.time_s = state.time_s;
    for (size_t i = 0; i < scene.tools.size(); ++i) {
        const sim::ToolState& tool = state.tools[i];
        sim::ToolSample& out = sample.tools[i];
        sim::ToolInput pose;  // for its conversion to float
        pose.set_pose(tool.proxy);
        out.tip_m = pose.position_m;
        out.orientation = pose.orientation;
        for (int k = 0; k < 3; ++k)
            out.force_n[static_cast<size_t>(k)] = static_cast<float>(tool.force_n[k]);
        out.jaw_rad = inputs[i].jaw_rad;
        out.tip_gap_m = static_cast<float>(tool.tip_gap_m);
        out.power_w = static_cast<float>(tool.power_in_tissue_w);
        out.pedals = inputs[i].pedals;
        out.in_contact = tool.in_contact;
        out.in_view = tip_in_view(scene, state, i) ? 1 : 0;
        out.touched = tool.touched;
    }
    sample.placode_peak_c = state.ledger.placode_peak_c;
    sample.placode_peak_cem43_min = state.ledger.placode_peak_cem43_min;
    sample.placode_burned_m3 = state.ledger.placode_burned_m3;
    sample.phase = state.phase;
    return sample;
}

}  // namespace placode::curriculum
