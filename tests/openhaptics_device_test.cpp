// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The OpenHaptics driver against a stand-in for libHD.so that checks the calling contract. No
// hardware: what the real library does beyond its reference guide is not shown here.
#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "haptics/catalogue/open_device.h"
#include "haptics/openhaptics_library.h"
#include "haptics/servo.h"
#include "sim/cutting/grasp.h"
#include "tests/count_allocations.h"
#include "tests/device_session.h"
#include "tests/stand_in/hd_stand_in.h"

namespace placode::haptics {
namespace THIS_TEST {

using test::error_of;
using ::testing::HasSubstr;

const FakeHd& hd() {
    static const FakeHd* controls = [] {
        void* library = dlopen(PLACODE_HD_STAND_IN, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) throw std::runtime_error(dlerror());
        return reinterpret_cast<const FakeHd* (*)()>(dlsym(library, "fakehd"))();
    }();
    return *controls;
}

std::vector<sim::ToolSpec> two_tools() {
    std::vector<sim::ToolSpec> tools(2);
    tools[0].kind = sim::ToolKind::kNeedle;
    tools[1].kind = sim::ToolKind::kGrasper;
    tools[1].hand = sim::Hand::kLeft;
    tools[1].pivot_m.y() = 0.055;
    return tools;
}

// A clock that goes on by one millisecond a tick.
std::atomic<int64_t> g_now_ns{1'000'000'000};
int64_t fake_clock() noexcept { return g_now_ns; }

DeviceConfig config(bool two_arms = false) {
    DeviceConfig out;
    out.clock_ns = fake_clock;
    out.name = "openhaptics";
    out.tools = two_tools();
    out.station.set("openhaptics.library", PLACODE_HD_STAND_IN);
    if (two_arms) {
        out.station.set("openhaptics.right", "Right");
        out.station.set("openhaptics.left", "Left");
    }
    return out;
}

/// A servo whose ticks the test gives, and tools that stay where the test wants them.
struct Session {
    Session() { hd().reset(); }
    void begin(const DeviceConfig& what) {
        const auto trocars = default_trocars(what.tools, "openhaptics", what.station);
        for (size_t i = 0; i < trocars.size(); ++i) home[i] = trocars[i].home_tip_m;
        for (size_t i = 0; i < tools.size(); ++i) tools[i].proxy.p = home[i];
        servo.emplace(open_device(what), what.tools, trocars, CouplingSettings{});
        servo->start();
    }
    void tick(int n = 1) {
        for (int i = 0; i < n; ++i) {
            time_s += 1e-3;
            auto& out = servo->exchange().feedback.back();
            for (size_t k = 0; k < 2; ++k) {
                out[k] = tools[k];
                out[k].time_s = waiting ? 0 : time_s;
            }
            servo->exchange().feedback.publish();
            g_now_ns += 1'000'000;
            hd().tick();
            servo->exchange().inputs.refresh();
        }
    }
    [[nodiscard]] const sim::ToolInput& input(size_t i) {
        return servo->exchange().inputs.front()[i];
    }
    [[nodiscard]] static Vec3 force(int arm) {
        double f[3]{};
        hd().force(arm, f);
        return {f[0], f[1], f[2]};
    }
    /// The tool of an arm is pushed aside; true when the arm feels it after the ramp.
    bool push(int arm, size_t tool) {
        tools[tool].proxy.p = home[tool] + Vec3(0, 0, 0.0015);
        tick(600);
        return force(arm).norm() > 0.1;
    }

    std::optional<Servo> servo;
    std::array<Vec3, 2> home;
    std::array<sim::ToolFeedback, 2> tools;
    double time_s = 0;
    bool waiting = false;  // for the first motion: nothing is simulated yet
};

TEST(OpenHaptics, SaysWhyTheLibraryCannotBeLoaded) {
    DeviceConfig absent = config();
    absent.station.set("openhaptics.library", "/nowhere/libHD.so");
    const std::string error = error_of(absent);
    EXPECT_THAT(error, HasSubstr("/nowhere/libHD.so"));
    EXPECT_THAT(error, HasSubstr("No such file"));
    EXPECT_THAT(error, HasSubstr("libncurses5")) << "the way out";
    DeviceConfig other = config();
    other.station.set("openhaptics.library", "libm.so.6");
    EXPECT_THAT(error_of(other), HasSubstr("has no hdInitDevice"));
    // As on Debian 12, where the real one misses libncurses.so.5: the loader's own words.
    DeviceConfig needs = config();
    needs.station.set("openhaptics.library", PLACODE_HD_WITHOUT_ITS_LIBRARY);
    EXPECT_THAT(error_of(needs), HasSubstr("libplacode_absent.so: cannot open shared object file"));
    EXPECT_THAT(error_of(needs), HasSubstr("libncurses5"));
}

TEST(OpenHaptics, NamesEveryErrorOfTheGuide) {
    EXPECT_EQ(hd::error_words(0x302), "0x302 (communication error)");
    EXPECT_EQ(hd::error_words(0x7ff), "0x7ff");
    for (const unsigned code :
         {0x100, 0x101, 0x102, 0x103, 0x104, 0x200, 0x201, 0x202, 0x203, 0x204, 0x300,
          0x301, 0x302, 0x303, 0x304, 0x400, 0x401, 0x402, 0x500, 0x501, 0x600})
        EXPECT_THAT(hd::error_words(code), HasSubstr(" (")) << std::hex << code;
}

TEST(OpenHaptics, HasTheSonameAndAllFunctionsOfTheVendorInItsStandIn) {
    void* library = dlopen(PLACODE_HD_STAND_IN, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr);
    int found = 0;
    for (const char* name : {"hdBeginFrame",
                             "hdCheckCalibration",
                             "hdCheckCalibrationStyle",
                             "hdDeploymentLicense",
                             "hdDisable",
                             "hdDisableDevice",
                             "hdEnable",
                             "hdEndFrame",
                             "hdGetBooleanv",
                             "hdGetCurrentDevice",
                             "hdGetDoublev",
                             "hdGetError",
                             "hdGetErrorString",
                             "hdGetFloatv",
                             "hdGetIntegerv",
                             "hdGetLongv",
                             "hdGetSchedulerTimeStamp",
                             "hdGetString",
                             "hdInitDevice",
                             "hdIsEnabled",
                             "hdMakeCurrentDevice",
                             "hdScaleGimbalAngles",
                             "hdScheduleAsynchronous",
                             "hdScheduleSynchronous",
                             "hdSetBooleanv",
                             "hdSetDoublev",
                             "hdSetFloatv",
                             "hdSetIntegerv",
                             "hdSetLongv",
                             "hdSetSchedulerRate",
                             "hdStartScheduler",
                             "hdStopScheduler",
                             "hdUnschedule",
                             "hdUpdateCalibration",
                             "hdUpdateCalibrationMessage",
                             "hdWaitForCompletion"})
        found += dlsym(library, name) != nullptr ? 1 : 0;
    EXPECT_EQ(found, 36);
}

TEST(OpenHaptics, TriesTheNamesThatDifferentDriversAccept) {
    for (const int null_works : {0, 1}) {
        hd().reset();
        hd().accept_null(null_works);
        const auto group = open_device(config());
        const auto info = group->info();
        EXPECT_EQ(info[0].model, "Touch");
        EXPECT_EQ(info[0].serial, "R-001");
        EXPECT_DOUBLE_EQ(info[0].max_force_n, 3.3);
        EXPECT_DOUBLE_EQ(info[0].max_stiffness_n_m, 400);
        EXPECT_TRUE(info[0].owns_servo);
        group->stop();
        EXPECT_FALSE(hd().open(0));
        EXPECT_STREQ(hd().violation(), "");
    }
}

TEST(OpenHaptics, NamesTheArmThatIsMissingAndFreesTheOther) {
    hd().reset();
    hd().plug(1, 0);
    const std::string error = error_of(config(true));
    EXPECT_THAT(error, HasSubstr("left arm \"Left\""));
    EXPECT_THAT(error, HasSubstr("Communication error (0x302)"));
    EXPECT_FALSE(hd().open(0)) << "the right arm is free again";
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, RefusesADeviceThatIsInUse) {
    hd().reset();
    const auto first = open_device(config());
    EXPECT_THAT(error_of(config()), HasSubstr("already initiated (0x301)"));
    first->stop();
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, RefusesOneNameForBothHands) {
    DeviceConfig same = config(true);
    same.station.set("openhaptics.left", "Right");
    EXPECT_THAT(error_of(same), HasSubstr("both \"Right\""));
}

TEST(OpenHaptics, StartsAndStopsInTheOrderOfTheGuide) {
    Session session;
    session.begin(config(true));
    EXPECT_TRUE(hd().scheduled());
    EXPECT_TRUE(hd().running());
    EXPECT_EQ(hd().rate(), 1000ul);
    session.tick(5);
    std::thread ticker([&] {  // stop() waits for the ramp, which needs ticks
        while (hd().scheduled() && hd().running()) {
            g_now_ns += 1'000'000;
            hd().tick();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    session.servo->stop();
    ticker.join();
    EXPECT_FALSE(hd().running());
    EXPECT_FALSE(hd().open(0));
    EXPECT_FALSE(hd().open(1));
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, ReadsMillimetresColumnsAndBothArmsInOneTick) {
    Session session;
    session.begin(config(true));
    session.tick(3);
    const auto before = session.input(0).position_m, other = session.input(1).position_m;
    EXPECT_EQ(session.input(0).engaged, 1);
    // 2 mm towards the operator is 2 mm caudal (-x) of the handle; the port turns it round.
    hd().place(0, 0, 0, 2);
    session.tick();
    Trocar expected(config().tools[0], default_trocars(config().tools, "openhaptics")[0]);
    DeviceState moved;
    moved.position_m = Vec3(0, 0, 0.002);
    const Vec3 tip = expected.tip_pose(moved).p;
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(session.input(0).position_m[static_cast<size_t>(k)], tip[k], 1e-7);
    EXPECT_NE(session.input(0).position_m, before);
    EXPECT_EQ(session.input(1).position_m, other) << "the left arm did not move";
    // Gimbal angle 3 is the roll.
    double transform[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 2, 1};
    hd().turn(1, transform, 0.3);
    const auto straight = session.input(1).orientation;
    session.tick();
    EXPECT_NE(session.input(1).orientation, straight);
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, GivesForceOnlyAfterCalibrationAndOutOfTheInkwell) {
    Session session;
    hd().set_calibration(0, 0x5001);
    hd().set_inkwell(0, 1);
    session.begin(config());
    session.tick(3);
    EXPECT_EQ(hd().calibration_updates(0), 1) << "calibrated in its inkwell";
    EXPECT_FALSE(hd().output_enabled(0)) << "not before it is looked at again";
    session.tick(100);
    EXPECT_TRUE(hd().output_enabled(0));
    EXPECT_EQ(session.input(0).engaged, 0) << "still in the inkwell";
    session.tools[0].proxy.p = session.home[0] + Vec3(0, 0, 0.0015);
    session.tick(50);
    EXPECT_EQ(Session::force(0), Vec3::Zero());
    hd().set_inkwell(0, 0);
    EXPECT_TRUE(session.push(0, 0));
    hd().set_inkwell(0, 1);
    session.tick();
    EXPECT_EQ(Session::force(0), Vec3::Zero()) << "put back";
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, CountsNoFaultOfAnArmThatIsCalibratedBeforeTheFirstMotion) {
    Session session;
    hd().set_calibration(0, 0x5001);
    hd().set_inkwell(0, 1);
    session.begin(config());
    session.waiting = true;
    session.tick(110);
    hd().set_inkwell(0, 0);
    session.tick(150);
    session.waiting = false;
    EXPECT_TRUE(session.push(0, 0));
    EXPECT_EQ(session.servo->certificate().faults, 0u);
    hd().set_joints(0, 0, 0, 0);
    session.tick(101);
    EXPECT_EQ(session.servo->certificate().faults, 1u) << "in the attempt it counts";
}

TEST(OpenHaptics, DistrustsAnArmWhoseJointsStandAtZero) {
    Session session;
    hd().set_joints(0, 0, 0, 0);
    session.begin(config());
    session.tick(101);
    EXPECT_EQ(session.input(0).engaged, 0) << "as in the inkwell of an uncalibrated Omni";
    hd().set_joints(0, 0.1, 0, 0);
    session.tick(200);
    EXPECT_EQ(session.input(0).engaged, 1);
}

TEST(OpenHaptics, PushesTheRightArmOnlyForTheRightTool) {
    Session session;
    session.begin(config(true));
    ASSERT_TRUE(session.push(0, 0));
    EXPECT_LT(Session::force(1).norm(), 1e-3);
    EXPECT_LE(Session::force(0).norm(), 3.0 + 1e-9);
    EXPECT_STREQ(hd().violation(), "");
}

// Every error code of the reference guide: force errors zero the force and stay, faults of device
// and scheduler end the session with the hands declared lost.
TEST(OpenHaptics, AnswersEveryErrorCodeByZeroForceInTheNextTick) {
    const std::vector<unsigned> codes{0x100, 0x101, 0x102, 0x104, 0x200, 0x201, 0x202,
                                      0x203, 0x204, 0x300, 0x301, 0x302, 0x303, 0x304,
                                      0x400, 0x401, 0x402, 0x500, 0x501, 0x600};
    for (const unsigned code : codes) {
        Session session;
        session.begin(config());
        ASSERT_TRUE(session.push(0, 0)) << std::hex << code;
        hd().push_error(code, 0);
        session.tick();
        EXPECT_EQ(Session::force(0), Vec3::Zero()) << std::hex << code;
        EXPECT_EQ(session.input(0).engaged, 0) << std::hex << code;
        const bool ends = code == 0x300 || (code >= 0x302 && code <= 0x304) || code >= 0x500;
        EXPECT_EQ(hd().scheduled() == 0, ends) << std::hex << code;
        const HapticCertificate certificate = session.servo->certificate();
        EXPECT_GE(certificate.faults, 1u);
        EXPECT_EQ(certificate.last_error, hd::error_words(code));
        session.servo->stop();
        EXPECT_STREQ(hd().violation(), "") << std::hex << code;
    }
}

TEST(OpenHaptics, IgnoresTheInputTypeErrorOfSoundHardware) {
    Session session;
    session.begin(config());
    ASSERT_TRUE(session.push(0, 0));
    hd().push_error(0x103, 0);
    session.tick();
    EXPECT_GT(Session::force(0).norm(), 0.05);
}

TEST(OpenHaptics, KeepsTheOtherArmWhenOneHasWarmMotors) {
    Session session;
    session.begin(config(true));
    session.tools[1].proxy.p = session.home[1] + Vec3(0, 0, 0.0015);
    ASSERT_TRUE(session.push(0, 0));
    ASSERT_GT(Session::force(1).norm(), 0.05);
    hd().push_error(0x200, 0);
    session.tick();
    EXPECT_EQ(Session::force(0), Vec3::Zero());
    EXPECT_GT(Session::force(1).norm(), 0.05);
}

// The watcher comes half a second later: nothing may stay on the motors until then.
TEST(OpenHaptics, TakesTheForceFromBothArmsWhenOneEndsTheSession) {
    Session session;
    session.begin(config(true));
    session.tools[1].proxy.p = session.home[1] + Vec3(0, 0, 0.0015);
    ASSERT_TRUE(session.push(0, 0));
    ASSERT_GT(Session::force(1).norm(), 0.05);
    hd().plug(0, 0);
    session.tick(2);
    EXPECT_EQ(Session::force(1), Vec3::Zero());
    EXPECT_EQ(hd().output_enabled(1), 0);
    EXPECT_EQ(hd().scheduled(), 0);
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, FailsSafelyWhenAReadFails) {
    Session session;
    session.begin(config());
    ASSERT_TRUE(session.push(0, 0));
    hd().fail_next_get(0x302);
    session.tick();
    EXPECT_EQ(Session::force(0), Vec3::Zero());
    EXPECT_EQ(session.input(0).engaged, 0);
    EXPECT_EQ(hd().scheduled(), 0);
}

TEST(OpenHaptics, TakesAnArmBackThatWasUnplugged) {
    Session session;
    session.begin(config());
    ASSERT_TRUE(session.push(0, 0));
    hd().plug(0, 0);
    session.tick(2);
    EXPECT_EQ(Session::force(0), Vec3::Zero());
    EXPECT_EQ(session.input(0).engaged, 0);
    hd().plug(0, 1);
    // The watcher looks every half second; the limit keeps a broken build from hanging.
    for (int i = 0; i < 100 && hd().scheduled() == 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ASSERT_EQ(hd().scheduled(), 1);
    session.tools[0].proxy.p = session.home[0];
    session.tick(200);
    EXPECT_EQ(session.input(0).engaged, 1);
    EXPECT_TRUE(session.push(0, 0)) << "and the force comes back by its ramp";
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, ClosesJawsAndClutchesByItsButtons) {
    Session session;
    session.begin(config(true));
    session.tick(400);
    EXPECT_NEAR(session.input(1).jaw_rad, 0.96f, 1e-6f) << "open by itself";
    hd().set_buttons(1, 1);
    session.tick(1000);
    // The ratchet: 18 % of the way from where jaws meet tissue to shut.
    EXPECT_NEAR(session.input(1).jaw_rad, 0.82 * sim::grip_angle(two_tools()[1]), 1e-5);
    hd().set_buttons(0, 1);
    session.tick();
    EXPECT_EQ(session.input(0).pedals, sim::kPedalCut) << "a needle has no jaws";
    hd().set_buttons(0, 2);
    session.tick(2);
    const auto held = session.input(0).position_m;
    hd().place(0, 3, 0, 0);
    session.tick();
    EXPECT_EQ(session.input(0).position_m, held) << "clutched";
    hd().set_buttons(0, 0);
    session.tick(3);
    EXPECT_EQ(session.input(0).position_m, held) << "and taken up where it was";
}

// The waiting instrument stands in tissue that pushes it: whoever takes it up gets that by a ramp.
TEST(OpenHaptics, BeginsTheForceOfAnotherInstrumentByARamp) {
    Session session;
    session.begin(config());
    session.tools[1].proxy.p = session.home[1] + Vec3(0, 0, 0.0015);
    session.tick(600);
    EXPECT_EQ(session.input(1).engaged, 1) << "it waits in its own port";
    hd().set_buttons(0, 2);
    session.tick(2);
    hd().set_buttons(0, 0);
    double before = Session::force(0).norm();
    for (int i = 0; i < 600; ++i) {
        session.tick();
        const double now = Session::force(0).norm();
        EXPECT_LE(now - before, 0.05) << i << " ms";
        before = now;
    }
    EXPECT_GT(before, 0.1) << "and it is felt";
    EXPECT_STREQ(hd().violation(), "");
}

// In a pause nobody sees the tool follow: whatever it held would be torn by the first frame after.
TEST(OpenHaptics, HoldsItsToolInAPauseAndGoesOnFromThere) {
    Session session;
    session.begin(config());
    hd().set_buttons(0, 1);
    session.tick(200);
    ASSERT_EQ(session.input(0).pedals, sim::kPedalCut);
    const auto before = session.input(0).position_m;
    session.servo->set_paused(true);
    for (int i = 1; i <= 20; ++i) {
        hd().place(0, i, 0, 0);
        session.tick();
        EXPECT_EQ(session.input(0).position_m, before) << i << " mm";
    }
    EXPECT_EQ(session.input(0).engaged, 1) << "held, not let go";
    hd().set_buttons(0, 3);
    session.tick(2);
    hd().set_buttons(0, 1);
    session.tick(2);
    session.servo->set_paused(false);
    session.tick();
    EXPECT_EQ(session.input(0).position_m, before);
    EXPECT_EQ(session.input(0).pedals, 0) << "to be pressed anew";
    hd().place(0, 21, 0, 0);
    session.tick();
    EXPECT_NE(session.input(0).position_m, before) << "the same instrument, and it follows";
    EXPECT_STREQ(hd().violation(), "");
}

TEST(OpenHaptics, AllocatesNothingInItsTick) {
    Session session;
    session.begin(config(true));
    session.tick(150);
    // The stand-in's own error stack may allocate: none is pushed here.
    const long before = placode::test::allocations;
    for (int i = 0; i < 300; ++i) hd().tick();
    EXPECT_EQ(placode::test::allocations, before);
}

// With the vendor's kind of thread; run under the thread sanitizer.
TEST(OpenHaptics, RunsInTheSchedulersThread) {
    Session session;
    hd().use_thread(1);
    DeviceConfig real = config(true);
    real.clock_ns = nullptr;
    session.begin(real);
    auto& exchange = session.servo->exchange();
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    int published = 0;
    while (published < 50 && std::chrono::steady_clock::now() < limit) {
        published += exchange.inputs.refresh() ? 1 : 0;
        session.time_s += 1e-3;
        auto& out = exchange.feedback.back();
        for (size_t k = 0; k < 2; ++k) {
            out[k] = session.tools[k];
            out[k].time_s = session.time_s;
        }
        exchange.feedback.publish();
        (void)session.servo->certificate();
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    session.servo->stop();
    EXPECT_GE(published, 50);
    EXPECT_EQ(exchange.inputs.front()[0].engaged, 1);
    EXPECT_FALSE(hd().open(0));
    EXPECT_STREQ(hd().violation(), "");
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
