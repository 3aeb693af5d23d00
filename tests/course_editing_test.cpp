// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/course_editing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "curriculum/definitions.h"

namespace placode::curriculum {
namespace THIS_TEST {

const std::vector<std::string> kTasks{"ring", "lift", "cut"};

Course three_stages() {
    Course course;
    course.id = "course";
    course.title.en = "A course";
    for (const std::string& task : kTasks) add_stage(course, task);
    return course;
}

std::vector<CourseFault> faults(const Course& course) {
    std::vector<CourseFault> found;
    for (const CourseProblem& each : check_course(course, kTasks)) found.push_back(each.fault);
    return found;
}

bool loads(const Course& course) {
    try {
        (void)load_course_text(course_json(course), "draft");
        return true;
    } catch (const DefinitionError&) {
        return false;
    }
}

TEST(CourseEditing, NewStagesWaitForTheOneBeforeAndHaveTheirOwnId) {
    Course course = three_stages();
    add_stage(course, "ring");
    EXPECT_EQ(course.stages[3].id, "ring_2");
    EXPECT_THAT(course.stages[1].requires_stages, testing::ElementsAre("ring"));
    EXPECT_TRUE(check_course(course, kTasks).empty());
    EXPECT_TRUE(loads(course));
}

TEST(CourseEditing, TellsEveryProblemAtOnceAndWhere) {
    Course course = three_stages();
    course.id = "a b";
    course.title.en.clear();
    course.stages[1].task_id = "sew";
    course.stages[1].requires_stages = {"cut"};
    course.stages[2].consecutive = 3;
    course.stages[2].max_attempts = 2;
    course.stages[2].mode = StageMode::kExam;
    const auto found = check_course(course, kTasks);
    EXPECT_THAT(faults(course),
                testing::ElementsAre(CourseFault::kId, CourseFault::kTitle, CourseFault::kTask,
                                     CourseFault::kRequires, CourseFault::kTooFewAttempts,
                                     CourseFault::kNoSeeds));
    EXPECT_EQ(found[2].pointer, "/stages/1/task_id");
    EXPECT_EQ(found[2].value, "sew");
    EXPECT_EQ(found[4].stage, 2);
}

// What the checker lets pass, the loader must take, and the other way round.
TEST(CourseEditing, AgreesWithTheLoader) {
    const std::vector<std::function<void(Course&)>> changes{
        [](Course&) {},
        [](Course& c) { c.id.clear(); },
        [](Course& c) { c.id = "ü"; },
        [](Course& c) { c.title.en.clear(); },
        [](Course& c) { c.stages.clear(); },
        [](Course& c) { c.stages[1].id = "ring"; },
        [](Course& c) { c.stages[1].id = "no space"; },
        [](Course& c) { c.stages[0].requires_stages = {"lift"}; },
        [](Course& c) { c.stages[0].requires_stages = {"ring"}; },
        [](Course& c) { c.stages[0].benchmark_points = 101; },
        [](Course& c) { c.stages[0].consecutive = 0; },
        [](Course& c) { c.stages[0].consecutive = 20; },
        [](Course& c) { c.stages[0].max_attempts = 1; },
        [](Course& c) { c.stages[0].max_attempts = 2; },
        [](Course& c) { c.stages[0].max_attempts = 1001; },
        [](Course& c) {
            c.stages[0].mode = StageMode::kExam, c.stages[0].exam.seeds = {7};
            c.stages[0].max_attempts = 2;
        },
        [](Course& c) {
            c.stages[0].mode = StageMode::kExam, c.stages[0].exam.seeds = {7};
            c.stages[0].max_attempts = 1;
        },
        [](Course& c) {
            c.stages[0].mode = StageMode::kExam, c.stages[0].exam.seeds = {7};
            c.stages[0].max_attempts = 1001;
        },
        [](Course& c) { c.stages[0].remind_after_days = 3651; },
        [](Course& c) { c.stages[0].mode = StageMode::kExam; },
        [](Course& c) {
            c.stages[0].mode = StageMode::kExam, c.stages[0].exam.seeds = {7, 8};
        },
        [](Course& c) {
            c.stages[0].mode = StageMode::kExam, c.stages[0].exam.seeds = {7, 7};
        },
    };
    int sound = 0;
    for (size_t i = 0; i < changes.size(); ++i) {
        Course course = three_stages();
        changes[i](course);
        EXPECT_EQ(check_course(course, kTasks).empty(), loads(course)) << "change " << i;
        sound += loads(course) ? 1 : 0;
    }
    EXPECT_EQ(sound, 4);
}

TEST(CourseEditing, KeepsOthersConsistentWhenAStageMovesGoesOrIsRenamed) {
    Course course = three_stages();
    rename_stage(course, 0, "first");
    EXPECT_THAT(course.stages[1].requires_stages, testing::ElementsAre("first"));
    move_stage(course, 2, 0);
    EXPECT_EQ(course.stages[0].id, "cut");
    EXPECT_TRUE(course.stages[0].requires_stages.empty());
    EXPECT_THAT(course.stages[2].requires_stages, testing::ElementsAre("first"));
    remove_stage(course, 1);
    EXPECT_TRUE(course.stages[1].requires_stages.empty());
    EXPECT_TRUE(check_course(course, kTasks).empty());
}

TEST(CourseEditing, AnotherTaskTakesItsIdAlongUnlessItWasChosen) {
    Course course = three_stages();
    set_task(course, 0, "lift");
    EXPECT_EQ(course.stages[0].id, "lift_2") << "lift is taken";
    EXPECT_THAT(course.stages[1].requires_stages, testing::ElementsAre("lift_2"));
    rename_stage(course, 0, "warm_up");
    set_task(course, 0, "cut");
    EXPECT_EQ(course.stages[0].id, "warm_up");
    EXPECT_EQ(course.stages[0].task_id, "cut");
}

TEST(CourseEditing, ReadsSeedsAndNamesWhatIsNone) {
    EXPECT_THAT(seeds_of_text(" 1, 22;3 "), testing::ElementsAre(1, 22, 3));
    EXPECT_EQ(seeds_text({1, 22, 3}), "1, 22, 3");
    EXPECT_TRUE(seeds_of_text("").empty());
    for (const char* wrong : {"1, x2", "-1", "1.5", "9007199254740992"})
        EXPECT_THROW((void)seeds_of_text(wrong), std::invalid_argument) << wrong;
}

TEST(CourseEditing, UndoesTypingAsOneStep) {
    CourseDraft draft(three_stages());
    for (const char* title : {"A", "Ab", "Abc"}) {
        Course course = draft.course();
        course.title.en = title;
        draft.change(course, "title");
    }
    Course course = draft.course();
    remove_stage(course, 0);
    draft.change(course);
    draft.change(course);  // Nothing new.
    draft.undo();
    EXPECT_EQ(draft.course().stages.size(), 3u);
    EXPECT_EQ(draft.course().title.en, "Abc");
    draft.undo();
    EXPECT_EQ(draft.course().title.en, "A course");
    EXPECT_FALSE(draft.can_undo());
    draft.redo();
    draft.redo();
    EXPECT_EQ(draft.course().stages.size(), 2u);
    EXPECT_FALSE(draft.can_redo());
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
