// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The whole path of the servo, from the driver of every vendor's stand-in through trocar, coupling
// and limits and back, allocates nothing and locks nothing: at work, in contact, and when the
// device goes and comes.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <mutex>

#include "haptics/catalogue/open_device.h"
#include "haptics/servo.h"
#include "tests/count_allocations.h"
#include "tests/device_session.h"
#include "tests/stand_in/avatar_port.h"
#include "tests/stand_in/haply_service.h"
#include "tests/stand_in/space_daemon.h"

namespace placode::haptics {
namespace THIS_TEST {

std::vector<sim::ToolSpec> two_tools() {
    std::vector<sim::ToolSpec> tools(2);
    tools[0].kind = sim::ToolKind::kNeedle;
    tools[1].kind = sim::ToolKind::kGrasper;
    tools[1].hand = sim::Hand::kLeft;
    tools[1].pivot_m.y() = 0.055;
    return tools;
}

/// Allocations and locks of this thread so far.
long cost() { return placode::test::allocations + placode::test::locks; }

/// Ticks the whole path 1500 times; at 500 `trouble` begins, at 700 it ends. The tools stay where
/// they are, so that a hand that moves feels them.
struct Path {
    explicit Path(const DeviceConfig& what)
        : servo(open_device(what), what.tools, default_trocars(what.tools, what.name, what.station),
                CouplingSettings{}) {
        const auto trocars = default_trocars(what.tools, what.name, what.station);
        for (size_t i = 0; i < what.tools.size(); ++i)
            feedback[i].proxy.p = trocars[i].home_tip_m + Vec3(0, 0, 0.001);
    }
    ~Path() { servo.stop(); }

    /// What the ticks allocated and locked; the calls of `trouble` do not count.
    long run(const std::function<void(bool)>& trouble) {
        long spent = 0;
        for (int i = 0; i < 1500; ++i) {
            if (i == 500 || i == 700) trouble(i == 500);
            for (sim::ToolFeedback& tool : feedback) tool.time_s = 1e-3 * (i + 1);
            const long before = cost();
            servo.tick(monotonic_ns(), inputs, feedback);
            spent += cost() - before;
            if (i % 4 == 0) sleep_until(monotonic_ns() + 200'000);
        }
        return spent;
    }

    std::array<sim::ToolInput, 2> inputs{};
    std::array<sim::ToolFeedback, 2> feedback{};
    Servo servo;
};

TEST(ServoPath, AllocatesAndLocksNothingWithHaply) {
    test::HaplyService service;
    DeviceConfig config;
    config.name = "haply";
    config.tools = two_tools();
    config.station.set("haply.port", std::to_string(service.port()));
    Path path(config);
    EXPECT_EQ(path.run([&](bool on) { service.change([&](auto& s) { s.silent = on; }); }), 0);
    EXPECT_GT(service.messages, 100);
    EXPECT_EQ(path.run([&](bool on) {
        if (on) service.hang_up();
    }),
              0);
}

TEST(ServoPath, AllocatesAndLocksNothingWithTheHapticAvatar) {
    test::AvatarPort port;
    DeviceConfig config;
    config.name = "avatar";
    config.tools = two_tools();
    config.tools.resize(1);
    config.tools[0].kind = sim::ToolKind::kGrasper;
    config.station.set("avatar.right", port.path());
    config.station.set("avatar.settle_s", "0");
    Path path(config);
    EXPECT_EQ(path.run([&](bool on) { port.change([&](auto& p) { p.silent = on; }); }), 0);
}

TEST(ServoPath, AllocatesAndLocksNothingWithForceDimension) {
    void* library = dlopen(PLACODE_DHD_STAND_IN, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr);
    const auto reset = reinterpret_cast<void (*)(int)>(dlsym(library, "fakedhd_reset"));
    const auto place =
        reinterpret_cast<void (*)(int, double, double, double)>(dlsym(library, "fakedhd_place"));
    reset(2);
    DeviceConfig config;
    config.name = "forcedimension";
    config.tools = two_tools();
    config.station.set("forcedimension.library", PLACODE_DHD_STAND_IN);
    Path path(config);
    EXPECT_EQ(path.run([&](bool on) { place(0, on ? std::nan("") : 0.0, 0, 0); }), 0);
}

TEST(ServoPath, AllocatesAndLocksNothingWithASpaceMouse) {
    test::SpaceDaemon daemon;
    DeviceConfig config;
    config.name = "spacemouse";
    config.tools = two_tools();
    config.station.set("spacemouse.socket", daemon.path);
    Path path(config);
    daemon.accept_client();
    daemon.event(0, {100, 200, -300, 0, 50, 0, 16});
    EXPECT_EQ(path.run([&](bool on) { on ? daemon.quit() : daemon.listen_again(); }), 0);
}

TEST(ServoPath, AllocatesAndLocksNothingWithMouseKeyboardAndGamepad) {
    for (const char* name : {"mouse", "keyboard", "gamepad"}) {
        sim::Latest<sim::WindowInput> window;
        DeviceConfig config;
        config.name = name;
        config.tools = two_tools();
        config.window = &window;
        Path path(config);
        EXPECT_EQ(path.run([&](bool on) {
            sim::WindowInput input;
            input.focused = !on;
            input.gamepad = !on;
            input.left = true;
            input.mouse_x = 100;
            input.down.set();
            window.publish(input);
        }),
                  0)
            << name;
    }
}

TEST(ServoPath, CountsWhatIsAllocatedAndLocked) {
    const long before = placode::test::allocations;
    ::operator delete(::operator new(8));
    EXPECT_EQ(placode::test::allocations, before + 1) << "the interposer works";
#ifndef PLACODE_ONLY_NEW_IS_COUNTED
    std::free(::strdup("by the C library"));
    EXPECT_EQ(placode::test::allocations, before + 2);
    const long locked = placode::test::locks;
    std::mutex mutex;
    { const std::lock_guard lock(mutex); }
    EXPECT_EQ(placode::test::locks, locked + 1);
#endif
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
