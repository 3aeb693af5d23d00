// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt on a machine that was too slow is kept and counts nowhere, in every mode, on both
// engines.

#include "db/attempt_counting.h"

#include <gmock/gmock.h>

#include <limits>

#include "curriculum/task.h"
#include "db/course_conduct.h"
#include "db/evidence.h"
#include "db/norm_bands.h"
#include "db/standards.h"
#include "tests/exam_course.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();

sim::Event machine(float speed, float pictures) {
    sim::Event event;
    event.kind = sim::EventKind::kMachineSpeed;
    event.value = speed;
    event.value2 = pictures;
    return event;
}

std::string said(const std::vector<sim::Event>& events) {
    return db::void_text(db::void_reasons(events));
}

class Counting : public EngineTest {
 protected:
    void ready() override {
        store = open();
        user = store->accounts().create({"anna", "Anna", "correct horse battery", 1, false});
    }
    [[nodiscard]] static db::AttemptResult passed(const std::string& started_utc,
                                                  std::vector<sim::Event> events) {
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.header.started_utc = started_utc;
        result.end.reason = sim::EndReason::kFinished;
        result.end.duration_s = 100;
        result.score.points = 90;
        result.score.verdict = assessment::Verdict::kPassed;
        result.metrics.values = {{"path_length_mm", 1}};
        result.events = std::move(events);
        return result;
    }
    int64_t save(const std::string& started_utc, std::vector<sim::Event> events,
                 db::ExamContext exam = {}) {
        db::AttemptResult result = passed(started_utc, std::move(events));
        result.exam = std::move(exam);
        return save_recorded(*store, user, result, folder.path().string());
    }

    std::unique_ptr<db::Store> store;
    int64_t user = 0;
};

/// Whatever else stands in the row: what is not simulated again yet, or gave something else, is no
/// proof.
TEST(ReplayCounts, WhatWasSimulatedAgainHasToBeIdentical) {
    db::AttemptRecord attempt;
    attempt.verdict = assessment::Verdict::kPassed;
    for (const auto& [replay, counts] :
         {std::pair{db::ReplayState::kNotReplayed, true},
          std::pair{db::ReplayState::kIdentical, true}, std::pair{db::ReplayState::kWaiting, false},
          std::pair{db::ReplayState::kDiffers, false}}) {
        attempt.replay = replay;
        EXPECT_EQ(db::counts(attempt), counts) << db::replay_name(replay);
    }
}

TEST(SlowMachine, IsSaidInPlainWordsWithTheFigureAndTheLimit) {
    EXPECT_EQ(said({}), "") << "scripts and windowless runs say nothing";
    EXPECT_EQ(said({machine(1, 60)}), "");
    EXPECT_EQ(said({machine(0.95F, 20)}), "") << "the limits themselves do";
    EXPECT_EQ(said({machine(1, 0)}), "") << "nothing was drawn";
    EXPECT_EQ(said({machine(1, 12.4F)}),
              "The computer was too slow: 12 pictures a second, 20 are needed");
    EXPECT_EQ(said({machine(1, 19.9F)}),
              "The computer was too slow: 19 pictures a second, 20 are needed")
        << "never \"20, 20 are needed\"";
    EXPECT_EQ(said({machine(0.62F, 60)}),
              "The computer was too slow: the simulation ran at 62 % of real time, 95 % are "
              "needed");
    EXPECT_THAT(said({machine(0.5F, 3)}), HasSubstr("3 pictures a second"));
    EXPECT_THAT(said({machine(0.5F, 1)}), HasSubstr("1 picture a second"));
    EXPECT_THAT(said({machine(0.5F, 3)}), HasSubstr("; The computer"));
    EXPECT_NE(said({machine(std::numeric_limits<float>::quiet_NaN(), 60)}), "");
}

