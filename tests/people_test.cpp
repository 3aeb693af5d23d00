// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// PIN, invitations, erasure and quick lists in the store, on both engines.

#include <gmock/gmock.h>

#include <cstdio>
#include <map>
#include <random>
#include <set>

#include "assessment/cohort.h"
#include "db/store.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::SignInOutcome;
using db::StoreError;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kPassword = "long enough 1";

class People : public EngineTest {
 protected:
    void ready() override {
        options.now_ms = [this] { return now_ms; };
        store = open();
        anna = add("anna", db::Role::kTrainee);
        adam = add("adam", db::Role::kAdministrator);
    }
    int64_t add(const std::string& login, db::Role role) const {
        return store->accounts().create(
            {login, "Name of " + login, kPassword, static_cast<db::Roles>(role), false});
    }
    int64_t attempt(int64_t user, double points, const std::string& at,
                    const std::string& task = "diathermy_ring",
                    sim::EndReason end = sim::EndReason::kFinished,
                    const std::string& device = "mouse") const {
        db::AttemptResult result;
        result.header.task_id = task;
        result.header.device = device;
        result.header.started_utc = at;
        result.end.reason = end;
        result.metrics.values = {{"task_time_s", 1}};
        result.score.points = points;
        result.score.verdict = points < 20   ? assessment::Verdict::kFailed
                               : points < 60 ? assessment::Verdict::kNotYet
                                             : assessment::Verdict::kPassed;
        return store->attempts().save(user, result);
    }

    std::unique_ptr<db::Store> store;
    int64_t anna = 0, adam = 0;
    int64_t now_ms = 1'767'225'600'000;  // 2026-01-01
};

