// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The scripted grasp and lift on a coarse field, as a whole attempt without a window.

#include "haptics/operators/lift_operator.h"

#include <gtest/gtest.h>

#include <memory>

#include "assessment/metrics.h"
#include "curriculum/attempt_runner.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

assessment::MetricSet perform(const std::string& level) {
    const Task task = test::changed_task("grasp_and_lift", {{"edge_ring_m", "0.0010"},
                                                            {"edge_placode_m", "0.0016"},
                                                            {"edge_outer_m", "0.003"},
                                                            {"settle_s", "0.05"}});
    const sim::Recording recording = test::scripted_attempt(task, level);
    EXPECT_EQ(recording.end.reason, sim::EndReason::kFinished);
    return assessment::compute_metrics(recording);
}

TEST(LiftOperator, TheExpertLiftsThreeTimesWithoutHarm) {
    const assessment::MetricSet m = perform("expert");
    EXPECT_EQ(*m.find("grasps"), 3);
    EXPECT_GT(*m.find("lift_hold_s"), 8);
    EXPECT_EQ(*m.find("crush_count"), 0);
    EXPECT_EQ(*m.find("slip_count"), 0);
    EXPECT_EQ(*m.find("placode_contacts"), 0);
    EXPECT_GT(*m.find("peak_traction_mn"), 1);
    EXPECT_LT(*m.find("peak_traction_mn"), 400);
}

TEST(LiftOperator, TheNoviceCrushesWhatItHolds) {
    EXPECT_GE(*perform("novice").find("crush_count"), 1);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
