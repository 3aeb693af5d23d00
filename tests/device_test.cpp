// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/catalogue/open_device.h"
#include "haptics/control_help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "haptics/trocar.h"
#include "haptics/window_hands.h"

namespace placode::haptics {
namespace THIS_TEST {

using sim::Key;
using ::testing::HasSubstr;

constexpr int64_t kMs = 1'000'000;

std::vector<sim::ToolSpec> needle_and_scope() {
    std::vector<sim::ToolSpec> tools(2);
    tools[1].kind = sim::ToolKind::kScope;
    tools[1].pivot_m = Vec3(-0.045, 0, 0.075);
    return tools;
}

// A window whose totals the test changes, and the device that reads it at 1 kHz.
struct Bench {
    explicit Bench(const std::string& name) {
        DeviceConfig config;
        config.name = name;
        config.tools = needle_and_scope();
        config.window = &window;
        input.mouse_x = 12'345;  // Totals from before the attempt must not count.
        input.wheel = 7;
        input.presses[static_cast<size_t>(Key::kEnter)] = 3;
        window.publish(input);
        device = open_device(config);
        read(10);
    }
    const DeviceState& read(int ms) {
        for (int i = 0; i < ms; ++i) {
            window.publish(input);
            read_only(1);
        }
        return states[0];
    }
    /// While the window says nothing.
    const DeviceState& read_only(int ms) {
        for (int i = 0; i < ms; ++i) device->read(t_ns += kMs, states);
        return states[0];
    }
    void hold(Key key, bool down = true) { input.down[static_cast<size_t>(key)] = down; }
    void press(Key key) { ++input.presses[static_cast<size_t>(key)]; }

