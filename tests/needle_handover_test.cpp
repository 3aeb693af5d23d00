// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A needle that goes from hand to hand: both hands feel it, the jaws that open give way, and the
// task of it, whole attempts at three levels.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "assessment/scoring.h"
#include "sim/core/turn.h"
#include "sim/cutting/grasp.h"
#include "sim/ledger/ledger.h"
#include "sim/step/begin_here.h"
#include "sim/world/saved_state.h"
#include "tests/judged_attempt.h"
#include "tests/stitch_scene.h"

namespace placode::curriculum {
namespace THIS_TEST {

using sim::EventKind;
using sim::Vec3;
using test::Outcome;

// -- Two drivers over a block --------------------------------------------------------------------

/// The first driver has the needle of 13 mm; the second, from the other side, may take it at a
/// third of its arc.
class TwoDrivers : public sim::test::Stitch {
 public:
    TwoDrivers() : Stitch(options()) {
        const double arc = kShare * scene.suture->needle().arc_m();
        const sim::Pose X_WN = lifted();
        const sim::ArcPoint at = scene.suture->needle().at(arc);
        sim::Mat3 r;
        r.col(0) = X_WN.q * at.back;
        r.col(2) = -Vec3::UnitY();
        r.col(1) = r.col(2).cross(r.col(0));
        const sim::Quat q(r);
        second = {X_WN * at.place_m + q * Vec3(0, 0, sim::test::driver_spec().tip_length_m / 3), q};
        driver(lifted() * scene.needle_start.X_TN.inverse());
        other(second, 0.6);
        rest(200);
    }
    void other(const sim::Pose& X_WT, double jaw) {
        inputs[1].set_pose(X_WT);
        inputs[1].jaw_rad = static_cast<float>(jaw);
        inputs[1].engaged = 1;
    }
    /// Jaws of the second driver; opening or closing takes 50 frames.
    void other_jaws(double from, double to) {
        for (int i = 1; i <= 50; ++i) {
            other(second, from + (to - from) * i / 50);
            frame();
        }
    }
    [[nodiscard]] sim::Pose lifted() const {
        sim::Pose up = start;
        up.p.z() += 10e-3;
        return up;
    }
    [[nodiscard]] int count(EventKind kind) const {
        return static_cast<int>(std::count_if(events.begin(), events.end(),
                                              [&](const auto& e) { return e.kind == kind; }));
    }

    static constexpr double kShare = 0.33;
    sim::Pose second;

