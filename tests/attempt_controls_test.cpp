// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/attempt_controls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/catalogue/open_device.h"

namespace placode::ui {
namespace THIS_TEST {

using curriculum::AttemptMode;
using sim::EndReason;
using sim::Key;
using testing::HasSubstr;
using view::WindowEvent;
using Kind = WindowEvent::Kind;

WindowEvent key(Key k, bool down = true) { return {.kind = Kind::kKey, .key = k, .down = down}; }
WindowEvent button(int b, bool down = true) {
    return {.kind = Kind::kButton, .button = static_cast<uint8_t>(b), .down = down};
}

/// A window, the controls, and the mouse behind them.
class Bench {
 public:
    explicit Bench(ControlsSetup setup = {}) : panel_(task(), {}), controls(setup, panel_) {
        haptics::DeviceConfig config;
        config.name = "mouse";
        config.tools.resize(1);
        config.window = &window_;
        step({});
        device_ = haptics::open_device(config);
        read();
    }
    static const curriculum::Task& task() {
        static const curriculum::Task loaded = curriculum::load_task("diathermy_ring_small");
        return loaded;
    }
    /// `passed_s` later, with these events in one round.
    void step(const view::WindowEvents& events, double passed_s = 0.02) {
        now_s += passed_s;
        for (const WindowEvent& event : events) {
            if (event.kind != Kind::kKey) continue;
            totals.down[static_cast<size_t>(event.key)] = event.down;
            if (event.down) ++totals.presses[static_cast<size_t>(event.key)];
        }
        controls.update(events, totals, pointer, attempt_s, now_s);
        window_.publish(controls.for_devices());
        if (device_) read();
    }
    void tap(Key k) {
        step({key(k)});
        step({key(k, false)});
    }
    [[nodiscard]] const haptics::DeviceState& hand() const { return states_[0]; }

    double now_s = 100, attempt_s = 200;
    sim::WindowInput totals;
    Pointer pointer;

 private:
    void read() {
        for (int i = 0; i < 20; ++i) device_->read(t_ns_ += 1'000'000, states_);
    }
    TuningPanel panel_;
    sim::Latest<sim::WindowInput> window_;
    std::unique_ptr<haptics::DeviceGroup> device_;
    std::array<haptics::DeviceState, 1> states_{};
    int64_t t_ns_ = 0;

