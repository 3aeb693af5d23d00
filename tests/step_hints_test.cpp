// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Nobody is left without a hint: every step of every practice task says and shows how it is done
// with every device that can do it, in both languages.

#include "curriculum/step_hints.h"

#include <gtest/gtest.h>

#include "curriculum/definitions.h"
#include "ui/view/practice_hint.h"

namespace placode::curriculum {
namespace THIS_TEST {

constexpr const char* kHands[] = {"mouse",       "keyboard", "gamepad", "spacemouse",
                                  "openhaptics", "haply",    "avatar",  "forcedimension"};

TEST(StepHints, EveryStepHasWordsAndSymbolsForEveryDeviceThatCanDoIt) {
    int steps = 0;
    for (const std::string& id : list_definitions("tasks")) {
        const Task task = load_task(id);
        for (const char* device : kHands) {
            for (const TaskStep& step : steps_for(task, device)) {
                for (const bool changes : {false, true}) {
                    const LocalText hint = step_hint(step, device, changes);
                    EXPECT_FALSE(hint.en.empty()) << id << " " << device << " " << step.text.en;
                    EXPECT_FALSE(hint.pl.empty()) << id << " " << device << " " << step.text.en;
                    EXPECT_FALSE(
                        view::hint_symbols(step.goal, haptics::hint_device(device), changes)
                            .empty())
                        << id << " " << device << " " << step.text.en;
                }
                ++steps;
            }
        }
    }
    EXPECT_GT(steps, 8 * 20);
}

TEST(StepHints, EveryKindOfStepHasThemWhateverTasksThereWillBe) {
    for (const char* device : kHands) {
        for (int kind = 0; kind < sim::kPracticeKinds; ++kind) {
            TaskStep step;
            step.goal.kind = static_cast<sim::PracticeKind>(kind);
            const LocalText hint = step_hint(step, device, false);
            EXPECT_FALSE(hint.en.empty()) << device << " " << kind;
            EXPECT_NE(hint.pl, hint.en) << device << " " << kind;
            EXPECT_FALSE(view::hint_symbols(step.goal, haptics::hint_device(device), false).empty())
                << device << " " << kind;
        }
    }
}

TEST(StepHints, SpeakOfTheInstrumentAndNotOfAFrozenHand) {
    TaskStep step;
    step.goal.kind = sim::PracticeKind::kMove;
    const LocalText hint = step_hint(step, "mouse", false);
    EXPECT_NE(hint.en.find("Space holds the instrument still"), std::string::npos) << hint.en;
    EXPECT_EQ(hint.en.find("freez"), std::string::npos);
    for (const std::string& id : list_definitions("tasks"))
        EXPECT_EQ(load_task(id).json.find("freez"), std::string::npos) << id;
}

TEST(StepHints, AStepForTheOtherHandBeginsWithChangingHands) {
    TaskStep step;
    step.goal.kind = sim::PracticeKind::kTurn;
    step.goal.hand = sim::Hand::kLeft;
    EXPECT_EQ(step_hint(step, "mouse", true).en.rfind("Tab changes hands. ", 0), 0U);
    const auto symbols = view::hint_symbols(step.goal, haptics::HintDevice::kMouse, true);
    ASSERT_EQ(symbols.size(), 3U);
    EXPECT_STREQ(symbols[0].name, "Tab");
    EXPECT_STREQ(symbols[1].name, "Shift");
    EXPECT_TRUE(symbols[1].together);
}

TEST(StepHints, ANeedleForTheNextBiteIsTakenAtTheRing) {
    TaskStep step;
    step.goal.kind = sim::PracticeKind::kNeedleTake;
    for (const char* device : kHands) {
        EXPECT_NE(step_hint(step, device, false).en.find("behind its point"), std::string::npos);
        TaskStep placed = step;
        placed.goal.take_share = 0.7;
        const std::string hint = step_hint(placed, device, false).en;
        EXPECT_NE(hint.find("to the ring"), std::string::npos) << device << ": " << hint;
        EXPECT_EQ(hint.find("behind its point"), std::string::npos) << device << ": " << hint;
    }
}

TEST(StepHints, JawsThatWereLeftShutOpenWithAPress) {
    TaskStep step;
    step.goal.kind = sim::PracticeKind::kRelease;
    EXPECT_EQ(step_hint(step, "mouse", false).en, "Let go of the left button.");
    EXPECT_EQ(step_hint(step, "mouse", true).en,
              "Tab changes hands. Press and let go of the left button: the jaws open.");
    EXPECT_EQ(step_hint(step, "keyboard", true).en,
              "Tab changes hands. Press and let go of X: the jaws open.");
}

TEST(StepHints, TheEdgeIsLiftedBeforeTheHandsChange) {
    TaskStep step;
    step.goal.kind = sim::PracticeKind::kUndermine;
    for (const char* device : kHands)
        EXPECT_EQ(step_hint(step, device, true).en.rfind("Lift the edge by 2 mm", 0), 0U) << device;
    EXPECT_EQ(step_hint(step, "mouse", false).en.find("Lift the edge"), std::string::npos);
}

/// Of a step: the hand, or the one instrument that there is of its kind.
bool names_its_hand(const std::string& text, sim::Hand hand) {
    const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
    return has("driver") || (hand == sim::Hand::kLeft ? has("left hand") : has("right hand"));
}

TEST(StepHints, EveryStepForTwoHandsNamesTheOneThatDoesIt) {
    for (const char* id : {"undermine", "wound_closure"})
        for (const TaskStep& step : load_task(id).steps)
            EXPECT_TRUE(names_its_hand(step.text.en, step.goal.hand)) << id << ": " << step.text.en;
    for (const TaskStep& step : load_task("needle_handover").steps) {
        const bool left = step.goal.hand == sim::Hand::kLeft;
        EXPECT_NE(step.text.en.find(left ? "left driver" : "right driver"), std::string::npos)
            << step.text.en;
        EXPECT_NE(step.text.pl.find(left ? "ewym imad" : "rawym imad"), std::string::npos)
            << step.text.pl;
    }
}

// A left-handed layout exchanges the sticks by their words: a third word would stay.
TEST(StepHints, AStickHasOneNameInPolish) {
    for (const std::string& id : list_definitions("tasks"))
        for (const TaskStep& step : load_task(id).steps)
            EXPECT_EQ(step_hint(step, "gamepad", false).pl.find("dr\xc4\x85\xc5\xbc"),
                      std::string::npos)
                << id << ": " << step.text.en;
}

TEST(StepHints, ATasksOwnWordsComeFirstAndScriptsNeedNone) {
    TaskStep step;
    step.hints["mouse"] = {"Own words.", "Własne słowa."};
    EXPECT_EQ(step_hint(step, "mouse", true).en, "Own words.");
    EXPECT_NE(step_hint(step, "keyboard", false).en, "Own words.");
    EXPECT_TRUE(step_hint(step, "script:expert", false).en.empty());
    EXPECT_TRUE(view::hint_symbols(step.goal, haptics::hint_device("script:mouse"), false).empty());
    // Only a mouse and a keyboard steer the scope.
    step.goal.hand = sim::Hand::kCamera;
    EXPECT_TRUE(step_hint(step, "gamepad", false).en.empty());
    EXPECT_FALSE(step_hint(step, "keyboard", false).en.empty());
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
