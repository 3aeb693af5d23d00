// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/view/step_watch.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

PracticeGoal goal(PracticeKind kind, double progress, int index = 0) {
    PracticeGoal g;
    g.count = 5;
    g.index = index;
    g.step.kind = kind;
    g.progress = progress;
    return g;
}

/// Pictures at 30 Hz.
void look(StepWatch& watch, const PracticeGoal& g, double& clock_s, double seconds,
          bool waits = false) {
    for (int i = 0; i < static_cast<int>(30 * seconds + 0.5); ++i)
        watch.look(g, clock_s += 1.0 / 30, waits);
}

TEST(ContactLost, IsSaidWhileEnergyFlowsBesideTheTissueAndOnlyThen) {
    PracticeStep step;
    step.kind = PracticeKind::kCut;
    EXPECT_TRUE(contact_lost(step, kPedalCut, false, 0.3));
    EXPECT_FALSE(contact_lost(step, kPedalCut, true, 0)) << "it touches";
    EXPECT_FALSE(contact_lost(step, 0, false, 0.3)) << "no pedal: the step's own words help";
    EXPECT_FALSE(contact_lost(step, kPedalCoag, false, 0.3)) << "the wrong pedal comes first";
    EXPECT_FALSE(contact_lost(step, kPedalCut, false, 9)) << "far away";
    step.kind = PracticeKind::kCoag;
    EXPECT_TRUE(contact_lost(step, kPedalCoag, false, 0.3));
    step.kind = PracticeKind::kTouch;
    EXPECT_FALSE(contact_lost(step, kPedalCut, false, 0.3));
}

TEST(StepWatch, SomebodyIsStuckAfterEightSecondsWithoutProgress) {
    StepWatch watch;
    double clock_s = 1000;
    look(watch, goal(PracticeKind::kMove, 0), clock_s, 7.9);
    EXPECT_FALSE(watch.stuck());
    look(watch, goal(PracticeKind::kMove, 0), clock_s, 0.3);
    EXPECT_TRUE(watch.stuck());
    watch.look(goal(PracticeKind::kMove, 0.1), clock_s += 0.03, false);
    EXPECT_FALSE(watch.stuck());
}

TEST(StepWatch, ATremorIsNoProgressAndANewStepBeginsAfresh) {
    StepWatch watch;
    double clock_s = 0;
    for (int i = 0; i < 9; ++i) look(watch, goal(PracticeKind::kMove, 0.002 * i), clock_s, 1);
    EXPECT_TRUE(watch.stuck());
    watch.look(goal(PracticeKind::kDepth, 0, 1), clock_s += 0.03, false);
    EXPECT_FALSE(watch.stuck());
    EXPECT_TRUE(watch.fresh());
    watch.look(goal(PracticeKind::kDepth, 0, 1), clock_s += 0.03, false);
    EXPECT_FALSE(watch.fresh());
}

TEST(StepWatch, AnAnchorWaitsForTheInstrument) {
    StepWatch watch;
    watch.look(goal(PracticeKind::kMove, 0), 1.0, false, false);
    watch.look(goal(PracticeKind::kMove, 0), 1.1, false, false);
    EXPECT_TRUE(watch.fresh()) << "before the first motion it is nowhere";
    watch.look(goal(PracticeKind::kMove, 0), 1.2, false, true);
    EXPECT_TRUE(watch.fresh());
    watch.look(goal(PracticeKind::kMove, 0), 1.3, false, true);
    EXPECT_FALSE(watch.fresh());
    watch.look(goal(PracticeKind::kMove, 0), 1.4, false, false);
    EXPECT_FALSE(watch.fresh()) << "a hand that was away goes on";
}

TEST(StepWatch, TimeInMenuAndHelpDoesNotCount) {
    StepWatch watch;
    double clock_s = 0;
    look(watch, goal(PracticeKind::kTouch, 0), clock_s, 5);
    look(watch, goal(PracticeKind::kTouch, 0), clock_s, 60, true);
    EXPECT_FALSE(watch.stuck());
    look(watch, goal(PracticeKind::kTouch, 0), clock_s, 3.2);
    EXPECT_TRUE(watch.stuck());
}

TEST(StepWatch, AmountsStandInTheUnitOfTheStep) {
    PracticeGoal g = goal(PracticeKind::kMove, 0.4);
    g.step.distance_m = 0.03;
    EXPECT_NEAR(step_amount(g).done, 12, 1e-9);
    EXPECT_NEAR(step_amount(g).whole, 30, 1e-9);
    EXPECT_STREQ(step_amount(g).unit, " mm");
    g = goal(PracticeKind::kTurn, 0.5);
    g.step.turn_rad = std::numbers::pi / 2;
    EXPECT_NEAR(step_amount(g).done, 45, 1e-9);
    g = goal(PracticeKind::kCut, 0.25);
    g.step.hold_s = 0.4;
    EXPECT_NEAR(step_amount(g).done, 0.1, 1e-9);
    EXPECT_EQ(step_amount(goal(PracticeKind::kRelease, 0)).whole, 0);
}

}  // namespace THIS_TEST
