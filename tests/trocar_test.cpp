// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/trocar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace placode::haptics {
namespace THIS_TEST {

sim::ToolSpec needle() {
    sim::ToolSpec tool;
    tool.kind = sim::ToolKind::kNeedle;
    return tool;
}

sim::ToolSpec scope() {
    sim::ToolSpec tool;
    tool.kind = sim::ToolKind::kScope;
    tool.pivot_m = Vec3(-0.045, 0, 0.075);
    return tool;
}

TrocarSettings settings_for(Mapping mapping) {
    const std::vector<sim::ToolSpec> tools{needle(), scope()};
    TrocarSettings settings = default_trocars(tools, mapping == Mapping::kTip ? "mouse" : "x")[0];
    EXPECT_EQ(settings.mapping, mapping);
    settings.scale = 0.7;
    return settings;
}

/// From the port to the tip.
double depth_m(const sim::Pose& pose) { return (pose.p - needle().pivot_m).norm(); }

class EveryMapping : public ::testing::TestWithParam<Mapping> {};

TEST_P(EveryMapping, TakesTheTipToTheDeviceAndBack) {
    Trocar trocar(needle(), settings_for(GetParam()));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> side(-0.02, 0.02), height(-0.005, 0.02);
    for (int i = 0; i < 500; ++i) {
        const Vec3 tip(side(random), side(random), height(random));
        DeviceState state;
        state.position_m = trocar.device_position(tip);
        // Two square roots and some sums in double: 1e-9 m is generous, 1e-15 is typical.
        EXPECT_LT((trocar.tip_pose(state).p - tip).norm(), 1e-9);
    }
}

TEST_P(EveryMapping, IsAtHomeWhenTheDeviceIsAtItsCentre) {
    const TrocarSettings settings = settings_for(GetParam());
    Trocar trocar(needle(), settings);
    EXPECT_LT((trocar.tip_pose(DeviceState{}).p - settings.home_tip_m).norm(), 1e-12);
}

TEST_P(EveryMapping, KeepsTheShaftInThePort) {
    Trocar trocar(needle(), settings_for(GetParam()));
    DeviceState state;
    state.position_m = Vec3(0.012, -0.007, 0.004);
    state.roll_rad = 0.4;
    const sim::Pose pose = trocar.tip_pose(state);
    const Vec3 port_in_tool = pose.inverse() * needle().pivot_m;
    EXPECT_NEAR(port_in_tool.head<2>().norm(), 0, 1e-12);
    EXPECT_NEAR(port_in_tool.z(), -depth_m(pose), 1e-12);
}

// F_h . v_h = F_t . v_t: the force map is the transpose of the motion map.
TEST_P(EveryMapping, ConservesPowerBetweenTipAndHand) {
    Trocar trocar(needle(), settings_for(GetParam()));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-1, 1);
    const auto vector = [&] { return Vec3(u(random), u(random), u(random)); };
    for (int i = 0; i < 200; ++i) {
        const Vec3 x = 0.01 * vector(), v = vector(), force = vector();
        // Central difference at 1e-5 m of a map with curvature 1/0.1 m: error below 1e-7.
        const double h = 1e-5;
        DeviceState before, after, here;
        before.position_m = x - h * v;
        after.position_m = x + h * v;
        here.position_m = x;
        const Vec3 tip_velocity = (trocar.tip_pose(after).p - trocar.tip_pose(before).p) / (2 * h);
        static_cast<void>(trocar.tip_pose(here));
        EXPECT_NEAR(trocar.device_force(force).dot(v), force.dot(tip_velocity), 1e-6);
    }
}

TEST_P(EveryMapping, KeepsTheLastPoseForNumbersThatAreNone) {
    Trocar trocar(needle(), settings_for(GetParam()));
    DeviceState state;
    state.position_m = Vec3(0.003, 0.002, 0.001);
    const sim::Pose good = trocar.tip_pose(state);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        DeviceState broken = state;
        broken.position_m.y() = bad;
        EXPECT_EQ(trocar.tip_pose(broken).p, good.p);
        broken = state;
        broken.roll_rad = bad;
        EXPECT_EQ(trocar.tip_pose(broken).q.coeffs(), good.q.coeffs());
    }
}

