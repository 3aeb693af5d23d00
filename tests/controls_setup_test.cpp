// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/controls_setup.h"

#include <gtest/gtest.h>

namespace placode::ui {
namespace THIS_TEST {

ControlsSetup setup_for(const char* device) {
    static const curriculum::Task task = curriculum::load_task("diathermy_ring_small");
    Arguments arguments;
    arguments.device = device;
    return controls_setup(task, arguments);
}

TEST(ControlsSetup, WhatStandsStillWithoutTheFocusPausesWithoutIt) {
    for (const char* device : {"mouse", "keyboard", "gamepad", "spacemouse"})
        EXPECT_TRUE(setup_for(device).window_hands) << device;
    for (const char* device :
         {"openhaptics", "haply", "avatar", "forcedimension", "script:expert", "script:mouse"})
        EXPECT_FALSE(setup_for(device).window_hands) << device;
}

TEST(ControlsSetup, ASpaceMouseThatLosesTheFocusStopsTheClock) {
    const curriculum::Task task = curriculum::load_task("diathermy_ring_small");
    TuningPanel panel(task, {});
    AttemptControls controls(setup_for("spacemouse"), panel);
    sim::WindowInput totals;
    controls.update({}, totals, {}, 5, 100);
    ASSERT_FALSE(controls.paused());
    totals.focused = false;
    controls.update({{.kind = view::WindowEvent::Kind::kFocus, .down = false}}, totals, {}, 5, 101);
    EXPECT_TRUE(controls.paused());
    EXPECT_EQ(controls.pause_cause(), sim::PauseCause::kFocus);
}

TEST(ControlsSetup, OnlyWhatIsPressedInTheWindowWaitsBehindTheFirstHelp) {
    for (const char* device : {"mouse", "keyboard", "gamepad"})
        EXPECT_TRUE(setup_for(device).help_first) << device;
    for (const char* device : {"spacemouse", "haply", "script:expert"})
        EXPECT_FALSE(setup_for(device).help_first) << device;
}

}  // namespace THIS_TEST
}  // namespace placode::ui
