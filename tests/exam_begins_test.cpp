// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An exam that was begun has used up an attempt, and what is saved as an exam is the one that was
// begun, on both engines.

#include <gmock/gmock.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

#include "curriculum/shipped_definitions.h"
#include "curriculum/utc_time.h"
#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "db/evidence.h"
#include "db/recording_order.h"
#include "db/sql_connection.h"
#include "tests/exam_course.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kTask = "touch_targets";

class ExamBegins : public EngineTest {
 protected:
    void ready() override {
        store = open();
        anna = add("anna", db::Role::kTrainee);
        add("ewa", db::Role::kEducator);
        publish_exam(*store, kTask, "7,8", R"("max_attempts":2,)");
        assignment = assign_exam(*store, anna);
    }
    int64_t add(const std::string& login, db::Role role) const {
        return store->accounts().create(
            {login, "Dr " + login, "long enough 1", static_cast<db::Roles>(role), false});
    }
    [[nodiscard]] static std::string later(int64_t seconds) {
        return curriculum::utc_text(*curriculum::utc_seconds(db::utc_now()) + seconds);
    }
    [[nodiscard]] db::ExamOrder prepared(db::Store& at, const std::string& proctor = {}) const {
        return db::prepare_exam(at, anna, "short", "final", proctor, "", db::utc_now());
    }
    [[nodiscard]] db::ExamOrder begun() const {
        return db::begin_exam(*store, anna, prepared(*store));
    }
    [[nodiscard]] db::AttemptResult result_of(const db::ExamOrder& order) const {
        db::AttemptResult result;
        result.header.task_id = order.task_id;
        result.header.task_version = curriculum::shipped_task(kTask)->version;
        result.header.seed = order.seed;
        result.header.mode = "exam";
        result.header.started_utc = db::utc_now();
        result.end.reason = sim::EndReason::kFinished;
        result.end.duration_s = 60;
        result.score.points = 90;
        result.score.verdict = assessment::Verdict::kPassed;
        result.exam = order.context;
        return result;
    }
    /// As the shell does: with the order that lies beside the recording.
    db::AttemptRecord keep(db::AttemptResult result, int64_t user = 0) {
        const std::string text = "order " + std::to_string(++files);
        record_to(folder.file("exam" + std::to_string(files) + ".placode"), result,
                  db::order_checksum(text));
        result.order = text;
        const int64_t id = store->attempts().save(user == 0 ? anna : user, result);
        replay_as_identical(*store, id);
        return store->attempts().detail(id).record;
    }
    /// As an import does, with a proctor.
    db::AttemptRecord take(db::AttemptResult result) const {
        result.exam.proctor = "ewa";
        const int64_t id = save_recorded(*store, anna, result, folder.path().string());
        return store->attempts().detail(id).record;
    }
    [[nodiscard]] curriculum::CourseProgress progress() const {
        return db::course_standing(*store, anna, "short", db::utc_now()).progress;
    }
    [[nodiscard]] curriculum::StageProgress stage() const { return progress().stages.front(); }

