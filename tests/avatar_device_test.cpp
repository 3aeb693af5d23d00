// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The Haptic Avatar driver against stand-ins on pseudo-terminals. No hardware: signs and the zero
// of the depth of a real device are not shown here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/rcm_device_map.h"
#include "tests/count_allocations.h"
#include "tests/device_session.h"
#include "tests/stand_in/avatar_port.h"

namespace placode::haptics {
namespace THIS_TEST {

using test::AvatarPort;
using test::error_of;
using ::testing::HasSubstr;
using Session = test::DeviceSession<1>;

DeviceConfig config(const AvatarPort& port) {
    DeviceConfig out;
    out.name = "avatar";
    out.tools.resize(1);
    out.tools[0].kind = sim::ToolKind::kGrasper;
    out.station.set("avatar.right", port.path());
    out.station.set("avatar.settle_s", "0");
    return out;
}

/// 0.1 rad and 120 mm, as the device says it.
std::vector<int> angles(double roll, double pitch, double depth_mm, double yaw) {
    const auto scaled = [](double v) { return static_cast<int>(std::lround(v * 10'000)); };
    return {scaled(roll), scaled(pitch), scaled(depth_mm), scaled(yaw)};
}

TEST(Avatar, SaysWhatIsWrongWithThePort) {
    DeviceConfig wrong;
    wrong.name = "avatar";
    wrong.tools.resize(1);
    wrong.station.set("avatar.right", "/dev/nothing");
    EXPECT_THAT(error_of(wrong), HasSubstr("/dev/nothing: No such file"));
    EXPECT_THAT(error_of(wrong), HasSubstr("dialout"));
    AvatarPort port;
    port.change([](auto& p) { p.silent = true; });
    EXPECT_THAT(error_of(config(port)), HasSubstr("no Haptic Avatar answers"));
    wrong.station.set("avatar.signs", "1 1 1 2");
    wrong.station.set("avatar.right", port.path());
    EXPECT_THAT(error_of(wrong), HasSubstr("avatar.signs"));
    wrong.station.set("avatar.left", port.path());
    EXPECT_THAT(error_of(wrong), HasSubstr("both"));
}

TEST(Avatar, PutsTheInstrumentWhereAnglesAndDepthSay) {
    AvatarPort port;
    port.change([](auto& p) { p.answers[2] = angles(0.3, -0.1, 70, 0.2); });
    const DeviceConfig what = config(port);
    Session session(what);
    ASSERT_TRUE(session.until([&] { return session.states[0].status == DeviceStatus::kReady; }));
    const RcmMap map(what.tools[0], default_trocars(what.tools, "avatar")[0]);
    const Vec3 expected = map.handle_m({0.2, -0.1, 0.070, 0.3});
    EXPECT_LT((session.states[0].position_m - expected).norm(), 1e-9)
        << "the instrument stands in its port: no fresh start";
    EXPECT_NEAR(session.states[0].roll_rad, 0.3, 1e-9);
}

// Its place is that of the instrument: it cannot be taken up elsewhere like other arms.
TEST(Avatar, WaitsBehindAPauseForItsInstrumentToComeBack) {
    AvatarPort port;
    port.change([](auto& p) { p.answers[2] = angles(0.3, -0.1, 70, 0.2); });
    const DeviceConfig what = config(port);
    const RcmMap map(what.tools[0], default_trocars(what.tools, "avatar")[0]);
    Session session(what);
    const DeviceState& hand = session.states[0];
    const auto stands_at = [&](double depth_m) {
        return (hand.position_m - map.handle_m({0.2, -0.1, depth_m, 0.3})).norm() < 1e-9;
    };
    const auto heard = [&] {  // what was changed before, for certain
        const int seen = port.lines;
        return session.until([&] { return port.lines > seen + 4; }, Vec3(1, 1, 1));
    };
    ASSERT_TRUE(session.until([&] { return hand.engaged && stands_at(0.070); }));
    session.device->hold(true);
    session.tick();
    port.change([](auto& p) { p.answers[2] = angles(1.0, -0.1, 90, 0.2); });
    ASSERT_TRUE(heard());
    EXPECT_TRUE(stands_at(0.070));
    EXPECT_TRUE(hand.engaged) << "held, not let go";
    session.device->hold(false);
    ASSERT_TRUE(heard());
    EXPECT_TRUE(stands_at(0.070)) << "20 mm away";
    EXPECT_TRUE(hand.clutched);
    EXPECT_EQ(port.forces()[2], 0);
    port.change([](auto& p) { p.answers[2] = angles(1.0, -0.1, 71, 0.2); });
    EXPECT_TRUE(session.until([&] { return !hand.clutched; }));
    EXPECT_TRUE(stands_at(0.071)) << "met";
    EXPECT_NEAR(hand.roll_rad, 0.3, 1e-9) << "turned on from what it had";
    // Or it is drawn out, which lets go, and comes in anew.
    session.device->hold(true);
    session.tick();
    port.change([](auto& p) { p.answers[2] = angles(0.3, -0.1, 90, 0.2); });
    ASSERT_TRUE(heard());
    session.device->hold(false);
    ASSERT_TRUE(heard());
    EXPECT_TRUE(hand.clutched);
    port.change([](auto& p) { p.answers[28] = {0}; });
    ASSERT_TRUE(session.until([&] { return !hand.engaged; }));
    port.change([](auto& p) { p.answers[28] = {1}; });
    EXPECT_TRUE(session.until([&] { return hand.engaged && stands_at(0.090); }));
    EXPECT_FALSE(hand.clutched);
    EXPECT_NEAR(hand.roll_rad, 0.3, 1e-9);
}

TEST(Avatar, SendsTorquesAndThrustByTheTranspose) {
    AvatarPort port;
    port.change([](auto& p) { p.answers[2] = angles(0, -0.1, 70, 0.2); });
    const DeviceConfig what = config(port);
    Session session(what);
    const Vec3 force(0.4, -0.7, 1.1);
    const RcmMap map(what.tools[0], default_trocars(what.tools, "avatar")[0]);
    const RcmForce expected = map.force({0.2, -0.1, 0.070, 0}, force);
    ASSERT_TRUE(session.until([&] { return port.forces()[2] != 0; }, force));
    EXPECT_EQ(port.enabled, 1) << "force feedback is switched on once calibrated";
    EXPECT_NEAR(port.forces()[1], expected.pitch_nm * 1e4, 1);
    EXPECT_NEAR(port.forces()[2], expected.depth_n * 1e4, 1);
    EXPECT_NEAR(port.forces()[3], expected.yaw_nm * 1e4, 1);
    EXPECT_EQ(port.forces()[0], 0);
}

TEST(Avatar, GivesNoForceUncalibratedOrWithoutAnInstrument) {
    AvatarPort port;
    port.change([](auto& p) { p.answers[38] = {1, 0, 1}; });
    Session session(config(port));
    ASSERT_TRUE(session.until([&] { return port.lines > 30; }, Vec3(1, 1, 1)));
    EXPECT_EQ(session.states[0].status, DeviceStatus::kNotCalibrated);
    EXPECT_EQ(port.forces()[2], 0);
    EXPECT_EQ(port.enabled, -1);
    port.change([](auto& p) { p.answers[38] = {1, 1, 1}; });
    ASSERT_TRUE(session.until([&] { return port.forces()[2] != 0; }, Vec3(1, 1, 1)));
    port.change([](auto& p) { p.answers[28] = {0}; });
    EXPECT_TRUE(session.until([&] { return !session.states[0].engaged && port.forces()[2] == 0; },
                              Vec3(1, 1, 1)));
}

TEST(Avatar, TakesJawsAndPedalsFromItsBox) {
    AvatarPort port, box(true);
    DeviceConfig what = config(port);
    what.station.set("avatar.ibox", box.path());
    what.tools[0].kind = sim::ToolKind::kScissors;
    Session session(what);
    box.change([](auto& b) { b.answers[2] = {5'000, 0, 0, 0, 0, 0}; });
    EXPECT_TRUE(session.until([&] {
        return std::abs(session.states[0].jaw_rad - 0.5 * what.tools[0].jaw_open_rad) < 1e-6;
    }));
    DeviceConfig needle = what;
    needle.tools[0].kind = sim::ToolKind::kNeedle;
    AvatarPort other;
    needle.station.set("avatar.right", other.path());
    AvatarPort pedals(true);
    needle.station.set("avatar.ibox", pedals.path());
    Session cutting(needle);
    pedals.change([](auto& b) { b.answers[4] = {0, 1}; });
    EXPECT_TRUE(cutting.until([&] { return cutting.states[0].pedals == sim::kPedalCoag; }));
    pedals.change([](auto& b) { b.silent = true; });
    EXPECT_TRUE(cutting.until([&] { return cutting.states[0].pedals == 0; })) << "box gone: let go";
}

TEST(Avatar, IsLostInSilenceAndRubbishAndComesBack) {
    AvatarPort port;
    Session session(config(port));
    const auto is = [&](DeviceStatus status) {
        return [&session, status] { return session.states[0].status == status; };
    };
    ASSERT_TRUE(session.until(is(DeviceStatus::kReady)));
    port.change([](auto& p) { p.silent = true; });
    EXPECT_TRUE(session.until(is(DeviceStatus::kLost)));
    port.change([](auto& p) { p.silent = false; });
    EXPECT_TRUE(session.until(is(DeviceStatus::kReady)));
    port.change([](auto& p) { p.garbage = true; });
    EXPECT_TRUE(session.until(is(DeviceStatus::kLost)));
    port.change([](auto& p) { p.garbage = false; });
    EXPECT_TRUE(session.until(is(DeviceStatus::kReady)));
    port.pull_out();
    EXPECT_TRUE(session.until(is(DeviceStatus::kLost)));
}

// The instrument that is drawn out stands in every tenth answer, which is longer than the others.
TEST(Avatar, StaysInStepWhenAnAnswerComesLateOrNever) {
    for (const bool never : {false, true}) {
        AvatarPort port;
        Session session(config(port));
        ASSERT_TRUE(session.until([&] { return session.states[0].engaged; }));
        port.every_ms = 3;
        if (never)
            port.swallow = true;
        else
            port.once_ms = 30;
        ASSERT_TRUE(session.until([&] { return port.once_ms == 0 && !port.swallow; }));
        const auto ready = [&] { return session.states[0].status == DeviceStatus::kReady; };
        const int before = port.lines;
        ASSERT_TRUE(session.until([&] { return port.lines > before + 20 && ready(); }));
        port.change([](auto& p) { p.answers[28] = {0}; });
        EXPECT_TRUE(session.until([&] { return !session.states[0].engaged && ready(); }))
            << (never ? "swallowed" : "late");
    }
}

TEST(Avatar, LowersItsForceWhenAnAmplifierIsHot) {
    AvatarPort port;
    port.change([](auto& p) { p.answers[5] = {0x20}; });
    Session session(config(port));
    EXPECT_TRUE(session.until([&] { return session.states[0].motor_heat == 1.0f; }));
}

TEST(Avatar, AllocatesNothingInItsTickAndLeavesTheMotorsOff) {
    AvatarPort port;
    {
        Session session(config(port));
        session.until([&] { return port.forces()[2] != 0; }, Vec3(1, 1, 1));
        const long before = placode::test::allocations;
        for (int i = 0; i < 200; ++i) session.tick(Vec3(1, 1, 1));
        EXPECT_EQ(placode::test::allocations, before);
    }
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (port.enabled != 0 && std::chrono::steady_clock::now() < limit)
        sleep_until(monotonic_ns() + 1'000'000);
    EXPECT_EQ(port.enabled, 0);
    EXPECT_EQ(port.forces()[2], 0);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
