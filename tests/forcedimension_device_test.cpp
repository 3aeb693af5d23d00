// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The Force Dimension driver against a stand-in for its library. No hardware.
#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/count_allocations.h"
#include "tests/device_session.h"

namespace placode::haptics {
namespace THIS_TEST {

using test::error_of;
using ::testing::HasSubstr;

template <class Function>
Function* fake(const char* name) {
    static void* library = dlopen(PLACODE_DHD_STAND_IN, RTLD_NOW | RTLD_LOCAL);
    return reinterpret_cast<Function*>(dlsym(library, name));
}
void reset(int count) { fake<void(int)>("fakedhd_reset")(count); }
void place(int id, double x, double y, double z) {
    fake<void(int, double, double, double)>("fakedhd_place")(id, x, y, z);
}
Vec3 force(int id) {
    double f[3]{};
    fake<void(int, double*)>("fakedhd_force")(id, f);
    return {f[0], f[1], f[2]};
}
int breaches() { return fake<int()>("fakedhd_breaches")(); }

DeviceConfig config() {
    DeviceConfig out;
    out.name = "forcedimension";
    out.tools.resize(2);
    out.tools[0].kind = sim::ToolKind::kNeedle;
    out.tools[1].kind = sim::ToolKind::kScissors;
    out.tools[1].hand = sim::Hand::kLeft;
    out.station.set("forcedimension.library", PLACODE_DHD_STAND_IN);
    return out;
}

/// On a clock of its own.
struct Session : test::DeviceSession<2> {
    Session() : DeviceSession(config()) {}
    void tick(int n = 1, const Vec3& wanted = Vec3::Zero()) {
        for (int i = 0; i < n; ++i) tick_at(t_ns += 1'000'000, wanted);
    }
    int64_t t_ns = 0;
};

TEST(ForceDimension, SaysWhatIsMissing) {
    DeviceConfig absent = config();
    absent.station.set("forcedimension.library", "/nowhere/libdhd.so");
    EXPECT_THAT(error_of(absent), HasSubstr("/nowhere/libdhd.so"));
    absent.station.set("forcedimension.library", "libm.so.6");
    EXPECT_THAT(error_of(absent), HasSubstr("has no dhdGetDeviceCount"));
    reset(0);
    EXPECT_THAT(error_of(config()), HasSubstr("finds no device"));
    reset(1);
    fake<void(int)>("fakedhd_occupy")(0);
    EXPECT_THAT(error_of(config()), HasSubstr("device is in use"));
}

TEST(ForceDimension, TurnsTheVendorsFrameAndForcesBack) {
    reset(2);
    Session session;
    EXPECT_EQ(session.device->info()[1].serial, "101");
    EXPECT_TRUE(session.device->info()[1].left_hand);
    session.tick();
    // x towards the operator, y right, z up: 1 mm, 2 mm, 3 mm.
    place(0, 0.001, 0.002, 0.003);
    session.tick(1, Vec3(0.1, 0.2, 0.3));
    EXPECT_LT((session.states[0].position_m - Vec3(0.002, 0.003, 0.001)).norm(), 1e-12);
    EXPECT_EQ(session.states[1].position_m, Vec3::Zero());
    EXPECT_LT((force(0) - Vec3(0.3, 0.1, 0.2)).norm(), 1e-12) << "transposed";
    EXPECT_DOUBLE_EQ(fake<double(int)>("fakedhd_max_force")(0), 3.0) << "the vendor's own limit";
    EXPECT_EQ(breaches(), 0);
}

TEST(ForceDimension, ReadsGripperAndButtons) {
    reset(2);
    Session session;
    fake<void(int, double, unsigned)>("fakedhd_grip")(1, 0.25, 0);
    fake<void(int, double, unsigned)>("fakedhd_grip")(0, 0, 1);
    session.tick(3);
    EXPECT_NEAR(session.states[1].jaw_rad, 0.48, 1e-9) << "half open";
    EXPECT_EQ(session.states[0].pedals, sim::kPedalCut);
}

TEST(ForceDimension, TakesGuardAndSaturationForNoErrors) {
    reset(2);
    Session session;
    for (const int result : {1, 2}) {
        fake<void(int, int)>("fakedhd_result")(0, result);
        session.tick();
        EXPECT_EQ(session.states[0].status, DeviceStatus::kReady);
    }
    fake<void(int, int)>("fakedhd_result")(0, -1);
    session.tick();
    EXPECT_EQ(session.states[0].status, DeviceStatus::kLost);
}

TEST(ForceDimension, GivesNoForceWithoutPowerAndInReset) {
    reset(2);
    Session session;
    session.tick(5, Vec3(0, 0, 1));
    EXPECT_GT(force(0).norm(), 0.9);
    for (const auto& [word, bad, good] :
         {std::array{0, 0, 1}, std::array{3, 1, 0}, std::array{9, 7, 0}}) {
        fake<void(int, int, int)>("fakedhd_status")(0, word, bad);
        session.tick(120, Vec3(0, 0, 1));
        EXPECT_EQ(session.states[0].status, DeviceStatus::kNotCalibrated) << word;
        EXPECT_EQ(force(0), Vec3::Zero()) << word;
        EXPECT_GT(force(1).norm(), 0.9) << "the other arm goes on";
        fake<void(int, int, int)>("fakedhd_status")(0, word, good);
        session.tick(120, Vec3(0, 0, 1));
        EXPECT_GT(force(0).norm(), 0.9) << word;
    }
}

TEST(ForceDimension, LosesAnArmAndTakesItBack) {
    reset(2);
    Session session;
    session.tick(5, Vec3(0, 0, 1));
    fake<void(int, int)>("fakedhd_unplug")(0, 1);
    session.tick(1, Vec3(0, 0, 1));
    EXPECT_EQ(session.states[0].status, DeviceStatus::kLost);
    session.tick(300, Vec3(0, 0, 1));
    fake<void(int, int)>("fakedhd_unplug")(0, 0);
    session.tick(2, Vec3(0, 0, 1));
    EXPECT_EQ(session.states[0].status, DeviceStatus::kReady);
    EXPECT_GT(force(0).norm(), 0.9);
}

TEST(ForceDimension, LetsTheFirmwareTakeTheForceOfAProgramThatStandsStill) {
    reset(2);
    Session session;
    for (const int id : {0, 1})
        EXPECT_EQ(fake<int(int)>("fakedhd_watchdog")(id), 80) << "of 125 us: 10 ms";
    session.tick(5, Vec3(0, 0, 1));
    ASSERT_GT(force(0).norm(), 0.9);
    fake<void(int)>("fakedhd_watchdog_acts")(0);
    session.t_ns += 20'000'000;
    session.tick(1, Vec3(0, 0, 1));
    EXPECT_GT(force(0).norm(), 0.9) << "enabled again after the gap";
    EXPECT_EQ(breaches(), 0);
}

TEST(ForceDimension, ClosesWithoutForceAndAllocatesNothing) {
    reset(2);
    {
        Session session;
        session.tick(5, Vec3(0, 0, 1));
        const long before = placode::test::allocations;
        session.tick(300, Vec3(0, 0, 1));
        EXPECT_EQ(placode::test::allocations, before);
    }
    EXPECT_EQ(force(0), Vec3::Zero());
    EXPECT_EQ(fake<int(int)>("fakedhd_open")(0), 0);
    EXPECT_EQ(breaches(), 0) << "every call named an open device";
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
