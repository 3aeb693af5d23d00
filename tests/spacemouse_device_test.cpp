// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The SpaceMouse driver against a socket that speaks as spacenavd does. No hardware.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/catalogue/open_device.h"
#include "tests/stand_in/space_daemon.h"

namespace placode::haptics {
namespace THIS_TEST {

using ::testing::HasSubstr;
using Daemon = test::SpaceDaemon;

struct Session {
    explicit Session(Daemon& daemon, sim::ToolKind kind = sim::ToolKind::kNeedle) {
        DeviceConfig config;
        config.name = "spacemouse";
        config.tools.resize(1);
        config.tools[0].kind = kind;
        config.station.set("spacemouse.socket", daemon.path);
        device = open_device(config);
        daemon.accept_client();
        read(5);
    }
    const DeviceState& read(int ms) {
        for (int i = 0; i < ms; ++i) device->read(t_ns += 1'000'000, states);
        return states[0];
    }
    std::unique_ptr<DeviceGroup> device;
    std::array<DeviceState, 1> states;
    int64_t t_ns = 0;
};

TEST(SpaceMouse, SaysHowToInstallTheDaemon) {
    DeviceConfig config;
    config.name = "spacemouse";
    config.tools.resize(1);
    config.station.set("spacemouse.socket", "/nowhere/spnav.sock");
    try {
        (void)open_device(config);
        FAIL();
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/nowhere/spnav.sock: No such file"));
        EXPECT_THAT(error.what(), HasSubstr("apt install spacenavd"));
    }
}

TEST(SpaceMouse, MovesAtARateWhileTheCapIsPushed) {
    Daemon daemon;
    Session session(daemon);
    for (int i = 0; i < 50; ++i) {
        daemon.event(0, {350, 175, -350, 0, 0, 0, 10});
        session.read(10);
    }
    const Vec3 start = session.states[0].position_m;
    for (int i = 0; i < 10; ++i) {
        daemon.event(0, {350, 175, -350, 0, 0, 0, 10});
        session.read(10);
    }
    const Vec3 moved = session.states[0].position_m - start;
    EXPECT_NEAR(moved.x(), 0.004, 2e-4) << "full deflection, 40 mm/s for 0.1 s";
    EXPECT_NEAR(moved.y(), 0.004 * (175 - 15) / 335, 2e-4) << "behind the dead zone of 15";
    EXPECT_GT(moved.z(), 0) << "pulled towards the operator: back";
}

TEST(SpaceMouse, StandsStillWithoutEventsAndInTheDeadZone) {
    Daemon daemon;
    Session session(daemon);
    daemon.event(0, {350, 0, 0, 0, 0, 0, 10});
    session.read(500);
    const Vec3 rest = session.states[0].position_m;
    EXPECT_GT(rest.x(), 0.001);
    // The eased end of the motion, a hundredth of a millimetre, is all that may follow.
    EXPECT_LT((session.read(300).position_m - rest).norm(), 1e-5)
        << "the daemon never sent the zero";
    daemon.event(0, {14, -15, 3, 0, 0, 0, 10});
    EXPECT_LT((session.read(200).position_m - rest).norm(), 1e-5);
}

TEST(SpaceMouse, StandsStillInAPauseWhateverIsPushed) {
    Daemon daemon;
    Session session(daemon);
    for (int i = 0; i < 30; ++i) {
        daemon.event(0, {350, 0, 0, 0, 0, 0, 10});
        session.read(10);
    }
    const Vec3 before = session.states[0].position_m;
    EXPECT_GT(before.x(), 0.005);
    session.device->hold(true);
    daemon.event(1, {0, 0, 0, 0, 0, 0, 0});
    for (int i = 0; i < 30; ++i) {
        daemon.event(0, {350, 0, 0, 0, 350, 0, 10});
        EXPECT_EQ(session.read(10).position_m, before);
        EXPECT_EQ(session.states[0].roll_rad, 0);
        EXPECT_EQ(session.states[0].pedals, 0);
    }
    daemon.event(0, {0, 0, 0, 0, 0, 0, 10});
    session.read(1);
    session.device->hold(false);
    EXPECT_EQ(session.read(20).position_m, before) << "nothing is made up for";
    EXPECT_EQ(session.states[0].pedals, 0) << "to be pressed anew";
    daemon.event(0, {350, 0, 0, 0, 0, 0, 10});
    EXPECT_GT(session.read(50).position_m.x(), before.x());
}

TEST(SpaceMouse, KeepsItsJawsAsTheyAreThroughAPause) {
    Daemon daemon;
    Session session(daemon, sim::ToolKind::kScissors);
    const double open = session.read(500).jaw_rad;
    daemon.event(1, {0, 0, 0, 0, 0, 0, 0});
    const double closed = session.read(1000).jaw_rad;
    EXPECT_LT(closed, open);
    session.device->hold(true);
    EXPECT_EQ(session.read(300).jaw_rad, closed);
    session.device->hold(false);
    EXPECT_EQ(session.read(300).jaw_rad, closed) << "the button is still held";
    daemon.event(2, {0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(session.read(1000).jaw_rad, open);
}

TEST(SpaceMouse, DrainsItsQueue) {
    Daemon daemon;
    Session session(daemon);
    for (int i = 0; i < 100; ++i) daemon.event(0, {350, 0, 0, 0, 0, 0, 10});
    daemon.event(0, {0, 0, 0, 0, 0, 0, 10});
    EXPECT_LT(session.read(500).position_m.norm(), 1e-6) << "the last event counts, at rest";
}

TEST(SpaceMouse, PressesPedalsByItsButtonsAndLetsGoWhenTheDaemonDies) {
    Daemon daemon;
    Session session(daemon);
    daemon.event(1, {0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(session.read(2).pedals, sim::kPedalCut);
    daemon.event(2, {0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(session.read(2).pedals, 0);
    daemon.event(1, {1, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(session.read(2).pedals, sim::kPedalCoag);
    daemon.quit();
    EXPECT_EQ(session.read(2).pedals, 0);
    EXPECT_EQ(session.states[0].status, DeviceStatus::kLost);
    daemon.listen_again();
    session.read(1100);  // it looks once a second
    EXPECT_EQ(session.states[0].status, DeviceStatus::kReady);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