INSTANTIATE_TEST_SUITE_P(Engines, Counting, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(Counting, ASlowAttemptIsKeptAndCountsNowhere) {
    const int64_t good = save("2026-01-02T03:00:00.000Z", {machine(1, 60)});
    const int64_t slow = save("2026-01-03T03:00:00.000Z", {machine(1, 12)});
    const auto record = store->attempts().detail(slow).record;
    EXPECT_THAT(record.void_reason, HasSubstr("12 pictures a second"));
    EXPECT_FALSE(db::counts(record));
    EXPECT_TRUE(db::counts(store->attempts().detail(good).record));
    EXPECT_EQ(store->attempts().list(user).size(), 2u) << "it is kept";
    EXPECT_EQ(store->audit().trail(1).at(0).action, "attempt.void");

    EXPECT_EQ(store->attempts().standings(0).at(0).attempts, 1);
    EXPECT_EQ(store->attempts().points(0).size(), 1u);
    EXPECT_EQ(store->attempts().recent_means("diathermy_ring", 5).at(0).attempts, 1);
    const auto levels = db::level_attempts(*store, "diathermy_ring", {{"expert", {user}}});
    ASSERT_EQ(levels.at(0).by_person.size(), 1u);
    EXPECT_EQ(levels[0].by_person.at(user).size(), 1u) << "norms and metric quality";
    EXPECT_EQ(levels[0].by_person.at(user)[0].record.id, good);
    EXPECT_THAT(
        failure_of([&] { (void)db::person_means(*store, "diathermy_ring", {user}, 5); }).what(),
        HasSubstr("1 of 1 attempts were never simulated again"));
    store->attempts().set_replay(good, db::ReplayState::kIdentical);
    EXPECT_EQ(db::person_means(*store, "diathermy_ring", {user}, 5), std::vector<double>{90})
        << "standards";
    EXPECT_EQ(db::other_attempts(*store, record).size(), 2u);
}

/// A script did it, or the recording says so: whoever asks, it is nobody's skill.
TEST_P(Counting, ADemonstrationCountsForNobodyButADemonstrationAccount) {
    const auto shown = [&](int64_t whose, const std::string& device, db::StudyContext study = {}) {
        db::AttemptResult result = passed("2026-01-02T03:00:00.000Z", {machine(1, 60)});
        result.header.device = device;
        result.header.demonstration = true;
        result.study = std::move(study);
        return store->attempts()
            .detail(save_recorded(*store, whose, result, folder.path().string()))
            .record;
    };
    const db::AttemptRecord script = shown(user, "script:expert");
    EXPECT_FALSE(db::counts(script));
    EXPECT_TRUE(db::not_verified(script));
    EXPECT_EQ(script.void_reason, "Practice, not verified: operated by script:expert");
    EXPECT_EQ(shown(user, "mouse").void_reason,
              "Practice, not verified: operated by somebody for a demonstration (mouse)");
    EXPECT_TRUE(store->attempts().standings(0).empty());
    EXPECT_TRUE(store->attempts().points(0).empty());
    EXPECT_TRUE(store->attempts().recent_means("diathermy_ring", 5).empty());
    EXPECT_TRUE(
        db::level_attempts(*store, "diathermy_ring", {{"expert", {user}}})[0].by_person.empty());
    for (const db::AttemptRecord& each : store->attempts().list(user))
        EXPECT_FALSE(db::counts(each)) << "grades, pages and cohorts";

    const int64_t dora =
        store->accounts().create({"dora", "Dora", "correct horse battery", 1, true});
    EXPECT_TRUE(db::counts(shown(dora, "script:expert")));
    EXPECT_EQ(store->attempts().standings(0).at(0).user_id, dora);
    EXPECT_EQ(store->attempts().points(0).size(), 1u);

    const std::string person = store->studies().new_participant("pilot", false);
    const std::string shows = store->studies().new_participant("pilot", true);
    EXPECT_FALSE(db::counts(shown(user, "script:novice", {"pilot", person})));
    EXPECT_TRUE(db::counts(shown(user, "script:expert", {"pilot", shows})));
}

/// Nobody simulates a demonstration again, so it could say any number of points.
TEST_P(Counting, ADemonstrationSetsNoMarkForRealPeople) {
    const int64_t dora =
        store->accounts().create({"dora", "Dora", "correct horse battery", 1, true});
    const auto means = [&] { return db::person_means(*store, "diathermy_ring", {user, dora}, 5); };
    db::AttemptResult shown = passed("2026-01-02T03:00:00.000Z", {machine(1, 60)});
    shown.header.demonstration = true;
    shown.score.points = 3;
    (void)save_recorded(*store, dora, shown, folder.path().string());
    store->attempts().set_replay(save("2026-01-03T03:00:00.000Z", {machine(1, 60)}),
                                 db::ReplayState::kIdentical);
    EXPECT_EQ(means(), std::vector<double>{90}) << "one function says whose and which";
    ASSERT_EQ(store->attempts().recent_means("diathermy_ring", 5).size(), 1u);
    EXPECT_EQ(store->attempts().recent_means("diathermy_ring", 5)[0].user_id, user);
    auto levels = db::level_attempts(*store, "diathermy_ring", {{"expert", {user, dora}}});
    EXPECT_EQ(levels[0].by_person.size(), 2u) << "a norm pack says that it demonstrates";
    db::leave_demonstrations_out(*store, levels);
    EXPECT_EQ(levels[0].by_person.size(), 1u);
    EXPECT_NO_THROW(db::need_proof(levels));
    (void)save("2026-01-04T03:00:00.000Z", {machine(1, 60)});
    EXPECT_THAT(failure_of([&] { (void)means(); }).what(), HasSubstr("1 of 2 attempts were never"));
    levels = db::level_attempts(*store, "diathermy_ring", {{"expert", {user}}});
    EXPECT_THAT(failure_of([&] { db::need_proof(levels); }).what(),
                HasSubstr("1 of 2 attempts were never"));
    // A store that is there to be looked at.
    ASSERT_TRUE(raw().run("UPDATE accounts SET demonstration = 1"));
    EXPECT_EQ(db::person_means(*store, "diathermy_ring", {dora}, 5), std::vector<double>{3});
}

/// Points of different rules are no common scale.
TEST_P(Counting, AMarkIsOfOneVersionOfTheTaskAndOfItsRubric) {
    const auto done = [&](int64_t whose, const std::string& started_utc, int task_version,
                          int rubric_version, const std::string& rubric = "ring") {
        db::AttemptResult result = passed(started_utc, {machine(1, 60)});
        result.header.task_version = task_version;
        result.score.rubric_id = rubric;
        result.score.rubric_version = rubric_version;
        store->attempts().set_replay(save_recorded(*store, whose, result, folder.path().string()),
                                     db::ReplayState::kIdentical);
    };
    const auto someone = [&](const std::string& login) {
        return store->accounts().create({login, login, "correct horse battery", 1, false});
    };
    const auto refused = [&](const std::vector<int64_t>& people, int last) {
        return std::string(failure_of([&] {
                               (void)db::person_means(*store, "diathermy_ring", people, last);
                           }).what());
    };
    const int64_t rubric = someone("bea"), task = someone("cy"), name = someone("di");
    done(user, "2026-01-02T03:00:00.000Z", 1, 1);
    done(user, "2026-01-03T03:00:00.000Z", 1, 2);
    done(rubric, "2026-01-03T03:00:00.000Z", 1, 2);
    done(task, "2026-01-03T03:00:00.000Z", 2, 2);
    done(name, "2026-01-03T03:00:00.000Z", 1, 2, "another");
    EXPECT_EQ(refused({user}, 5),
              "standard of diathermy_ring: the attempts are of different versions of the task "
              "or of its rubric; choose people whose attempts are of one version");
    for (const int64_t other : {task, name})
        EXPECT_THAT(refused({rubric, other}, 1), HasSubstr("different versions"));
    EXPECT_EQ(db::person_means(*store, "diathermy_ring", {user, rubric}, 1),
              (std::vector<double>{90, 90}))
        << "the last ones are of one version";
    EXPECT_NO_THROW(db::need_fit_to_judge(*store, "diathermy_ring", {user, rubric}, 1));
    EXPECT_THAT(failure_of([&] {
                    db::need_fit_to_judge(*store, "diathermy_ring", {user, task}, 1);
                }).what(),
                HasSubstr("different versions"));
}

TEST_P(Counting, ATunedAttemptCountsNowhereAndNoMachineIsAtFault) {
    sim::Event tuned;
    tuned.kind = sim::EventKind::kTuned;
    const auto record = store->attempts().detail(save("2026-01-03T03:00:00.000Z", {tuned})).record;
    EXPECT_EQ(record.void_reason, "Tissue or generator was tuned");
    EXPECT_FALSE(db::counts(record));
    EXPECT_FALSE(db::machine_at_fault(record));
    const auto both =
        store->attempts().detail(save("2026-01-04T03:00:00.000Z", {tuned, machine(1, 12)})).record;
    EXPECT_THAT(both.void_reason, HasSubstr("12 pictures a second"));
    EXPECT_FALSE(db::machine_at_fault(both)) << "who tuned would not have counted anyway";
    auto slow = store->attempts().detail(save("2026-01-05T03:00:00.000Z", {machine(1, 12)})).record;
    EXPECT_TRUE(db::machine_at_fault(slow));
    slow.end = sim::EndReason::kInterrupted;
    EXPECT_FALSE(db::machine_at_fault(slow)) << "left after five seconds";
    EXPECT_TRUE(store->attempts().standings(0).empty());
}

TEST_P(Counting, WhatBeganAtAStageCountsNowhere) {
    const curriculum::Course course = curriculum::load_course("first_steps");
    const auto counted = [&] {
        return db::course_standing(*store, user, course.id, "2026-06-01T00:00:00Z")
            .progress.stages.front()
            .attempts;
    };
    const int before = counted();
    db::AttemptResult result = passed("2026-01-03T03:00:00.000Z", {});
    result.header.task_id = course.stages.front().task_id;
    result.header.stage = 2;
    result.header.given_frames = 100;
    const int64_t id = save_recorded(*store, user, result, folder.path().string());
    const db::AttemptRecord record = store->attempts().detail(id).record;
    EXPECT_EQ(record.void_reason, "Begun at stage 2, what came before it was given");
    EXPECT_THAT(db::why_void(record),
                testing::ElementsAre(db::VoidReason{db::VoidCause::kGiven, 2, 0, {}}));
    EXPECT_EQ(db::given_stage(record), 2);
    EXPECT_FALSE(db::counts(record));
    EXPECT_FALSE(db::machine_at_fault(record));
    EXPECT_FALSE(db::not_verified(record)) << "honest practice";
    store->attempts().set_replay(id, db::ReplayState::kIdentical, {});
    EXPECT_FALSE(db::counts(store->attempts().detail(id).record)) << "no replay makes it count";
    EXPECT_TRUE(store->attempts().standings(0).empty());
    EXPECT_EQ(counted(), before) << "mastery does not see it";
    // What an exam asks for, and whatever else happened, it is void for this cause.
    result.events = {machine(0.4F, 60)};
    EXPECT_THAT(db::void_text(db::void_causes(result)),
                testing::StartsWith("Begun at stage 2, what came before it was given; "));
    const auto whole = store->attempts().detail(save("2026-01-05T03:00:00.000Z", {})).record;
    EXPECT_TRUE(db::counts(whole));
    EXPECT_EQ(db::given_stage(whole), 0);
}

TEST_P(Counting, PracticeExamAndMasteryLeaveItOut) {
    const curriculum::Course course = curriculum::load_course("first_steps");
    const curriculum::CourseStage& stage = course.stages.front();
    const auto standing = [&] {
        return db::course_standing(*store, user, course.id, "2026-06-01T00:00:00Z")
            .progress.stages.front();
    };
    const int before = standing().attempts;
    db::AttemptResult result;
    result.header.task_id = stage.task_id;
    result.header.started_utc = "2026-01-02T03:00:00.000Z";
    result.end.reason = sim::EndReason::kFinished;
    result.score.points = 100;
    result.score.verdict = assessment::Verdict::kPassed;
    result.events = {machine(0.4F, 60)};
    store->attempts().save(user, result);
    EXPECT_EQ(standing().attempts, before) << "mastery does not see it";
    store->accounts().create({"piotr", "Dr. P", "correct horse battery",
                              static_cast<db::Roles>(db::Role::kEducator), false});
    publish_exam(*store, "diathermy_ring", "0");
    assign_exam(*store, user);
    const int64_t exam =
        save("2026-01-04T03:00:00.000Z", {machine(0.4F, 60)}, {"short", 1, "final", "Dr. P", ""});
    const db::AttemptRecord kept = store->attempts().detail(exam).record;
    EXPECT_THAT(kept.void_reason, HasSubstr("40 % of real time"));
    EXPECT_TRUE(db::machine_at_fault(kept)) << kept.void_reason;
    result.events = {machine(1, 60)};
    store->attempts().save(user, result);
    EXPECT_EQ(standing().attempts, before + 1);
}

}  // namespace THIS_TEST
