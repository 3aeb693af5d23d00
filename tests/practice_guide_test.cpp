// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/practice_guide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "curriculum/attempt_sample.h"
#include "tests/box_scene.h"
#include "tests/stitch_scene.h"

namespace placode::curriculum {
namespace THIS_TEST {

TEST(PracticeGuide, AnInstrumentIsDrawnBackAsFarAsTheStepSays) {
    sim::test::BoxOptions options;
    options.heat = false;
    const sim::Scene scene = sim::test::box_scene(options);
    sim::State state(scene, 1);
    TaskStep step;
    step.goal.kind = sim::PracticeKind::kWithdraw;
    step.goal.distance_m = 0.008;
    PracticeGuide guide({step}, scene, state);
    const auto done_at = [&](double above_m) {
        const sim::ToolInput input = sim::test::upright(sim::Vec3(0, 0, above_m));
        sim::ToolFeedback feedback;
        for (int i = 0; i < 10; ++i) sim::test::frame(scene, state, input, feedback);
        const auto events = guide.see(state, {&input, 1}, sample_of(scene, state, {&input, 1}));
        return std::any_of(events.begin(), events.end(),
                           [](const sim::Event& e) { return e.kind == sim::EventKind::kStepDone; });
    };
    for (const double above_m : {0.002, 0.004, 0.0079}) EXPECT_FALSE(done_at(above_m)) << above_m;
    EXPECT_TRUE(done_at(0.0081));
}

// Else a driver with its needle near the mark has "grasped the edge", and an edge that was let go
// is held for as long as the needle is.
TEST(PracticeGuide, ANeedleInTheJawsIsNoTissueInThem) {
    sim::test::Stitch stitch;
    stitch.rest(10);
    ASSERT_NE(sim::hold_of(stitch.state, 0), nullptr);
    const auto told = [&](sim::PracticeKind kind) {
        TaskStep step;
        step.goal.kind = kind;
        step.goal.hand = stitch.scene.tools[0].hand;
        PracticeGuide guide({step}, stitch.scene, stitch.state);
        const auto events = guide.see(stitch.state, stitch.inputs,
                                      sample_of(stitch.scene, stitch.state, stitch.inputs));
        std::vector<sim::EventKind> kinds;
        for (const sim::Event& e : events) kinds.push_back(e.kind);
        return kinds;
    };
    using sim::EventKind;
    EXPECT_EQ(told(sim::PracticeKind::kGrasp), std::vector{EventKind::kPracticeSteps});
    EXPECT_EQ(told(sim::PracticeKind::kRelease),
              (std::vector{EventKind::kPracticeSteps, EventKind::kStepDone}));
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