 public:
    AttemptControls controls;
    [[nodiscard]] const TuningPanel& panel() const { return panel_; }
};

TEST(AttemptControls, EnterThatLeavesTheMenuEndsNothing) {
    for (const bool at_once : {false, true}) {
        Bench bench;
        if (at_once) {  // a slow picture: all of it between two rounds
            bench.step({key(Key::kEscape), key(Key::kEscape, false), key(Key::kEnter),
                        key(Key::kEnter, false)});
        } else {
            bench.tap(Key::kEscape);
            EXPECT_EQ(bench.controls.screen(), Screen::kMenu);
            bench.tap(Key::kEnter);
        }
        EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
        bench.step({}, 3);
        EXPECT_FALSE(bench.controls.end());
        EXPECT_FALSE(bench.hand().finish);
    }
}

TEST(AttemptControls, EnterThatLeavesTheMenuAndStaysDownEndsNothing) {
    Bench bench;
    bench.tap(Key::kEscape);
    bench.step({key(Key::kEnter)});
    for (int i = 0; i < 100; ++i) bench.step({}, 0.05);
    EXPECT_FALSE(bench.controls.end());
    EXPECT_EQ(bench.controls.holding(), 0);
}

TEST(AttemptControls, EnterAsksAndHeldForASecondEnds) {
    Bench bench;
    bench.tap(Key::kEnter);
    EXPECT_EQ(bench.controls.screen(), Screen::kQuestion);
    EXPECT_EQ(bench.controls.menu().selected, 0);
    bench.tap(Key::kEnter);  // the harmless one is chosen
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
    bench.step({key(Key::kEnter)});
    bench.step({}, 0.5);
    EXPECT_NEAR(bench.controls.holding(), 0.5, 1e-9);
    EXPECT_FALSE(bench.controls.end());
    bench.step({}, 0.5);
    EXPECT_EQ(bench.controls.end(), EndReason::kFinished);
}

TEST(AttemptControls, AStudysProcedureBelowItsLeastTimeIsAskedHoweverLongEnterIsHeld) {
    ControlsSetup setup;
    setup.mode = AttemptMode::kStudy;
    setup.least_s = 60;
    Bench bench(setup);
    bench.attempt_s = 12;
    bench.step({key(Key::kEnter)});
    bench.step({}, 5);
    EXPECT_FALSE(bench.controls.end());
    ASSERT_EQ(bench.controls.screen(), Screen::kQuestion);
    EXPECT_TRUE(bench.controls.paused());
    ASSERT_FALSE(bench.controls.menu().lines.empty());
    EXPECT_THAT(bench.controls.menu().lines[0], HasSubstr("at least 1:00"));
    bench.step({key(Key::kEnter, false)});
    bench.tap(Key::kDown);
    bench.tap(Key::kEnter);
    EXPECT_EQ(bench.controls.end(), EndReason::kFinished);
}

struct EndCase {
    AttemptMode mode;
    double attempt_s;
    bool asks;
};
const EndCase kEnds[] = {{AttemptMode::kPractice, 200, false},
                         {AttemptMode::kPractice, 20, true},
                         {AttemptMode::kPractice, 15, true},
                         {AttemptMode::kExam, 200, true},
                         {AttemptMode::kStudy, 200, true}};

TEST(AttemptControls, EnterHeldAsksInExamsStudiesAndEarlyHoweverLong) {
    for (const EndCase& each : kEnds) {
        ControlsSetup setup;
        setup.mode = each.mode;
        setup.usual_s = 300;
        Bench bench(setup);
        bench.attempt_s = each.attempt_s;
        bench.step({key(Key::kEnter)});
        for (int i = 0; i < 5; ++i) bench.step({}, 1);
        EXPECT_EQ(bench.controls.end().has_value(), !each.asks);
        EXPECT_EQ(bench.controls.screen() == Screen::kQuestion, each.asks);
        if (!each.asks) continue;
        EXPECT_TRUE(bench.controls.paused());
        EXPECT_EQ(bench.controls.pause_cause(), sim::PauseCause::kMenu);
        bench.step({key(Key::kEnter, false)});
        EXPECT_FALSE(bench.controls.end()) << "letting go answers nothing";
        bench.tap(Key::kEnter);
        EXPECT_EQ(bench.controls.screen(), Screen::kOperate) << "the harmless answer is chosen";
    }
}

TEST(AttemptControls, AKeyThatIsLetGoUnseenStopsAndAnswersNothing) {
    const auto unseen = [](Key k) {
        return WindowEvent{.kind = Kind::kKey, .key = k, .unseen = true};
    };
    Bench bench;
    bench.step({key(Key::kEnter), key(Key::kX)});
    EXPECT_TRUE(bench.controls.for_devices().is_down(Key::kX));
    bench.step({unseen(Key::kX)});
    EXPECT_FALSE(bench.controls.for_devices().is_down(Key::kX));
    bench.step({key(Key::kEnter)}, 0.5);
    bench.step({unseen(Key::kEnter)}, 0.5);
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate) << "no question either";
    for (int i = 0; i < 5; ++i) bench.step({}, 1);
    EXPECT_FALSE(bench.controls.end());
    EXPECT_EQ(bench.controls.holding(), 0);
}

TEST(AttemptControls, TheMenusFinishAsksAgainInExamsStudiesAndEarly) {
    for (const EndCase& each : kEnds) {
        ControlsSetup setup;
        setup.mode = each.mode;
        setup.usual_s = 300;
        Bench bench(setup);
        bench.attempt_s = each.attempt_s;
        bench.tap(Key::kEscape);
        bench.tap(Key::kDown);
        bench.tap(Key::kEnter);
        EXPECT_EQ(bench.controls.end().has_value(), !each.asks);
        EXPECT_EQ(bench.controls.screen() == Screen::kQuestion, each.asks);
    }
}

TEST(AttemptControls, LeavingIsAskedAndKeptAsInterrupted) {
    Bench bench;
    bench.tap(Key::kEscape);
    bench.tap(Key::kUp);
    bench.tap(Key::kEnter);
    EXPECT_FALSE(bench.controls.end());
    EXPECT_EQ(bench.controls.screen(), Screen::kQuestion);
    bench.tap(Key::kDown);
    bench.tap(Key::kEnter);
    EXPECT_EQ(bench.controls.end(), EndReason::kInterrupted);
}

TEST(AttemptControls, WhoLeavesAnExamIsToldThatItUsesUpTheAttempt) {
    const auto lines = [](AttemptMode mode, double attempt_s, bool close) {
        ControlsSetup setup;
        setup.mode = mode;
        Bench bench(setup);
        bench.attempt_s = attempt_s;
        if (close) {
            bench.step({{.kind = Kind::kClose}});
        } else {
            for (const Key key : {Key::kEscape, Key::kUp, Key::kEnter}) bench.tap(key);
        }
        EXPECT_EQ(bench.controls.screen(), Screen::kQuestion);
        return bench.controls.menu().lines;
    };
    const char* const uses_up = "This is an exam: leaving uses up this attempt.";
    for (const bool close : {false, true}) {
        EXPECT_THAT(lines(AttemptMode::kExam, 40, close), testing::ElementsAre(uses_up));
        EXPECT_THAT(lines(AttemptMode::kExam, 0, close),
                    testing::ElementsAre(HasSubstr("leaving uses up nothing")));
        EXPECT_THAT(lines(AttemptMode::kPractice, 40, close),
                    testing::ElementsAre(HasSubstr("counts for nothing")));
    }
}

TEST(AttemptControls, TheMenuSaysWhatLeavingCosts) {
    const auto leave = [](AttemptMode mode, double attempt_s) {
        ControlsSetup setup;
        setup.mode = mode;
        Bench bench(setup);
        bench.attempt_s = attempt_s;
        bench.tap(Key::kEscape);
        return bench.controls.menu().items.at(2);
    };
    EXPECT_EQ(leave(AttemptMode::kExam, 40), "Leave: uses up an attempt");
    EXPECT_EQ(leave(AttemptMode::kExam, 0), "Leave without finishing") << "nothing has begun";
    EXPECT_EQ(leave(AttemptMode::kStudy, 40), "Leave: has to be done again");
    EXPECT_EQ(leave(AttemptMode::kPractice, 40), "Leave without finishing");
}

TEST(AttemptControls, WhatAnExamDoesNotHaveIsRefusedInTheMenuToo) {
    ControlsSetup setup;
    setup.mode = AttemptMode::kExam;
    Bench exam(setup), practice;
    for (Bench* bench : {&exam, &practice})
        for (const Key key : {Key::kEscape, Key::kF2, Key::kF2, Key::kF1}) bench->tap(key);
    EXPECT_EQ(exam.controls.screen(), Screen::kMenu);
    EXPECT_THAT(exam.controls.menu().lines,
                testing::ElementsAre("No tuning in an exam", "No help in an exam"));
    EXPECT_THAT(practice.controls.menu().lines, testing::IsEmpty());
}

TEST(AttemptControls, ClosingTheWindowPausesAndAsks) {
    Bench bench;
    for (int i = 0; i < 3; ++i) bench.step({{.kind = Kind::kClose}});
    EXPECT_FALSE(bench.controls.end());
    EXPECT_EQ(bench.controls.screen(), Screen::kQuestion);
    EXPECT_EQ(bench.controls.pause_cause(), sim::PauseCause::kClosing);
    bench.tap(Key::kEscape);
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
}

TEST(AttemptControls, AClickWhereThePointerHappensToLieChoosesNothing) {
    Bench bench;
    bench.pointer = {400, 300, 1, -1};
    bench.tap(Key::kEscape);
    bench.step({button(0)});
    bench.step({button(0, false)});
    EXPECT_EQ(bench.controls.screen(), Screen::kMenu);
    EXPECT_EQ(bench.controls.menu().selected, 0);
    bench.pointer = {430, 300, 0, -1};  // moved on purpose
    bench.step({button(0)});
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
    EXPECT_EQ(bench.hand().pedals, 0) << "the click that leaves the menu fires nothing";
    bench.step({button(0, false)});
    bench.step({button(0)});
    EXPECT_EQ(bench.hand().pedals, sim::kPedalCut);
}

TEST(AttemptControls, KeysMoveTheSelectionUnderAPointerThatRests) {
    Bench bench;
    bench.tap(Key::kEscape);
    bench.pointer = {10, 10, -1, -1};
    bench.step({});
    bench.pointer = {400, 300, 2, -1};
    bench.step({});
    EXPECT_EQ(bench.controls.menu().selected, 2);
    bench.tap(Key::kUp);
    bench.step({});
    EXPECT_EQ(bench.controls.menu().selected, 1);
}

TEST(AttemptControls, HelpStopsTheClockAndItsKeyIsUsedUp) {
    Bench bench;
    bench.tap(Key::kF1);
    EXPECT_EQ(bench.controls.screen(), Screen::kHelp);
    EXPECT_TRUE(bench.controls.paused());
    EXPECT_EQ(bench.controls.pause_cause(), sim::PauseCause::kHelp);
    bench.totals.mouse_x += 5000;
    bench.step({});
    EXPECT_EQ(bench.controls.screen(), Screen::kHelp) << "who reads may rest a hand on the mouse";
    bench.step({key(Key::kX)});
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
    EXPECT_FALSE(bench.controls.for_devices().is_down(Key::kX));
    EXPECT_EQ(bench.controls.for_devices().mouse_x, 0);
}

TEST(AttemptControls, TheTuningPanelStopsTheClockAndGivesEveryKeyBack) {
    Bench bench;
    bench.tap(Key::kF1);  // its cause must not stay
    bench.tap(Key::kF1);
    bench.tap(Key::kF2);
    EXPECT_TRUE(bench.panel().shown());
    EXPECT_TRUE(bench.controls.paused()) << "time does not run behind the panel";
    EXPECT_EQ(bench.controls.pause_cause(), sim::PauseCause::kMenu);
    EXPECT_FALSE(bench.controls.captures_pointer());
    bench.tap(Key::kDown);
    bench.tap(Key::kRight);
    EXPECT_TRUE(bench.panel().tuned());
    EXPECT_FALSE(bench.controls.for_devices().is_down(Key::kRight));
    bench.step({key(Key::kEnter)});
    bench.step({}, 2);
    bench.step({key(Key::kEnter, false)});
    EXPECT_FALSE(bench.controls.end());
    for (const Key closing : {Key::kF2, Key::kEscape}) {
        bench.tap(closing);
        EXPECT_FALSE(bench.panel().shown());
        EXPECT_FALSE(bench.controls.paused());
        EXPECT_TRUE(bench.controls.captures_pointer());
        const sim::WindowInput& seen = bench.controls.for_devices();
        for (const Key arrow : {Key::kUp, Key::kDown, Key::kLeft, Key::kRight}) {
            const uint32_t before = seen.presses[static_cast<size_t>(arrow)];
            bench.step({key(arrow)});
            EXPECT_TRUE(seen.is_down(arrow)) << "the arrows are the hands' again";
            EXPECT_EQ(seen.presses[static_cast<size_t>(arrow)], before + 1);
            bench.step({key(arrow, false)});
        }
        if (closing == Key::kF2) bench.tap(Key::kF2);
    }
}

TEST(AttemptControls, BeginsWithTheHelpUntilSomebodyMeansToMove) {
    ControlsSetup setup;
    setup.help_first = true;
    Bench bench(setup);
    bench.attempt_s = 0;
    EXPECT_EQ(bench.controls.screen(), Screen::kHelp);
    bench.totals.mouse_x += 100;
    bench.step({});
    EXPECT_EQ(bench.controls.screen(), Screen::kHelp);
    bench.totals.mouse_y += 400;
    bench.step({});
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
    EXPECT_EQ(bench.controls.for_devices().mouse_y, 0);
}

TEST(AttemptControls, EscapeFromTheFirstHelpGivesThePointerBackInsteadOfTakingIt) {
    ControlsSetup setup;
    setup.help_first = true;
    Bench bench(setup);
    bench.attempt_s = 0;
    bench.tap(Key::kEscape);
    EXPECT_EQ(bench.controls.screen(), Screen::kMenu);
    EXPECT_FALSE(bench.controls.captures_pointer());
    bench.tap(Key::kEscape);
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate) << "from the menu it goes on, as always";
    bench.tap(Key::kF1);
    bench.tap(Key::kEscape);
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate) << "a help that was asked for just closes";
}

