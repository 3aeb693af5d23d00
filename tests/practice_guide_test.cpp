// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/practice_guide.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "curriculum/attempt_sample.h"
#include "tests/box_scene.h"

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

}  // namespace THIS_TEST
}  // namespace placode::curriculum
