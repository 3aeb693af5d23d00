// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The Haply driver against a stand-in for the Inverse service over a real socket. No hardware.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/count_allocations.h"
#include "tests/device_session.h"
#include "tests/stand_in/haply_service.h"

namespace placode::haptics {
namespace THIS_TEST {

using test::error_of;
using test::HaplyService;
using ::testing::HasSubstr;
using Session = test::DeviceSession<2>;

DeviceConfig config(const HaplyService& service) {
    DeviceConfig out;
    out.name = "haply";
    out.tools.resize(2);
    out.tools[0].kind = sim::ToolKind::kNeedle;
    out.tools[1].kind = sim::ToolKind::kGrasper;
    out.tools[1].hand = sim::Hand::kLeft;
    out.station.set("haply.port", std::to_string(service.port()));
    return out;
}

TEST(Haply, SaysThatNoServiceAnswers) {
    DeviceConfig absent;
    {
        const HaplyService service;  // its port is free afterwards
        absent = config(service);
    }
    EXPECT_THAT(error_of(absent), HasSubstr("no Inverse service answers at ws://127.0.0.1:"));
}

TEST(Haply, SaysWhichArmsAreThereWhenTheWantedOneIsNot) {
    HaplyService service;
    DeviceConfig wanted = config(service);
    wanted.station.set("haply.right", "BEEF");
    EXPECT_THAT(error_of(wanted), HasSubstr("shows 04EA (right)"));
    service.change([](auto& s) { s.arms.clear(); });
    EXPECT_THAT(error_of(wanted), HasSubstr("shows none"));
}

TEST(Haply, RefusesAnArmThatIsSetUpForTheOtherHand) {
    HaplyService service;
    service.change([](auto& s) { s.arms[0].handedness = "left"; });
    DeviceConfig wanted = config(service);
    wanted.station.set("haply.right", "04EA");
    EXPECT_THAT(error_of(wanted), HasSubstr("04EA as the right arm"));
    wanted.station.set("haply.left", "04EA");
    EXPECT_THAT(error_of(wanted), HasSubstr("both \"04EA\""));
}

TEST(Haply, TurnsItsAxesAndSendsForcesBackThroughThem) {
    HaplyService service;
    Session session(config(service));
    EXPECT_EQ(session.device->info()[0].serial, "04EA");
    ASSERT_TRUE(session.until([&] { return session.states[0].status == DeviceStatus::kReady; }));
    // Where the hand is when it begins is the home of the handle.
    EXPECT_EQ(session.states[0].position_m, Vec3::Zero());
    service.change([](auto& s) { s.arms[0].position = {0.001, 0.002, 0.003}; });
    const Vec3 expected(0.001, 0.003, -0.002);
    EXPECT_TRUE(
        session.until([&] { return (session.states[0].position_m - expected).norm() < 1e-9; }));
    ASSERT_TRUE(session.until([&] { return std::abs(service.force(0)[2] - 0.5) < 1e-4; },
                              Vec3(0.25, 0.5, -1)));
    EXPECT_NEAR(service.force(0)[0], 0.25, 1e-4);
    EXPECT_NEAR(service.force(0)[1], 1.0, 1e-4) << "power in = power out: transposed axes";
}

TEST(Haply, GivesNoForceBeforeItIsCalibratedAndReady) {
    for (const int which : {0, 1}) {
        HaplyService service;
        service.change(
            [&](auto& s) { (which == 0 ? s.arms[0].calibrated : s.arms[0].ready) = false; });
        Session session(config(service));
        for (int i = 0; i < 20; ++i) session.tick(Vec3(1, 1, 1));
        ASSERT_TRUE(session.until([&] { return service.messages > 20; }, Vec3(1, 1, 1)));
        EXPECT_EQ(session.states[0].status, DeviceStatus::kNotCalibrated);
        EXPECT_EQ(service.force(0)[0], 0);
        service.change([&](auto& s) { s.arms[0].calibrated = s.arms[0].ready = true; });
        EXPECT_TRUE(session.until([&] { return service.force(0)[0] > 0.9; }, Vec3(1, 1, 1)));
    }
}

TEST(Haply, ReadsFragmentsPingsUnknownKeysAndThreeSpellingsOfButtons) {
    HaplyService service;
    service.change([](auto& s) {
        s.fragments = 7;
        s.ping = true;
        s.extra = R"(,"future":{"list":[1,[2,{"x":"]"}]],"nothing":null},"number":-1e-3)";
    });
    Session session(config(service));
    for (const char* buttons : {R"({"a":true,"b":false,"c":false,"home":false})",
                                R"({"button_0":true,"button_1":false})", R"({"button":true})"}) {
        service.change([&](auto& s) {
            s.grip = std::string(R"({"device_id":"61576","state":{"buttons":)") + buttons +
                     R"(,"orientation":{"w":1,"x":0,"y":0,"z":0}}})";
        });
        EXPECT_TRUE(session.until([&] { return session.states[0].buttons == 1; })) << buttons;
        EXPECT_EQ(session.states[0].pedals, sim::kPedalCut) << "a needle without pedals";
        service.change([&](auto& s) { s.grip.clear(); });
        ASSERT_TRUE(session.until([&] { return session.states[0].buttons == 0; })) << "grip gone";
    }
    EXPECT_GT(service.pongs, 0);
}

TEST(Haply, IsLostAfterATenthOfASecondOfSilenceAndComesBack) {
    HaplyService service;
    Session session(config(service));
    ASSERT_TRUE(session.until([&] { return session.states[0].status == DeviceStatus::kReady; }));
    service.change([](auto& s) { s.silent = true; });
    EXPECT_TRUE(session.until([&] { return session.states[0].status == DeviceStatus::kLost; }));
    service.change([](auto& s) { s.silent = false; });
    EXPECT_TRUE(session.until([&] { return session.states[0].status == DeviceStatus::kReady; }));
}

TEST(Haply, ConnectsAgainAfterTheServiceHasHungUp) {
    HaplyService service;
    Session session(config(service));
    service.hang_up();
    EXPECT_TRUE(session.until([&] { return session.states[0].status == DeviceStatus::kLost; }));
    EXPECT_TRUE(session.until([&] {
        return service.connections == 2 && session.states[0].status == DeviceStatus::kReady;
    }));
    EXPECT_GE(service.hellos, 2) << "it introduced itself again";
}

TEST(Haply, DoubtsAPositionWithoutNumbers) {
    HaplyService service;
    Session session(config(service));
    ASSERT_TRUE(session.until([&] { return session.states[0].status == DeviceStatus::kReady; }));
    for (const char* position : {R"({"x":0,"y":0})", R"({"x":"0","y":0,"z":0})", "null"}) {
        service.change([&](auto& s) { s.position = position; });
        EXPECT_TRUE(session.until([&] {
            return !session.states[0].position_m.allFinite() ||
                   session.states[0].status != DeviceStatus::kReady;
        })) << position;
        service.change([&](auto& s) { s.position.clear(); });
        EXPECT_TRUE(session.until([&] {
            return session.states[0].position_m.allFinite() &&
                   session.states[0].status == DeviceStatus::kReady;
        }));
    }
}

TEST(Haply, TakesTwoArmsByTheirHands) {
    HaplyService service;
    service.change([](auto& s) {
        s.arms.resize(2);
        s.arms[0].id = "L1";
        s.arms[0].handedness = "left";
        s.arms[1].id = "R1";
    });
    DeviceConfig two = config(service);
    two.station.set("haply.left", "auto");
    Session session(two);
    const auto info = session.device->info();
    EXPECT_EQ(info[0].serial, "R1");
    EXPECT_EQ(info[1].serial, "L1");
    ASSERT_TRUE(session.until([&] {
        return session.states[0].status == DeviceStatus::kReady &&
               session.states[1].status == DeviceStatus::kReady;
    }));
    service.change([](auto& s) { s.arms[0].position = {0.004, 0, 0}; });
    EXPECT_TRUE(
        session.until([&] { return std::abs(session.states[1].position_m.x() - 0.004) < 1e-9; }));
    EXPECT_EQ(session.states[0].position_m, Vec3::Zero());
}

TEST(Haply, AllocatesNothingInItsTickAndSaysGoodbye) {
    HaplyService service;
    {
        Session session(config(service));
        session.until([&] { return session.states[0].status == DeviceStatus::kReady; });
        const long before = placode::test::allocations;
        for (int i = 0; i < 200; ++i) session.tick(Vec3(0.1, 0, 0));
        EXPECT_EQ(placode::test::allocations, before);
    }
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!service.closed_by_client && std::chrono::steady_clock::now() < limit)
        sleep_until(monotonic_ns() + 1'000'000);
    EXPECT_TRUE(service.closed_by_client);
    EXPECT_EQ(service.force(0)[0], 0) << "the last force is none";
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