TEST(AttemptControls, WhatAModeDoesNotHaveIsNotThere) {
    for (const AttemptMode mode : {AttemptMode::kExam, AttemptMode::kStudy}) {
        ControlsSetup setup;
        setup.mode = mode;
        setup.planned_line = false;
        Bench bench(setup);
        bench.tap(Key::kF2);
        EXPECT_FALSE(bench.panel().shown());
        EXPECT_THAT(bench.controls.take_note(), HasSubstr("No tuning"));
        for (const Key k : {Key::kF3, Key::kF5, Key::kF12}) bench.tap(k);
        EXPECT_TRUE(bench.controls.take_commands().empty());
        bench.tap(Key::kF1);
        EXPECT_EQ(bench.controls.screen() == Screen::kHelp, mode == AttemptMode::kStudy);
    }
}

TEST(AttemptControls, ALostFocusPausesHandsOfTheWindowOnceTheyHaveBegun) {
    for (const bool window_hands : {true, false}) {
        ControlsSetup setup;
        setup.window_hands = window_hands;
        Bench bench(setup);
        bench.attempt_s = 0;
        bench.step({{.kind = Kind::kFocus, .down = false}});
        EXPECT_FALSE(bench.controls.paused());
        bench.attempt_s = 5;
        bench.step({button(0)});
        bench.step({{.kind = Kind::kFocus, .down = false}});
        EXPECT_EQ(bench.controls.paused(), window_hands);
        EXPECT_FALSE(bench.controls.for_devices().left);
    }
}

