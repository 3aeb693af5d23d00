// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/rcm_device_map.h"

#include <gtest/gtest.h>

namespace placode::haptics {
namespace THIS_TEST {

struct Port {
    sim::ToolSpec tool;
    TrocarSettings settings;
    Port() {
        settings = default_trocars(std::span(&tool, 1), "avatar")[0];
        settings.scale = 0.8;
    }
};

TEST(Rcm, PutsTheTipWhereTheAnglesSay) {
    const Port port;
    const RcmMap map(port.tool, port.settings);
    Trocar trocar(port.tool, port.settings);
    const double home_depth = (port.settings.home_tip_m - port.tool.pivot_m).norm();
    const auto tip = [&](const RcmPose& pose) {
        DeviceState state;
        state.position_m = map.handle_m(pose);
        return trocar.tip_pose(state).p;
    };
    EXPECT_LT((tip({0, 0, home_depth, 0}) - port.settings.home_tip_m).norm(), 1e-12);
    // 12 mm deeper, and a turn: the tip is on a sphere around the port.
    const Vec3 deep = tip({0.1, -0.2, home_depth + 0.012, 0});
    EXPECT_NEAR((deep - port.tool.pivot_m).norm(), home_depth + 0.012, 1e-12);
    const Vec3 ahead = (port.settings.home_tip_m - port.tool.pivot_m).normalized();
    // cos of the angle between shafts: cos(pitch) cos(yaw).
    EXPECT_NEAR((deep - port.tool.pivot_m).normalized().dot(ahead), std::cos(0.2) * std::cos(0.1),
                1e-12);
}

TEST(Rcm, CarriesForcesByTheTransposeOfItsMotion) {
    const Port port;
    const RcmMap map(port.tool, port.settings);
    const RcmPose pose{0.15, -0.25, 0.11, 0.4};
    const Vec3 force(0.7, -1.1, 0.4);
    const RcmForce general = map.force(pose, force);
    constexpr double h = 1e-6;  // central differences: error of the order of h^2
    const auto slope = [&](RcmPose up, RcmPose down) {
        return force.dot(map.handle_m(up) - map.handle_m(down)) / (2 * h);
    };
    RcmPose up = pose, down = pose;
    up.yaw_rad += h;
    down.yaw_rad -= h;
    EXPECT_NEAR(general.yaw_nm, slope(up, down), 1e-9);
    up = down = pose;
    up.pitch_rad += h;
    down.pitch_rad -= h;
    EXPECT_NEAR(general.pitch_nm, slope(up, down), 1e-9);
    up = down = pose;
    up.depth_m += h;
    down.depth_m -= h;
    EXPECT_NEAR(general.depth_n, slope(up, down), 1e-9);
}

// Tip force -> handle force (Trocar) -> torques: together d times the lateral force at the tip.
TEST(Rcm, TurnsALateralTipForceIntoDepthTimesForce) {
    Port port;
    port.settings.max_lateral_gain = 100;
    port.settings.scale = 1;
    const RcmMap map(port.tool, port.settings);
    Trocar trocar(port.tool, port.settings);
    const RcmPose pose{0, 0, 0.100, 0};
    DeviceState state;
    state.position_m = map.handle_m(pose);
    const Vec3 shaft = trocar.tip_pose(state).q * Vec3::UnitZ();
    Vec3 lateral = Vec3(0.3, 0.9, -0.2);
    lateral -= lateral.dot(shaft) * shaft;
    const RcmForce general = map.force(pose, trocar.device_force(lateral + 0.5 * shaft));
    EXPECT_NEAR(std::hypot(general.yaw_nm, general.pitch_nm), 0.100 * lateral.norm(), 1e-9);
    EXPECT_NEAR(general.depth_n, 0.5, 1e-9);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
