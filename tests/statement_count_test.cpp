// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A server elsewhere takes 50 ms for each statement: what reads or writes many rows sends as many
// of them for thirty as for two. Nothing is timed: the statements are counted, on both engines.

#include "db/statement_count.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "db/attempt_counting.h"
#include "db/study_deviations.h"
#include "tests/statement_cost.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

namespace THIS_TEST {

class StatementCount : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        owner = open();
        anna = owner->accounts().create(trainee("anna"));
        bert = owner->accounts().create(trainee("bert"));
        db::NewUser teacher = trainee("coach");
        teacher.roles = static_cast<db::Roles>(db::Role::kEducator) |
                        static_cast<db::Roles>(db::Role::kCoordinator);
        coach = owner->accounts().create(teacher);
        // As people sit there: rights are asked, too.
        store = open_at_station();
        ASSERT_EQ(store->accounts().sign_in("coach", kPassword).outcome, db::SignInOutcome::kOk);
    }
    /// Half of them of each of two people, each with a remark.
    std::vector<int64_t> add_attempts(int n) {
        std::vector<int64_t> ids;
        for (int i = 0; i < n; ++i) {
            db::AttemptResult result = make_result();
            result.score.points = i;
            result.events.front().kind = sim::EventKind::kPaused;
            ids.push_back(owner->attempts().save(i % 2 == 0 ? anna : bert, result));
            owner->reviews().add_comment({0, ids.back(), coach, "", -1, std::to_string(i), ""});
        }
        return ids;
    }
    /// Each with a participant of its own, and one attempt.
    void add_participants(const std::string& study, int n) {
        for (int i = 0; i < n; ++i)
            (void)add_procedure(study, owner->studies().new_participant(study), "run");
    }
    int64_t add_procedure(const std::string& study, const std::string& code,
                          const std::string& name, const std::string& task = "diathermy_ring") {
        db::AttemptResult result = make_result(task);
        result.events.front().kind = sim::EventKind::kPaused;
        result.study = {study, code};
        db::StepRecord step;
        step.study_id = study;
        step.participant = code;
        step.step = name;
        step.attempt_id = owner->attempts().save(coach, result);
        owner->studies().record_step(step);
        return step.attempt_id;
    }

    std::unique_ptr<db::Store> owner, store;
    int64_t anna = 0, bert = 0, coach = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, StatementCount, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(StatementCount, EveryStatementCounts) {
    EXPECT_GT(cost_of([&] { (void)store->attempts().list(0); }), 1) << "the rights, and the rows";
    EXPECT_GT(cost_of([&] { owner->groups().create("Spring"); }), 3);
}

TEST_P(StatementCount, ManyAttemptsCostAsMuchAsTwo) {
    const std::vector<int64_t> ids = add_attempts(30), two{ids[0], ids[1]};
    std::map<int64_t, db::AttemptDetail> few, all;
    const int64_t of_two = cost_of([&] { few = store->attempts().details(two); });
    EXPECT_EQ(cost_of([&] { all = store->attempts().details(ids); }), of_two);
    EXPECT_LT(of_two, 10);
    ASSERT_THAT(few, SizeIs(2));
    ASSERT_THAT(all, SizeIs(30));
    for (size_t i = 0; i < ids.size(); ++i) {
        const db::AttemptDetail& here = all.at(ids[i]);
        EXPECT_EQ(here.record.id, ids[i]);
        EXPECT_EQ(here.record.user_id, i % 2 == 0 ? anna : bert);
        EXPECT_EQ(here.score.points, static_cast<double>(i));
        ASSERT_THAT(here.metrics.values, SizeIs(5));
        EXPECT_EQ(here.metrics.values[3].id, "third");
        EXPECT_EQ(here.metrics.values[3].value, -1.0 / 3.0);
        ASSERT_THAT(here.score.reasons, SizeIs(2));
        EXPECT_EQ(here.score.reasons[0].item, "dwell");
        EXPECT_EQ(here.score.reasons[0].meaning, make_result().score.reasons[0].meaning);
        ASSERT_THAT(here.events, SizeIs(2));
        EXPECT_EQ(here.events[0].kind, sim::EventKind::kPaused);
        EXPECT_EQ(here.events[1].kind, sim::EventKind::kDwell);
    }
    std::map<int64_t, db::AttemptRecord> records;
    const int64_t light = cost_of([&] { (void)store->attempts().records(two); });
    EXPECT_EQ(cost_of([&] { records = store->attempts().records(ids); }), light);
    EXPECT_LT(light, of_two);
    EXPECT_EQ(records.at(ids[7]).points, 7);
}

