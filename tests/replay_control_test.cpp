// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keys of a replay's window do what its foot and its help say.
#include "ui/attempt/replay_control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/attempt/attempt_overlay.h"
#include "ui/view/strings.h"

namespace placode::ui {
namespace THIS_TEST {

using sim::Key;
using testing::HasSubstr;
using testing::Not;

class Window {
 public:
    void press(Key key) {
        ++input_.presses[static_cast<size_t>(key)];
        keys_.apply(input_, 20, wish);
    }
    ReplayWish wish;

 private:
    sim::WindowInput input_;
    ReplayKeys keys_;
};

TEST(ReplayKeys, EscapeAndSpacePauseAndGoOnAndCloseNothing) {
    Window window;
    for (const Key key : {Key::kEscape, Key::kSpace}) {
        window.press(key);
        EXPECT_TRUE(window.wish.paused);
        EXPECT_FALSE(window.wish.quit);
        window.press(key);
        EXPECT_FALSE(window.wish.paused);
    }
    window.press(Key::kEnter);
    EXPECT_FALSE(window.wish.quit) << "nothing is to be finished";
    window.press(Key::kQ);
    EXPECT_TRUE(window.wish.quit);
}

TEST(ReplayKeys, ArrowsAndVDoWhatTheFootSays) {
    Window window;
    window.press(Key::kRight);
    EXPECT_EQ(window.wish.seek_s, 25);
    window.press(Key::kLeft);
    EXPECT_EQ(window.wish.seek_s, 15);
    window.press(Key::kUp);
    EXPECT_EQ(window.wish.speed, 2);
    window.press(Key::kV);
    EXPECT_EQ(window.wish.camera, ReplayCamera::kAbove);
}

view::OverlayState overlay_of(const std::string& mode) {
    Arguments arguments;
    arguments.play = "attempt.placode";
    arguments.device = "play:attempt.placode";
    sim::Recording recording;
    recording.header.mode = mode;
    recording.end.duration_s = 42;
    return replay_overlay(curriculum::load_task("touch_targets"), recording, arguments);
}

TEST(ReplayOverlay, SaysThatItIsAReplayAndOfWhat) {
    EXPECT_EQ(overlay_of("exam").heading, "Replay: exam");
    EXPECT_EQ(overlay_of("study").heading, "Replay: study");
    EXPECT_EQ(overlay_of("practice").heading, "Replay: practice");
    EXPECT_EQ(overlay_of("exam").time_limit_s, 42);
    // What was asked for is seen again, without hints for whoever only watches.
    ASSERT_EQ(overlay_of("exam").practice.steps.size(), 8U);
    EXPECT_FALSE(overlay_of("exam").practice.steps[0].text.empty());
    EXPECT_EQ(overlay_of("exam").practice.steps[0].hint, "");
    for (const char* mode : {"exam", "study", "practice"}) {
        const std::string english = overlay_of(mode).heading;
        EXPECT_NE(view::translated(english, "pl"), english);
    }
}

TEST(ReplayOverlay, FootAndHelpTellTheKeysOfAReplay) {
    const view::OverlayState overlay = overlay_of("exam");
    EXPECT_THAT(overlay.keys, HasSubstr("Space pause"));
    EXPECT_THAT(overlay.keys, HasSubstr("Q close"));
    EXPECT_THAT(overlay.keys, Not(HasSubstr("Enter")));
    EXPECT_NE(view::translated(overlay.keys, "pl"), overlay.keys);
    std::string help;
    for (const auto& [control, does] : overlay.help) help += control + ": " + does + "\n";
    EXPECT_THAT(help, HasSubstr("Space, Esc: Pause, go on"));
    EXPECT_THAT(help, HasSubstr("Q: Close"));
    EXPECT_THAT(view::OverlayState{}.keys, HasSubstr("hold Enter")) << "of an attempt";
}

TEST(ReplayWindow, FloatsOnlyWhereItIsSteeredFromOutsideAndStandsBesideTheControls) {
    Arguments arguments;
    EXPECT_FALSE(view_settings(arguments, "Task").floating);
    arguments.control = true;
    EXPECT_FALSE(view_settings(arguments, "Task").floating) << "it might cover its controls";
    arguments.place = {1000, 40};
    EXPECT_TRUE(view_settings(arguments, "Task").floating);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
