// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Groups, assignments, standing, exams and certificates in the store, on both engines.

#include "db/course_conduct.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <random>
#include <thread>
#include <tuple>

#include "curriculum/utc_time.h"
#include "db/access.h"
#include "db/attempt_counting.h"
#include "db/packing.h"
#include "db/password.h"
#include "db/void_reason.h"
#include "haptics/certificate.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::GroupRole;
using db::Scope;
using db::StoreError;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kNow = "2026-03-01T00:00:00Z";

/// Practise once at 70, then an exam of two seeds.
std::string course_text(int version, const char* limit = "3") {
    return R"({"id":"short","version":)" + std::to_string(version) +
           R"(,"title":{"en":"Short"},"stages":[{"task_id":"diathermy_ring","consecutive":1},)"
           R"({"id":"final","task_id":"diathermy_ring","mode":"exam","consecutive":1,)"
           R"("max_attempts":)" +
           limit + R"(,"requires_stages":["diathermy_ring"],"exam":{"seeds":[7,8]}}]})";
}

class CourseStore : public EngineTest {
 protected:
    void ready() override {
        store = open();
        anna = add("anna", db::Role::kTrainee);
        jan = add("jan", db::Role::kTrainee);
        ewa = add("ewa", db::Role::kEducator);
        publish(1);
    }
    int64_t add(const std::string& login, db::Role role) const {
        return store->accounts().create(
            {login, login, "long enough 1", static_cast<db::Roles>(role), false});
    }
    void publish(int version, const char* limit = "3") const {
        db::DefinitionRecord definition;
        definition.kind = "course";
        definition.id = "short";
        definition.version = version;
        definition.json = course_text(version, limit);
        definition.reason = "because";
        store->definitions().publish(definition);
    }
    int64_t assign(int64_t user, int64_t group = 0, const std::string& due = "",
                   const std::string& starts = "") const {
        db::AssignmentRecord assignment;
        assignment.course_id = "short";
        assignment.course_version = 1;
        assignment.user_id = user;
        assignment.group_id = group;
        assignment.due_utc = due;
        assignment.starts_utc = starts;
        return store->courses().assign(assignment);
    }
    void attempt(int64_t user, double points, const db::ExamContext& exam = {}, uint64_t seed = 1,
                 const std::string& at = "2026-02-01T00:00:00Z",
                 const std::string& haptics = {}) const {
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.header.started_utc = at;
        result.header.seed = seed;
        result.score.points = points;
        result.score.verdict = assessment::Verdict::kPassed;
        result.exam = exam;
        result.haptic_certificate = haptics;
        save_recorded(*store, user, result, folder.path().string());
    }