INSTANTIATE_TEST_SUITE_P(Engines, People, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(People, APinOpensUntilItWasWrongThreeTimes) {
    const auto door = open();  // Where somebody stands: it works for whoever came in.
    for (const char* pin : {"123", "1234567890123", "12a4", "0000", "1234", "9876"})
        EXPECT_EQ(failure_of([&] { store->accounts().set_pin(anna, pin); }).kind(),
                  StoreError::Kind::kRefused)
            << pin;
    EXPECT_FALSE(store->accounts().has_pin(anna));
    EXPECT_EQ(door->accounts().unlock(anna, "2580").outcome, SignInOutcome::kWrong);
    store->accounts().set_pin(anna, "2580");
    EXPECT_TRUE(store->accounts().has_pin(anna));
    EXPECT_EQ(door->accounts().unlock(anna, "2580").user->login, "anna");
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(door->accounts().unlock(anna, "2581").outcome, SignInOutcome::kWrong);
    EXPECT_EQ(door->accounts().unlock(anna, "2580").outcome, SignInOutcome::kOk)
        << "the count begins again";
    for (int i = 0; i < 3; ++i) (void)door->accounts().unlock(anna, "2581");
    EXPECT_EQ(door->accounts().unlock(anna, "2580").outcome, SignInOutcome::kWrong);
    EXPECT_FALSE(store->accounts().has_pin(anna));
    store->accounts().set_pin(anna, "2580");
    store->accounts().set_active(anna, false);
    EXPECT_EQ(door->accounts().unlock(anna, "2580").outcome, SignInOutcome::kDeactivated);
    store->accounts().set_pin(adam, "2580");
    store->accounts().set_password(adam, "another one 1");
    EXPECT_FALSE(store->accounts().has_pin(adam)) << "a new password takes it away";
}

TEST_P(People, AnInvitationMakesOneAccountInItsGroupUntilItsLastDay) {
    const int64_t group = store->groups().create("A");
    db::InvitationRecord invitation;
    invitation.roles = static_cast<db::Roles>(db::Role::kEducator);
    invitation.group_id = group;
    invitation.expires_utc = "2026-01-02";
    invitation.note = "Olga from Gdansk";
    const std::string code = store->accounts().invite(invitation);
    EXPECT_EQ(store->accounts().invitations().at(0).note, "Olga from Gdansk");
    EXPECT_EQ(code.size(), 27u);
    const db::NewUser olga{"olga", "Olga", kPassword, 8, false};
    EXPECT_EQ(failure_of([&] { store->accounts().accept_invitation("x", olga); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(failure_of([&] {
                  store->accounts().accept_invitation(code, {"anna", "A", kPassword, 1, false});
              }).kind(),
              StoreError::Kind::kConflict)
        << "a login that is taken";
    now_ms += int64_t{2} * 86400 * 1000 - 1;
    const int64_t id = store->accounts().accept_invitation(code, olga);
    EXPECT_EQ(store->accounts().find(id)->roles, invitation.roles)
        << "not those that were asked for";
    EXPECT_THAT(store->groups().list().at(0).members, ElementsAre(id));
    EXPECT_THAT(failure_of([&] {
                    store->accounts().accept_invitation(code, {"p", "P", kPassword, 1, false});
                }).what(),
                HasSubstr("was used"));
    const std::string late = store->accounts().invite(invitation);
    now_ms += 1;
    EXPECT_THAT(failure_of([&] {
                    store->accounts().accept_invitation(late, {"p", "P", kPassword, 1, false});
                }).what(),
                HasSubstr("ended on 2026-01-02"));
    ASSERT_EQ(store->accounts().invitations().size(), 2u);
    EXPECT_FALSE(store->accounts().invitations()[0].used_utc.empty());
    EXPECT_EQ(store->accounts().invitations()[0].note, "olga") << "who accepted it";
    EXPECT_TRUE(store->accounts().invitations()[1].used_utc.empty());
    // An earlier version kept for whom it was; erasure knows whose it became.
    const auto note = [this] { return raw().value("SELECT note FROM invitations WHERE id = 1"); };
    EXPECT_EQ(note(), "");
    ASSERT_TRUE(raw().run("UPDATE invitations SET note = 'Olga from Gdansk' WHERE id = 1"));
    store->accounts().erase(id, false);
    EXPECT_EQ(note(), "");
    EXPECT_EQ(raw().value("SELECT note FROM invitations WHERE id = 2"), invitation.note);
    invitation.expires_utc = "soon";
    EXPECT_EQ(failure_of([&] { store->accounts().invite(invitation); }).kind(),
              StoreError::Kind::kRefused);
}

TEST_P(People, AnErasedPersonIsNobodyAndTheAttemptsStayWithoutAName) {
    const int64_t id = attempt(anna, 50, "2026-01-01T00:00:00Z");
    const int64_t group = store->groups().create("A");
    store->groups().set_role(group, anna, db::GroupRole::kMember);
    store->accounts().set_pin(anna, "2580");
    store->accounts().request_erasure(anna, "I leave");
    EXPECT_EQ(failure_of([&] { store->accounts().request_erasure(anna, "x"); }).kind(),
              StoreError::Kind::kConflict);
    ASSERT_EQ(store->accounts().erasure_requests().size(), 1u);
    EXPECT_TRUE(store->accounts().erasure_requests()[0].done_utc.empty());
    store->accounts().erase(anna, false);
    EXPECT_FALSE(store->accounts().find(anna));
    EXPECT_EQ(store->accounts().list().size(), 1u);
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome, SignInOutcome::kWrong);
    EXPECT_EQ(store->accounts().unlock(anna, "2580").outcome, SignInOutcome::kWrong);
    EXPECT_EQ(store->attempts().detail(id).record.user_name, "");
    EXPECT_THAT(store->groups().list().at(0).members, IsEmpty());
    EXPECT_FALSE(store->accounts().erasure_requests()[0].done_utc.empty());
    EXPECT_EQ(store->accounts().erasure_requests()[0].reason, "") << "may tell who it was";
    EXPECT_THAT(store->check(), IsEmpty());
    EXPECT_NE(add("anna", db::Role::kTrainee), anna) << "the login is free, the number is not";
}

TEST_P(People, ErasureMayTakeTheAttemptsAlong) {
    attempt(anna, 50, "2026-01-01T00:00:00Z");
    const int64_t kept = attempt(adam, 60, "2026-01-01T00:00:00Z");
    db::RescoreRecord rescore;
    rescore.attempt_id = 1;
    rescore.metrics.values = {{"task_time_s", 2}};
    store->attempts().save_rescore(rescore);
    EXPECT_EQ(failure_of([&] { store->accounts().erase(adam, true); }).kind(),
              StoreError::Kind::kRefused)
        << "the last administrator";
    store->accounts().erase(anna, true);
    ASSERT_EQ(store->attempts().list(0).size(), 1u);
    EXPECT_EQ(store->attempts().list(0)[0].id, kept);
    EXPECT_THAT(store->check(), IsEmpty());
}

TEST_P(People, AListComesInPages) {
    for (int i = 0; i < 5; ++i)
        attempt(i % 2 ? adam : anna, i, "2026-01-0" + std::to_string(i + 1) + "T00:00:00Z");
    db::AttemptFilter filter;
    filter.limit = 2;
    const auto page = store->attempts().page(filter);
    EXPECT_EQ(page.total, 5);
    ASSERT_EQ(page.rows.size(), 2u);
    EXPECT_EQ(page.rows[0].points, 4) << "newest first";
    EXPECT_EQ(page.rows[0].user_name, "Name of anna");
    filter.offset = 4;
    ASSERT_EQ(store->attempts().page(filter).rows.size(), 1u);
    EXPECT_EQ(store->attempts().page(filter).rows[0].points, 0);
    filter = {};
    filter.newest_first = false;
    filter.user_id = adam;
    const auto own = store->attempts().page(filter);
    EXPECT_EQ(own.total, 2);
    EXPECT_EQ(own.rows[0].points, 1);
    const int64_t group = store->groups().create("A");
    store->groups().set_role(group, anna, db::GroupRole::kMember);
    filter = {};
    filter.group_id = group;
    EXPECT_EQ(store->attempts().page(filter).total, 3);
    filter.task_id = "grasp_and_lift";
    EXPECT_EQ(store->attempts().page(filter).total, 0);
}

TEST_P(People, AStandingIsSummedUpByPersonAndTask) {
    attempt(anna, 10, "2026-01-03T00:00:00Z");
    attempt(anna, 90, "2026-01-01T00:00:00Z");
    attempt(anna, 50, "2026-01-02T00:00:00Z");
    attempt(anna, 99, "2026-01-04T00:00:00Z", "diathermy_ring", sim::EndReason::kInterrupted);
    attempt(anna, 30, "2026-01-01T00:00:00Z", "grasp_and_lift");
    attempt(adam, 40, "2026-01-05T00:00:00Z");
    attempt(adam, 45, "2026-01-05T00:00:00Z");
    const auto all = store->attempts().standings(0);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].user_id, adam);
    EXPECT_DOUBLE_EQ(all[0].last_points, 45) << "of the same second: the later number";
    EXPECT_EQ(all[1].task_id, "diathermy_ring");
    EXPECT_EQ(all[1].attempts, 3) << "an interrupted one does not count";
    EXPECT_EQ(all[1].failed, 1);
    EXPECT_DOUBLE_EQ(all[1].best_points, 90);
    EXPECT_DOUBLE_EQ(all[1].mean_points, 50);
    EXPECT_DOUBLE_EQ(all[1].last_points, 10);
    EXPECT_EQ(all[1].last_utc, "2026-01-03T00:00:00Z");
    EXPECT_EQ(store->attempts().standings(0, "grasp_and_lift").size(), 1u);
    const auto points = store->attempts().points(0, "diathermy_ring");
    ASSERT_EQ(points.size(), 5u);
    EXPECT_DOUBLE_EQ(points[0].points, 90) << "by person, then time";
    EXPECT_THAT(store->attempts().standings(99), IsEmpty());
    EXPECT_THAT(store->attempts().tasks(), ElementsAre("diathermy_ring", "grasp_and_lift"));
}

TEST_P(People, AStandingSaysWhoseAccountIsClosed) {
    for (int i = 1; i <= 5; ++i) attempt(anna, 10, "2026-01-0" + std::to_string(i) + "T00:00:00Z");
    attempt(adam, 40, "2026-01-05T00:00:00Z");
    const auto active = [&] {
        std::map<int64_t, bool> found;
        for (const auto& each : store->attempts().standings(0)) found[each.user_id] = each.active;
        return found;
    };
    EXPECT_EQ(active(), (std::map<int64_t, bool>{{anna, true}, {adam, true}}));
    store->accounts().set_active(anna, false);
    EXPECT_EQ(active(), (std::map<int64_t, bool>{{anna, false}, {adam, true}}));
    store->accounts().set_active(anna, true);
    EXPECT_EQ(active(), (std::map<int64_t, bool>{{anna, true}, {adam, true}}));
}

TEST_P(People, AnAttemptInWhichNothingWasDoneIsNoTryThatFailed) {
    attempt(anna, 70, "2026-01-01T00:00:00Z");
    db::AttemptResult idle;
    idle.header.task_id = "diathermy_ring";
    idle.header.device = "mouse";
    idle.header.started_utc = "2026-01-02T00:00:00Z";
    idle.score.verdict = assessment::Verdict::kNotAttempted;
    const int64_t id = store->attempts().save(anna, idle);
    EXPECT_EQ(store->attempts().detail(id).score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_FALSE(db::was_tried(store->attempts().detail(id).record));
    EXPECT_EQ(store->attempts().list(anna, "diathermy_ring").size(), 2u) << "it is kept and listed";
    const auto standings = store->attempts().standings(0);
    ASSERT_EQ(standings.size(), 1u);
    EXPECT_EQ(standings[0].attempts, 1);
    EXPECT_DOUBLE_EQ(standings[0].last_points, 70);
    EXPECT_EQ(standings[0].trials.streak, 1) << "the streak goes on";
    EXPECT_EQ(store->attempts().points(0, "diathermy_ring").size(), 1u);
}

// The store sums up what the rule needs; the rule itself reads every outcome.
TEST_P(People, StandingsFromSumsAreThoseFromEveryAttempt) {
    std::mt19937 random(7);
    int minute = 0;
    for (const int n : {1, 2, 5, 6, 9, 14})
        for (int person = 0; person < 6; ++person) {
            const int64_t id =
                add(std::to_string(n) + "p" + std::to_string(person), db::Role::kTrainee);
            const double level = person < 3 ? 45 : 70;
            for (int i = 0; i < n; ++i) {
                char at[32];
                std::snprintf(at, sizeof at, "2026-02-01T%02d:%02d:00Z", minute / 60, minute % 60);
                // Two of them in the same minute now and then.
                if (random() % 4 != 0) ++minute;
                attempt(
                    id, level + static_cast<double>(random() % 30) - 10, at, "diathermy_ring",
                    random() % 9 == 0 ? sim::EndReason::kInterrupted : sim::EndReason::kFinished);
            }
        }
    std::map<int64_t, std::vector<assessment::TrialOutcome>> every;
    std::map<int64_t, double> first;
    for (const auto& point : store->attempts().points(0)) {
        if (every[point.user_id].empty()) first[point.user_id] = point.points;
        every[point.user_id].push_back(
            {point.points, point.verdict == assessment::Verdict::kPassed});
    }
    std::set<assessment::Standing> seen;
    const auto standings = store->attempts().standings(0);
    EXPECT_EQ(standings.size(), every.size());
    for (const auto& each : standings) {
        const auto expected = assessment::judge_standing(every[each.user_id]);
        const auto got = assessment::judge_standing(each.trials);
        EXPECT_EQ(got.standing, expected.standing) << each.user_name;
        EXPECT_EQ(got.attempts, expected.attempts);
        EXPECT_EQ(got.streak, expected.streak);
        EXPECT_DOUBLE_EQ(got.last, expected.last);
        EXPECT_DOUBLE_EQ(got.best, expected.best);
        EXPECT_DOUBLE_EQ(got.recent, expected.recent);
        EXPECT_DOUBLE_EQ(each.first_points, first[each.user_id]);
        seen.insert(got.standing);
    }
    EXPECT_GE(seen.size(), 3u) << "the example shows more than one standing";
}

TEST_P(People, TheMeanOfTheLastAttemptsKeepsScriptsApart) {
    for (const double points : {10.0, 60.0, 70.0, 80.0})
        attempt(anna, points,
                "2026-01-0" + std::to_string(static_cast<int>(points / 10)) + "T00:00:00Z");
    attempt(anna, 95, "2026-01-09T00:00:00Z", "diathermy_ring", sim::EndReason::kFinished,
            "script:expert");
    attempt(adam, 40, "2026-01-05T00:00:00Z");
    attempt(adam, 5, "2026-01-06T00:00:00Z", "grasp_and_lift");
    const auto means = store->attempts().recent_means("diathermy_ring", 3);
    ASSERT_EQ(means.size(), 3u);
    EXPECT_EQ(means[0].user_id, adam);
    EXPECT_DOUBLE_EQ(means[0].mean_points, 40);
    EXPECT_EQ(means[1].user_id, anna);
    EXPECT_EQ(means[1].script, "");
    EXPECT_EQ(means[1].attempts, 4);
    EXPECT_DOUBLE_EQ(means[1].mean_points, 70) << "of the last three";
    EXPECT_EQ(means[2].script, "script:expert");
    EXPECT_DOUBLE_EQ(means[2].mean_points, 95);
}

}  // namespace THIS_TEST