TEST(AttemptControls, AMinimisedWindowPausesEveryDeviceOnceItHasBegun) {
    for (const bool window_hands : {true, false}) {
        ControlsSetup setup;
        setup.window_hands = window_hands;
        Bench bench(setup);
        bench.attempt_s = 0;
        bench.step({{.kind = Kind::kHidden}});
        EXPECT_FALSE(bench.controls.paused());
        bench.attempt_s = 5;
        bench.step({button(0)});
        bench.step({{.kind = Kind::kFocus, .down = false}, {.kind = Kind::kHidden}});
        EXPECT_TRUE(bench.controls.paused()) << window_hands;
        EXPECT_EQ(bench.controls.pause_cause(), sim::PauseCause::kFocus);
        EXPECT_EQ(bench.controls.screen(), Screen::kMenu);
        EXPECT_FALSE(bench.controls.for_devices().left);
        bench.step({{.kind = Kind::kFocus, .down = true}});
        EXPECT_TRUE(bench.controls.paused()) << "until somebody chooses to go on";
        bench.tap(Key::kEscape);
        EXPECT_FALSE(bench.controls.paused());
    }
}

TEST(AttemptControls, AGamepadThatGoesAwayPausesWhatHasBegun) {
    for (const bool gamepad : {true, false}) {
        ControlsSetup setup;
        setup.gamepad = gamepad;
        Bench bench(setup);
        bench.attempt_s = 0;
        if (bench.controls.paused()) bench.tap(Key::kEscape);  // it begins in mid-attempt
        bench.step({});
        EXPECT_FALSE(bench.controls.paused()) << "nothing has begun";
        bench.attempt_s = 5;
        bench.totals.gamepad = true;
        bench.step({button(0)});
        EXPECT_FALSE(bench.controls.paused());
        bench.totals.gamepad = false;
        bench.step({});
        EXPECT_EQ(bench.controls.paused(), gamepad);
        EXPECT_EQ(bench.controls.for_devices().left, !gamepad);
        if (!gamepad) continue;
        EXPECT_EQ(bench.controls.screen(), Screen::kMenu);
        EXPECT_EQ(bench.controls.pause_cause(), sim::PauseCause::kDevice);
        EXPECT_EQ(bench.controls.menu().title, "Paused: the gamepad is gone");
        bench.tap(Key::kEscape);
        EXPECT_TRUE(bench.controls.paused()) << "without it nobody operates";
        bench.totals.gamepad = true;
        bench.step({});
        EXPECT_TRUE(bench.controls.paused()) << "until somebody chooses to go on";
        bench.tap(Key::kEscape);
        EXPECT_FALSE(bench.controls.paused());
    }
}