    std::unique_ptr<db::Store> store;
    int64_t anna = 0, jan = 0, ewa = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, CourseStore, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(CourseStore, AGroupHasMembersAndEducatorsAndAUniqueName) {
    const int64_t group = store->groups().create("Cohort A");
    EXPECT_EQ(failure_of([&] { store->groups().create("cohort a"); }).kind(),
              StoreError::Kind::kConflict);
    EXPECT_EQ(failure_of([&] { store->groups().create(" "); }).kind(), StoreError::Kind::kRefused);
    store->groups().set_role(group, anna, GroupRole::kMember);
    store->groups().set_role(group, ewa, GroupRole::kEducator);
    ASSERT_EQ(store->groups().list().size(), 1u);
    EXPECT_THAT(store->groups().list()[0].members, ElementsAre(anna));
    EXPECT_THAT(store->groups().list()[0].educators, ElementsAre(ewa));
    store->groups().set_role(group, anna, GroupRole::kNone);
    EXPECT_THAT(store->groups().list()[0].members, IsEmpty());
    EXPECT_EQ(failure_of([&] { store->groups().set_role(99, anna, GroupRole::kMember); }).kind(),
              StoreError::Kind::kNotFound);
}

// A page of text that was pasted by mistake would push all else off the page.
TEST_P(CourseStore, AGroupsNameHasAtMost200Letters) {
    std::string letters;
    for (int i = 0; i < db::kMostNameLength; ++i) letters += "ł";  // two bytes each
    EXPECT_GT(store->groups().create(letters), 0);
    EXPECT_THAT(failure_of([&] { store->groups().create(letters + "l"); }).what(),
                testing::HasSubstr("the name is longer than 200 characters"));
}

TEST_P(CourseStore, AnEducatorReachesTheOwnGroupsAndPeopleWithoutAGroup) {
    const int64_t other = add("olga", db::Role::kEducator);
    EXPECT_EQ(db::scope_between(*store, ewa, ewa), Scope::kOwn);
    EXPECT_EQ(db::scope_between(*store, ewa, anna), Scope::kGroup) << "in no group";
    const int64_t group = store->groups().create("A");
    store->groups().set_role(group, anna, GroupRole::kMember);
    EXPECT_EQ(db::scope_between(*store, ewa, anna), Scope::kOther);
    store->groups().set_role(group, ewa, GroupRole::kMember);
    EXPECT_EQ(db::scope_between(*store, ewa, anna), Scope::kOther) << "a member teaches nobody";
    store->groups().set_role(group, ewa, GroupRole::kEducator);
    EXPECT_EQ(db::scope_between(*store, ewa, anna), Scope::kGroup);
    EXPECT_EQ(db::scope_between(*store, other, anna), Scope::kOther);
}

TEST_P(CourseStore, ACourseIsAssignedByPersonOrGroupAndEnds) {
    const int64_t group = store->groups().create("A");
    store->groups().set_role(group, anna, GroupRole::kMember);
    store->groups().set_role(group, ewa, GroupRole::kEducator);
    const int64_t by_group = assign(0, group, "2026-06-01");
    EXPECT_EQ(failure_of([&] { assign(0, group); }).kind(), StoreError::Kind::kConflict);
    const int64_t own = assign(anna, 0, "2026-05-01");
    const auto mine = store->courses().assignments(anna);
    ASSERT_EQ(mine.size(), 2u);
    EXPECT_EQ(mine[0].id, own) << "due first";
    EXPECT_EQ(mine[1].group_id, group);
    EXPECT_THAT(store->courses().assignments(jan), IsEmpty());
    EXPECT_THAT(store->courses().assignments(ewa), IsEmpty()) << "who teaches need not do it";
    EXPECT_EQ(db::course_standings(*store, anna, kNow).size(), 1u) << "the same course once";
    store->courses().end_assignment(own);
    EXPECT_EQ(failure_of([&] { store->courses().end_assignment(own); }).kind(),
              StoreError::Kind::kConflict);
    EXPECT_EQ(failure_of([&] { store->courses().end_assignment(99); }).kind(),
              StoreError::Kind::kNotFound);
    ASSERT_EQ(store->courses().assignments(anna).size(), 1u);
    EXPECT_EQ(store->courses().assignments(anna)[0].id, by_group);
    EXPECT_EQ(store->courses().assignments(0).size(), 2u) << "ended ones are kept";
}

TEST_P(CourseStore, WhatBeginsLaterDoesNotBlockWhatRunsAndTheOwnDatesComeBeforeTheGroups) {
    const int64_t group = store->groups().create("A");
    store->groups().set_role(group, anna, GroupRole::kMember);
    store->groups().set_role(group, jan, GroupRole::kMember);
    const int64_t of_all = assign(0, group);
    const int64_t own = assign(anna, 0, "2026-05-01", "2026-04-01");
    const auto held = [&](int64_t user, const char* now) {
        const auto listed = db::course_standings(*store, user, now);
        EXPECT_EQ(listed.size(), 1u);
        const auto one = db::course_standing(*store, user, "short", now);
        EXPECT_EQ(one.assignment.id, listed.at(0).assignment.id);
        return one;
    };
    EXPECT_EQ(held(anna, kNow).assignment.id, of_all);
    EXPECT_EQ(held(anna, kNow).next.kind, curriculum::NextKind::kStart);
    EXPECT_EQ(held(anna, "2026-04-02").assignment.id, own);
    store->courses().end_assignment(of_all);
    EXPECT_EQ(held(anna, kNow).next.kind, curriculum::NextKind::kWait) << "there is no other";
    // More time for one of the group.
    store->courses().end_assignment(own);
    const int64_t earlier = assign(0, group, "2026-02-01");
    const int64_t longer = assign(anna, 0, "2026-06-01");
    EXPECT_EQ(held(anna, kNow).assignment.id, longer);
    EXPECT_FALSE(held(anna, kNow).next.overdue);
    EXPECT_EQ(held(jan, kNow).assignment.id, earlier);
    EXPECT_TRUE(held(jan, kNow).next.overdue);
}

/// The store looks again when an exam begins and when it is saved.
TEST_P(CourseStore, AnExamIsOfTheAssignmentThatRuns) {
    const int64_t group = store->groups().create("A");
    store->groups().set_role(group, anna, GroupRole::kMember);
    assign(0, group);
    assign(anna, 0, "2099-05-01", "2099-04-01");
    attempt(anna, 80);
    const db::ExamOrder order = db::prepare_exam(*store, anna, "short", "final", "ewa", "", kNow);
    attempt(anna, 90, order.context, order.seed, "2026-02-03T00:00:00Z");
    EXPECT_EQ(store->attempts().list(anna).back().void_reason, "");
    const db::ExamOrder next = db::prepare_exam(*store, anna, "short", "final", "ewa", "", kNow);
    EXPECT_GT(db::begin_exam(*store, anna, next).context.begin, 0);
}

TEST_P(CourseStore, WhatCannotBeAssignedIsRefusedAndChangesNothing) {
    db::AssignmentRecord good;
    good.course_id = "short";
    good.course_version = 1;
    good.user_id = anna;
    const auto kind_of = [&](auto change) {
        db::AssignmentRecord bad = good;
        change(bad);
        return failure_of([&] { store->courses().assign(bad); }).kind();
    };
    EXPECT_EQ(kind_of([](auto& a) { a.course_version = 2; }), StoreError::Kind::kRefused);
    EXPECT_EQ(kind_of([](auto& a) { a.course_id = "none"; }), StoreError::Kind::kRefused);
    EXPECT_EQ(kind_of([](auto& a) { a.user_id = 0; }), StoreError::Kind::kRefused);
    EXPECT_EQ(kind_of([](auto& a) { a.group_id = 1; }), StoreError::Kind::kRefused);
    EXPECT_EQ(kind_of([](auto& a) { a.due_utc = "soon"; }), StoreError::Kind::kRefused);
    EXPECT_EQ(kind_of([](auto& a) { a.starts_utc = "2026-02-02", a.due_utc = "2026-02-01"; }),
              StoreError::Kind::kRefused);
    EXPECT_EQ(kind_of([](auto& a) {
                  a.starts_utc = "2026-02-02T08:00:00Z", a.due_utc = "2026-02-02T08:00:00Z";
              }),
              StoreError::Kind::kRefused)
        << "an hour has no end of its day";
    EXPECT_EQ(kind_of([](auto& a) { a.user_id = 99; }), StoreError::Kind::kNotFound);
    EXPECT_THAT(store->courses().assignments(0), IsEmpty());
}

TEST_P(CourseStore, OfManyEducatorsAtOnceOneAssigns) {
    constexpr int kPeople = 12, kEducators = 3;
    std::vector<int64_t> people;
    for (int i = 0; i < kPeople; ++i)
        people.push_back(add("p" + std::to_string(i), db::Role::kTrainee));
    std::barrier together(kEducators);
    std::atomic<int> assigned{0}, refused{0};
    std::vector<std::thread> educators;
    for (int i = 0; i < kEducators; ++i)
        educators.emplace_back([&] {
            const auto own = open();
            for (const int64_t person : people) {
                db::AssignmentRecord assignment;
                assignment.course_id = "short";
                assignment.course_version = 1;
                assignment.user_id = person;
                together.arrive_and_wait();
                try {
                    own->courses().assign(assignment);
                    ++assigned;
                } catch (const StoreError& error) {
                    if (error.kind() == StoreError::Kind::kConflict) ++refused;
                }
            }
        });
    for (std::thread& each : educators) each.join();
    EXPECT_EQ(assigned, kPeople);
    EXPECT_EQ(refused, kPeople * (kEducators - 1));
    for (const int64_t person : people) EXPECT_EQ(store->courses().assignments(person).size(), 1u);
}

TEST_P(CourseStore, ACourseMayLastOneDay) {
    const int64_t one_day = assign(anna, 0, "2026-03-01", "2026-03-01");
    const auto standing = db::course_standing(*store, anna, "short", "2026-03-01T23:00:00Z");
    EXPECT_EQ(standing.assignment.id, one_day);
    EXPECT_EQ(standing.next.kind, curriculum::NextKind::kStart);
    EXPECT_FALSE(standing.next.overdue) << "the day is due to its end";
}

TEST_P(CourseStore, AnAssignmentKeepsItsVersionWhenANewOneIsPublished) {
    assign(anna);
    publish(2, "1");
    const auto standing = db::course_standing(*store, anna, "short", kNow);
    EXPECT_EQ(standing.course.version, 1);
    EXPECT_EQ(standing.progress.stages[1].attempts_left, 3);
    EXPECT_EQ(db::course_standing(*store, jan, "short", kNow).course.version, 2) << "not assigned";
}

TEST_P(CourseStore, AGrantOpensAStageWhoseAttemptsAreUsed) {
    assign(anna);
    attempt(anna, 80);
    for (const char* day : {"2026-02-03", "2026-02-04", "2026-02-05"}) {
        const db::ExamOrder order =
            db::prepare_exam(*store, anna, "short", "final", "ewa", "", kNow);
        attempt(anna, 10, order.context, order.seed, day);
    }
    EXPECT_EQ(db::course_standing(*store, anna, "short", kNow).next.kind,
              curriculum::NextKind::kExhausted);
    EXPECT_EQ(failure_of([&] {
                  store->courses().grant_attempts({anna, "short", "final", 1, "", {}, {}});
              }).kind(),
              StoreError::Kind::kRefused)
        << "without a reason";
    store->courses().grant_attempts({anna, "short", "final", 2, "device was faulty", {}, {}});
    const auto standing = db::course_standing(*store, anna, "short", kNow);
    EXPECT_EQ(standing.next.kind, curriculum::NextKind::kExam);
    EXPECT_EQ(standing.next.attempts_left, 2);
    EXPECT_EQ(db::course_standing(*store, jan, "short", kNow).progress.stages[1].attempts_left, 3);
}

/// Practice from before the course counts, too: nobody could keep to a limit.
TEST_P(CourseStore, APracticeWithALimitIsNotPublishedAnyMoreAndReadWithoutItWhereItWas) {
    const std::string old =
        R"({"id":"old","version":1,"title":{"en":"Old"},"stages":[{"task_id":"diathermy_ring",)"
        R"("consecutive":1,"max_attempts":1}]})";
    EXPECT_THROW(store->definitions().publish({"course", "old", 1, old, {}, "test", {}, {}}),
                 curriculum::DefinitionError);
    RawConnection pen = raw();
    ASSERT_TRUE(
        pen.run("INSERT INTO definitions (kind, id, version, content, checksum, reason, "
                "published_by, published_utc) VALUES ('course', 'old', 1, '" +
                old + "', '" + db::checksum_hex(old) +
                "', 'of an older Placode', 'user 1', '2025-01-01T00:00:00Z')"))
        << pen.problem();
    for (int i = 0; i < 3; ++i) attempt(anna, 10);
    const auto own = [&] {
        return db::course_standing(*store, anna, "old", kNow).progress.stages[0];
    };
    EXPECT_EQ(own().status, curriculum::StageStatus::kOpen);
    EXPECT_EQ(own().attempts_left, -1);
    attempt(anna, 90);
    EXPECT_EQ(db::issue_certificate(*store, anna, "old", kNow).course_version, 1);
}

TEST_P(CourseStore, AnExamIsPreparedOnlyWhenAllIsThereAndLeadsToACertificate) {
    const auto refused = [&](const std::string& proctor) {
        return std::string(failure_of([&] {
                               (void)db::prepare_exam(*store, anna, "short", "final", proctor, "",
                                                      kNow);
                           }).what());
    };
    EXPECT_THAT(refused("P"), HasSubstr("not assigned"));
    assign(anna);
    EXPECT_THAT(refused("P"), HasSubstr("locked"));
    attempt(anna, 80);
    EXPECT_THAT(refused(""), HasSubstr("proctor"));
    EXPECT_THAT(refused("Dr N"), HasSubstr("\"Dr N\" has no account here"));
    EXPECT_THAT(refused("jan"), HasSubstr("no active educator"));
    EXPECT_THAT(refused("anna"), HasSubstr("no active educator"));
    EXPECT_THAT(failure_of([&] { db::issue_certificate(*store, anna, "short", kNow); }).what(),
                HasSubstr("not mastered yet. Exam, attempt 1"));
    const db::ExamOrder order = db::prepare_exam(*store, anna, "short", "final", "ewa", "", kNow);
    EXPECT_EQ(order.seed, 7u);
    EXPECT_EQ(order.task_id, "diathermy_ring");
    attempt(anna, 90, order.context, 3);
    EXPECT_EQ(db::course_standing(*store, anna, "short", kNow).progress.stages[1].attempts, 0)
        << "another seed";
    attempt(anna, 90, order.context, order.seed, "2026-02-03T00:00:00Z");
    ASSERT_EQ(store->attempts().list(anna).back().exam, order.context);
    const db::CertificateRecord issued = db::issue_certificate(*store, anna, "short", kNow);
    EXPECT_EQ(issued.mastered_utc, "2026-02-03T00:00:00Z");
    EXPECT_EQ(issued.code.size(), 16u);
    const db::CertificateRecord again = db::issue_certificate(*store, anna, "short", kNow);
    EXPECT_EQ(again.code, issued.code) << "one for each version";
    EXPECT_EQ(store->courses().certificates(0).size(), 1u);
    EXPECT_THAT(store->courses().certificates(jan), IsEmpty());
    EXPECT_EQ(db::course_standing(*store, anna, "short", kNow).certificate->id, issued.id);
}

/// "Attempts and certificates stay", whatever an educator publishes or ends.
TEST_P(CourseStore, ACertificateStaysWhereANewerVersionAsksForMore) {
    const int64_t held = assign(anna);
    attempt(anna, 80);
    const db::ExamOrder order = db::prepare_exam(*store, anna, "short", "final", "ewa", "", kNow);
    attempt(anna, 90, order.context, order.seed, "2026-02-03T00:00:00Z");
    const std::string code = db::issue_certificate(*store, anna, "short", kNow).code;
    store->courses().end_assignment(held);
    std::string longer = course_text(2);
    longer.insert(longer.rfind("]}"), R"(,{"task_id":"grasp_and_lift","consecutive":1})");
    store->definitions().publish({"course", "short", 2, longer, {}, "more", {}, {}});
    const db::CourseStanding now = db::course_standing(*store, anna, "short", kNow);
    ASSERT_EQ(now.course.version, 2);
    EXPECT_FALSE(now.progress.mastered);
    ASSERT_TRUE(now.certificate);
    EXPECT_EQ(now.certificate->code, code);
    const db::CertificateRecord again = db::issue_certificate(*store, anna, "short", kNow);
    EXPECT_EQ(again.code, code);
    EXPECT_EQ(again.course_version, 1) << "what is printed names its version";
    EXPECT_FALSE(db::course_standing(*store, jan, "short", kNow).certificate);
    // A row that SQL added names a version that was never published.
    ASSERT_TRUE(
        raw().run("INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, "
                  "issued_utc, issued_by, code) SELECT account_id, course_id, 99, mastered_utc, "
                  "issued_utc, issued_by, 'ABCD' FROM certificates"));
    EXPECT_EQ(db::issue_certificate(*store, anna, "short", kNow).code, code);
    // A version that is mastered as well has its own.
    publish(3);
    EXPECT_EQ(db::course_standing(*store, anna, "short", kNow).certificate->code, code);
    EXPECT_EQ(db::issue_certificate(*store, anna, "short", kNow).course_version, 3);
}

/// A case that became known is replaced by another one.
TEST_P(CourseStore, AnExamKeepsWhatWasPassedAndUsedWhenItsCasesAreReplaced) {
    const auto text = [](int version, const char* seeds) {
        return R"({"id":"seen","version":)" + std::to_string(version) +
               R"(,"title":{"en":"Seen"},"stages":[{"id":"final","task_id":"diathermy_ring",)"
               R"("mode":"exam","consecutive":1,"max_attempts":2,"exam":{"seeds":[)" +
               seeds + "]}}]}";
    };
    const auto publish_cases = [&](int version, const char* seeds) {
        store->definitions().publish(
            {"course", "seen", version, text(version, seeds), {}, "a case became known", {}, {}});
    };
    const auto own = [&](int64_t user) {
        return db::course_standing(*store, user, "seen", kNow).progress.stages[0];
    };
    publish_cases(1, "7,8");
    for (const int64_t user : {anna, jan}) {
        db::AssignmentRecord assignment;
        assignment.course_id = "seen";
        assignment.course_version = 1;
        assignment.user_id = user;
        const int64_t held = store->courses().assign(assignment);
        const db::ExamOrder order =
            db::prepare_exam(*store, user, "seen", "final", "ewa", "", kNow);
        ASSERT_EQ(order.seed, 7u);
        attempt(user, user == anna ? 90 : 10, order.context, order.seed, "2026-02-03T00:00:00Z");
        store->courses().end_assignment(held);
    }
    publish_cases(2, "17,8");
    EXPECT_EQ(own(anna).status, curriculum::StageStatus::kMastered);
    EXPECT_EQ(own(jan).status, curriculum::StageStatus::kOpen);
    EXPECT_EQ(own(jan).attempts, 1);
    EXPECT_EQ(own(jan).attempts_left, 1) << "what was used stays used";
    EXPECT_EQ(own(jan).next_seed, 17u);
}

TEST_P(CourseStore, APassedExamIsRefreshedThoughItsAttemptsAreUsed) {
    store->definitions().publish(
        {"course",
         "fades",
         1,
         R"({"id":"fades","version":1,"title":{"en":"Fades"},"stages":[{"id":"final",)"
         R"("task_id":"diathermy_ring","mode":"exam","consecutive":1,"max_attempts":1,)"
         R"("remind_after_days":30,"exam":{"seeds":[7,8]}}]})",
         {},
         "because",
         {},
         {}});
    db::AssignmentRecord assignment;
    assignment.course_id = "fades";
    assignment.course_version = 1;
    assignment.user_id = anna;
    store->courses().assign(assignment);
    const auto prepared = [&](const char* now) {
        return db::prepare_exam(*store, anna, "fades", "final", "ewa", "", now);
    };
    attempt(anna, 90, prepared("2026-02-03").context, 7, "2026-02-03T00:00:00Z");
    ASSERT_EQ(db::course_standing(*store, anna, "fades", "2026-03-06").next.kind,
              curriculum::NextKind::kRefresh);
    const db::ExamOrder again = prepared("2026-03-06");
    EXPECT_EQ(again.seed, 8u);
    attempt(anna, 90, again.context, again.seed, "2026-03-06T00:00:00Z");
    EXPECT_EQ(store->attempts().list(anna).back().void_reason, "");
    EXPECT_EQ(db::course_standing(*store, anna, "fades", "2026-03-07").next.kind,
              curriculum::NextKind::kFinished);
}

TEST_P(CourseStore, WhatAScriptShowedPassesNothingWhateverTheRowsSay) {
    assign(anna);
    attempt(anna, 80);
    const db::ExamOrder order = db::prepare_exam(*store, anna, "short", "final", "ewa", "", kNow);
    attempt(anna, 90, order.context, order.seed, "2026-02-03T00:00:00Z");
    const auto progress = [&] { return db::course_standing(*store, anna, "short", kNow).progress; };
    ASSERT_TRUE(progress().mastered);
    RawConnection pen = raw();
    for (const char* column : {"demonstration", "generated_from"}) {
        const std::string set = std::string("UPDATE attempts SET ") + column;
        ASSERT_TRUE(pen.run(set + " = 1 WHERE exam_course <> ''")) << pen.problem();
        EXPECT_FALSE(progress().mastered) << column;
        EXPECT_EQ(progress().stages[1].attempts, 1) << "a case was seen";
        ASSERT_TRUE(pen.run(set + " = 0 WHERE exam_course <> ''"));
        EXPECT_TRUE(progress().mastered);
    }
}

/// Given up is what the person left or tuned, not what a crash or a slow computer took away.
TEST(Outcomes, AreGivenUpByThePersonAlone) {
    const auto given_up = [](const auto& change) {
        db::AttemptRecord attempt;
        attempt.end = sim::EndReason::kInterrupted;
        attempt.duration_s = 30;
        change(attempt);
        return db::outcomes_of({attempt}).front().given_up;
    };
    const auto voided = [](db::AttemptRecord& a, db::VoidCause cause) {
        const std::vector<db::VoidReason> why{{cause, 8, 20, {}}};
        a.void_reason = db::void_text(why);
        a.void_meaning = db::void_meaning(why);
    };
    EXPECT_TRUE(given_up([](db::AttemptRecord&) {})) << "left";
    EXPECT_FALSE(given_up([](db::AttemptRecord& a) { a.ended = false; })) << "a crash";
    EXPECT_FALSE(given_up([](db::AttemptRecord& a) { a.end = sim::EndReason::kFinished; }));
    EXPECT_FALSE(given_up([](db::AttemptRecord& a) { a.end = sim::EndReason::kClosed; }));
    EXPECT_FALSE(given_up([](db::AttemptRecord& a) { a.duration_s = 9; }));
    EXPECT_FALSE(given_up([](db::AttemptRecord& a) {
        a.verdict = assessment::Verdict::kNotAttempted;
    })) << "nothing was done";
    EXPECT_TRUE(given_up([](db::AttemptRecord& a) {
        a.duration_s = 9;
        a.verdict = assessment::Verdict::kFailed;
    })) << "critical";
    EXPECT_FALSE(given_up([&](db::AttemptRecord& a) { voided(a, db::VoidCause::kFewPictures); }));
    EXPECT_TRUE(given_up([&](db::AttemptRecord& a) { voided(a, db::VoidCause::kTuned); }));
    EXPECT_FALSE(given_up([&](db::AttemptRecord& a) {
        voided(a, db::VoidCause::kTuned);
        a.duration_s = 5;
        a.verdict = assessment::Verdict::kFailed;  // whatever was tuned is
    }));
}

TEST_P(CourseStore, ThePracticeThatWasLeftEndsTheRow) {
    assign(anna);
    const auto practised = [&](double points, sim::EndReason end, uint64_t hash, const char* at) {
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.header.started_utc = at;
        result.score.points = points;
        result.score.verdict = assessment::Verdict::kPassed;
        result.end.reason = end;
        result.end.duration_s = 40;
        result.end.final_hash = hash;
        return store->attempts().save(anna, result);
    };
    const auto streak = [&] {
        return db::course_standing(*store, anna, "short", kNow).progress.stages[0].streak;
    };
    practised(80, sim::EndReason::kFinished, 11, "2026-02-01T00:00:00Z");
    practised(80, sim::EndReason::kInterrupted, 0, "2026-02-02T00:00:00Z");
    EXPECT_EQ(streak(), 1) << "a crash is nobody's fault";
    practised(80, sim::EndReason::kInterrupted, 13, "2026-02-03T00:00:00Z");
    EXPECT_EQ(streak(), 0);
}

TEST_P(CourseStore, AClockThatIsSetBackMakesNoRow) {
    store->definitions().publish(
        {"course",
         "row",
         1,
         R"({"id":"row","version":1,"title":{"en":"Row"},"stages":[{"task_id":"diathermy_ring",)"
         R"("consecutive":2}]})",
         {},
         "because",
         {},
         {}});
    const auto own = [&] {
        return db::course_standing(*store, anna, "row", kNow).progress.stages[0];
    };
    attempt(anna, 90, {}, 1, "2026-02-01T10:00:00Z");
    attempt(anna, 10, {}, 1, "2026-02-01T10:10:00Z");
    attempt(anna, 90, {}, 1, "2026-02-01T10:05:00Z");
    EXPECT_EQ(own().streak, 0);
    EXPECT_EQ(own().status, curriculum::StageStatus::kOpen) << "by its clock before the bad one";
    EXPECT_EQ(own().attempts, 3);
    attempt(anna, 90, {}, 1, "2026-02-01T10:20:00Z");
    EXPECT_EQ(own().streak, 1);
    attempt(anna, 90, {}, 1, "2026-02-01T10:30:00Z");
    EXPECT_EQ(own().status, curriculum::StageStatus::kMastered);
}

/// Attempts at the one stage of a course that asks for two in a row, numbered as they were saved.
class RowOfTwo : public testing::Test {
 protected:
    void SetUp() override {
        course.stages.resize(1);
        course.stages[0].id = course.stages[0].task_id = "ring";
    }
    /// @param at_s when it began, by some clock.
    void add(double points, int64_t at_s) {
        db::AttemptRecord made;
        made.id = static_cast<int64_t>(attempts.size()) + 1;
        made.task_id = "ring";
        made.points = points;
        made.duration_s = 60;
        made.started_utc = curriculum::utc_text(kFirst + at_s);
        attempts.push_back(std::move(made));
    }
    [[nodiscard]] curriculum::StageProgress own() const {
        std::vector<db::AttemptRecord> listed = attempts;
        std::sort(listed.begin(), listed.end(), [](const auto& a, const auto& b) {
            return std::tie(a.started_utc, a.id) < std::tie(b.started_utc, b.id);
        });
        return curriculum::course_progress(course, db::outcomes_of(listed)).stages[0];
    }
    [[nodiscard]] bool mastered() const {
        return own().status == curriculum::StageStatus::kMastered;
    }

