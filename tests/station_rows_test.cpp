// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that somebody adds by SQL who has signed in and may add such rows: what they must not say.

#include <gmock/gmock.h>

#include "db/course_conduct.h"
#include "tests/exam_course.h"
#include "tests/station_guard_attacks.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;

namespace THIS_TEST {

class StationRows : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        anna_ = add("anna", db::Role::kTrainee);
    }
    [[nodiscard]] int64_t add(const std::string& login, db::Role role) const {
        db::NewUser user = trainee(login);
        user.roles = static_cast<db::Roles>(role);
        return open()->accounts().create(user);
    }
    [[nodiscard]] std::unique_ptr<db::Store> station_of(const std::string& login) const {
        auto store = open_at_station();
        store->sign_out();
        EXPECT_EQ(store->accounts().sign_in(login, kPassword).outcome, db::SignInOutcome::kOk);
        return store;
    }
    /// A connection of their own, with their log-in to Placode.
    struct Pen {
        RawConnection station;
        Intruder person{station};
        Pen(const std::string& database, const std::string& login)
            : station(World::get().server().connect_station(database)) {
            EXPECT_NE(person.enter(login, kPassword), "0");
        }
        /// Why it is refused; "" where it is not. Nothing stays.
        std::string tried(const std::string& sql) {
            EXPECT_TRUE(station.run("BEGIN"));
            const Outcome got = outcome_of(station, sql);
            EXPECT_TRUE(station.run("ROLLBACK"));
            return got.refusal;
        }
    };

    int64_t anna_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Server, StationRows, testing::Values("Postgresql"), engine_name);

constexpr const char* kMayNot = "you may not do this on the server";

// It would be the exam's, and nobody would simulate it again.
TEST_P(StationRows, NoPracticeEndsAnExamThatWasBegun) {
    publish_exam(*open(), "diathermy_ring", "7,8");
    assign_exam(*open(), anna_);
    const auto store = station_of("anna");
    const db::ExamOrder order = db::begin_exam(
        *store, anna_, db::prepare_exam(*store, anna_, "short", "final", "", "", db::utc_now()));
    Pen anna(database, "anna");
    const auto practice = [&](int64_t begin) {
        return anna.tried(
            "INSERT INTO attempts (account_id, task_id, task_version, started_utc, saved_utc, "
            "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, "
            "points, verdict, rubric_id, rubric_version, metric_set_version, exam_begin) VALUES (" +
            std::to_string(anna_) + ", 'diathermy_ring', 2, '" + db::utc_now() +
            "', '', 60, 'mouse', '7', '', 1, '7', 0, 0, 100, 0, 'ring', 4, 15, " +
            std::to_string(begin) + ")");
    };
    EXPECT_EQ(practice(0), "") << "or this proves nothing";
    EXPECT_THAT(practice(order.context.begin), HasSubstr(kMayNot));
}

}  // namespace THIS_TEST