    std::unique_ptr<db::Store> store;
    int64_t anna = 0, assignment = 0;
    int files = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, ExamBegins, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(ExamBegins, WhoKillsShellAndSimulatorHasUsedUpTheAttempt) {
    const db::ExamOrder first = begun();
    EXPECT_GT(first.context.begin, 0);
    EXPECT_EQ(store->audit().trail(1).front().action, "exam.begin");
    EXPECT_EQ(store->audit().trail(1).front().object, "short/final");
    // Nothing was saved, and the store was opened again.
    store = open();
    EXPECT_EQ(stage().attempts, 1);
    EXPECT_EQ(stage().unfinished, 1) << "begun, not finished";
    EXPECT_EQ(stage().attempts_left, 1);
    EXPECT_EQ(stage().next_seed, 8u) << "the case was seen";
    (void)begun();
    EXPECT_THAT(failure_of([&] { (void)begun(); }).what(), HasSubstr("all attempts are used"));
    ASSERT_EQ(store->courses().exam_begins(anna).size(), 2u);
    EXPECT_EQ(store->courses().exam_begins(anna)[0].attempt_id, 0);
    // An educator gives one back, with a reason.
    store->courses().grant_attempts({anna, "short", "final", 1, "a power cut", {}, {}});
    EXPECT_EQ(stage().attempts_left, 1);
    EXPECT_EQ(begun().seed, 7u);
    EXPECT_EQ(store->check(), std::vector<std::string>{});
}

TEST_P(ExamBegins, SavingTheAttemptEndsTheBegin) {
    const db::AttemptRecord kept = keep(result_of(begun()));
    EXPECT_EQ(kept.void_reason, "");
    EXPECT_TRUE(db::counts(kept));
    EXPECT_EQ(stage().attempts, 1);
    EXPECT_EQ(stage().unfinished, 0);
    EXPECT_TRUE(progress().mastered);
    EXPECT_EQ(store->courses().exam_begins(anna).at(0).attempt_id, kept.id);
    EXPECT_EQ(kept.exam.begin, store->courses().exam_begins(anna).at(0).id);
}

TEST_P(ExamBegins, OneBeginIsTheExamOfOneAttempt) {
    const db::ExamOrder order = begun();
    ASSERT_TRUE(db::counts(keep(result_of(order))));
    const db::AttemptRecord second = keep(result_of(order));
    EXPECT_FALSE(db::counts(second));
    EXPECT_THAT(second.void_reason, HasSubstr("it was not begun here, or is saved already"));
    EXPECT_EQ(second.exam.begin, 0);
}

TEST_P(ExamBegins, WhatWasNotBegunIsNoExam) {
    db::AttemptResult made_up = result_of(prepared(*store));
    EXPECT_FALSE(db::counts(keep(made_up)));
    made_up.exam.begin = 99;
    EXPECT_FALSE(db::counts(keep(made_up)));
    EXPECT_FALSE(progress().mastered);
}

TEST_P(ExamBegins, AnImportedExamNeedsTheWordOfSomebodyWhoIsNotExamined) {
    const int64_t adam = add("adam", db::Role::kAdministrator);
    // Whoever that is: a program, the account itself, an administrator.
    const auto imported_by = [&](int64_t account) {
        const auto at = open();
        if (account != 0) at->act_for(account);
        db::AttemptResult result = result_of(prepared(*store));
        record_to(folder.file("import" + std::to_string(++files) + ".placode"), result);
        const int64_t id = at->attempts().save(anna, result);
        replay_as_identical(*store, id);
        return store->attempts().detail(id).record;
    };
    for (const int64_t nobody : {int64_t{0}, anna}) {
        const db::AttemptRecord kept = imported_by(nobody);
        EXPECT_FALSE(db::counts(kept)) << nobody;
        EXPECT_THAT(kept.void_reason,
                    HasSubstr("neither a proctor nor an administrator vouches for it"));
        EXPECT_FALSE(progress().mastered);
        store->courses().grant_attempts({anna, "short", "final", 1, "for the test", {}, {}});
    }
    const db::AttemptRecord kept = imported_by(adam);
    EXPECT_TRUE(db::counts(kept)) << kept.void_reason;
    EXPECT_TRUE(progress().mastered);
}

TEST_P(ExamBegins, TheBeginProvesItsProctorWhoseAccountIsClosedSince) {
    add("ola", db::Role::kEducator);
    db::AttemptResult result = result_of(db::begin_exam(*store, anna, prepared(*store, "ewa")));
    const auto ewa = store->accounts().find_staff("ewa");
    ASSERT_TRUE(ewa);
    store->accounts().set_active(ewa->id, false);
    // Whom the order names makes no difference any more.
    result.exam.proctor = "ola";
    const db::AttemptRecord kept = keep(result);
    EXPECT_EQ(kept.void_reason, "");
    EXPECT_TRUE(db::counts(kept));
    EXPECT_EQ(kept.exam.proctor, "Dr ewa");
    // Of an import nothing else says so.
    EXPECT_THAT(take(result_of(prepared(*store))).void_reason,
                HasSubstr("the proctor is the person examined, or neither educator"));
}

/// Begins bear the time of the store's clock, recordings that of a station's.
TEST_P(ExamBegins, AStationWhoseClockIsMinutesOffDoesNotReorderTheCases) {
    store->courses().grant_attempts({anna, "short", "final", 1, "for the test", {}, {}});
    db::AttemptResult first = result_of(begun());
    EXPECT_EQ(first.header.seed, 7u);
    first.header.started_utc = later(240);
    first.score.verdict = assessment::Verdict::kFailed;
    ASSERT_TRUE(db::counts(keep(first)));
    EXPECT_EQ(begun().seed, 8u);  // and nothing was saved
    EXPECT_EQ(stage().next_seed, 7u) << "the case after the one that was begun last";
}

TEST_P(ExamBegins, ABeginIsForItsPersonCaseAndStageOnly) {
    const db::ExamOrder order = begun();
    db::AttemptResult other = result_of(order);
    other.header.seed = 8;
    EXPECT_THAT(keep(other).void_reason, HasSubstr("another case is due by now"));
    const int64_t jan = add("jan", db::Role::kTrainee);
    assign_exam(*store, jan);
    EXPECT_THAT(keep(result_of(order), jan).void_reason, HasSubstr("it was not begun here"));
}

/// The case of the begin was seen, whatever recording lies in its place.
TEST_P(ExamBegins, AnotherRecordingInItsPlaceGivesNoExamBack) {
    db::AttemptResult other = result_of(begun());
    other.header.seed = 99;
    EXPECT_FALSE(db::counts(keep(other)));
    EXPECT_NE(store->courses().exam_begins(anna).at(0).attempt_id, 0) << "it has its attempt";
    EXPECT_EQ(stage().attempts, 1);
    EXPECT_EQ(stage().next_seed, 8u);
    other = result_of(begun());
    other.header.task_id = "trace_contour";
    EXPECT_FALSE(db::counts(keep(other)));
    EXPECT_EQ(stage().attempts, 2);
    EXPECT_EQ(stage().attempts_left, 0);
    EXPECT_EQ(stage().next_seed, 7u);
    EXPECT_FALSE(progress().mastered);
}

TEST_P(ExamBegins, AnOrderWithoutTheCertificateGivesNoExamBack) {
    std::string course = exam_course(kTask, "7,8");
    const std::string id = "short", proctor = R"("proctor":false)";
    course.replace(course.find(proctor), proctor.size(), proctor + R"(,"haptic_certificate":true)");
    course.replace(course.find(id), id.size(), "sound");
    store->definitions().publish({"course", "sound", 1, course, {}, "test", {}, {}});
    db::AssignmentRecord assigned;
    assigned.course_id = "sound";
    assigned.course_version = 1;
    assigned.user_id = anna;
    store->courses().assign(assigned);
    db::AttemptResult result = result_of(db::begin_exam(
        *store, anna,
        db::prepare_exam(*store, anna, "sound", "final", "", "a certificate", db::utc_now())));
    result.score.points = 10;
    result.score.verdict = assessment::Verdict::kFailed;
    result.exam.device_certificate.clear();
    (void)keep(result);
    const auto standing = db::course_standing(*store, anna, "sound", db::utc_now());
    EXPECT_EQ(standing.progress.stages.front().attempts, 1);
    EXPECT_EQ(standing.progress.stages.front().next_seed, 8u);
    EXPECT_FALSE(standing.progress.mastered);
}

/// As somebody writes it by SQL.
TEST_P(ExamBegins, NorDoesARowThatSaysSomethingElseThanItsBegin) {
    (void)keep(result_of(begun()));
    ASSERT_TRUE(progress().mastered);
    for (const char* other : {"seed = '99'", "task_id = 'trace_contour'", "exam_stage = 'other'",
                              "demonstration = 1, exam_course = ''"}) {
        ASSERT_TRUE(raw().run(std::string("UPDATE attempts SET ") + other)) << other;
        EXPECT_EQ(stage().attempts, 1) << other;
        EXPECT_EQ(stage().next_seed, 8u) << other;
        EXPECT_FALSE(progress().mastered) << other;
    }
}

/// As somebody adds it who names the begin and says that it is practice: it would count at once.
TEST_P(ExamBegins, WhatEndsABeginCountsOnceItWasSimulatedAgainWhateverItSays) {
    (void)keep(result_of(begun()));
    const auto say = [&](const char* what) {
        EXPECT_TRUE(raw().run(std::string("UPDATE attempts SET ") + what)) << what;
        EXPECT_EQ(stage().attempts, 1) << what;
        EXPECT_EQ(stage().next_seed, 8u) << what;
        return progress().mastered;
    };
    EXPECT_FALSE(say("replay = 0, exam_course = ''"));
    EXPECT_FALSE(say("replay = 0, exam_course = 'short'"));
    EXPECT_FALSE(say("replay = 1, exam_course = 'short'")) << "it waits";
    EXPECT_FALSE(say("replay = 2, exam_course = ''"));
    EXPECT_TRUE(say("replay = 2, exam_course = 'short'"));
}

TEST_P(ExamBegins, TwoStationsDoNotBeginTheSameAttempt) {
    const auto elsewhere = open();
    const db::ExamOrder here = prepared(*store), there = prepared(*elsewhere);
    (void)db::begin_exam(*store, anna, here);
    EXPECT_EQ(failure_of([&] { (void)db::begin_exam(*elsewhere, anna, there); }).kind(),
              StoreError::Kind::kConflict)
        << "another case is due";
    const db::ExamOrder last = prepared(*elsewhere);
    (void)db::begin_exam(*store, anna, prepared(*store));
    EXPECT_THAT(failure_of([&] { (void)db::begin_exam(*elsewhere, anna, last); }).what(),
                HasSubstr("all attempts are used"));
}

TEST_P(ExamBegins, OfManyAtOnceOneBeginsTheLastAttempt) {
    (void)begun();
    const db::ExamOrder last = prepared(*store);
    std::atomic<int> begins{0};
    std::vector<std::thread> stations;
    for (int i = 0; i < 4; ++i)
        stations.emplace_back([&] {
            const auto own = open();
            try {
                (void)db::begin_exam(*own, anna, last);
                ++begins;
            } catch (const StoreError&) {
                // Somebody else did.
            }
        });
    for (std::thread& each : stations) each.join();
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(stage().attempts, 2);
}

TEST_P(ExamBegins, OfAnImportAttemptsCaseAndAssignmentAreLookedUpWhenItIsSaved) {
    // Two stations of an older program: nobody wrote down that they began.
    const db::ExamOrder one = prepared(*store), two = prepared(*store);
    db::AttemptResult poor = result_of(one);
    poor.score.verdict = assessment::Verdict::kFailed;
    EXPECT_TRUE(db::counts(take(poor)));
    const db::AttemptRecord second = take(result_of(two));
    EXPECT_FALSE(db::counts(second));
    EXPECT_THAT(second.void_reason, HasSubstr("it is not the exam that was open, another case is "
                                              "due by now"));
    const db::AttemptRecord third = take(result_of(two));
    EXPECT_THAT(third.void_reason, HasSubstr("all attempts are used"));
    store->courses().grant_attempts({anna, "short", "final", 2, "for the test", {}, {}});
    const db::ExamOrder last = prepared(*store);
    store->courses().end_assignment(assignment);
    const db::AttemptRecord unassigned = take(result_of(last));
    EXPECT_FALSE(db::counts(unassigned));
    EXPECT_THAT(unassigned.void_reason, HasSubstr("the course is not assigned to this person"));
}

/// Nobody loses an honest exam to what an educator does while it runs.
TEST_P(ExamBegins, WhatChangesWhileAnExamRunsDoesNotVoidIt) {
    const db::ExamOrder first = begun();
    store->courses().end_assignment(assignment);
    const db::AttemptRecord unassigned = keep(result_of(first));
    EXPECT_EQ(unassigned.void_reason, "");
    EXPECT_TRUE(db::counts(unassigned));
    EXPECT_TRUE(progress().mastered);
    // The person has the next version by the time that it is saved: other cases, one attempt.
    (void)assign_exam(*store, anna);
    const db::ExamOrder second = begun();
    std::string newer = exam_course(kTask, "17,18", R"("max_attempts":1,)");
    newer.replace(newer.find(R"("version":1)"), 11, R"("version":2)");
    store->definitions().publish({"course", "short", 2, newer, {}, "other cases", {}, {}});
    store->courses().end_assignment(store->courses().assignments(anna).at(0).id);
    db::AssignmentRecord next;
    next.course_id = "short";
    next.course_version = 2;
    next.user_id = anna;
    store->courses().assign(next);
    const db::AttemptRecord replaced = keep(result_of(second));
    EXPECT_EQ(replaced.void_reason, "");
    EXPECT_TRUE(db::counts(replaced));
    EXPECT_EQ(replaced.exam.course_version, 1);
    // Another case is none of it, as ever.
    db::AttemptResult other = result_of(begun());
    EXPECT_EQ(other.header.seed, 17u);
    other.header.seed = 18;
    EXPECT_THAT(keep(other).void_reason, HasSubstr("another case is due by now"));
}

TEST_P(ExamBegins, ARecordingWhoseClockIsWrongDoesNotCount) {
    const auto at = [&](const std::string& started_utc) {
        store->courses().grant_attempts({anna, "short", "final", 1, "for the test", {}, {}});
        db::AttemptResult result = result_of(begun());
        result.header.started_utc = started_utc;
        return keep(result);
    };
    for (const std::string& wrong :
         {later(-86400), later(-400), later(400), later(86400), std::string("yesterday")}) {
        const db::AttemptRecord kept = at(wrong);
        EXPECT_FALSE(db::counts(kept)) << wrong;
        EXPECT_THAT(kept.void_reason, HasSubstr("the time that it says cannot be right, " + wrong));
    }
    EXPECT_TRUE(db::counts(at(later(-60)))) << "clocks differ a little";
    // Practice from the future would put off when a skill is to be refreshed.
    db::AttemptResult practice = result_of(prepared(*store));
    practice.exam = {};
    practice.header.mode = "practice";
    practice.header.started_utc = later(86400);
    EXPECT_FALSE(db::counts(keep(practice)));
    practice.header.started_utc = later(-86400);
    EXPECT_TRUE(db::counts(keep(practice))) << "kept by a crash, saved on the next day";
}

TEST_P(ExamBegins, AnOlderVersionOfTheTaskIsNoExam) {
    db::DefinitionRecord task;
    task.kind = "task";
    task.id = kTask;
    task.version = curriculum::shipped_task(kTask)->version;
    task.json = curriculum::shipped_task(kTask)->json;
    store->definitions().publish(task);
    db::AttemptResult older = result_of(begun());
    older.header.task_version = task.version + 1;
    const db::AttemptRecord kept = keep(older);
    EXPECT_FALSE(db::counts(kept));
    EXPECT_THAT(kept.void_reason, HasSubstr("the exam asked for another version than "));
    const db::ExamOrder order = prepared(*store);
    // A newer Placode published its text.
    ASSERT_TRUE(raw().run(
        "INSERT INTO definitions (kind, id, version, content, checksum, reason, published_by, "
        "published_utc) SELECT kind, id, version + 1, content, checksum, 'newer', published_by, "
        "published_utc FROM definitions WHERE kind = 'task'"));
    EXPECT_THAT(failure_of([&] { (void)db::begin_exam(*store, anna, order); }).what(),
                HasSubstr("update Placode"))
        << "the simulator here would perform the older one";
    EXPECT_THAT(take(result_of(order)).void_reason,
                HasSubstr("the exam asked for another version than touch_targets version " +
                          std::to_string(task.version)));
}

TEST_P(ExamBegins, AnotherTextOfATaskOfPlacodeIsNotPublished) {
    const auto shipped = curriculum::shipped_task(kTask);
    const auto publish = [&](const std::string& id, int version, const std::string& goal) {
        auto json = nlohmann::json::parse(shipped->json);
        json["id"] = id;
        json["version"] = version;
        json["title"]["en"] = goal;
        store->definitions().publish(
            {"task", id, version, json.dump(), {}, "the centre's", {}, {}});
    };
    for (const int version : {shipped->version, shipped->version + 1}) {
        const StoreError refused = failure_of([&] { publish(kTask, version, "Ours"); });
        EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused);
        EXPECT_THAT(refused.what(),
                    HasSubstr("touch_targets is a task of Placode itself, which has version " +
                              std::to_string(shipped->version) + " of it; give your text an id"));
    }
    publish("our_targets", shipped->version + 1, "Ours");
    // The program's own text is kept at its first use, and exams begin.
    db::publish_task_on_first_use(*store, kTask, shipped->version);
    EXPECT_TRUE(store->definitions().find("task", kTask));
    EXPECT_GT(begun().context.begin, 0);
}