TEST(AttemptControls, AMenuThatStandsIsNotReplacedByAPauseThatNobodyAskedFor) {
    Bench bench;
    bench.tap(Key::kEscape);
    bench.controls.interrupt("Paused: the SpaceMouse is gone", sim::PauseCause::kDevice);
    EXPECT_EQ(bench.controls.pause_cause(), sim::PauseCause::kMenu);
    bench.tap(Key::kEscape);
    bench.controls.interrupt("Paused: the SpaceMouse is gone", sim::PauseCause::kDevice);
    EXPECT_EQ(bench.controls.menu().title, "Paused: the SpaceMouse is gone");
    bench.step({});
    EXPECT_TRUE(bench.controls.paused());
}

TEST(AttemptControls, AClickBetweenTwoPicturesIsSeenByTheHand) {
    Bench bench;
    bench.step({button(0), button(0, false)});
    EXPECT_TRUE(bench.controls.for_devices().left);
    bench.step({});
    EXPECT_FALSE(bench.controls.for_devices().left);
}

TEST(AttemptControls, AGamepadsStartOpensTheMenuAndNeverEnds) {
    Bench bench;
    bench.totals.gamepad = true;
    bench.totals.gamepad_buttons = 1U << 7;
    bench.step({{.kind = Kind::kStart, .down = true}});
    EXPECT_EQ(bench.controls.screen(), Screen::kMenu);
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, 0);
    bench.step({{.kind = Kind::kStart, .down = true}});
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
    bench.step({});
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, 0);
}