TEST_P(EveryMapping, StaysFiniteThroughThePort) {
    const TrocarSettings settings = settings_for(GetParam());
    Trocar trocar(needle(), settings);
    const Vec3 home =
        GetParam() == Mapping::kTip
            ? settings.home_tip_m
            : Vec3(needle().pivot_m - (needle().length_m - depth_m(trocar.tip_pose({}))) *
                                          (settings.home_tip_m - needle().pivot_m).normalized());
    const Vec3 to_port = settings.R_WD.transpose() * (needle().pivot_m - home) / settings.scale;
    for (int i = 0; i <= 20; ++i) {
        DeviceState state;
        state.position_m = to_port * (0.1 * i);  // Exactly at the port when i = 10, then beyond.
        const sim::Pose pose = trocar.tip_pose(state);
        EXPECT_TRUE(pose.p.allFinite());
        EXPECT_NEAR(pose.q.norm(), 1, 1e-12);
        EXPECT_GE(depth_m(pose), settings.min_depth_m - 1e-12);
        EXPECT_LE(depth_m(pose), needle().length_m - 0.010 + 1e-12);
        const Vec3 force = trocar.device_force(Vec3(1, 1, 1));
        EXPECT_LE(force.norm(), 3.2 * std::sqrt(3.0) * settings.scale);
    }
}

INSTANTIATE_TEST_SUITE_P(Trocar, EveryMapping, ::testing::Values(Mapping::kHandle, Mapping::kTip),
                         [](const auto& info) {
                             return info.param == Mapping::kTip ? "Tip" : "Handle";
                         });

TEST(Trocar, InvertsLateralHandleMotionAndScalesItByTheLever) {
    TrocarSettings settings = settings_for(Mapping::kHandle);
    settings.scale = 1;
    Trocar trocar(needle(), settings);
    const Vec3 shaft = (settings.home_tip_m - needle().pivot_m).normalized();
    const Vec3 across = shaft.cross(Vec3::UnitX()).normalized();
    DeviceState state;
    state.position_m = settings.R_WD.transpose() * (1e-5 * across);
    const Vec3 moved = trocar.tip_pose(state).p - settings.home_tip_m;
    const double depth = (settings.home_tip_m - needle().pivot_m).norm();
    EXPECT_NEAR(moved.dot(across), -1e-5 * depth / (needle().length_m - depth), 1e-9);
}

TEST(Trocar, LimitsTheLateralForceNearTheEndOfTheShaft) {
    TrocarSettings settings;
    settings.home_tip_m = needle().pivot_m + Vec3(0, 0, -0.185);  // 15 mm outside: lever 12.
    Trocar trocar(needle(), settings);
    EXPECT_NEAR(trocar.device_force(Vec3(0.1, 0, 0)).norm(), 0.3, 1e-9);
    EXPECT_NEAR(trocar.device_force(Vec3(0, 0, 0.1)).norm(), 0.1, 1e-9);
}

TEST(Port, IsSharedByTheInstrumentsOfOneHandAndNeverByAScope) {
    std::vector<sim::ToolSpec> tools{needle(), needle(), needle(), scope()};
    tools[1].hand = sim::Hand::kLeft;
    EXPECT_EQ(others_in_port(tools, 0), 0b0100U);
    EXPECT_EQ(others_in_port(tools, 1), 0U);
    EXPECT_EQ(others_in_port(tools, 2), 0b0001U);
    tools[3].hand = sim::Hand::kRight;
    EXPECT_EQ(others_in_port(tools, 0), 0b0100U);
    EXPECT_EQ(others_in_port(tools, 3), 0U);
}

TEST(DefaultTrocars, LookWithTheScopeAtTheLesionFromThirtyMillimetres) {
    const std::vector<sim::ToolSpec> tools{needle(), scope()};
    for (const char* device : {"mouse", "script:expert"}) {
        const auto trocars = default_trocars(tools, device);
        ASSERT_EQ(trocars.size(), 2u);
        Trocar trocar(scope(), trocars[1]);
        const sim::Pose pose = trocar.tip_pose(DeviceState{});
        EXPECT_NEAR(pose.p.norm(), 0.030, 1e-9);
        const Vec3 view = pose.q * Vec3::UnitZ();
        EXPECT_LT((view + pose.p.normalized()).norm(), 1e-9) << "+z points at the lesion";
        // Cranial is up: the picture's down (+y of the tool) has no cranial part.
        EXPECT_LT((pose.q * Vec3::UnitY()).x(), -0.5);
        EXPECT_LT((pose.q * Vec3::UnitX() + Vec3::UnitY()).norm(), 1e-9);
    }
}

