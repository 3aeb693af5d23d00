// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A device tried by itself, with stand-ins: signals, the floor with its ceiling, which hand.
#include "haptics/catalogue/device_trial.h"

#include <gmock/gmock.h>

#include <chrono>
#include <functional>
#include <limits>

#include "haptics/real_time.h"
#include "tests/stand_in/haply_service.h"

namespace placode::haptics {
namespace THIS_TEST {

using test::HaplyService;
using ::testing::HasSubstr;

TrialSettings settings(const HaplyService& service) {
    TrialSettings out;
    out.device = "haply";
    out.station.set("haply.port", std::to_string(service.port()));
    // A busy computer lets the servo wait more than 5 ms again and again: the ramp never ends.
    out.servo_gap_s = 0.5;
    return out;
}

/// Looks until `done`; the limit only keeps a broken build from hanging.
bool until(DeviceTrial& trial, const std::function<bool(const TrialReport&)>& done) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < limit) {
        if (done(trial.report())) return true;
        sleep_until(monotonic_ns() + 2'000'000);
    }
    return false;
}

bool ready(const TrialReport& report) {
    for (const TrialArm& arm : report.arms)
        if (arm.state.status != DeviceStatus::kReady) return false;
    return !report.arms.empty();
}

/// Moves an arm slowly: half a millimetre at a time along the device's z, which is our y.
void lower(HaplyService& service, DeviceTrial& trial, double to_m) {
    double z = 0;
    service.change([&](auto& s) { z = s.arms[0].position[2]; });
    while (std::abs(z - to_m) > 1e-9) {
        z = z > to_m ? std::max(to_m, z - 0.0005) : std::min(to_m, z + 0.0005);
        service.change([&](auto& s) { s.arms[0].position[2] = z; });
        const int seen = service.messages;
        ASSERT_TRUE(until(trial, [&](const TrialReport&) { return service.messages > seen + 2; }));
    }
}

TEST(DeviceTrial, KnowsWhatCanBeTried) {
    TrialSettings mouse;
    mouse.device = "mouse";
    try {
        const DeviceTrial trial(mouse);
        FAIL() << "no error";
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), HasSubstr("found \"mouse\", expected one of openhaptics, haply"));
    }
}

TEST(DeviceTrial, ShowsSignalsAndPushesFromTheFloorWithHalfANewtonAtMost) {
    HaplyService service;
    DeviceTrial trial(settings(service));
    trial.start();
    ASSERT_TRUE(until(trial, ready));
    EXPECT_EQ(trial.report().arms.size(), 1u);
    EXPECT_EQ(trial.report().arms[0].info.serial, "04EA");
    EXPECT_EQ(trial.report().force_n, kFirstForceN);
    EXPECT_EQ(trial.report().stiffness_n_m, kFirstStiffnessNM);
    // In air there is no force but a little drag.
    lower(service, trial, -0.004);
    ASSERT_TRUE(until(trial, [](const TrialReport& r) {
        return std::abs(r.arms[0].state.position_m.y() + 0.004) < 1e-6;
    }));
    EXPECT_LT(trial.report().arms[0].force_n.norm(), 0.1);
    // The floor is 10 mm below where the arm is now.
    trial.set_floor(true);
    ASSERT_TRUE(until(
        trial, [](const TrialReport& r) { return std::abs(r.arms[0].height_m - 0.010) < 1e-4; }));
    lower(service, trial, -0.016);
    // 2 mm into it at 100 N/m; after the ramp.
    ASSERT_TRUE(until(trial, [](const TrialReport& r) {
        return std::abs(r.arms[0].force_n.y() - 0.2) < 0.01;
    })) << trial.report().arms[0].force_n.transpose();
    lower(service, trial, -0.030);
    ASSERT_TRUE(until(
        trial, [](const TrialReport& r) { return std::abs(r.arms[0].force_n.y() - 0.5) < 1e-3; }));
    // The service got it through the device's axes: our y is its z.
    EXPECT_NEAR(service.force(0)[2], 0.5, 0.01);
    EXPECT_LE(trial.report().certificate.peak_force_n, kFirstForceN + 1e-9);
    trial.set_floor(false);
    EXPECT_TRUE(until(trial, [](const TrialReport& r) { return r.arms[0].force_n.norm() < 0.05; }));
    trial.stop();
    EXPECT_EQ(service.force(0)[2], 0) << "the last force is none";
}