constexpr uint16_t kPadA = 1U << 0, kPadB = 1U << 1, kPadLeftBumper = 1U << 4;

TEST(AttemptControls, APadsButtonThatLeavesTheFirstHelpDoesNothingElse) {
    ControlsSetup setup;
    setup.help_first = true;
    Bench bench(setup);
    bench.attempt_s = 0;
    bench.totals.gamepad = true;
    bench.totals.gamepad_buttons = kPadA;
    for (int i = 0; i < 10; ++i) {
        bench.step({});
        EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, 0) << "held since the help";
    }
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
    bench.totals.gamepad_buttons = kPadA | kPadB;
    bench.step({});
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, kPadB) << "the other one is new";
    bench.totals.gamepad_buttons = 0;
    bench.step({});
    bench.totals.gamepad_buttons = kPadA;
    bench.step({});
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, kPadA) << "pressed anew";
}

TEST(AttemptControls, APadsPedalThatIsHeldThroughAPauseHasToBePressedAnew) {
    Bench bench;
    bench.totals.gamepad = true;
    bench.totals.gamepad_buttons = kPadA | kPadLeftBumper;
    bench.step({});
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, kPadA | kPadLeftBumper);
    bench.tap(Key::kEscape);
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, 0);
    bench.tap(Key::kEscape);
    ASSERT_EQ(bench.controls.screen(), Screen::kOperate);
    bench.step({});
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, kPadLeftBumper)
        << "precision goes on, the pedal does not";
    bench.totals.gamepad_buttons = 0;
    bench.step({});
    bench.totals.gamepad_buttons = kPadA;
    bench.step({});
    EXPECT_EQ(bench.controls.for_devices().gamepad_buttons, kPadA);
}

