// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace placode::curriculum {
namespace THIS_TEST {

Course two_stages() {
    Course course;
    course.stages.resize(2);
    course.id = "c";
    course.stages[0].id = course.stages[0].task_id = "warm_up";
    course.stages[1].id = course.stages[1].task_id = "real";
    course.stages[1].requires_stages = {"warm_up"};
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

TEST(Course, WhoGivesUpAnAttemptBeginsTheRowAnew) {
    AttemptOutcome left{"warm_up", 20, false, true};
    left.given_up = true;
    const auto own = [&](const std::vector<AttemptOutcome>& outcomes) {
        return course_progress(two_stages(), outcomes).stages[0];
    };
    const StageProgress between = own({{"warm_up", 80}, left, {"warm_up", 80}});
    EXPECT_EQ(between.status, StageStatus::kOpen) << "two good ones, but not in a row";
    EXPECT_EQ(between.streak, 1);
    EXPECT_EQ(between.attempts, 2) << "what was left is no attempt that counts";
    EXPECT_EQ(own({{"warm_up", 80}, left, {"warm_up", 80}, {"warm_up", 75}}).status,
              StageStatus::kMastered);
    EXPECT_EQ(own({{"warm_up", 80}, {"warm_up", 80}, left}).status, StageStatus::kMastered)
        << "mastered stays mastered";
    left.task_id = "real";
    EXPECT_EQ(own({{"warm_up", 80}, left, {"warm_up", 80}}).status, StageStatus::kMastered)
        << "another task's row";
    // Practice that was left says nothing of an exam of the same task.
    Course exam = two_stages();
    exam.stages[0].mode = StageMode::kExam;
    exam.stages[0].exam.seeds = {7};
    exam.stages[0].exam.proctor = false;
    AttemptOutcome sat{"warm_up", 90};
    sat.exam_course = "c";
    sat.exam_stage = "warm_up";
    sat.seed = 7;
    left.task_id = "warm_up";
    EXPECT_EQ(course_progress(exam, {sat, left}).stages[0].streak, 1);
    // Tuned: the same, though it came to its end.
    AttemptOutcome tuned{"warm_up", 90, true};
    tuned.given_up = tuned.voided = true;
    EXPECT_EQ(own({{"warm_up", 80}, tuned, {"warm_up", 80}}).streak, 1);
}

TEST(Course, WhereNothingWasDoneNothingIsMetOrMissed) {
    Course course = two_stages();
    AttemptOutcome idle{"warm_up", 0};
    idle.not_attempted = true;
    const CourseProgress p =
        course_progress(course, {{"warm_up", 80}, idle, {"warm_up", 75}, idle});
    EXPECT_EQ(p.stages[0].status, StageStatus::kMastered) << "the streak goes on";
    EXPECT_EQ(p.stages[0].attempts, 2);
    course.stages[0].mode = StageMode::kFamiliarisation;
    course.stages[0].consecutive = 1;
    EXPECT_EQ(course_progress(course, {idle}).stages[0].status, StageStatus::kOpen)
        << "to look on is not to get to know";
    // An exam has shown its lesion: the next one is another, and one attempt less is left.
    course = two_stages();
    CourseStage& exam = course.stages[0];
    exam.mode = StageMode::kExam;
    exam.exam.seeds = {7, 8};
    exam.exam.proctor = false;
    exam.max_attempts = 3;
    idle.exam_course = "c";
    idle.exam_stage = "warm_up";
    idle.seed = 7;
    const StageProgress own = course_progress(course, {idle}).stages[0];
    EXPECT_EQ(own.next_seed, 8u);
    EXPECT_EQ(own.attempts_left, 2);
    EXPECT_EQ(own.streak, 0);
    EXPECT_FALSE(own.last_critical);
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
    EXPECT_EQ(load_course("first_steps").stages.size(), 9u);
}

TEST(Course, WrongCoursesAreRefusedWithTheirPlace) {
    struct Case {
        const char *stages, *pointer, *says;
    };
    const Case cases[]{
        {R"({"task_id":"a","requires_stages":["b"]},{"task_id":"b"})", "/stages/0/requires_stages",
         "earlier stage"},
        {R"({"task_id":"a"},{"task_id":"a"})", "/stages/1/task_id", "give the stage an"},
        {R"({"task_id":"a","id":"x"},{"task_id":"b","id":"x"})", "/stages/1/id", "already"},
        {R"({"task_id":"a","mode":"exam","exam":{"seeds":[1]},"max_attempts":1,"consecutive":2})",
         "/stages/0/max_attempts", "cannot reach"},
        {R"({"task_id":"a","max_attempts":3})", "/stages/0/max_attempts",
         "3 attempts at a stage of mode \"practice\"; only an exam has one: leave"},
        {R"({"task_id":"a","mode":"familiarisation","max_attempts":1})", "/stages/0/max_attempts",
         "only an exam"},
        {R"({"task_id":"a","mode":"exam"})", "/stages/0", "fixed seeds"},
        {R"({"task_id":"a","exam":{"seeds":[1]}})", "/stages/0/exam", "mode"},
        {R"({"task_id":"a","mode":"exam","exam":{"seeds":[1,2,1]}})", "/stages/0/exam/seeds/2",
         "twice"},
        {R"({"task_id":"a","mode":"exam","exam":{"seeds":[]}})", "/stages/0/exam/seeds",
         "list of 0"},
        {R"({"task_id":"a","mode":"test"})", "/stages/0/mode", "practice"},
        {R"({"task_id":"a","benchmark_points":101})", "/stages/0/benchmark_points", "too large"},
        {R"({"task_id":"a","requires_tasks":["b"]})", "/stages/0", "requires_stages"},
    };
    for (const Case& each : cases) {
        const std::string text = R"({"id":"c","version":1,"title":{"en":"t"},"stages":[)" +
                                 std::string(each.stages) + "]}";
        try {
            (void)load_course_text(text, "c.json");
            ADD_FAILURE() << "was accepted: " << each.stages;
        } catch (const DefinitionError& error) {
            EXPECT_EQ(error.pointer(), each.pointer) << error.what();
            EXPECT_NE(std::string(error.what()).find(each.says), std::string::npos) << error.what();
        }
    }
}

TEST(Course, ALimitOfPracticeThatWasPublishedOnceIsIgnored) {
    const std::string text =
        R"({"id":"c","version":1,"title":{"en":"t"},"stages":[{"task_id":"a","max_attempts":1},)"
        R"({"task_id":"b","mode":"exam","exam":{"seeds":[1]},"max_attempts":2}]})";
    EXPECT_THROW((void)load_course_text(text, "c.json"), DefinitionError);
    const Course course = load_published_course(text, "c.json");
    EXPECT_EQ(course.stages[0].max_attempts, 0);
    EXPECT_EQ(course.stages[0].consecutive, 2);
    EXPECT_EQ(course.stages[1].max_attempts, 2);
    EXPECT_EQ(course.json, text) << "it is never changed";
}

TEST(Course, ACourseFileMayNameOnlyTasksThatAreThere) {
    const std::string file = testing::TempDir() + "course_of_nothing.json";
    std::ofstream(file)
        << R"({"id":"c","version":1,"title":{"en":"t"},"stages":[{"task_id":"a"}]})";
    try {
        (void)load_course(file);
        FAIL() << "was accepted";
    } catch (const DefinitionError& error) {
        EXPECT_EQ(error.pointer(), "/stages/0/task_id");
        EXPECT_NE(std::string(error.what()).find("diathermy_ring"), std::string::npos);
    }
}

TEST(Course, WhatAnEditorSavesReadsBackTheSame) {
    for (const std::string& id : list_definitions("courses")) {
        const Course course = load_course(id);
        const std::string text = course_json(course);
        EXPECT_EQ(course_json(load_course_text(text, id)), text);
        const Course again = load_course_text(text, id);
        ASSERT_EQ(again.stages.size(), course.stages.size());
        for (size_t i = 0; i < course.stages.size(); ++i) {
            EXPECT_EQ(again.stages[i].id, course.stages[i].id);
            EXPECT_EQ(again.stages[i].mode, course.stages[i].mode);
            EXPECT_EQ(again.stages[i].requires_stages, course.stages[i].requires_stages);
            EXPECT_EQ(again.stages[i].exam.seeds, course.stages[i].exam.seeds);
            EXPECT_EQ(again.stages[i].remind_after_days, course.stages[i].remind_after_days);
        }
    }
}

TEST(Course, TheCourseToTheExamReachesFromFamiliarisationToTheWholeDissection) {
    const Course course = load_course("full_dissection");
    EXPECT_EQ(course.stages.front().mode, StageMode::kFamiliarisation);
    EXPECT_EQ(course.stages.back().mode, StageMode::kExam);
    EXPECT_EQ(course.stages.back().task_id, "sb_dissection");
    for (const char* task : {"diathermy_ring_small", "diathermy_ring", "grasp_and_lift",
                             "scissors_resection", "sb_dissection"})
        EXPECT_TRUE(std::any_of(course.stages.begin(), course.stages.end(),
                                [&](const CourseStage& stage) { return stage.task_id == task; }))
            << task << " is in no stage";
}

TEST(Course, TheWholeRepairIsLearntAndExaminedInTheOrderOfTheOperation) {
    const Course course = load_course("whole_repair");
    std::vector<std::string> practised, examined;
    for (size_t i = 0; i < course.stages.size(); ++i) {
        const CourseStage& stage = course.stages[i];
        (stage.mode == StageMode::kExam ? examined : practised).push_back(stage.task_id);
        if (i > 0) {
            EXPECT_EQ(stage.requires_stages, std::vector{course.stages[i - 1].id}) << stage.id;
        }
        if (stage.mode == StageMode::kExam) {
            EXPECT_TRUE(stage.exam.proctor) << stage.id;
        }
        // Who meets the benchmark has passed the task.
        EXPECT_GE(stage.benchmark_points, load_task(stage.task_id).rubric.pass_points) << stage.id;
    }
    EXPECT_EQ(practised, (std::vector<std::string>{"sb_dissection", "irrigate", "patch_place",
                                                   "wound_closure"}));
    EXPECT_EQ(examined,
              (std::vector<std::string>{"sb_dissection", "patch_place", "wound_closure"}));
}

TEST(Course, FamiliarisationCountsWhateverTheScore) {
    Course course = two_stages();
    course.stages[0].mode = StageMode::kFamiliarisation;
    course.stages[0].consecutive = 1;
    EXPECT_EQ(course_progress(course, {{"warm_up", 0, true}}).stages[0].status,
              StageStatus::kMastered);
    EXPECT_EQ(course_progress(course, {{"warm_up", 0, false, true}}).stages[0].status,
              StageStatus::kOpen)
        << "an interrupted one does not";
}

TEST(Course, TheLimitOfAttemptsClosesAStageAndAGrantOpensItAgain) {
    Course course = two_stages();
    course.stages[0].max_attempts = 2;
    course.stages[0].mode = StageMode::kExam;
    course.stages[0].exam.seeds = {7};
    course.stages[0].exam.proctor = false;
    const auto sat = [](double points) {
        AttemptOutcome outcome{"warm_up", points};
        outcome.exam_course = "c";
        outcome.exam_stage = "warm_up";
        outcome.seed = 7;
        return outcome;
    };
    const std::vector<AttemptOutcome> two{sat(50), sat(90)};
    const CourseProgress used = course_progress(course, two);
    EXPECT_EQ(used.stages[0].status, StageStatus::kExhausted);
    EXPECT_EQ(used.stages[0].attempts_left, 0);
    EXPECT_EQ(used.next_stage, -1);
    EXPECT_FALSE(used.mastered);
    const CourseProgress granted = course_progress(course, two, {}, {{"warm_up", 1}});
    EXPECT_EQ(granted.stages[0].status, StageStatus::kOpen);
    EXPECT_EQ(granted.stages[0].attempts_left, 1);
    EXPECT_EQ(granted.next_stage, 0);
    EXPECT_EQ(course_progress(course, two, {}, {{"real", 5}}).next_stage, -1) << "another stage's";
    EXPECT_EQ(course_progress(course, {sat(90), sat(90)}).stages[0].status, StageStatus::kMastered)
        << "mastered with the last attempt";
}

AttemptOutcome at(const char* task, double points, const char* day) {
    AttemptOutcome outcome;
    outcome.task_id = task;
    outcome.points = points;
    outcome.at_utc = day;
    return outcome;
}

TEST(Course, AMasteredSkillIsDueAgainAfterItsDaysAndEveryGoodAttemptPutsItOff) {
    Course course = two_stages();
    course.stages[0].remind_after_days = 30;
    std::vector<AttemptOutcome> done{at("warm_up", 80, "2026-01-01"),
                                     at("warm_up", 80, "2026-01-02")};
    const auto due = [&](const char* now) {
        return course_progress(course, done, now).stages[0].refresh_due;
    };
    EXPECT_EQ(course_progress(course, done).stages[0].refresh_utc, "2026-02-01T00:00:00Z");
    EXPECT_EQ(course_progress(course, done).stages[0].mastered_utc, "2026-01-02");
    EXPECT_FALSE(due(""));
    EXPECT_FALSE(due("2026-01-31T23:59:59Z"));
    EXPECT_TRUE(due("2026-02-01T00:00:00Z"));
    done.push_back(at("warm_up", 20, "2026-02-01"));
    EXPECT_TRUE(due("2026-02-02")) << "a poor attempt refreshes nothing";
    done.push_back(at("warm_up", 75, "2026-02-02"));
    EXPECT_FALSE(due("2026-02-02"));
    EXPECT_TRUE(due("2026-03-04"));
    course.stages[0].remind_after_days = 0;
    EXPECT_FALSE(due("2036-01-01"));
}

TEST(Course, AnExamCountsOnlyUnderItsConditions) {
    Course course = two_stages();
    CourseStage& exam = course.stages[1];
    exam.id = "final";
    exam.mode = StageMode::kExam;
    exam.consecutive = 1;
    exam.exam.seeds = {7, 8};
    exam.exam.haptic_certificate = true;
    AttemptOutcome good = at("real", 90, "2026-01-01");
    good.seed = 7;
    good.exam_course = "c";
    good.exam_stage = "final";
    good.proctor = "Dr Nowak";
    good.certified = true;
    EXPECT_TRUE(counts_for(course, exam, good));
    const auto spoiled = [&](auto change) {
        AttemptOutcome outcome = good;
        change(outcome);
        return counts_for(course, exam, outcome);
    };
    EXPECT_FALSE(spoiled([](auto& o) { o.seed = 9; }));
    EXPECT_FALSE(spoiled([](auto& o) { o.proctor.clear(); }));
    EXPECT_FALSE(spoiled([](auto& o) { o.certified = false; }));
    EXPECT_FALSE(spoiled([](auto& o) { o.exam_stage.clear(); })) << "practice";
    EXPECT_FALSE(spoiled([](auto& o) { o.exam_course = "other"; }));
    EXPECT_FALSE(spoiled([](auto& o) { o.interrupted = true; }));
    EXPECT_FALSE(spoiled([](auto& o) { o.voided = true; })) << "void for cause";
    EXPECT_FALSE(spoiled([](auto& o) { o.task_id = "warm_up"; }));
    std::vector<AttemptOutcome> all{at("warm_up", 80, "2026-01-01"),
                                    at("warm_up", 80, "2026-01-01")};
    EXPECT_EQ(course_progress(course, all).stages[1].next_seed, 7u);
    AttemptOutcome poor = good;
    poor.points = 40;
    all.push_back(poor);
    EXPECT_EQ(course_progress(course, all).stages[1].next_seed, 8u);
    poor.seed = 8;
    all.push_back(poor);
    EXPECT_EQ(course_progress(course, all).stages[1].next_seed, 7u) << "from the start again";
    all.push_back(good);
    EXPECT_TRUE(course_progress(course, all).mastered);
    EXPECT_EQ(course_progress(course, all).mastered_utc, "2026-01-01");
}

TEST(Course, AnExamThatIsLeftUsesUpAnAttemptAndTheNextHasAnotherCase) {
    Course course = two_stages();
    CourseStage& exam = course.stages[0];
    exam.mode = StageMode::kExam;
    exam.exam.proctor = false;
    exam.exam.seeds = {7, 8, 9};
    exam.max_attempts = 3;
    const auto sat = [](uint64_t seed, double points, bool left, bool voided) {
        AttemptOutcome outcome{"warm_up", points};
        outcome.exam_course = "c";
        outcome.exam_stage = "warm_up";
        outcome.seed = seed;
        outcome.interrupted = left;
        outcome.voided = voided;
        return outcome;
    };
    std::vector<AttemptOutcome> all{sat(7, 90, false, false), sat(8, 0, true, false)};
    const StageProgress left = course_progress(course, all).stages[0];
    EXPECT_EQ(left.attempts_left, 1);
    EXPECT_EQ(left.next_seed, 9u);
    EXPECT_EQ(left.streak, 0) << "to leave is not to meet the benchmark";
    EXPECT_DOUBLE_EQ(left.best_points, 90) << "it has no score";
    // The machine was at fault: no attempt is used up, but the case was seen.
    all.push_back(sat(9, 40, false, true));
    const StageProgress voided = course_progress(course, all).stages[0];
    EXPECT_EQ(voided.attempts_left, 1);
    EXPECT_EQ(voided.next_seed, 7u);
    EXPECT_EQ(voided.status, StageStatus::kOpen);
    all.push_back(sat(7, 0, true, false));
    EXPECT_EQ(course_progress(course, all).stages[0].status, StageStatus::kExhausted);
    exam.exam.seeds = {7};
    EXPECT_EQ(course_progress(course, {sat(7, 0, true, false)}).stages[0].next_seed, 7u)
        << "there is no other case";
    // Practice in the same case is no exam.
    AttemptOutcome practice = sat(7, 80, true, false);
    practice.exam_course.clear();
    EXPECT_EQ(course_progress(course, {practice}).stages[0].attempts, 0);
}

/// Whoever can stop a program for a moment could have every exam back that goes badly.
TEST(Course, AnExamThatTheMachineSpoiltIsGivenBackOnce) {
    Course course = two_stages();
    CourseStage& exam = course.stages[0];
    exam.mode = StageMode::kExam;
    exam.exam.proctor = false;
    exam.exam.seeds = {7, 8, 9};
    exam.max_attempts = 2;
    AttemptOutcome spoilt{"warm_up", 95};
    spoilt.exam_course = "c";
    spoilt.exam_stage = "warm_up";
    spoilt.voided = true;
    std::vector<AttemptOutcome> all;
    for (const auto& [seed, left] :
         {std::pair{uint64_t{7}, 2}, std::pair{uint64_t{8}, 1}, std::pair{uint64_t{9}, 0}}) {
        spoilt.seed = seed;
        all.push_back(spoilt);
        const StageProgress own = course_progress(course, all).stages[0];
        EXPECT_EQ(own.attempts_left, left);
        EXPECT_EQ(own.streak, 0) << "nor is it met";
    }
    EXPECT_EQ(course_progress(course, all).stages[0].status, StageStatus::kExhausted);
    const StageProgress granted = course_progress(course, all, {}, {{"warm_up", 1}}).stages[0];
    EXPECT_EQ(granted.attempts_left, 1) << "an educator judges";
    // Practice is nobody's exam, however slow.
    for (AttemptOutcome& each : all) each.exam_course.clear();
    EXPECT_EQ(course_progress(course, all).stages[0].attempts_left, 2);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