TEST_P(ExamBegins, PracticeByAVersionThatANewerOneHadReplacedDoesNotCount) {
    const auto shipped = curriculum::shipped_task(kTask);
    const auto publish = [&](int version) {
        auto json = nlohmann::json::parse(shipped->json);
        json["id"] = "our_targets";
        json["version"] = version;
        store->definitions().publish(
            {"task", "our_targets", version, json.dump(), {}, "the centre's", {}, {}});
    };
    // By a program, which may take over what was recorded later.
    const auto practised = [&](const std::string& task, int version, int64_t after_s) {
        db::AttemptResult result = result_of(prepared(*store));
        result.exam = {};
        result.header.mode = "practice";
        result.header.task_id = task;
        result.header.task_version = version;
        result.header.started_utc = later(after_s);
        const int64_t id = save_recorded(*store, anna, result, folder.path().string());
        return store->attempts().detail(id).record;
    };
    publish(1);
    EXPECT_TRUE(db::counts(practised("our_targets", 1, 3600)));
    publish(2);
    const db::AttemptRecord older = practised("our_targets", 1, 3600);
    EXPECT_FALSE(db::counts(older));
    EXPECT_EQ(older.void_reason,
              "Practice, not verified: its task is not the published our_targets version 2");
    EXPECT_TRUE(db::counts(practised("our_targets", 1, -60))) << "begun before";
    EXPECT_TRUE(db::counts(practised("our_targets", 2, 3600)));
    // Another station has a newer Placode.
    db::publish_task_on_first_use(*store, kTask, shipped->version);
    ASSERT_TRUE(raw().run(
        "INSERT INTO definitions (kind, id, version, content, checksum, reason, published_by, "
        "published_utc) SELECT kind, id, version + 1, content, checksum, 'newer', published_by, "
        "published_utc FROM definitions WHERE kind = 'task' AND id = 'touch_targets'"));
    EXPECT_TRUE(db::counts(practised(kTask, shipped->version, 3600)))
        << "what this one ships counts until it is updated";
    EXPECT_FALSE(db::counts(practised(kTask, shipped->version - 1, 3600)));
}