TEST_P(StatementCount, WhatIsNotThereIsLeftOutAndTwiceIsOnce) {
    const std::vector<int64_t> ids = add_attempts(1);
    EXPECT_THAT(store->attempts().details({ids[0], 4711, ids[0]}), SizeIs(1));
    EXPECT_THAT(store->attempts().details({}), IsEmpty());
    EXPECT_THAT(store->attempts().records({4711}), IsEmpty());
    EXPECT_THAT(store->reviews().comments_of({}), IsEmpty());
    // More than one question takes.
    std::vector<int64_t> many(ids);
    for (int64_t id = 10'000; id < 11'200; ++id) many.push_back(id);
    EXPECT_THAT(store->attempts().details(many), SizeIs(1));
}

TEST_P(StatementCount, OneAttemptOfSomebodyElseIsEnoughToBeRefused) {
    const std::vector<int64_t> ids = add_attempts(2);
    const auto own = open_at_station();
    ASSERT_EQ(own->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
    EXPECT_THAT(own->attempts().details({ids[0]}), SizeIs(1));
    for (const auto& ask : {std::function<void()>([&] { (void)own->attempts().details(ids); }),
                            std::function<void()>([&] { (void)own->attempts().records(ids); }),
                            std::function<void()>([&] { (void)own->reviews().comments_of(ids); })})
        EXPECT_EQ(failure_of(ask).kind(), db::StoreError::Kind::kRefused);
    // Of a study, beside an own one.
    add_participants("pilot", 1);
    const int64_t study = owner->studies().steps("pilot").front().attempt_id;
    EXPECT_EQ(failure_of([&] {
                  (void)own->attempts().details({ids[0], study});
              }).kind(),
              db::StoreError::Kind::kRefused);
}

TEST_P(StatementCount, RemarksOnManyAttemptsCostAsMuchAsOnTwo) {
    const std::vector<int64_t> ids = add_attempts(30);
    const int64_t of_two = cost_of([&] {
        (void)store->reviews().comments_of({ids.front(), ids.back()});
    });
    std::vector<db::CommentRecord> all;
    EXPECT_EQ(cost_of([&] { all = store->reviews().comments_of(ids); }), of_two);
    ASSERT_THAT(all, SizeIs(30));
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].attempt_id, ids[i]);
        EXPECT_EQ(all[i].text, std::to_string(i));
    }
}

TEST_P(StatementCount, DeviationsOfManyParticipantsCostAsMuchAsOfTwo) {
    add_participants("few", 2);
    add_participants("many", 30);
    std::vector<db::Deviation> found;
    const int64_t of_two = cost_of([&] { (void)db::study_deviations(*store, "few"); });
    EXPECT_EQ(cost_of([&] { found = db::study_deviations(*store, "many"); }), of_two);
    const auto paused = [](const auto& each) { return each.kind == db::DeviationKind::kPaused; };
    EXPECT_EQ(std::count_if(found.begin(), found.end(), paused), 30);
}

TEST_P(StatementCount, ManyProceduresOfAParticipantCostAsMuchAsTwo) {
    std::vector<db::AttemptRecord> found;
    std::vector<int64_t> ids;
    const auto cost = [&](int procedures) {
        const std::string code = owner->studies().new_participant("pilot");
        ids.clear();
        for (int i = 0; i < procedures; ++i)
            ids.push_back(add_procedure("pilot", code, "run " + std::to_string(i)));
        (void)add_procedure("pilot", code, "another", "touch_targets");
        const db::AttemptRecord one = store->attempts().detail(ids.back()).record;
        return cost_of([&] { found = db::other_attempts(*store, one); });
    };
    const int64_t of_two = cost(2);
    EXPECT_THAT(found, SizeIs(2));
    EXPECT_EQ(cost(30), of_two);
    // At the same task, oldest first.
    ASSERT_THAT(found, SizeIs(30));
    for (size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].id, ids[i]);
}

