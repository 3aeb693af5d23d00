// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a study or a person's attempts for a file or a page sends as many statements for thirty
// attempts as for two: on a server elsewhere each takes 50 ms.

#include "reports/dataset.h"

#include <gmock/gmock.h>

#include "reports/study_report.h"
#include "tests/statement_cost.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::SizeIs;

namespace THIS_TEST {

/// As make_result(), of a person at the mouse.
db::AttemptResult performed(int points) {
    db::AttemptResult result = make_result();
    result.header.demonstration = false;
    result.header.device = "mouse";
    result.score.points = points;
    return result;
}

class DatasetTest : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        store = open();
        anna = store->accounts().create(trainee("anna"));
        bert = store->accounts().create(trainee("bert"));
    }
    void add_participants(const std::string& study, int n) {
        for (int i = 0; i < n; ++i) {
            db::AttemptResult result = performed(i);
            result.study = {study, store->studies().new_participant(study)};
            db::StepRecord step;
            step.study_id = study;
            step.participant = result.study.participant;
            step.step = "run";
            step.attempt_id = store->attempts().save(anna, result);
            store->studies().record_step(step);
        }
    }

    std::unique_ptr<db::Store> store;
    int64_t anna = 0, bert = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, DatasetTest, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(DatasetTest, ThirtyParticipantsCostAsMuchAsTwo) {
    add_participants("few", 2);
    add_participants("many", 30);
    reports::StudyReport few, many;
    const int64_t of_two = cost_of([&] { few = reports::read_study_report(*store, "few", "en"); });
    EXPECT_EQ(cost_of([&] { many = reports::read_study_report(*store, "many", "en"); }), of_two);
    EXPECT_THAT(few.data.attempts, SizeIs(2));
    ASSERT_THAT(many.data.attempts, SizeIs(30));
    for (size_t i = 0; i < many.data.attempts.size(); ++i) {
        const db::AttemptDetail& each = many.data.attempts[i];
        EXPECT_EQ(each.score.points, static_cast<double>(i)) << "in the order of the steps";
        EXPECT_EQ(each.record.study.participant, many.everybody[i].code);
        EXPECT_THAT(each.events, SizeIs(1));
    }
}

TEST_P(DatasetTest, ThirtyAttemptsOfAPersonCostAsMuchAsTwo) {
    for (int i = 0; i < 30; ++i) store->attempts().save(anna, performed(i));
    for (int i = 0; i < 2; ++i) store->attempts().save(bert, performed(i));
    const auto read = [&](int64_t id) {
        return reports::user_dataset(*store, *store->accounts().find(id), {});
    };
    const int64_t of_two = cost_of([&] { EXPECT_THAT(read(bert).attempts, SizeIs(2)); });
    EXPECT_EQ(cost_of([&] { EXPECT_THAT(read(anna).attempts, SizeIs(30)); }), of_two);
}

}  // namespace THIS_TEST