TEST_P(ExamBegins, ACertificateNeedsTheMasteryThatTheRowsShow) {
    const auto issue = [&](int version) {
        return store->courses().save_certificate(anna, "short", version);
    };
    EXPECT_THAT(failure_of([&] { (void)issue(1); }).what(),
                HasSubstr("the course is not mastered"));
    EXPECT_THAT(failure_of([&] { (void)issue(2); }).what(), HasSubstr("is not published"));
    const db::AttemptRecord kept = keep(result_of(begun()));
    ASSERT_TRUE(db::counts(kept));
    EXPECT_EQ(issue(1).mastered_utc, store->courses().exam_begins(anna).at(0).begun_utc);
    EXPECT_EQ(store->courses().certificates(anna).size(), 1u);
}

TEST_P(ExamBegins, AtAStationWhoIsExaminedBeginsAndNobodyElse) {
    const auto station = open_at_station();
    ASSERT_EQ(station->accounts().sign_in("anna", "long enough 1").outcome, db::SignInOutcome::kOk);
    const db::ExamOrder order = db::begin_exam(*station, anna, prepared(*station));
    EXPECT_GT(order.context.begin, 0);
    EXPECT_EQ(station->courses().exam_begins(anna).size(), 1u);
    ASSERT_EQ(station->accounts().sign_in("ewa", "long enough 1").outcome, db::SignInOutcome::kOk);
    EXPECT_EQ(failure_of([&] { (void)station->courses().begin_exam(anna, order); }).kind(),
              StoreError::Kind::kRefused);
}