TEST(AttemptControls, StartDoesNotGoOnWhileAnotherWindowHasTheFocus) {
    for (const bool help : {false, true}) {
        Bench bench;
        bench.totals.gamepad = true;
        if (help) bench.tap(Key::kF1);
        bench.totals.focused = false;
        bench.step({{.kind = Kind::kFocus, .down = false}});
        ASSERT_TRUE(bench.controls.paused());
        bench.step({{.kind = Kind::kStart, .down = true}});
        EXPECT_TRUE(bench.controls.paused()) << "the press was for the window in front";
        bench.totals.focused = true;
        bench.step({{.kind = Kind::kFocus, .down = true}});
        bench.step({{.kind = Kind::kStart, .down = true}});
        EXPECT_FALSE(bench.controls.paused());
    }
}

TEST(AttemptControls, TheLeftHandedLayoutIsTheSameInTheMirror) {
    ControlsSetup setup;
    setup.layout = haptics::ControlLayout::left_handed();
    Bench bench(setup);
    const sim::WindowInput& seen = bench.controls.for_devices();
    bench.step({button(1)});
    EXPECT_TRUE(seen.left) << "the right button is below the first finger of the left hand";
    EXPECT_FALSE(seen.right);
    bench.step({button(1, false)});
    bench.step({key(Key::kJ)});
    EXPECT_TRUE(seen.is_down(Key::kA));
    EXPECT_FALSE(seen.is_down(Key::kJ));
    bench.step({key(Key::kJ, false)});
    EXPECT_FALSE(seen.is_down(Key::kA));
    bench.tap(Key::kA);
    EXPECT_EQ(seen.presses[static_cast<size_t>(Key::kA)], 1U) << "J once, and A does nothing now";
    // L moves to the right and M coagulates; lens and sound have other keys.
    bench.step({key(Key::kL), {.kind = Kind::kLetter, .letter = U'l'}});
    EXPECT_TRUE(seen.is_down(Key::kD));
    EXPECT_TRUE(bench.controls.take_commands().empty());
    bench.step({key(Key::kL, false), key(Key::kB), {.kind = Kind::kLetter, .letter = U'b'}});
    EXPECT_EQ(bench.controls.take_commands(), std::vector{Command::kWipeLens});
    bench.step({key(Key::kM), {.kind = Kind::kLetter, .letter = U'm'}});
    EXPECT_TRUE(seen.is_down(Key::kC));
    EXPECT_TRUE(bench.controls.take_commands().empty());
    bench.step({key(Key::kV), {.kind = Kind::kLetter, .letter = U'v'}});
    EXPECT_EQ(bench.controls.take_commands(), std::vector{Command::kMute});
    EXPECT_FALSE(bench.controls.end());
}

WindowEvent typed(char32_t letter) { return {.kind = Kind::kLetter, .letter = letter}; }

