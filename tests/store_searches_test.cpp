// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a store of years reads for one attempt: an index each, and never a whole table.

#include <gmock/gmock.h>

#include <regex>

#include "db/course_conduct.h"
#include "db/sql_connection.h"
#include "tests/exam_course.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"
#include "tests/watched_statements.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kTask = "touch_targets";

class StoreSearches : public EngineTest {
 protected:
    void ready() override {
        const auto store = open();
        anna_ = store->accounts().create(
            {"anna", "Anna", "long enough 1", static_cast<db::Roles>(db::Role::kTrainee), false});
        publish_exam(*store, kTask, "7,8");
        assign_exam(*store, anna_);
        code_ = store->studies().new_participant("pilot");
    }
    /// A person's, so that its signature is asked for.
    [[nodiscard]] db::AttemptResult performed() {
        db::AttemptResult result;
        result.header.task_id = kTask;
        result.header.task_version = 1;
        result.header.started_utc = db::utc_now();
        result.end.reason = sim::EndReason::kFinished;
        record_to(folder.file("r" + std::to_string(++files_) + ".placode"), result);
        return result;
    }
    /// All that a day asks: an attempt, an exam, what waits, a withdrawal with erasure.
    void aDay(db::Store& store) {
        (void)store.attempts().save(anna_, performed());
        (void)db::begin_exam(
            store, anna_, db::prepare_exam(store, anna_, "short", "final", "", "", db::utc_now()));
        (void)store.attempts().waiting_for_replay();
        store.studies().withdraw("pilot", code_, db::WithdrawalMode::kErase, "asked for it");
    }