    sim::WindowInput input;
    sim::Latest<sim::WindowInput> window;
    std::unique_ptr<DeviceGroup> device;
    std::array<DeviceState, 2> states{};
    int64_t t_ns = 0;
};

std::string error_of(const std::string& name) {
    DeviceConfig config;
    config.name = name;
    config.tools = needle_and_scope();
    try {
        static_cast<void>(open_device(config));
    } catch (const DeviceError& error) {
        return error.what();
    }
    return "no error";
}

TEST(OpenDevice, NamesAnUnknownDeviceAndTheKnownOnes) {
    for (const char* name : {"mice", "", "script:", "script:surgeon", "MOUSE"}) {
        const std::string error = error_of(name);
        EXPECT_THAT(error, HasSubstr("unknown device \"" + std::string(name) + "\""));
        EXPECT_THAT(error, HasSubstr("mouse, keyboard, gamepad, spacemouse"));
    }
}

// With the device at hand the message is not seen.
TEST(OpenDevice, SaysWhatIsMissingAndHowToInstallIt) {
    const std::vector<std::pair<std::string, std::string>> advice{
        {"spacemouse", "apt install spacenavd"},
        {"openhaptics", "OpenHaptics"},
        {"haply", "Inverse service"},
        {"avatar", "dialout"},
        {"forcedimension", "Force Dimension SDK"}};
    for (const auto& [name, way_out] : advice) {
        const std::string error = error_of(name);
        if (error == "no error") continue;  // it is there
        EXPECT_THAT(error, HasSubstr(name));
        EXPECT_THAT(error, HasSubstr(way_out));
    }
}

TEST(OpenDevice, RefusesWithoutTools) {
    DeviceConfig config;
    config.name = "mouse";
    EXPECT_THROW(static_cast<void>(open_device(config)), DeviceError);
    config.tools.resize(sim::kMaxTools + 1);
    EXPECT_THROW(static_cast<void>(open_device(config)), DeviceError);
}

TEST(ListDevices, OffersExactlyWhatOpens) {
    for (const auto& listing : list_devices()) {
        EXPECT_EQ(error_of(listing.name) == "no error", listing.available) << listing.name;
        EXPECT_FALSE(listing.detail.empty());
    }
}

TEST(Controls, ExplainEveryHandDevice) {
    for (const char* name : {"mouse", "keyboard", "gamepad", "spacemouse", "openhaptics", "haply",
                             "avatar", "forcedimension"}) {
        const auto help = controls(name);
        ASSERT_GE(help.size(), 6u);
        for (const auto& line : help) {
            EXPECT_FALSE(line.action.empty());
            EXPECT_FALSE(line.input.empty());
        }
    }
    EXPECT_TRUE(controls("script:expert").empty());
}

TEST(Mouse, MovesRightAndUpInThePictureByItsGain) {
    Bench bench("mouse");
    EXPECT_EQ(bench.read(10).position_m, Vec3::Zero());
    bench.input.mouse_x += 315;  // 10 mm on the desk
    bench.input.mouse_y -= 630;  // y grows downwards
    const Vec3 moved = bench.read(1000).position_m;
    EXPECT_LT((moved - Vec3(0.0025, 0.005, 0)).norm(), 1e-6);
    // Frame D is the picture: x right, y up. That the tip follows is shown in trocar_test.
    EXPECT_EQ(bench.states[1].position_m, Vec3::Zero()) << "the scope stays";
}

TEST(Mouse, GoesDeeperWithTheWheelAwayFromTheUser) {
    Bench bench("mouse");
    bench.input.wheel += 2;
    EXPECT_NEAR(bench.read(1000).position_m.z(), -0.001, 1e-6);
    bench.hold(Key::kShift);  // for long ways
    bench.input.wheel -= 2;
    EXPECT_NEAR(bench.read(1000).position_m.z(), 0.003, 1e-6);
}

TEST(Mouse, IsFiveTimesFinerWithControl) {
    Bench bench("mouse");
    bench.hold(Key::kControl);
    bench.input.mouse_x += 3150;
    EXPECT_NEAR(bench.read(1000).position_m.x(), 0.005, 1e-6);
}

TEST(Mouse, DoesNotMoveTheTipWithTheClutch) {
    Bench bench("mouse");
    bench.hold(Key::kSpace);
    bench.input.mouse_x += 1000;
    EXPECT_EQ(bench.read(500).position_m, Vec3::Zero());
    bench.hold(Key::kSpace, false);
    EXPECT_EQ(bench.read(500).position_m, Vec3::Zero()) << "nor afterwards";
}

TEST(Mouse, MovesSmoothlyAndNeverFasterThanItsCap) {
    Bench bench("mouse");
    bench.input.mouse_x += 100'000;  // a flick of three metres
    Vec3 before = Vec3::Zero();
    for (int i = 0; i < 2000; ++i) {
        const Vec3 now = bench.read(1).position_m;
        EXPECT_LE((now - before).norm(), 0.150e-3 + 1e-12);
        before = now;
    }
    EXPECT_LE(before.x(), 0.045 + 1e-12) << "and stays within reach";
}

TEST(Mouse, SteersTheScopeWithTheMiddleButton) {
    Bench bench("mouse");
    bench.input.middle = true;
    bench.input.mouse_x += 315;
    EXPECT_EQ(bench.read(1000).position_m, Vec3::Zero());
    EXPECT_NEAR(bench.states[1].position_m.x(), 0.0025, 1e-6);
}

TEST(Mouse, TurnsANeedleAboutItsOwnAxisAndElseAboutTheShaft) {
    Bench bench("mouse");
    bench.hold(Key::kShift);
    bench.input.mouse_x += 100;
    EXPECT_NEAR(bench.read(1).roll_rad, 0.4, 1e-12) << "at once";
    EXPECT_EQ(bench.read(500).position_m, Vec3::Zero());
    // A needle whose centre lies 5 mm off the tip, seen tick by tick as the servo sees it.
    const Vec3 axis = Vec3(1, 2, -4).normalized();
    const Vec3 first = 0.005 * axis.unitOrthogonal();
    const Vec3 centre = first;
    double before = 0.4;
    bench.input.mouse_x += 700;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 arm = Eigen::AngleAxisd(bench.states[0].roll_rad - 0.4, axis) * first;
        bench.device->turn_about(0, arm, axis);
        const DeviceState& now = bench.read(1);
        EXPECT_LE(now.roll_rad - before, 0.004 + 1e-12) << "no faster than 4 rad/s";
        before = now.roll_rad;
        const Vec3 turned = Eigen::AngleAxisd(now.roll_rad - 0.4, axis) * first;
        EXPECT_LT((now.position_m + turned - centre).norm(), 1e-9);
    }
    EXPECT_NEAR(bench.states[0].roll_rad, 3.2, 1e-6);
    EXPECT_NEAR(bench.states[0].position_m.norm(), 0.01 * std::sin(1.4), 1e-6) << "the chord";
    bench.device->turn_about(0, Vec3(std::nan(""), 0, 0), axis);
    EXPECT_TRUE(bench.read(10).position_m.allFinite());
}

TEST(Mouse, PressesThePedalsOfTheNeedleOnly) {
    Bench bench("mouse");
    bench.input.left = true;
    EXPECT_EQ(bench.read(1).pedals, sim::kPedalCut);
    EXPECT_EQ(bench.states[1].pedals, 0);
    bench.input.left = false;
    bench.input.right = true;
    EXPECT_EQ(bench.read(1).pedals, sim::kPedalCoag);
    bench.input.right = false;
    EXPECT_EQ(bench.read(1).pedals, 0);
    bench.hold(Key::kCut);  // a foot pedal
    EXPECT_EQ(bench.read(1).pedals, sim::kPedalCut);
}

/// A mouse for several tools: which of them Tab leads to.
struct TabBench {
    TabBench(std::initializer_list<std::pair<sim::ToolKind, sim::Hand>> tools)
        : states(tools.size()) {
        DeviceConfig config;
        config.name = "mouse";
        config.window = &window;
        for (const auto& [kind, hand] : tools) {
            sim::ToolSpec& tool = config.tools.emplace_back();
            tool.kind = kind;
            tool.hand = hand;
            tool.tip_length_m = 0.010;
        }
        device = open_device(config);
        read();
    }
    void read() {
        window.publish(input);
        for (int i = 0; i < 500; ++i) device->read(t_ns += kMs, states);
    }
    /// The tool in the hand after Tab.
    int tab() {
        ++input.presses[static_cast<size_t>(Key::kTab)];
        read();
        return in_hand();
    }
    [[nodiscard]] int in_hand() const {
        int found = -1;
        for (size_t i = 0; i < states.size(); ++i)
            if (states[i].in_hand) found = found < 0 ? static_cast<int>(i) : 99;
        return found;
    }
    void press(bool down) {
        input.left = down;
        read();
    }