TEST_P(ExamBegins, ErasureTakesTheBeginsAlong) {
    (void)begun();
    add("ola", db::Role::kAdministrator);
    store->accounts().erase(anna, false);
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM exam_begins"), "0");
}

/// What was changed behind the store's back is found.
TEST_P(ExamBegins, ABeginIsSealed) {
    (void)begun();
    ASSERT_TRUE(raw().run("DELETE FROM exam_begins"));
    const auto problems = store->check();
    ASSERT_FALSE(problems.empty());
    EXPECT_THAT(problems.front(), HasSubstr("user " + std::to_string(anna) + " was changed"));
}

TEST_P(ExamBegins, ACertificateThatSqlAddedShowsNowhereBeforeTheCourseIsMastered) {
    ASSERT_TRUE(raw().run(
        "INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, "
        "issued_utc, issued_by, code) VALUES (" +
        std::to_string(anna) +
        ", 'short', 1, '2026-01-01T00:00:00Z', '2026-01-01T00:00:00Z', 'user 2', 'ABCD')"));
    EXPECT_FALSE(db::course_standing(*store, anna, "short", db::utc_now()).certificate);
    EXPECT_THAT(
        failure_of([&] { (void)store->courses().save_certificate(anna, "short", 1); }).what(),
        HasSubstr("the course is not mastered"));
    // Nor after, with that date: what is certified is what the attempts say.
    (void)keep(result_of(begun()));
    const db::CourseStanding mastered = db::course_standing(*store, anna, "short", db::utc_now());
    ASSERT_TRUE(mastered.progress.mastered);
    EXPECT_FALSE(mastered.certificate);
    const auto issue = [&] { return db::issue_certificate(*store, anna, "short", db::utc_now()); };
    EXPECT_THAT(failure_of([&] { (void)issue(); }).what(),
                HasSubstr("the certificate ABCD that is there says that the course was mastered at "
                          "2026-01-01T00:00:00Z, and the attempts say " +
                          mastered.progress.mastered_utc));
    ASSERT_TRUE(raw().run("DELETE FROM certificates"));
    EXPECT_EQ(issue().mastered_utc, mastered.progress.mastered_utc);
    EXPECT_EQ(issue().code, store->courses().certificates(anna).at(0).code);
    // Attempts that are verified later may show an earlier day: it stays the same certificate.
    ASSERT_TRUE(raw().run("UPDATE certificates SET mastered_utc = issued_utc"));
    EXPECT_EQ(issue().code, store->courses().certificates(anna).at(0).code);
}