    static constexpr int64_t kFirst = 1'767'000'000;
    curriculum::Course course;
    std::vector<db::AttemptRecord> attempts;
};

TEST_F(RowOfTwo, NoOrderOfClocksMakesARowThatTheOrderOfSavingDoesNot) {
    std::mt19937 random(7);
    const auto one_of = [&random](unsigned count) {
        return static_cast<int64_t>(random() % count);
    };
    int mastered_all_the_same = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        attempts.clear();
        int row = 0;
        bool two = false;
        for (int i = 0; i < 8; ++i) {
            const bool good = one_of(2) == 0, left = one_of(6) == 0;
            add(good ? 90 : 10, 600 * i);
            if (left) attempts.back().end = sim::EndReason::kInterrupted;
            row = good && !left ? row + 1 : 0;
            two = two || row == 2;
        }
        ASSERT_EQ(mastered(), two) << trial << ", by clocks that are right";
        for (db::AttemptRecord& each : attempts)
            each.started_utc = curriculum::utc_text(kFirst + one_of(86400));
        if (mastered()) {
            ASSERT_TRUE(two) << trial;
            ++mastered_all_the_same;
        }
    }
    EXPECT_GT(mastered_all_the_same, 0);
}

TEST_F(RowOfTwo, WhatWaitedForAServerLosesOneStepOfAll) {
    add(90, 86400);  // meanwhile, at another computer
    add(90, 0);
    EXPECT_EQ(own().streak, 1) << "it ends no row";
    add(90, 600);
    EXPECT_TRUE(mastered());
    attempts.clear();
    add(90, 86400);
    add(10, 0);
    EXPECT_EQ(own().streak, 0) << "late or not, it missed";
}