TEST(DeviceTrial, IsAsGentleWhereItsForceIsNoNumber) {
    for (const double force_n :
         {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::quiet_NaN(),
          std::numeric_limits<double>::infinity()}) {
        HaplyService service;
        TrialSettings none = settings(service);
        none.force_n = force_n;
        DeviceTrial trial(none);
        EXPECT_EQ(trial.report().force_n, kFirstForceN) << force_n;
        EXPECT_EQ(trial.report().stiffness_n_m, kFirstStiffnessNM) << force_n;
    }
}

TEST(DeviceTrial, IsNoStifferForAHandWhoseMotionIsMadeLarger) {
    HaplyService service;
    TrialSettings large = settings(service);
    large.station.set("arm.scale", "2");
    DeviceTrial trial(large);
    trial.start();
    ASSERT_TRUE(until(trial, ready));
    EXPECT_DOUBLE_EQ(trial.report().stiffness_n_m, kFirstStiffnessNM);
    trial.set_floor(true);
    ASSERT_TRUE(until(
        trial, [](const TrialReport& r) { return std::abs(r.arms[0].height_m - 0.010) < 1e-4; }));
    lower(service, trial, -0.012);
    // 2 mm of the hand into it at 100 N/m; after the ramp.
    EXPECT_TRUE(until(trial, [](const TrialReport& r) {
        return std::abs(r.arms[0].force_n.y() - 0.2) < 0.01;
    })) << trial.report().arms[0].force_n.transpose();
}

TEST(DeviceTrial, GivesNoForceToAnArmThatIsNotCalibrated) {
    HaplyService service;
    service.change([](auto& s) { s.arms[0].calibrated = false; });
    DeviceTrial trial(settings(service));
    trial.start();
    trial.set_floor(true);
    ASSERT_TRUE(until(trial, [](const TrialReport& r) {
        return r.arms[0].state.status == DeviceStatus::kNotCalibrated;
    }));
    service.change([](auto& s) { s.arms[0].position[2] = -0.03; });
    const int seen = service.messages;
    ASSERT_TRUE(until(trial, [&](const TrialReport&) { return service.messages > seen + 50; }));
    EXPECT_EQ(trial.report().arms[0].force_n, Vec3::Zero());
}

TEST(DeviceTrial, FindsOutWhichArmIsInTheHandAndSwapsThem) {
    HaplyService service;
    service.change([](auto& s) {
        s.arms.resize(2);
        s.arms[0].id = "A";
        s.arms[0].handedness = s.arms[1].handedness = "";
        s.arms[1].id = "B";
    });
    TrialSettings two = settings(service);
    two.station.set("haply.right", "A");
    two.station.set("haply.left", "B");
    {
        DeviceTrial trial(two);
        trial.start();
        ASSERT_TRUE(until(trial, ready));
        ASSERT_EQ(trial.report().arms.size(), 2u);
        trial.identify();
        ASSERT_TRUE(until(trial, [](const TrialReport& r) { return r.identity.asked; }));
        // The person moves what is in the right hand to and fro: it is the arm called left.
        for (int i = 1; i <= 40; ++i) {
            service.change([&](auto& s) { s.arms[1].position[0] = 0.002 * (i % 2); });
            const int seen = service.messages;
            ASSERT_TRUE(
                until(trial, [&](const TrialReport&) { return service.messages > seen + 2; }));
        }
        ASSERT_TRUE(until(trial, [](const TrialReport& r) { return r.identity.arm == 1; }));
        const TrialReport report = trial.report();
        const DeviceInfo infos[] = {report.arms[0].info, report.arms[1].info};
        swap_hands(two.station, "haply", infos);
    }
    EXPECT_EQ(two.station.text("haply.right"), "B");
    DeviceTrial again(two);
    EXPECT_EQ(again.report().arms[0].info.serial, "B");
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