    sim::Latest<sim::WindowInput> window;
    sim::WindowInput input;
    std::unique_ptr<DeviceGroup> device;
    std::vector<DeviceState> states;
    int64_t t_ns = 0;
};

TEST(Mouse, TabGoesFromHandToHandAndNeverToTheScope) {
    TabBench bench{{sim::ToolKind::kNeedle, sim::Hand::kRight},
                   {sim::ToolKind::kScope, sim::Hand::kCamera},
                   {sim::ToolKind::kGrasper, sim::Hand::kLeft}};
    EXPECT_EQ(bench.in_hand(), 0);
    EXPECT_EQ(bench.tab(), 2);
    EXPECT_EQ(bench.tab(), 0);
    TabBench alone{{sim::ToolKind::kNeedle, sim::Hand::kRight},
                   {sim::ToolKind::kScope, sim::Hand::kCamera}};
    EXPECT_EQ(alone.tab(), 0);
}

// Who sews holds the needle with one hand and the edge with the other; a grasper waits outside.
TEST(Mouse, TabNeverTakesAwayWhatClosedJawsHold) {
    TabBench bench{{sim::ToolKind::kGrasper, sim::Hand::kRight},
                   {sim::ToolKind::kGrasper, sim::Hand::kLeft},
                   {sim::ToolKind::kNeedleDriver, sim::Hand::kRight}};
    EXPECT_TRUE(bench.states[0].engaged);
    EXPECT_FALSE(bench.states[2].engaged);
    // Nothing is held: round and round, the two of the right hand take turns.
    EXPECT_EQ(bench.tab(), 1);
    EXPECT_EQ(bench.tab(), 2);
    EXPECT_TRUE(bench.states[2].engaged);
    EXPECT_FALSE(bench.states[0].engaged);
    // The driver holds: from the left hand Tab leads back to it, past the right grasper.
    bench.press(true);
    EXPECT_EQ(bench.tab(), 1);
    bench.press(false);
    EXPECT_TRUE(bench.states[2].engaged);
    EXPECT_EQ(bench.tab(), 2);
    EXPECT_EQ(bench.tab(), 1);
    EXPECT_EQ(bench.tab(), 2);
    // Opened, it makes room.
    bench.press(true);
    bench.press(false);
    EXPECT_EQ(bench.tab(), 0);
    EXPECT_FALSE(bench.states[2].engaged);
    // So does a grasper that holds tissue not.
    bench.press(true);
    EXPECT_EQ(bench.tab(), 1);
    bench.press(false);
    EXPECT_EQ(bench.tab(), 0);
}

// Nor does the clock of an attempt start by itself: it waits for the first motion of a hand.
TEST(Mouse, NothingMovesBeforeThePersonDoes) {
    for (const char* name : {"mouse", "keyboard", "gamepad"})
        for (const sim::ToolKind kind :
             {sim::ToolKind::kNeedle, sim::ToolKind::kHook, sim::ToolKind::kGrasper,
              sim::ToolKind::kScissors, sim::ToolKind::kProbe, sim::ToolKind::kNeedleDriver}) {
            sim::Latest<sim::WindowInput> window;
            sim::WindowInput input;
            input.gamepad = true;
            DeviceConfig config;
            config.name = name;
            config.window = &window;
            config.tools.resize(2);
            config.tools[0].kind = kind;
            config.tools[1].kind = sim::ToolKind::kScope;
            const auto device = open_device(config);
            std::vector<DeviceState> first(2), states(2);
            for (int tick = 1; tick <= 1000; ++tick) {
                window.publish(input);
                device->read(tick * int64_t{1'000'000}, states);
                if (tick == 1) first = states;
                for (size_t i = 0; i < 2; ++i) {
                    ASSERT_EQ(states[i].position_m, first[i].position_m)
                        << name << ", tool " << static_cast<int>(kind);
                    ASSERT_EQ(states[i].jaw_rad, first[i].jaw_rad)
                        << name << ", tool " << static_cast<int>(kind);
                    ASSERT_EQ(states[i].roll_rad, first[i].roll_rad)
                        << name << ", tool " << static_cast<int>(kind);
                    ASSERT_EQ(states[i].engaged, first[i].engaged)
                        << name << ", tool " << static_cast<int>(kind);
                }
            }
        }
}

TEST(Mouse, KeepsJawsClosedOverTabUntilTheNextPress) {
    sim::Latest<sim::WindowInput> window;
    sim::WindowInput input;
    DeviceConfig config;
    config.name = "mouse";
    config.window = &window;
    config.tools.resize(2);
    config.tools[0].kind = sim::ToolKind::kScissors;
    config.tools[1].kind = sim::ToolKind::kGrasper;
    config.tools[1].tip_length_m = 0.010;
    config.tools[1].hand = sim::Hand::kLeft;
    const auto device = open_device(config);
    std::vector<DeviceState> states(2);
    int64_t t = 0;
    const auto read = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) {
            window.publish(input);
            device->read(t += 1'000'000, states);
        }
    };
    const auto tab = [&] { ++input.presses[static_cast<size_t>(Key::kTab)]; };
    read(500);
    tab();  // to the grasper
    read(500);
    const double open = states[1].jaw_rad;
    input.left = true;
    read(12'000);  // jaws hold as long as it takes
    const double closed = states[1].jaw_rad;
    EXPECT_LT(closed, 0.5 * open);
    tab();
    read(100);
    EXPECT_GT(states[0].jaw_rad, 0.1) << "the same press does not close the scissors";
    input.left = false;
    read(2000);
    input.left = true;
    read(500);
    EXPECT_LT(states[0].jaw_rad, 0.01) << "a new one does";
    input.left = false;
    tab();
    read(2000);
    EXPECT_EQ(states[1].jaw_rad, closed) << "back at the grasper: it still holds";
    input.left = true;
    read(100);
    input.left = false;
    read(500);
    EXPECT_NEAR(states[1].jaw_rad, open, 1e-9) << "pressed and let go: it opens";
}