TEST_F(RowOfTwo, AClockThatWasFoundWrongMakesNothingLate) {
    add(90, 0);
    add(90, 365 * 86400);
    const std::vector<db::VoidReason> why{{db::VoidCause::kClock, 0, 0, {}}};
    attempts.back().void_reason = db::void_text(why);
    attempts.back().void_meaning = db::void_meaning(why);
    add(90, 600);
    EXPECT_TRUE(mastered());
}

TEST_P(CourseStore, AnExamOnAHapticLoopThatFailedIsVoidForCause) {
    assign(anna);
    attempt(anna, 80);
    const db::ExamOrder order = db::prepare_exam(*store, anna, "short", "final", "ewa", "", kNow);
    haptics::HapticCertificate loop;
    loop.force = true;
    loop.ticks = 60'000;
    loop.duration_s = 60;
    const std::string sound = haptics::certificate_to_json(loop);
    loop.gaps = 40;
    loop.faults = 1;
    const std::string bad = haptics::certificate_to_json(loop);
    const auto save = [&](const db::ExamContext& exam, const std::string& haptics) {
        const uint64_t due =
            db::course_standing(*store, anna, "short", kNow).progress.stages[1].next_seed;
        attempt(anna, 90, exam, due, "2026-02-03T00:00:00Z", haptics);
        return store->attempts().list(anna).back();
    };
    const auto exams = [&] {
        return db::course_standing(*store, anna, "short", kNow).progress.stages[1].attempts;
    };
    const db::AttemptRecord failed = save(order.context, bad);
    EXPECT_EQ(failed.haptic_grade, "bad");
    EXPECT_THAT(failed.void_reason, HasSubstr("40 drop-outs"));
    EXPECT_THAT(failed.void_reason, HasSubstr("1 device faults"));
    const auto why = db::why_void(failed);
    ASSERT_EQ(why.size(), 2u);
    EXPECT_STREQ(why[0].detail.sentence(), "%1 drop-outs of more than 5 ms (at most %2 a minute)");
    EXPECT_STREQ(why[1].detail.sentence(), "%1 device faults (at most %2)");
    EXPECT_EQ(exams(), 0) << "it uses up no attempt";
    EXPECT_EQ(store->attempts().detail(failed.id).haptic_certificate, bad)
        << "kept with the attempt";
    EXPECT_EQ(store->audit().trail(1).front().action, "attempt.void");
    const db::AttemptRecord damaged = save(order.context, "{damaged");
    EXPECT_THAT(damaged.void_reason, HasSubstr("cannot be read"));
    // What it says of itself does not count.
    std::string flattered = bad;
    flattered.replace(flattered.find("\"grade\":\"bad\""), 13, "\"grade\":\"sound\"");
    EXPECT_NE(save(order.context, flattered).void_reason, "");
    EXPECT_EQ(exams(), 2) << "it was given back once";
    const db::AttemptRecord practice = save({}, bad);
    EXPECT_EQ(practice.haptic_grade, "bad");
    EXPECT_EQ(practice.void_reason, "") << "only an exam is declared void";
    const db::AttemptRecord counted = save(order.context, sound);
    EXPECT_EQ(counted.haptic_grade, "sound");
    EXPECT_EQ(counted.void_reason, "");
    EXPECT_EQ(exams(), 3);
    for (const auto& standing : store->attempts().standings(0))
        if (standing.user_id == anna) {
            EXPECT_EQ(standing.attempts, 3) << "two practices and one exam";
        }
}

