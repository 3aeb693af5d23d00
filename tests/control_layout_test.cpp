// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every layout has each thing on one key, is written and read back the same, and is what help and
// hints say.
#include "haptics/control_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "curriculum/step_hints.h"
#include "haptics/control_help.h"
#include "haptics/control_words.h"

namespace placode::haptics {
namespace THIS_TEST {

using sim::Key;
using testing::HasSubstr;
using testing::Not;

void expect_whole(const ControlLayout& layout) {
    std::set<Key> used;
    for (const Control& control : layout_controls()) {
        const Key key = layout.key_for(control.does);
        ASSERT_NE(key, Key::kCount) << control.name << " is on no key";
        EXPECT_TRUE(used.insert(key).second) << control.name << " shares " << key_word(key);
        EXPECT_EQ(layout.does(key), control.does) << control.name;
    }
    for (const Key fixed : {Key::kEnter, Key::kEscape, Key::kF1, Key::kF2, Key::kF3, Key::kF5,
                            Key::kF12, Key::kCut, Key::kCoag})
        EXPECT_EQ(layout.does(fixed), fixed);
}

TEST(ControlLayout, KeepsEachThingOnOneKeyWhateverIsChosen) {
    expect_whole({});
    expect_whole(ControlLayout::left_handed());
    std::mt19937 random(5);
    ControlLayout layout;
    for (int i = 0; i < 3000; ++i) {
        const auto controls = layout_controls();
        const Key does = i % 7 == 0 ? static_cast<Key>(random() % static_cast<size_t>(Key::kCount))
                                    : controls[random() % controls.size()].does;
        const Key key = static_cast<Key>(random() % static_cast<size_t>(Key::kCount));
        const ControlLayout before = layout;
        if (layout.put(does, key)) {
            EXPECT_EQ(layout.key_for(does), key);
        } else {
            EXPECT_EQ(layout, before);
        }
        layout.buttons_exchanged = random() % 2 == 0;
        layout.sticks_exchanged = random() % 2 == 0;
        expect_whole(layout);
        ASSERT_EQ(ControlLayout::parse(layout.text()), layout) << layout.text();
    }
}

TEST(ControlLayout, ExchangesWhatWasOnTheKey) {
    ControlLayout layout;
    ASSERT_TRUE(layout.put(Key::kX, Key::kF));
    EXPECT_EQ(layout.does(Key::kF), Key::kX);
    EXPECT_EQ(layout.does(Key::kX), Key::kF);
    EXPECT_EQ(layout.text(), "deeper=X cut=F");
    ASSERT_TRUE(layout.put(Key::kX, Key::kG));
    EXPECT_EQ(layout.does(Key::kF), Key::kCount) << "a key that was left does nothing";
    EXPECT_FALSE(layout.put(Key::kX, Key::kEnter));
    EXPECT_FALSE(layout.put(Key::kX, Key::kF1));
    EXPECT_FALSE(layout.put(Key::kEnter, Key::kG));
}

TEST(ControlLayout, IsSaidShortly) {
    EXPECT_EQ(ControlLayout().text(), "");
    EXPECT_EQ(ControlLayout::left_handed().text(), "left-handed");
    ControlLayout layout = ControlLayout::left_handed();
    layout.buttons_exchanged = false;
    layout.put(Key::kL, Key::kG);
    EXPECT_EQ(layout.text(), "left-handed wipe=G buttons=usual");
}

TEST(ControlLayout, RefusesWhatItDoesNotUnderstandByName) {
    const auto why = [](std::string_view text) {
        try {
            (void)ControlLayout::parse(text);
        } catch (const LayoutError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(why("jump=G"), HasSubstr("\"jump=G\""));
    EXPECT_THAT(why("cut"), HasSubstr("NAME=KEY"));
    EXPECT_THAT(why("cut=Enter"), HasSubstr("no such key"));
    EXPECT_THAT(why("cut="), HasSubstr("no such key"));
    EXPECT_THAT(why("cut=C"), HasSubstr("cut and coagulate are both on the key C"));
    EXPECT_THAT(why("buttons=maybe"), HasSubstr("exchanged or usual"));
    EXPECT_THAT(why("cut=V left-handed"), HasSubstr("left-handed"));
    EXPECT_EQ(why("  cut=C   coagulate=X "), "");
}

TEST(ControlWords, SayTheChosenKeysAndNoOthers) {
    ControlLayout none;
    const ControlLayout left = ControlLayout::left_handed();
    for (const char* device : {"mouse", "keyboard", "gamepad", "spacemouse", "haply", "avatar"}) {
        const HintDevice kind = hint_device(device);
        for (int step = 0; step < sim::kPracticeKinds; ++step) {
            curriculum::TaskStep practice;
            practice.goal.kind = static_cast<sim::PracticeKind>(step);
            const curriculum::LocalText hint = curriculum::step_hint(practice, device, true);
            for (const char* language : {"en", "pl"}) {
                const std::string text = hint.in(language);
                EXPECT_EQ(in_layout(text, none, kind, language), text);
                const std::string said = in_layout(text, left, kind, language);
                EXPECT_THAT(said, Not(HasSubstr("Tab"))) << device;
                if (kind == HintDevice::kKeyboard) {
                    EXPECT_THAT(said, Not(HasSubstr("W A S D")));
                }
                if (kind == HintDevice::kMouse) {
                    // Exchanged twice is as before.
                    ControlLayout buttons;
                    buttons.buttons_exchanged = true;
                    const std::string once = in_layout(text, buttons, kind, language);
                    EXPECT_EQ(in_layout(once, buttons, kind, language), text);
                }
            }
        }
        for (const ControlHelp& help : controls(device))
            EXPECT_EQ(in_layout(help.input, none, kind, "en"), help.input);
    }
    EXPECT_EQ(in_layout("W A S D, F and R bring the point over the mark; Q and E turn it in.", left,
                        HintDevice::kKeyboard, "en"),
              "I J K L, H and Y bring the point over the mark; U and O turn it in.");
    EXPECT_EQ(in_layout("hold the left button, or X", left, HintDevice::kMouse, "en"),
              "hold the right button, or N");
    EXPECT_EQ(in_layout("Hold A to grasp, Tab on the keyboard keeps it held", left,
                        HintDevice::kGamepad, "en"),
              "Hold A to grasp, Backspace on the keyboard keeps it held");
    EXPECT_EQ(in_layout("Go above the ring, then F with Ctrl. F1 helps.", left,
                        HintDevice::kKeyboard, "en"),
              "Go above the ring, then H with Ctrl. F1 helps.");
    ControlLayout own;
    own.put(Key::kSpace, Key::kB);
    own.put(Key::kUp, Key::kW);
    own.sticks_exchanged = true;
    EXPECT_EQ(
        in_layout("Ctrl: precyzyjnie, Spacja: narzędzie stoi.", own, HintDevice::kMouse, "pl"),
        "Ctrl: precyzyjnie, B: narzędzie stoi.");
    EXPECT_EQ(in_layout("Arrow keys.", own, HintDevice::kKeyboard, "en"),
              "W \xE2\x86\x90 \xE2\x86\x93 \xE2\x86\x92.");
    EXPECT_EQ(in_layout("Left stick and triggers; the right stick turns it in.", own,
                        HintDevice::kGamepad, "en"),
              "Right stick and triggers; the left stick turns it in.");
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