TEST_P(ExamBegins, NoneBeginsAtAComputerThatNobodyVouchedFor) {
    if (is_sqlite()) GTEST_SKIP() << "whoever has the file vouches for its computer";
    ::setenv("PLACODE_STATION_KEY", folder.file("other.key").c_str(), 1);
    store = open();
    EXPECT_THAT(failure_of([&] { (void)begun(); }).what(), HasSubstr("nobody has vouched"));
    EXPECT_TRUE(store->courses().exam_begins(anna).empty());
}

/// A store from before there were begins.
TEST(ExamBeginsOfOldStores, AnOldStoreOpensAndItsExamsStayAsTheyWere) {
    TemporaryFolder folder;
    ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
    db::StoreOptions options;
    options.cheap_passwords = true;
    const std::string url = "sqlite:" + folder.file("placode.db");
    auto store = db::open_store(url, options);
    const int64_t anna = store->accounts().create(
        {"anna", "Anna", "long enough 1", static_cast<db::Roles>(db::Role::kTrainee), false});
    store->accounts().create(
        {"ewa", "Dr Ewa", "long enough 1", static_cast<db::Roles>(db::Role::kEducator), false});
    publish_exam(*store, kTask, "7,8", R"("max_attempts":2,)");
    assign_exam(*store, anna);
    db::AttemptResult result;
    result.header.task_id = kTask;
    result.header.seed = 7;
    result.score.verdict = assessment::Verdict::kPassed;
    result.exam = {"short", 1, "final", "ewa", ""};
    (void)save_recorded(*store, anna, result, folder.path().string());
    store.reset();
    RawConnection pen("QSQLITE", folder.file("placode.db"));
    for (const char* each :
         {"ALTER TABLE attempts DROP COLUMN read_by",
          "DELETE FROM schema_migrations WHERE name = '0019_readings.sql'",
          "DROP INDEX attempts_by_exam_begin", "ALTER TABLE attempts DROP COLUMN exam_begin",
          "DROP TABLE exam_begins",
          "DELETE FROM schema_migrations WHERE name = '0017_exam_begins.sql'"})
        ASSERT_TRUE(pen.run(each)) << pen.problem();
    store = db::open_store(url, options);
    EXPECT_EQ(store->check(), std::vector<std::string>{});
    const auto standing = db::course_standing(*store, anna, "short", db::utc_now());
    EXPECT_EQ(standing.progress.stages[0].attempts, 1);
    EXPECT_TRUE(standing.progress.mastered);
}

}  // namespace THIS_TEST