TEST_P(CourseStore, APublishedCourseCannotBeChangedAndEverythingLeavesATrace) {
    db::DefinitionRecord other;
    other.kind = "course";
    other.id = "short";
    other.version = 1;
    other.json = course_text(1, "9");
    EXPECT_EQ(failure_of([&] { store->definitions().publish(other); }).kind(),
              StoreError::Kind::kConflict);
    EXPECT_FALSE(raw().run("UPDATE definitions SET content = 'x'"));
    const int64_t group = store->groups().create("A");
    store->groups().set_role(group, anna, GroupRole::kMember);
    store->courses().end_assignment(assign(anna));
    store->courses().grant_attempts({anna, "short", "final", 1, "why", {}, {}});
    std::vector<std::string> actions;
    for (const auto& entry : store->audit().trail(10)) actions.push_back(entry.action);
    EXPECT_THAT(actions,
                testing::IsSupersetOf({"course.publish", "group.create", "group.member",
                                       "course.assign", "course.unassign", "course.grant"}));
}

TEST_P(CourseStore, AShippedCourseIsPublishedOnFirstUse) {
    const auto course = db::find_course(*store, "full_dissection");
    db::publish_course_on_first_use(*store, course);
    db::publish_course_on_first_use(*store, course);
    EXPECT_EQ(store->definitions().find("course", "full_dissection")->json, course.json);
    EXPECT_THAT(db::course_ids(*store),
                ElementsAre("first_steps", "full_dissection", "short", "suturing", "whole_repair"));
    EXPECT_THROW((void)db::find_course(*store, "none"), curriculum::DefinitionError);
    EXPECT_THROW((void)db::find_course(*store, "full_dissection", 9), curriculum::DefinitionError);
}

}  // namespace THIS_TEST
