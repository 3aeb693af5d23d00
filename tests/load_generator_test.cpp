// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/load_generator.h"

#include <gmock/gmock.h>

#include <set>

#include "db/store.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::IsEmpty;

namespace THIS_TEST {

World* const world = World::install();

class LoadGenerator : public EngineTest {
 protected:
    /// A simulated attempt to multiply.
    void add_source(bool demonstration = true) const {
        const auto store = open();
        const int64_t user =
            store->accounts().create({"s", "S", "long enough 1", 1, demonstration});
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.metrics.values = {{"task_time_s", 100}, {"path_length_mm", 50}};
        result.score.reasons = {{"late", "Late.", 3, 1, false}};
        sim::Event event;
        event.kind = sim::EventKind::kDwell;
        result.events = {event, event};
        store->attempts().save(user, result);
    }
};

db::LoadOrder small() {
    db::LoadOrder order;
    order.users = 4;
    order.attempts = 20;
    order.group_size = 2;
    return order;
}

INSTANTIATE_TEST_SUITE_P(Engines, LoadGenerator, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(LoadGenerator, EveryCopyHasItsListsAndSaysThatItIsOne) {
    add_source();
    const db::LoadResult load = db::generate_load(url(), small());
    EXPECT_EQ(load.attempts, 20);
    EXPECT_EQ(load.groups, 2);
    EXPECT_EQ(load.rows, 20 * (1 + 2 + 1 + 2)) << "attempt, metrics, reason, events";
    const auto store = open();
    EXPECT_EQ(store->accounts().list().size(), 5u);
    ASSERT_EQ(store->groups().list().size(), 2u);
    EXPECT_EQ(store->groups().list()[0].members.size(), 2u);
    const auto attempts = store->attempts().list(load.first_user);
    ASSERT_EQ(attempts.size(), 5u);
    std::set<double> points;
    for (const auto& attempt : attempts) {
        EXPECT_TRUE(attempt.generated);
        EXPECT_TRUE(attempt.demonstration);
        points.insert(attempt.points);
        const auto detail = store->attempts().detail(attempt.id);
        EXPECT_EQ(detail.events.size(), 2u);
        EXPECT_EQ(detail.score.reasons.size(), 1u);
        EXPECT_NEAR(*detail.metrics.find("task_time_s"), 100, 10.001);
    }
    EXPECT_EQ(points.size(), 5u) << "no two are alike";
    EXPECT_FALSE(store->attempts().list(1).at(0).generated);
    EXPECT_EQ(store->accounts().sign_in("generated-1", "").outcome, db::SignInOutcome::kWrong);
    EXPECT_THAT(store->check(), IsEmpty());
}

TEST_P(LoadGenerator, ARealStoreIsNoPlaceForCopies) {
    add_source(false);
    EXPECT_EQ(failure_of([&] { (void)db::generate_load(url(), small()); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(open()->attempts().list(0).size(), 1u);
}

TEST_P(LoadGenerator, WithoutAnAttemptOrASecondTimeItRefuses) {
    EXPECT_EQ(failure_of([&] { (void)db::generate_load(url(), small()); }).kind(),
              StoreError::Kind::kRefused);
    add_source();
    (void)db::generate_load(url(), small());
    EXPECT_EQ(failure_of([&] { (void)db::generate_load(url(), small()); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(open()->attempts().list(0).size(), 21u);
}

TEST_P(LoadGenerator, AStopLeavesNothing) {
    add_source();
    db::LoadOrder order = small();
    order.progress = [](int64_t, int64_t) { return false; };
    EXPECT_TRUE(db::generate_load(url(), order).cancelled);
    EXPECT_EQ(open()->accounts().list().size(), 1u);
    EXPECT_EQ(open()->attempts().list(0).size(), 1u);
}

}  // namespace THIS_TEST
