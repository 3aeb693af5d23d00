// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A check of a large store takes long: it says how far it is, and is stopped anywhere on its way.
#include "db/store_check.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "db/sqlite_file.h"
#include "db/store_context.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using CheckStep = db::CheckProgress::Step;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

namespace THIS_TEST {

class StoreCheck : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        store = open();
        db::AttemptResult result = make_result();
        result.recording_file = folder.file("a.placode");
        write_recording(result.recording_file);
        (void)store->attempts().save(store->accounts().create(trainee("anna")), result);
    }
    /// A transaction that was left open would refuse this.
    void expect_usable() const {
        EXPECT_NO_THROW(store->groups().create("Group " + std::to_string(++groups_)));
        EXPECT_THAT(store->check(), IsEmpty());
    }

    std::unique_ptr<db::Store> store;

 private:
    mutable int groups_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, StoreCheck, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(StoreCheck, SaysHowFarItIsAndEndsInEachStepWhereWhoIsToldThrows) {
    std::vector<CheckStep> steps;
    const auto told = [&](const db::CheckProgress& at) {
        if (steps.empty() || steps.back() != at.step) steps.push_back(at.step);
    };
    EXPECT_THAT(store->check({{}, told}), Optional(IsEmpty()));
    EXPECT_THAT(steps, ElementsAre(CheckStep::kFile, CheckStep::kTrail, CheckStep::kObjects,
                                   CheckStep::kRecordings));
    struct Enough {};
    for (const CheckStep step : steps) {
        const auto enough = [&](const db::CheckProgress& at) {
            if (at.step == step) throw Enough{};
        };
        EXPECT_THROW((void)store->check({{}, enough}), Enough) << static_cast<int>(step);
        expect_usable();
    }
}

// Nobody takes a check that was stopped for one that found nothing.
TEST_P(StoreCheck, ThatIsStoppedSaysNothingOfTheStore) {
    for (const CheckStep step : {CheckStep::kFile, CheckStep::kTrail, CheckStep::kObjects}) {
        std::atomic<bool> stops{false};
        const db::CheckOptions how{[&] { return stops.load(); },
                                   [&](const db::CheckProgress& at) { stops = at.step == step; }};
        EXPECT_EQ(store->check(how), std::nullopt) << static_cast<int>(step);
        expect_usable();
    }
    EXPECT_THAT(store->check({[] { return false; }, {}}), Optional(IsEmpty()));
}

// Most of the time of a large file goes into single questions, of which SQLite says nothing.
TEST_P(StoreCheck, AFileIsStoppedWithinAQuestion) {
    if (!is_sqlite()) return;
    const auto here = std::this_thread::get_id();
    std::atomic<bool> elsewhere{false};
    const db::CheckOptions how{[&] {
                                   if (std::this_thread::get_id() != here) elsewhere = true;
                                   return elsewhere.load();
                               },
                               {}};
    EXPECT_EQ(store->check(how), std::nullopt);
    EXPECT_TRUE(elsewhere);
    expect_usable();
    db::StoreContext context(db::parse_store_url(url()), options);
    const db::InterruptOn interrupt(context.connection, [] { return true; });
    db::Statement endless(context.connection,
                          "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT "
                          "COUNT(*) FROM n");
    EXPECT_THROW(endless.run(), db::StoreError);
    EXPECT_TRUE(interrupt.stopped());
}

}  // namespace THIS_TEST