/// A mouse with one tool, in pauses and without the focus.
struct OneTool {
    explicit OneTool(sim::ToolKind kind) {
        DeviceConfig config;
        config.name = "mouse";
        config.window = &window;
        config.tools.resize(1);
        config.tools[0].kind = kind;
        config.tools[0].tip_length_m = 0.010;
        device = open_device(config);
        read(500);
    }
    const DeviceState& read(int ticks) {
        window.publish(input);
        for (int i = 0; i < ticks; ++i) device->read(t_ns += kMs, states);
        return states[0];
    }
    void away(bool gone, bool pause) {
        if (pause)
            device->hold(gone);
        else
            input.focused = !gone;
    }

    sim::WindowInput input;
    sim::Latest<sim::WindowInput> window;
    std::unique_ptr<DeviceGroup> device;
    std::array<DeviceState, 1> states{};
    int64_t t_ns = 0;
};

TEST(Mouse, KeepsWhatItsJawsHoldThroughAPauseAndAnotherWindow) {
    for (const sim::ToolKind kind : {sim::ToolKind::kGrasper, sim::ToolKind::kNeedleDriver})
        for (const bool pause : {true, false}) {
            OneTool tool(kind);
            const double open = tool.read(1).jaw_rad;
            tool.input.left = true;
            const double closed = tool.read(1000).jaw_rad;
            EXPECT_LT(closed, open);
            tool.away(true, pause);
            tool.input.left = false;  // behind a menu the controls show no button
            EXPECT_EQ(tool.read(100).jaw_rad, closed);
            tool.away(false, pause);
            EXPECT_EQ(tool.read(500).jaw_rad, closed) << "still held, pause " << pause;
            tool.input.left = true;
            EXPECT_EQ(tool.read(100).jaw_rad, closed);
            tool.input.left = false;
            EXPECT_NEAR(tool.read(500).jaw_rad, open, 1e-9) << "pressed and let go: it opens";
            // What was open stays open, whatever is pressed and let go meanwhile.
            tool.away(true, pause);
            for (const bool down : {false, true, false}) {
                tool.input.left = down;
                tool.read(100);
            }
            tool.away(false, pause);
            EXPECT_NEAR(tool.read(500).jaw_rad, open, 1e-9);
        }
}