TEST_P(StatementCount, ManySignedRecordsCostAsMuchAsTwo) {
    const auto sign = [&](const std::string& study, int n) {
        add_participants(study, n);
        for (const db::ParticipantRecord& each : owner->studies().participants(study)) {
            // No two alike, and some without what not every record has.
            db::AnswerRecord answers;
            answers.study_id = study;
            answers.participant = each.code;
            answers.questionnaire_id = "sus";
            answers.answers = {{"sus02", std::to_string(each.number % 5)}, {"sus01", "4"}};
            if (each.number % 2 == 0) (void)owner->studies().save_answers(answers);
            if (each.number % 3 == 0) owner->records().note_step(study, each.code, 1, "run", "x");
            if (each.number % 4 == 0)
                owner->records().repeat_step(study, each.code, 1, "run", "the pedal");
            owner->records().lock(study, each.code);
            owner->records().sign(study, each.code, "coach", kPassword, "read");
        }
    };
    sign("few", 2);
    sign("many", 30);
    std::map<std::string, db::RecordState> found;
    const int64_t of_two = cost_of([&] { found = store->records().states("few"); });
    EXPECT_THAT(found, SizeIs(2));
    EXPECT_EQ(cost_of([&] { found = store->records().states("many"); }), of_two);
    ASSERT_THAT(found, SizeIs(30));
    // Signed one at a time, and read together: the same checksum.
    for (const auto& [code, state] : found) {
        ASSERT_TRUE(state.signature) << code;
        EXPECT_EQ(state.signature->name, "Name of coach") << code;
        EXPECT_TRUE(state.signature_fits) << code;
    }
    const std::string edited = found.rbegin()->first;
    ASSERT_TRUE(
        raw().run("UPDATE participants SET created_utc = '' WHERE study_id = 'many' AND "
                  "code = '" +
                  edited + "'"));
    for (const auto& [code, state] : store->records().states("many"))
        EXPECT_EQ(state.signature_fits, code != edited) << code;
}

/// No two alike, and numbers that a text would round.
db::AttemptResult result_with(int events, int metrics, int reasons) {
    db::AttemptResult result = make_result();
    const sim::Event one = result.events[1];
    result.events.clear();
    result.metrics.values.clear();
    result.score.reasons.clear();
    for (int i = 0; i < events; ++i) {
        sim::Event& event = result.events.emplace_back(one);
        event.time_s = i / 3.0;
        event.value = 0.1F * static_cast<float>(i);
        event.element = i;
    }
    for (int i = 0; i < metrics; ++i)
        result.metrics.values.push_back({"metric_" + std::to_string(i),
                                         i % 7 == 0 ? std::nan("") : static_cast<double>(i) / 3});
    for (int i = 0; i < reasons; ++i)
        result.score.reasons.push_back({"item", "Reason " + std::to_string(i), i / 3.0, -1, false});
    return result;
}

TEST_P(StatementCount, SavingManyRowsCostsAFewStatementsMore) {
    int64_t id = 0;
    const auto cost = [&](const db::AttemptResult& result) {
        return cost_of([&] { id = owner->attempts().save(anna, result); });
    };
    (void)cost(result_with(10, 10, 10));  // What is asked once.
    const int64_t of_ten = cost(result_with(10, 10, 10));
    EXPECT_LE(cost(result_with(500, 10, 10)), of_ten + 5);
    EXPECT_LE(cost(result_with(10, 500, 500)), of_ten + 10);
    for (const int n : {0, 1, 99, 100, 101, 250}) {
        const db::AttemptResult result = result_with(n, n, n);
        (void)cost(result);
        const db::AttemptDetail kept = store->attempts().detail(id);
        ASSERT_THAT(kept.events, SizeIs(n));
        ASSERT_THAT(kept.metrics.values, SizeIs(n));
        ASSERT_THAT(kept.score.reasons, SizeIs(n));
        for (size_t i = 0; i < kept.events.size(); ++i) {
            EXPECT_EQ(kept.events[i].time_s, result.events[i].time_s);
            EXPECT_EQ(kept.events[i].value, result.events[i].value);
            EXPECT_EQ(kept.events[i].rest_position_m, result.events[i].rest_position_m);
            EXPECT_EQ(kept.events[i].element, static_cast<int32_t>(i));
            EXPECT_EQ(kept.metrics.values[i].id, result.metrics.values[i].id);
            EXPECT_THAT(kept.metrics.values[i].value,
                        testing::NanSensitiveDoubleEq(result.metrics.values[i].value));
            EXPECT_EQ(kept.score.reasons[i].text, result.score.reasons[i].text);
            EXPECT_EQ(kept.score.reasons[i].points, result.score.reasons[i].points);
        }
    }
    // What was written is what was sealed.
    for (const std::string& problem : owner->check())
        EXPECT_THAT(problem, testing::Not(testing::HasSubstr("seals:")));
}

TEST_P(StatementCount, StudiesWithParticipantsAreOneQuestion) {
    (void)owner->studies().new_participant("b");
    (void)owner->studies().new_participant("a");
    (void)owner->studies().new_participant("b");
    std::vector<std::string> ids;
    const int64_t of_two = cost_of([&] { ids = store->studies().with_participants(); });
    EXPECT_THAT(ids, ElementsAre("a", "b"));
    for (int i = 0; i < 28; ++i) (void)owner->studies().new_participant("c" + std::to_string(i));
    EXPECT_EQ(cost_of([&] { ids = store->studies().with_participants(); }), of_two);
    EXPECT_THAT(ids, SizeIs(30));
}

}  // namespace THIS_TEST