 private:
    static sim::test::StitchOptions options() {
        sim::test::StitchOptions options;
        sim::ToolSpec driver = sim::test::driver_spec();
        driver.hand = sim::Hand::kLeft;
        driver.pivot_m = Vec3(0, 0.08, 0.02);
        options.other = driver;
        return options;
    }
};

TEST(NeedleHandover, BothHandsFeelWhatOneOfThemPulls) {
    TwoDrivers hands;
    ASSERT_EQ(hands.state.suturing.driver, 0);
    hands.other_jaws(0.6, 0);
    ASSERT_EQ(hands.state.suturing.handover.second, 1);
    EXPECT_EQ(hands.state.suturing.driver, 0) << "nobody has let go";
    hands.second.p += Vec3(0.4e-3, 0.3e-3, 0.5e-3);
    hands.other(hands.second, 0);
    hands.rest(600);
    const Vec3 one = hands.state.tools[0].force_n, two = hands.state.tools[1].force_n;
    EXPECT_GT(one.norm(), 0.05);
    EXPECT_LT((one + two).norm(), 0.01 * one.norm()) << "the needle weighs nothing here";
    // The hands' own springs carry it: 600 N/m each.
    const Vec3 hand = 600 * (hands.inputs[1].pose().p - hands.state.tools[1].proxy.p);
    EXPECT_LT((hand + two).norm(), 0.02 * two.norm());
}

TEST(NeedleHandover, TheNeedleStaysWhereItIsWhenHandsChange) {
    TwoDrivers hands;
    const sim::Pose before = hands.needle().needle;
    hands.other_jaws(0.6, 0);
    hands.jaws(0.6);
    EXPECT_EQ(hands.state.suturing.driver, 1);
    EXPECT_EQ(hands.state.suturing.handover.second, -1);
    hands.rest(100);
    EXPECT_LT((hands.needle().needle.p - before.p).norm(), 0.3e-3) << "no leap";
    const sim::Event* told = hands.find(EventKind::kNeedleHandedOver);
    ASSERT_NE(told, nullptr);
    EXPECT_EQ(told->tool, 1);
    EXPECT_GT(told->element, 20) << "both held it [ms]";
    EXPECT_EQ(hands.count(EventKind::kNeedleTaken), 2);
    EXPECT_EQ(hands.count(EventKind::kNeedleGrip), 2);
    EXPECT_EQ(hands.count(EventKind::kNeedleReleased), 1);
    // The wire lies across the jaws of the second driver.
    for (const sim::Event& e : hands.events)
        if (e.kind == EventKind::kNeedleGrip && e.tool == 1) {
            EXPECT_GT(e.value2, 0.98F);
        }
}

TEST(NeedleHandover, WhoTookItAndLetsGoHandsNothingOver) {
    TwoDrivers hands;
    hands.other_jaws(0.6, 0);
    hands.other_jaws(0, 0.6);
    EXPECT_EQ(hands.state.suturing.driver, 0);
    EXPECT_EQ(hands.state.suturing.handover.second, -1);
    ASSERT_EQ(hands.count(EventKind::kNeedleHandedOver), 1);
    EXPECT_EQ(hands.find(EventKind::kNeedleHandedOver)->element, -1) << "the first one kept it";
}

// Else hands could pull at it as they like, and the one that came last would let go again; or the
// attempt would end before anybody does.
TEST(NeedleHandover, WhatBothHandsDidIsToldWhoeverKeepsIt) {
    TwoDrivers hands;
    hands.other_jaws(0.6, 0);
    hands.second.p += Vec3(0.4e-3, 0.3e-3, 0.5e-3);
    hands.other(hands.second, 0);
    hands.rest(600);
    const float apart_n = hands.state.suturing.handover.apart_n;
    EXPECT_GT(apart_n, 0.05F);
    const auto told = [](const std::vector<sim::Event>& events) {
        const auto found = std::find_if(events.begin(), events.end(), [](const sim::Event& e) {
            return e.kind == EventKind::kNeedleHandedOver && e.element == -1;
        });
        return found == events.end() ? -1 : found->value2;
    };
    EXPECT_EQ(told(hands.events), -1);
    EXPECT_EQ(told(sim::open_spells(hands.scene, hands.state)), apart_n) << "where it ends now";
    hands.other_jaws(0, 0.6);
    ASSERT_EQ(hands.state.suturing.driver, 0);
    EXPECT_GE(told(hands.events), apart_n);
}

// A needle that is never let go has been turned all the same.
TEST(NeedleHandover, HowFarItTurnedIsToldAtTheEnd) {
    TwoDrivers hands;
    const sim::Quat before = hands.needle().needle.q;
    for (int i = 1; i <= 400; ++i) {
        sim::Pose turned = hands.lifted() * hands.scene.needle_start.X_TN.inverse();
        turned.q = turned.q * sim::test::turned(i * 1e-3, Vec3::UnitZ());
        hands.driver(turned);
        hands.frame();
    }
    const double turn = sim::turn_between(before, hands.needle().needle.q).norm();
    ASSERT_GT(turn, 0.2);
    EXPECT_EQ(hands.count(EventKind::kNeedleSwung), 0);
    double told = 0;
    for (const sim::Event& e : sim::open_spells(hands.scene, hands.state))
        if (e.kind == EventKind::kNeedleSwung) told += static_cast<double>(e.value);
    EXPECT_NEAR(told, turn, 0.05) << "counted in steps of two degrees";
}

// Let go before the other one closes: it is told, with nobody who held it in between.
TEST(NeedleHandover, LetGoInBetweenIsNoHandOverFromJawsToJaws) {
    TwoDrivers hands;
    hands.jaws(0.6);
    EXPECT_EQ(hands.state.suturing.driver, -1);
    hands.other_jaws(0.6, 0);  // without gravity it waits there
    ASSERT_EQ(hands.state.suturing.driver, 1);
    const sim::Event* told = hands.find(EventKind::kNeedleHandedOver);
    ASSERT_NE(told, nullptr);
    EXPECT_EQ(told->element, 0);
}

// Jaws that open a little hold less: the needle slides in these, and not in the closed ones.
TEST(NeedleHandover, JawsThatOpenGiveWay) {
    TwoDrivers hands;
    hands.other_jaws(0.6, 0);
    const double meet = sim::grip_angle(hands.scene.tools[0]);
    hands.inputs[0].jaw_rad = static_cast<float>(1.24 * meet);
    const sim::Quat first = hands.needle().hold.X_HN.q, other = hands.needle().second.hold.X_HN.q;
    for (int i = 1; i <= 400; ++i) {
        sim::Pose away = hands.second;
        away.p += Vec3(-2.5e-3, 0, 1.5e-3) * (i / 400.0);
        hands.other(away, 0);
        hands.frame();
    }
    hands.rest(200);
    EXPECT_EQ(hands.state.suturing.driver, 0) << "it still holds";
    EXPECT_EQ(hands.state.suturing.handover.second, 1);
    EXPECT_GT(sim::turn_between(first, hands.needle().hold.X_HN.q).norm(), 0.01);
    EXPECT_EQ(sim::turn_between(other, hands.needle().second.hold.X_HN.q).norm(), 0);
    EXPECT_GT(hands.needle().work.jaws, 0);
    for (const sim::Event& e : hands.events)
        EXPECT_NE(e.kind, EventKind::kNeedleTurned) << "to give way is no fault";
}

TEST(NeedleHandover, ASavedStateGoesOnWithBothHands) {
    TwoDrivers hands, same;
    for (TwoDrivers* each : {&hands, &same}) {
        each->other_jaws(0.6, 0);
        each->second.p.z() += 0.5e-3;
        each->other(each->second, 0);
        each->rest(20);
    }
    EXPECT_EQ(state_hash(hands.state), state_hash(same.state));
    sim::State loaded(hands.scene, 2);
    load_own_state(loaded, save_state(hands.scene, hands.state));
    EXPECT_EQ(state_hash(loaded), state_hash(hands.state));
    for (int i = 0; i < 50; ++i) {
        hands.frame();
        (void)step(hands.scene, loaded, hands.inputs, hands.feedback);
    }
    EXPECT_EQ(state_hash(loaded), state_hash(hands.state));
    EXPECT_EQ(loaded.suturing.handover.second, 1);
}

// What a stage gives is not counted as the trainee's (curriculum/stage_start.h).
TEST(NeedleHandover, AnAttemptThatBeginsHereCountsNoneOfItsHolding) {
    TwoDrivers run;
    sim::Handover& handover = run.state.suturing.handover;
    handover.swung_rad = handover.apart_n = handover.both_s = handover.peak_n = 1;
    handover.slide = handover.turn = {1, 1, 0};
    sim::begin_here(run.scene, run.state);
    EXPECT_EQ(handover.swung_rad + handover.apart_n + handover.both_s + handover.peak_n, 0);
    EXPECT_TRUE(sim::open_spells(run.scene, run.state).empty());
}

// -- The task ------------------------------------------------------------------------------------

Outcome perform(const std::string& level, uint64_t seed = 1) {
    return test::performed(load_task("needle_handover"), level, seed, {"needle_", "steps_"});
}

const Outcome& expert() {
    static const Outcome outcome = perform("expert");
    return outcome;
}

TEST(NeedleHandover, AnExpertHandsItOverTwiceAndDropsNothing) {
    const Outcome& run = expert();
    EXPECT_EQ(run.recording.end.reason, sim::EndReason::kFinished);
    EXPECT_EQ(run.value("steps_done_percent"), 100);
    EXPECT_EQ(run.value("needle_handovers"), 2);
    EXPECT_EQ(run.value("needle_let_between"), 0);
    EXPECT_EQ(run.value("needle_drops"), 0);
    EXPECT_LT(run.value("needle_askew_deg"), 15);
    EXPECT_EQ(run.score.verdict, assessment::Verdict::kPassed) << run.score.points;
    EXPECT_GE(run.score.points, 90);
}

TEST(NeedleHandover, LevelsOrderByHowTheNeedleIsHandled) {
    const Outcome middle = perform("intermediate"), bad = perform("novice");
    EXPECT_GT(expert().score.points, middle.score.points);
    EXPECT_GT(middle.score.points, bad.score.points + 5);
    EXPECT_NE(bad.score.verdict, assessment::Verdict::kPassed) << bad.score.points;
    EXPECT_GT(bad.score.points, 0) << "who does something earns something";
    EXPECT_GT(bad.value("needle_drops"), 0);
}

TEST(NeedleHandover, WhoDoesNothingHasNotAttemptedIt) {
    Task task = load_task("needle_handover");
    task.time_limit_s = 0.5;
    const Outcome nothing = test::performed(task, "expert", 1, {"needle_"});
    EXPECT_EQ(nothing.score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_EQ(nothing.score.points, 0);
}

TEST(NeedleHandover, IsReplayedBitForBitOnOtherNumbersOfThreads) {
    test::expect_replays_alike(expert().recording, {2, 3, 1});
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