TEST(Mouse, CurrentStopsInAPauseAndWithoutTheFocusUntilPressedAnew) {
    for (const bool pause : {true, false})
        for (const bool held : {true, false}) {
            OneTool tool(sim::ToolKind::kNeedle);
            tool.input.left = true;
            EXPECT_EQ(tool.read(100).pedals, sim::kPedalCut);
            tool.away(true, pause);
            tool.input.left = held;
            EXPECT_EQ(tool.read(100).pedals, 0);
            tool.away(false, pause);
            EXPECT_EQ(tool.read(500).pedals, 0) << "pause " << pause << ", held " << held;
            tool.input.left = false;
            tool.read(10);
            tool.input.left = true;
            EXPECT_EQ(tool.read(10).pedals, sim::kPedalCut) << "pressed anew";
        }
}

TEST(Mouse, ReleasesThePedalAfterTenSeconds) {
    Bench bench("mouse");
    bench.input.left = true;
    EXPECT_EQ(bench.read(9'990).pedals, sim::kPedalCut);
    EXPECT_EQ(bench.read(30).pedals, 0);
    EXPECT_EQ(bench.read(5'000).pedals, 0) << "until it was let go";
    bench.input.left = false;
    bench.read(1);
    bench.input.left = true;
    EXPECT_EQ(bench.read(1).pedals, sim::kPedalCut);
}

TEST(Mouse, StopsWithoutTheFocus) {
    Bench bench("mouse");
    bench.input.left = true;
    bench.input.mouse_x += 3000;
    const Vec3 here = bench.read(5).position_m;
    EXPECT_EQ(bench.states[0].pedals, sim::kPedalCut);
    bench.input.focused = false;
    bench.input.mouse_x += 3000;
    EXPECT_EQ(bench.read(1000).pedals, 0);
    EXPECT_EQ(bench.states[0].position_m, here);
    bench.input.focused = true;
    EXPECT_EQ(bench.read(1000).pedals, 0) << "a button held meanwhile must be pressed again";
    EXPECT_EQ(bench.states[0].position_m, here) << "motion from meanwhile is not made up for";
}

TEST(Mouse, FinishesOnEnter) {
    Bench bench("mouse");
    EXPECT_FALSE(bench.read(100).finish);
    bench.press(Key::kEnter);
    EXPECT_TRUE(bench.read(1).finish);
}

TEST(Mouse, WorksWithoutAWindow) {
    DeviceConfig config;
    config.name = "mouse";
    config.tools = needle_and_scope();
    const auto device = open_device(config);
    std::array<DeviceState, 2> states;
    for (int i = 1; i < 100; ++i) device->read(i * kMs, states);
    EXPECT_EQ(states[0].position_m, Vec3::Zero());
    EXPECT_EQ(states[0].pedals, 0);
    EXPECT_EQ(device->info().size(), 2u);
}

TEST(Keyboard, MovesAtItsSpeedAndStopsWhenReleased) {
    Bench bench("keyboard");
    bench.hold(Key::kD);
    bench.hold(Key::kW);
    bench.read(300);
    const Vec3 start = bench.states[0].position_m;
    const Vec3 moved = bench.read(200).position_m - start;
    EXPECT_NEAR(moved.x(), 0.040 * 0.2, 4e-4);
    EXPECT_NEAR(moved.y(), 0.040 * 0.2, 4e-4);
    bench.hold(Key::kD, false);
    bench.hold(Key::kW, false);
    bench.read(600);
    const Vec3 rest = bench.states[0].position_m;
    EXPECT_LT((bench.read(200).position_m - rest).norm(), 1e-7);
}

TEST(Keyboard, GoesDeeperWithFAndBackWithR) {
    Bench bench("keyboard");
    bench.hold(Key::kF);
    const double deep = bench.read(300).position_m.z();
    EXPECT_LT(deep, -0.005);
    bench.hold(Key::kF, false);
    bench.hold(Key::kR);
    EXPECT_GT(bench.read(500).position_m.z(), deep + 0.005);
}

TEST(Keyboard, CutsWithXSlowly) {
    Bench bench("keyboard");
    bench.hold(Key::kX);
    bench.hold(Key::kD);
    bench.read(300);
    const double start = bench.states[0].position_m.x();
    EXPECT_EQ(bench.states[0].pedals, sim::kPedalCut);
    EXPECT_NEAR(bench.read(1000).position_m.x() - start, 0.004, 2e-4) << "4 mm/s under the pedal";
}

// A main thread that hung went on cutting for ten seconds, at the speed of the keys held last.
TEST(Keyboard, StopsWhereTheWindowSaysNothingForASecond) {
    Bench bench("keyboard");
    bench.hold(Key::kX);
    bench.hold(Key::kD);
    bench.read(1);
    const double start = bench.states[0].position_m.x();
    // Two pictures a second: slow, and no reason to stop.
    bench.read_only(900);
    EXPECT_EQ(bench.states[0].pedals, sim::kPedalCut);
    EXPECT_GT(bench.states[0].position_m.x(), start + 0.002);
    bench.read_only(200);
    const Vec3 here = bench.states[0].position_m;
    for (int i = 0; i < 2000; ++i) {
        EXPECT_EQ(bench.read_only(1).pedals, 0);
        EXPECT_EQ(bench.states[0].position_m, here);
    }
    EXPECT_EQ(bench.read(10).pedals, 0) << "what was held meanwhile has to be pressed anew";
    EXPECT_GT(bench.read(300).position_m.x(), here.x()) << "the hand goes on";
    bench.hold(Key::kX, false);
    bench.read(1);
    bench.hold(Key::kX);
    EXPECT_EQ(bench.read(1).pedals, sim::kPedalCut);
}

TEST(Mouse, StopsWhereTheWindowSaysNothingForASecond) {
    Bench bench("mouse");
    bench.input.left = true;
    bench.read(1);
    EXPECT_EQ(bench.read_only(900).pedals, sim::kPedalCut);
    EXPECT_EQ(bench.read_only(101).pedals, 0);
    EXPECT_EQ(bench.read(10).pedals, 0);
    EXPECT_FALSE(bench.states[0].finish);
}

TEST(Gamepad, IsLostUntilAPadIsThere) {
    Bench bench("gamepad");
    EXPECT_EQ(bench.read(1).status, DeviceStatus::kLost);
    bench.input.gamepad = true;
    bench.input.gamepad_axis = {1.0f, 0.0f, 0.0f, 0.0f, -1.0f, -1.0f};
    EXPECT_EQ(bench.read(1).status, DeviceStatus::kReady);
    bench.read(300);
    const Vec3 start = bench.states[0].position_m;
    const Vec3 moved = bench.read(100).position_m - start;
    EXPECT_NEAR(moved.x(), 0.006, 3e-4);
    EXPECT_NEAR(moved.z(), 0, 1e-9);
    bench.input.gamepad_axis[0] = 0.1f;  // a worn stick inside the dead zone
    bench.input.gamepad_buttons = 1;
    bench.read(600);
    const Vec3 rest = bench.states[0].position_m;
    EXPECT_LT((bench.read(200).position_m - rest).norm(), 1e-7);
    EXPECT_EQ(bench.states[0].pedals, sim::kPedalCut);
    bench.input.gamepad = false;
    EXPECT_EQ(bench.read(1).pedals, 0) << "unplugged";
}

TEST(Script, RunsInStepAndPutsTheTipWhereItWants) {
    DeviceConfig config;
    config.name = "script:expert";
    config.tools = needle_and_scope();
    const auto device = open_device(config);
    EXPECT_TRUE(device->lock_step());
    std::array<DeviceState, 2> states;
    device->read(kMs, states);
    // Before there is anything to see, the needle is at home, but for its tremor.
    const auto trocars = default_trocars(config.tools, config.name);
    Trocar trocar(config.tools[0], trocars[0]);
    EXPECT_LT((trocar.tip_pose(states[0]).p - trocars[0].home_tip_m).norm(), 2e-4);
    EXPECT_EQ(states[1].position_m, Vec3::Zero());
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
