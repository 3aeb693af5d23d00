// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/first_view.h"

#include <gtest/gtest.h>

namespace placode::curriculum {
namespace THIS_TEST {

const sim::ToolSpec& scope_of(const Task& task) {
    for (const sim::ToolSpec& tool : task.scene.tools)
        if (tool.kind == sim::ToolKind::kScope) return tool;
    ADD_FAILURE() << task.id << " has no scope";
    return task.scene.tools.front();
}

void expect_look(const char* id, double x_m, double y_m) {
    const Task task = load_task(id);
    EXPECT_LT((scope_of(task).look_at_m - sim::Vec3(x_m, y_m, 0)).norm(), 1e-9) << id;
}

TEST(FirstView, LooksAtTheMiddleOfTheWound) {
    expect_look("undermine", 0.011, 0);
    expect_look("wound_closure", 0.011, 0);
    expect_look("suture_slit", 0.009, 0);
}

TEST(FirstView, LooksAtTheMiddleOfTheMarksWhereThereIsNoWound) {
    expect_look("suture_run", 0.009, 0);
    expect_look("needle_handover", 0.0015, 0);
}

TEST(FirstView, LooksAtTheLesionWhereTheWorkIs) {
    for (const char* id : {"sb_dissection", "touch_targets", "patch_place", "irrigate"}) {
        expect_look(id, 0, 0);
        EXPECT_EQ(scope_of(load_task(id)).look_from_m, 0.030);
    }
}

TEST(FirstView, StaysThatOfATaskThatIsReadFromARecording) {
    const Task task = load_task("needle_handover");
    EXPECT_EQ(scope_of(task).look_from_m, 0.038) << "two drivers in front of the lens";
    const Task again = load_task_text(task.json, "recording");
    EXPECT_EQ(scope_of(again).look_from_m, scope_of(task).look_from_m);
    EXPECT_EQ(scope_of(again).look_at_m, scope_of(task).look_at_m);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
