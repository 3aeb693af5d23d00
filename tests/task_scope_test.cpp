// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/task_scope.h"

#include <gtest/gtest.h>

#include "report_fixture.h"
#include "reports/attempt_figures.h"

using namespace placode;

namespace THIS_TEST {

using namespace placode::test;

TEST(TaskScope, EveryShippedTaskShowsWhatItIsAbout) {
    struct Expected {
        const char* task;
        bool ring, line, energy, resection, jaws, scissors;
    };
    for (const Expected& each : {Expected{"diathermy_ring", true, true, true, false, false, false},
                                 {"sb_dissection", true, true, true, true, true, true},
                                 {"touch_targets", false, false, false, false, false, false},
                                 {"trace_contour", false, true, false, false, false, false},
                                 {"grasp_and_lift", false, false, false, false, true, false},
                                 {"two_handed_traction", false, false, false, false, true, false},
                                 {"scissors_resection", false, true, false, true, true, true},
                                 {"familiarisation", false, false, true, false, true, false}}) {
        const curriculum::Task task = curriculum::load_task(each.task);
        const reports::TaskScope scope = reports::scope_of(task);
        EXPECT_EQ(scope.ring, each.ring) << each.task;
        EXPECT_EQ(scope.line, each.line) << each.task;
        EXPECT_EQ(scope.energy, each.energy) << each.task;
        EXPECT_EQ(scope.resection, each.resection) << each.task;
        EXPECT_EQ(scope.jaws, each.jaws) << each.task;
        EXPECT_EQ(scope.scissors, each.scissors) << each.task;
        for (const assessment::RubricItem& item : task.rubric.items)
            EXPECT_TRUE(reports::belongs(scope, item.metric)) << each.task << " " << item.metric;
        // A recording of it says the same.
        const reports::TaskScope kept = reports::scope_of(recording_of(each.task).header);
        EXPECT_EQ(kept.ring, each.ring) << each.task;
        EXPECT_EQ(kept.line, each.line) << each.task;
    }
    const reports::TaskScope touch = reports::scope_of(curriculum::load_task("touch_targets"));
    for (const char* cutting : {"ring_completeness_percent", "largest_gap_mm", "off_line_mm",
                                "energy_j", "placode_peak_c", "snips", "marked_gone_percent"})
        EXPECT_FALSE(reports::belongs(touch, cutting)) << cutting;
    for (const char* touching : {"target_error_mm", "path_length_mm", "placode_contacts"})
        EXPECT_TRUE(reports::belongs(touch, touching)) << touching;
}

TEST(TaskScope, ATouchingTaskHasNeitherPhasesNorALaneOfEnergy) {
    const auto picture = [](const char* task) {
        const sim::Recording made = recording_of(task);
        return reports::ledger_picture(made, reports::scope_of(made.header));
    };
    EXPECT_TRUE(picture("touch_targets").phases.empty());
    EXPECT_EQ(picture("touch_targets").lanes, assessment::kHarmLanes - 1);
    EXPECT_FALSE(picture("diathermy_ring").phases.empty());
    EXPECT_EQ(picture("diathermy_ring").lanes, assessment::kHarmLanes);
}

}  // namespace THIS_TEST
