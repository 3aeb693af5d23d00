// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/course.h"

#include <gtest/gtest.h>

#include <fstream>

namespace placode::curriculum {
namespace {

Course two_stages() {
    Course course;
    course.stages.resize(2);
    course.stages[0].task_id = "warm_up";
    course.stages[1].task_id = "real";
    course.stages[1].requires_tasks = {"warm_up"};
    return course;
}

TEST(Course, OpensTheFirstStageAndLocksTheSecond) {
    const CourseProgress p = course_progress(two_stages(), {});
    ASSERT_EQ(p.stages.size(), 2u);
    EXPECT_EQ(p.stages[0].status, StageStatus::kOpen);
    EXPECT_EQ(p.stages[1].status, StageStatus::kLocked);
    EXPECT_EQ(p.stages[1].missing, std::vector<std::string>{"warm_up"});
    EXPECT_EQ(p.next_stage, 0);
}

TEST(Course, TwoBenchmarksInARowMasterAStageAndOpenTheNext) {
    const CourseProgress p = course_progress(two_stages(), {{"warm_up", 70}, {"warm_up", 85}});
    EXPECT_EQ(p.stages[0].status, StageStatus::kMastered);
    EXPECT_EQ(p.stages[0].streak, 2);
    EXPECT_DOUBLE_EQ(p.stages[0].best_points, 85);
    EXPECT_EQ(p.stages[1].status, StageStatus::kOpen);
    EXPECT_TRUE(p.stages[1].missing.empty());
    EXPECT_EQ(p.next_stage, 1);
}

TEST(Course, AMissACriticalErrorOrAnInterruptionDoesNotCountAsInARow) {
    EXPECT_EQ(course_progress(two_stages(), {{"warm_up", 80}, {"warm_up", 69.9}, {"warm_up", 80}})
                  .stages[0]
                  .streak,
              1);
    const CourseProgress critical =
        course_progress(two_stages(), {{"warm_up", 80}, {"warm_up", 95, true}});
    EXPECT_EQ(critical.stages[0].status, StageStatus::kOpen);
    EXPECT_EQ(critical.stages[0].streak, 0);
    // An interrupted attempt neither helps nor harms.
    const CourseProgress interrupted = course_progress(
        two_stages(), {{"warm_up", 80}, {"warm_up", 0, false, true}, {"warm_up", 80}});
    EXPECT_EQ(interrupted.stages[0].status, StageStatus::kMastered);
    EXPECT_EQ(interrupted.stages[0].attempts, 2);
}

TEST(Course, WhatWasMasteredStaysMastered) {
    const CourseProgress p = course_progress(
        two_stages(), {{"warm_up", 80}, {"warm_up", 80}, {"warm_up", 20}, {"real", 90}});
    EXPECT_EQ(p.stages[0].status, StageStatus::kMastered);
    EXPECT_EQ(p.stages[0].streak, 0);
    EXPECT_EQ(p.stages[1].status, StageStatus::kOpen);
    EXPECT_EQ(p.stages[1].streak, 1);
}

TEST(Course, AllMasteredLeavesNothingNext) {
    const CourseProgress p = course_progress(
        two_stages(), {{"warm_up", 80}, {"warm_up", 80}, {"real", 90}, {"real", 90}});
    EXPECT_EQ(p.next_stage, -1);
}

TEST(Course, TheShippedCourseNamesShippedTasks) {
    const std::vector<std::string> tasks = list_definitions("tasks");
    for (const std::string& id : list_definitions("courses")) {
        const Course course = load_course(id);
        EXPECT_EQ(course.id, id);
        EXPECT_FALSE(course.title.pl.empty());
        for (const CourseStage& stage : course.stages)
            EXPECT_NE(std::find(tasks.begin(), tasks.end(), stage.task_id), tasks.end())
                << stage.task_id;
    }
    EXPECT_EQ(load_course("first_steps").stages.size(), 5u);
}

TEST(Course, AStageThatWaitsForALaterOneIsRefused) {
    const std::string file = testing::TempDir() + "broken_course.json";
    std::ofstream(file) << R"({"id":"c","version":1,"title":{"en":"t"},"stages":[
        {"task_id":"a","requires_tasks":["b"]},{"task_id":"b"}]})";
    try {
        (void)load_course(file);
        FAIL() << "was accepted";
    } catch (const DefinitionError& error) {
        EXPECT_EQ(error.pointer(), "/stages/0/requires_tasks");
    }
}

}  // namespace
}  // namespace placode::curriculum