TEST(DefaultTrocars, LookAtTheWorkFromWhereTheHandsAreSeenToo) {
    sim::ToolSpec left = needle();
    left.hand = sim::Hand::kLeft;
    left.pivot_m = Vec3(0.0105, 0.085, 0.029);
    std::vector<sim::ToolSpec> tools{needle(), left, scope()};
    tools[2].look_at_m = Vec3(0.011, 0, 0);
    for (const char* device : {"mouse", "script:expert"}) {
        const auto trocars = default_trocars(tools, device);
        const sim::Pose pose = Trocar(tools[2], trocars[2]).tip_pose(DeviceState{});
        const Vec3 to_work = tools[2].look_at_m - pose.p;
        EXPECT_LT((pose.q * Vec3::UnitZ() - to_work.normalized()).norm(), 1e-9) << device;
        EXPECT_LT((pose.p - tools[2].pivot_m).cross(to_work).norm(), 1e-9)
            << "in line with its port";
        EXPECT_GT(to_work.norm(), 0.030) << "drawn back";
        EXPECT_LT(to_work.norm(), 0.036);
        for (size_t i = 0; i < 2; ++i) {
            const Vec3 to_tip = trocars[i].home_tip_m - pose.p;
            const double angle =
                std::acos(to_tip.normalized().dot(to_work.normalized())) * 180 / M_PI;
            EXPECT_LT(angle, 28) << "half of the 70 degree picture, less a margin; tool " << i;
        }
    }
    // The hands begin where they always do.
    const auto before = default_trocars(std::vector<sim::ToolSpec>{needle(), scope()}, "mouse");
    EXPECT_EQ(default_trocars(tools, "mouse")[0].home_tip_m, before[0].home_tip_m);
}

TEST(DefaultTrocars, LookFromAsFarAsTheSceneSays) {
    std::vector<sim::ToolSpec> tools{needle(), scope()};
    tools[1].look_from_m = 0.038;
    EXPECT_NEAR(default_trocars(tools, "mouse")[1].home_tip_m.norm(), 0.038, 1e-9);
}

TEST(DefaultTrocars, PutTheNeedleAboveTheEdgeInsideThePicture) {
    const std::vector<sim::ToolSpec> tools{needle(), scope()};
    const auto trocars = default_trocars(tools, "mouse");
    const Vec3 home = trocars[0].home_tip_m;
    EXPECT_GT(home.z(), 0.012);
    EXPECT_LT(home.z(), 0.017);
    const Vec3 to_tip = home - trocars[1].home_tip_m;
    const Vec3 view = -trocars[1].home_tip_m.normalized();
    const double angle = std::acos(to_tip.normalized().dot(view)) * 180 / M_PI;
    EXPECT_LT(angle, 33) << "half of the 70 degree picture, less a margin";
}

TEST(DefaultTrocars, MoveTheTipRightInThePictureWhenTheDeviceMovesRight) {
    const std::vector<sim::ToolSpec> tools{needle(), scope()};
    const auto trocars = default_trocars(tools, "spacemouse");
    Trocar tip(needle(), trocars[0]);
    Trocar camera(scope(), trocars[1]);
    const sim::Pose X_WC = camera.tip_pose(DeviceState{});
    const Vec3 before = X_WC.inverse() * tip.tip_pose(DeviceState{}).p;
    const Vec3 want[3] = {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)};  // C: y down, z inwards
    for (int axis = 0; axis < 3; ++axis) {
        DeviceState state;
        state.position_m[axis] = 0.005;
        const Vec3 moved = X_WC.inverse() * tip.tip_pose(state).p - before;
        EXPECT_LT((moved - 0.005 * want[axis]).norm(), 1e-9) << "device axis " << axis;
    }
}

TEST(DefaultTrocars, AMouseMovesAlongTheTissueAndItsWheelAwayFromIt) {
    const std::vector<sim::ToolSpec> tools{needle(), scope()};
    for (const char* device : {"mouse", "keyboard", "gamepad"}) {
        const auto trocars = default_trocars(tools, device);
        Trocar tip(needle(), trocars[0]);
        const Vec3 before = tip.tip_pose(DeviceState{}).p;
        const Vec3 want[3] = {Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)};
        for (int axis = 0; axis < 3; ++axis) {
            DeviceState state;
            state.position_m[axis] = 0.005;
            const Vec3 moved = tip.tip_pose(state).p - before;
            EXPECT_LT((moved - 0.005 * want[axis]).norm(), 1e-9) << device << " axis " << axis;
        }
    }
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