TEST(AttemptControls, AKeyboardWithoutLatinLettersWipesAndMutesByPlace) {
    constexpr char32_t kDe = 0x0434, kSoftSign = 0x044C;  // where a Russian keyboard has L and M
    Bench bench;
    bench.step({{.kind = Kind::kKey, .key = Key::kL, .down = true, .letter = kDe}, typed(kDe)});
    EXPECT_EQ(bench.controls.take_commands(), std::vector{Command::kWipeLens});
    for (int i = 0; i < 20; ++i) bench.step({typed(kDe)});
    EXPECT_TRUE(bench.controls.take_commands().empty()) << "held, it types on";
    bench.step({key(Key::kL, false)});
    bench.step({{.kind = Kind::kKey, .key = Key::kM, .down = true, .letter = kSoftSign},
                typed(kSoftSign)});
    EXPECT_EQ(bench.controls.take_commands(), std::vector{Command::kMute});
    // Another key with such a letter means what its place means.
    bench.step({{.kind = Kind::kKey, .key = Key::kX, .down = true, .letter = 0x0447}});
    EXPECT_TRUE(bench.controls.take_commands().empty());
    EXPECT_TRUE(bench.controls.for_devices().is_down(Key::kX));
}

TEST(AttemptControls, AKeyThatIsHeldWipesAndMutesOnce) {
    struct Case {
        Key place;
        char32_t letter;
        Command command;
    };
    // The last as on a French keyboard, whose M lies elsewhere.
    for (const Case& each :
         {Case{Key::kM, U'm', Command::kMute}, Case{Key::kL, U'L', Command::kWipeLens},
          Case{Key::kSemicolon, U'm', Command::kMute}}) {
        Bench bench;
        for (int press = 0; press < 2; ++press) {
            bench.step({key(each.place)});
            for (int i = 0; i < 20; ++i) bench.step({typed(each.letter)});
            EXPECT_EQ(bench.controls.take_commands(), std::vector{each.command});
            bench.step({key(each.place, false)});
        }
        for (int i = 0; i < 3; ++i) bench.step({typed(U'+')});
        EXPECT_EQ(bench.controls.take_commands().size(), 3U) << "louder goes on";
    }
}

TEST(AttemptControls, MenusKeepTheirKeysWhateverTheHandsHave) {
    ControlsSetup setup;
    setup.layout = haptics::ControlLayout::parse(
        "up=Up down=Down left=Left right=Right scope-up=W scope-down=S scope-left=A scope-right=D "
        "precise=Space still=Ctrl");
    Bench bench(setup);
    const sim::WindowInput& seen = bench.controls.for_devices();
    bench.step({key(Key::kUp), key(Key::kSpace)});
    EXPECT_TRUE(seen.is_down(Key::kW));
    EXPECT_TRUE(seen.is_down(Key::kControl)) << "a modifier, on a key of another kind";
    bench.step({key(Key::kUp, false), key(Key::kSpace, false)});
    bench.tap(Key::kEscape);
    ASSERT_EQ(bench.controls.screen(), Screen::kMenu);
    bench.tap(Key::kDown);
    EXPECT_EQ(bench.controls.menu().selected, 1);
    bench.tap(Key::kUp);
    bench.tap(Key::kEnter);
    EXPECT_EQ(bench.controls.screen(), Screen::kOperate);
    EXPECT_EQ(seen.presses[static_cast<size_t>(Key::kS)], 0U);
}

TEST(AttemptControls, ExchangedSticksMoveAndTurn) {
    ControlsSetup setup;
    setup.layout.sticks_exchanged = true;
    Bench bench(setup);
    bench.totals.gamepad = true;
    bench.totals.gamepad_axis = {0.1F, 0.2F, 0.3F, 0.4F, -1, 1};
    bench.step({});
    EXPECT_EQ(bench.controls.for_devices().gamepad_axis,
              (std::array<float, 6>{0.3F, 0.4F, 0.1F, 0.2F, -1, 1}));
}

}  // namespace THIS_TEST
}  // namespace placode::ui