    int64_t anna_ = 0;
    std::string code_;
    int files_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, StoreSearches, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(StoreSearches, NothingReadsTheWholeTrailOrAllAttempts) {
    if (!is_sqlite()) GTEST_SKIP() << "below";
    std::vector<std::string> asked;
    {
        WatchedStatements watched;
        const auto store = open();
        watched.forget();
        aDay(*store);
        asked = watched.all();
        EXPECT_THAT(watched.with("action = 'station.trust'"), testing::SizeIs(testing::Ge(2u)))
            << "or this proves nothing";
        EXPECT_THAT(watched.with("study <> ''"), testing::Not(testing::IsEmpty()));
        EXPECT_THAT(watched.with("replay = 1"), testing::Not(testing::IsEmpty()));
    }
    // An index of few rows may be read in whole, and of the trail its last entry.
    const std::regex whole("SCAN (audit|attempts|a|t)\\b(?!.* INDEX attempts_waiting)");
    for (const std::string& each : asked) {
        if (!each.starts_with("SELECT") || each.ends_with("LIMIT 1")) continue;
        if (each.find("attempts") == std::string::npos && each.find("audit") == std::string::npos)
            continue;
        std::string plan = plan_of(folder.file("placode.db"), each);
        // Of demonstration accounts, which are few.
        if (each.find("FROM accounts a ") != std::string::npos)
            plan = std::regex_replace(plan, std::regex("LIST SUBQUERY \\d+\\s+SCAN a\\b"), "");
        EXPECT_FALSE(std::regex_search(plan, whole)) << each << "\n" << plan;
    }
}

// The server's own functions, too: their plans stand in its log.
TEST_P(StoreSearches, AServerUsesTheIndexes) {
    if (is_sqlite()) GTEST_SKIP() << "above";
    if (!fs::exists("/usr/lib/postgresql/15/lib/auto_explain.so")) GTEST_SKIP() << "auto_explain";
    for (const char* setting :
         {"session_preload_libraries = 'auto_explain'", "auto_explain.log_min_duration = 0",
          "auto_explain.log_nested_statements = on", "enable_seqscan = off"}) {
        RawConnection owner = raw();
        ASSERT_TRUE(owner.run("ALTER DATABASE " + database + " SET " + setting)) << owner.problem();
    }
    const size_t before = World::get().server().log().size();
    const auto store = open();
    aDay(*store);
    const std::string log = World::get().server().log().substr(before);
    for (const char* index : {"audit_by_action", "attempts_by_study", "attempts_waiting"})
        EXPECT_THAT(log, HasSubstr(index));
    for (const char* table : {"audit", "attempts"})
        EXPECT_THAT(log, testing::Not(HasSubstr(std::string("Seq Scan on ") + table + " ")));
}

// A server answers hundreds of questions a second, and a store of years holds 100,000 recordings.
TEST_P(StoreSearches, RecordingsAreCheckedByPages) {
    constexpr int kAll = 50;
    std::vector<int64_t> ids;
    {
        const auto store = open();
        for (int i = 0; i < kAll; ++i) ids.push_back(store->attempts().save(anna_, performed()));
    }
    // Damage in the middle is named as well.
    ASSERT_TRUE(raw().run("UPDATE recordings SET checksum = 'x' WHERE attempt_id = " +
                          std::to_string(ids[20])));
    ASSERT_TRUE(raw().run("UPDATE recordings SET size_bytes = 2000000000 WHERE attempt_id = " +
                          std::to_string(ids[49])));
    const std::string logged =
        is_sqlite() ? "SELECT 1" : "ALTER DATABASE " + database + " SET log_statement = 'all'";
    ASSERT_TRUE(raw().run(logged));
    WatchedStatements watched;
    const auto store = open();
    watched.forget();
    const size_t before = is_sqlite() ? 0 : World::get().server().log().size();
    std::vector<std::string> problems;
    store->attempts().check_recordings(problems);
    EXPECT_THAT(problems, testing::ElementsAre(
                              "recordings: the recording of attempt " + std::to_string(ids[20]) +
                                  " is damaged",
                              HasSubstr("the recording of attempt " + std::to_string(ids[49]) +
                                        " is damaged (it says that it has 2000000000 bytes")));
    if (is_sqlite()) {
        EXPECT_LT(watched.with("FROM recordings").size(), 10u);
        EXPECT_GT(watched.with("FROM recordings").size(), 0u) << "or this proves nothing";
        return;
    }
    const std::string log = World::get().server().log().substr(before);
    const std::regex runs("LOG:  statement: EXECUTE");
    const auto asked =
        std::distance(std::sregex_iterator(log.begin(), log.end(), runs), std::sregex_iterator());
    EXPECT_LT(asked, 10);
    EXPECT_GT(asked, 0) << "or this proves nothing";
}

// All of a centre wait while somebody writes the trail.
TEST_P(StoreSearches, LittleIsAskedWhileOthersWaitForTheTrail) {
    if (is_sqlite()) GTEST_SKIP() << "a file has one writer from the beginning";
    ASSERT_TRUE(raw().run("ALTER DATABASE " + database + " SET log_statement = 'all'"));
    const auto store = open();
    (void)store->attempts().save(anna_, performed());  // asks what it asks once
    const size_t before = World::get().server().log().size();
    (void)store->attempts().save(anna_, performed());
    const std::string log = World::get().server().log().substr(before);
    const std::string lock =
        "LOG:  statement: SELECT set_config('lock_timeout', '60000', true), "
        "pg_advisory_xact_lock(1347371844, hashtext('audit')), set_config('lock_timeout', '5000', "
        "true)";
    const size_t locked = log.find(lock), ended = log.find("LOG:  statement: COMMIT", locked);
    ASSERT_NE(locked, std::string::npos) << "it is waited for twelve times as long as a row";
    ASSERT_NE(ended, std::string::npos);
    EXPECT_EQ(log.find(lock, locked + 1), std::string::npos) << "once";
    const std::regex runs("LOG:  statement: EXECUTE");
    const auto asked = [&](size_t from, size_t to) {
        const std::string part = log.substr(from, to - from);
        return std::distance(std::sregex_iterator(part.begin(), part.end(), runs),
                             std::sregex_iterator());
    };
    EXPECT_GE(asked(0, locked), 13) << "the seals, or this proves nothing";
    EXPECT_LE(asked(locked, ended), 3) << "the end of the trail and the entries";
}

}  // namespace THIS_TEST
