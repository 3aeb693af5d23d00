// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the server asks by itself before a station changes something: SQL of people who have a
// station's log-in and are signed in as nobody, as a trainee, or were; and that people who may can
// do all of it through the store.
#include "db/station_guard.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "curriculum/shipped_definitions.h"
#include "db/course_conduct.h"
#include "db/password.h"
#include "db/recording_order.h"
#include "db/station_role.h"
#include "tests/bars.h"
#include "tests/exam_course.h"
#include "tests/recorded_attempt.h"
#include "tests/station_guard_attacks.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using db::Role;
using db::SignInOutcome;
using db::StoreError;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

namespace THIS_TEST {

constexpr auto kAdministrator = static_cast<db::Roles>(Role::kAdministrator);

class StationGuard : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        const auto store = open();
        db::NewUser keeper = trainee("keeper");
        keeper.roles = kAdministrator;
        keeper_ = store->accounts().create(keeper);
        anna_ = store->accounts().create(trainee("anna"));
        bert_ = store->accounts().create(trainee("bert"));
        (void)store->attempts().save(anna_, make_result());
        store->groups().set_role(store->groups().create("Ours"), anna_, db::GroupRole::kMember);
        for (const int64_t each : {anna_, bert_}) store->accounts().set_pin(each, "2580");
        db::InvitationRecord invitation;
        invitation.roles = static_cast<db::Roles>(Role::kEducator);
        invitation.expires_utc = "2099-01-02";
        code_ = store->accounts().invite(invitation);
    }
    [[nodiscard]] RawConnection at_the_station() const {
        return World::get().server().connect_station(database);
    }
    [[nodiscard]] std::unique_ptr<db::Store> owner() const {
        return db::open_store(World::get().server().url(database), options);
    }
    /// True: it got nowhere.
    bool attack(RawConnection& station, const char* with) const {
        // One by one: Qt reports the first of several alone. All but the last may pass.
        RawConnection::edits() += 1;
        Outcome last;
        std::istringstream statements(with);
        for (std::string one; last.refusal.empty() && std::getline(statements, one, ';');)
            last = outcome_of(station, one);
        // Rows that somebody does not see cannot be changed either, and nothing is said of them.
        if (last.refusal.empty()) {
            EXPECT_EQ(last.rows, 0) << with;
            return last.rows == 0;
        }
        EXPECT_THAT(last.refusal,
                    AnyOf(HasSubstr("you may not"), HasSubstr("permission denied"),
                          HasSubstr("must be owner"), HasSubstr("must be superuser"),
                          HasSubstr("must have admin"), HasSubstr("row-level security")))
            << with;
        return true;
    }
    [[nodiscard]] std::vector<std::string> seals() const {
        std::vector<std::string> found;
        for (const std::string& each : owner()->check())
            if (each.starts_with("seals:") || each.starts_with("audit:")) found.push_back(each);
        return found;
    }

    int64_t keeper_ = 0, anna_ = 0, bert_ = 0;
    std::string code_;
};

INSTANTIATE_TEST_SUITE_P(Server, StationGuard, testing::Values("Postgresql"), engine_name);

TEST_P(StationGuard, NobodyGetsAnywhereBySql) {
    EXPECT_GE(kGuardAttacks.size(), 130u);
    Bar bar("attacks by SQL with a station's log-in");
    for (const char* each : kGuardAttacks) {
        RawConnection station = at_the_station();
        ASSERT_TRUE(station.is_open());
        bar.tried(attack(station, each));
    }
    EXPECT_THAT(seals(), IsEmpty());
}

// The trainee's own log-in to Placode, rightly signed in, opens nothing of it either.
TEST_P(StationGuard, NorDoesATraineeWhoHasSignedIn) {
    for (const char* each : kGuardAttacks) {
        RawConnection station = at_the_station();
        Intruder anna(station);
        ASSERT_EQ(anna.enter("anna", kPassword), std::to_string(anna_));
        ASSERT_EQ(anna.me(), std::to_string(anna_));
        attack(station, each);
    }
    RawConnection station = at_the_station();
    Intruder anna(station);
    ASSERT_EQ(anna.enter("anna", kPassword), std::to_string(anna_));
    const std::string hash = db::hash_password("another password", true);
    const auto set = [&](int64_t of) {
        const QByteArray channel = anna.channel();
        return station.run("SELECT placode_guard.set_password(" + std::to_string(of) + ", '" +
                           Intruder::masked(channel, hash) + "', 0)");
    };
    EXPECT_FALSE(set(bert_)) << "another one's password";
    EXPECT_FALSE(set(keeper_));
    EXPECT_THAT(station.problem(), HasSubstr("you may not"));
    EXPECT_THAT(seals(), IsEmpty());
    // That it is the account and not the way that is refused.
    EXPECT_TRUE(set(anna_)) << station.problem();
    EXPECT_EQ(open()->accounts().sign_in("anna", "another password").outcome, SignInOutcome::kOk);
}

TEST_P(StationGuard, AProofIsForOneConnectionAndOneTry) {
    RawConnection one = at_the_station(), other = at_the_station();
    Intruder here(one), there(other);
    const std::string key = here.key_of("keeper", kPassword);
    // Of this channel, and given from another connection: there it is another channel.
    const std::string proof = Intruder::proof(here.channel(), key);
    (void)there.channel();
    EXPECT_EQ(there.enter_with("keeper", proof), "0");
    EXPECT_EQ(there.me(), "0");
    EXPECT_EQ(here.enter_with("keeper", proof), std::to_string(keeper_));
    EXPECT_EQ(here.enter_with("keeper", proof), "") << "a second time";
    // What is wrong is wrong, also for a log-in that is none, which is not told apart.
    for (const std::string& wrong : {std::string(64, '0'), std::string(), key}) {
        (void)there.channel();
        EXPECT_EQ(there.enter_with("keeper", wrong), "0") << wrong;
    }
    EXPECT_EQ(there.enter("keeper", "not the password"), "0");
    EXPECT_EQ(there.enter("nobody here", kPassword), "0");
    EXPECT_THAT(other.value("SELECT placode_guard.salt_of('nobody here')"),
                StartsWith("$argon2id$v=19$m=65536,t=2,p=1$"));
    EXPECT_EQ(other.value("SELECT placode_guard.salt_of('nobody here')"),
              one.value("SELECT placode_guard.salt_of('nobody here')"));
    EXPECT_EQ(there.me(), "0");
}

TEST_P(StationGuard, ATokenOpensNothingOnceItsOwnerHasLeft) {
    RawConnection one = at_the_station(), other = at_the_station();
    Intruder here(one), there(other);
    ASSERT_EQ(here.enter("keeper", kPassword), std::to_string(keeper_));
    const std::string token = here.token(), keeper = std::to_string(keeper_);
    EXPECT_EQ(there.resume(std::to_string(anna_), token), "false") << "of another account";
    EXPECT_EQ(there.resume(keeper, std::string(64, '0')), "false");
    ASSERT_EQ(there.resume(keeper, token), "true") << "while it lasts, who has it may";
    EXPECT_EQ(there.me(), keeper);
    EXPECT_TRUE(other.run("SELECT placode_guard.leave(false)"));
    EXPECT_EQ(there.me(), "0");
    EXPECT_EQ(here.me(), keeper);
    EXPECT_TRUE(one.run("SELECT placode_guard.leave(true)"));
    EXPECT_EQ(there.resume(keeper, token), "false");
    EXPECT_TRUE(other.run("SET placode.session = '" + token + "'"));
    EXPECT_EQ(there.me(), "0");
    attack(other, "UPDATE accounts SET roles = 15");
    // An account that is closed acts no more from that moment on.
    ASSERT_EQ(there.enter("anna", kPassword), std::to_string(anna_));
    open()->accounts().set_active(anna_, false);
    EXPECT_EQ(there.me(), "0");
    // Nor does one that somebody has got hold of, once the password is another; whoever has changed
    // it stays.
    const std::string bert = std::to_string(bert_);
    ASSERT_EQ(there.enter("bert", kPassword), bert);
    const std::string stolen = there.token();
    const auto store = open_at_station();
    ASSERT_EQ(store->accounts().sign_in("bert", kPassword).outcome, SignInOutcome::kOk);
    store->accounts().set_password(bert_, "another long one");
    EXPECT_EQ(there.me(), "0");
    EXPECT_EQ(here.resume(bert, stolen), "false");
    EXPECT_EQ(store->attempts().list(bert_).size(), 0u);
    ASSERT_EQ(there.enter("bert", "another long one"), bert);
    ASSERT_EQ(store->accounts().sign_in("keeper", kPassword).outcome, SignInOutcome::kOk);
    store->accounts().set_password(bert_, "yet another long one");
    EXPECT_EQ(there.me(), "0");
}

// Others with the same log-in see the statements of this one.
TEST_P(StationGuard, StatementsHoldNoHashNoCodeAndNoToken) {
    const auto store = open_at_station();
    RawConnection other = at_the_station();
    const auto last = [&other] {
        return other.value(
            "SELECT string_agg(query, ' ') FROM pg_stat_activity WHERE usename = 'theatre' AND pid "
            "<> pg_backend_pid()");
    };
    store->sign_out();
    ASSERT_EQ(store->accounts().sign_in("keeper", kPassword).outcome, SignInOutcome::kOk);
    EXPECT_THAT(last(), Not(IsEmpty())) << "or this proves nothing";
    RawConnection behind = raw();
    ASSERT_TRUE(behind.run("ALTER SYSTEM SET log_statement = 'all'"));
    ASSERT_TRUE(behind.run("SELECT pg_reload_conf()"));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    (void)store->accounts().create(trainee("carla"));
    store->accounts().set_password(bert_, "another password", true);
    (void)store->accounts().sign_in("keeper", kPassword);
    open_at_station()->accounts().accept_invitation(code_, trainee("dora"));
    ASSERT_TRUE(behind.run("ALTER SYSTEM RESET log_statement"));
    ASSERT_TRUE(behind.run("SELECT pg_reload_conf()"));
    const std::string log = World::get().server().log();
    EXPECT_THAT(log, HasSubstr("placode_guard.add_account")) << "or this proves nothing";
    EXPECT_THAT(log, HasSubstr("placode_guard.accept_invitation"));
    for (const char* secret : {"$argon2id$", code_.c_str()})
        EXPECT_THAT(log.substr(log.find("placode_guard.add_account")), Not(HasSubstr(secret)));
}

// The first signature of a trail is the one that all trust goes back to.
TEST_P(StationGuard, ATrailBeginsWithTheFirstAccountAndNothingElse) {
    const PostgresqlServer& server = World::get().server();
    const std::string empty = World::get().server().new_store(options);
    const char* entry =
        "SELECT placode_guard.add_entry('2026-01-01T00:00:00.000Z', 'me', 'store.seal', '', '', "
        "'chain', '', 'key', 'signature')";
    RawConnection station = server.connect_station(empty);
    EXPECT_FALSE(station.run(entry));
    EXPECT_THAT(station.problem(), HasSubstr("you may not"));
    db::StoreOptions its = options;
    its.station = true;
    const auto store = db::open_store(server.station_url(empty), its);
    EXPECT_THAT(failure_of([&] { store->audit().write("me", "session.lock", "", ""); }).what(),
                HasSubstr("you may not"));
    store->sign_out();
    EXPECT_EQ(store->accounts().sign_in("keeper", kPassword).outcome, SignInOutcome::kWrong);
    EXPECT_EQ(server.connect(empty).value("SELECT COUNT(*) FROM audit"), "0");
    db::NewUser keeper = trainee("keeper");
    keeper.roles = kAdministrator;
    (void)store->accounts().create(keeper);
    EXPECT_EQ(server.connect(empty).value("SELECT action FROM audit ORDER BY id LIMIT 1"),
              "user.create");
    EXPECT_TRUE(station.run(entry)) << station.problem();
}

TEST_P(StationGuard, WhoMayDoesAllOfItAtAStation) {
    const auto store = open_at_station();
    store->sign_out();
    db::Accounts& accounts = store->accounts();
    EXPECT_EQ(accounts.sign_in("keeper", "not the password").outcome, SignInOutcome::kWrong);
    EXPECT_EQ(accounts.sign_in("no such login", kPassword).outcome, SignInOutcome::kWrong);
    ASSERT_EQ(accounts.sign_in("keeper", kPassword).outcome, SignInOutcome::kOk);
    const int64_t carla = accounts.create(trainee("carla"));
    accounts.set_roles(carla, static_cast<db::Roles>(Role::kCoordinator));
    accounts.set_active(carla, false);
    EXPECT_EQ(accounts.confirm("carla", kPassword).outcome, SignInOutcome::kDeactivated);
    accounts.set_active(carla, true);
    EXPECT_EQ(accounts.confirm("carla", kPassword).user->id, carla);
    accounts.set_password(bert_, "another password", true);
    accounts.erase(carla, true);
    // A further connection of this program, and one that the server has dropped.
    const auto further = open_at_station();
    further->act_for(keeper_);
    further->accounts().set_roles(bert_, static_cast<db::Roles>(Role::kEducator));
    RawConnection behind = raw();
    ASSERT_TRUE(behind.run(
        "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE usename = 'theatre'"));
    (void)failure_of([&] { accounts.set_roles(bert_, kAdministrator); });
    accounts.set_roles(bert_, kAdministrator);
    EXPECT_EQ(raw().value("SELECT roles FROM accounts WHERE id = " + std::to_string(bert_)), "8");
    store->sign_out();
    const auto late = open_at_station();
    late->act_for(keeper_);
    EXPECT_THAT(failure_of([&] { late->accounts().set_roles(bert_, 1); }).what(),
                HasSubstr("you may not do this on the server"));
    EXPECT_THAT(seals(), IsEmpty());
}

TEST_P(StationGuard, APinBringsBackWhoGaveThePasswordHere) {
    const auto store = open_at_station();
    store->sign_out();
    db::Accounts& accounts = store->accounts();
    EXPECT_EQ(accounts.unlock(anna_, "2580").outcome, SignInOutcome::kWrong) << "never was here";
    ASSERT_EQ(accounts.sign_in("anna", kPassword).outcome, SignInOutcome::kOk);
    store->sign_out();
    EXPECT_EQ(accounts.unlock(anna_, "2581").outcome, SignInOutcome::kWrong);
    ASSERT_EQ(accounts.unlock(anna_, "2580").outcome, SignInOutcome::kOk);
    accounts.set_pin(anna_, "2468");
    store->sign_out();
    ASSERT_EQ(accounts.unlock(anna_, "2468").outcome, SignInOutcome::kOk);
    store->sign_out();
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(accounts.unlock(anna_, "2581").outcome, SignInOutcome::kWrong);
    EXPECT_FALSE(accounts.has_pin(anna_));
    EXPECT_THAT(seals(), IsEmpty());
}

// A trainee adds an exam and cannot say that it was simulated again, nor can its own educator.
TEST_P(StationGuard, WhatAReplayGaveSaysSomebodyElseWhoMay) {
    db::NewUser educator = trainee("eva");
    educator.roles = static_cast<db::Roles>(Role::kEducator);
    const int64_t eva = open()->accounts().create(educator);
    publish_exam(*open(), "diathermy_ring", "7,8");
    for (const int64_t who : {anna_, eva}) assign_exam(*open(), who);
    const auto exam_of = [&](const std::string& login, int64_t who) {
        const auto store = open_at_station();
        store->sign_out();
        EXPECT_EQ(store->accounts().sign_in(login, kPassword).outcome, SignInOutcome::kOk);
        db::AttemptResult result = make_result();
        result.header.device = "mouse";
        result.header.demonstration = false;
        result.end.final_hash = static_cast<uint64_t>(who);
        const db::ExamOrder order = db::begin_exam(
            *store, who, db::prepare_exam(*store, who, "short", "final", "", "", db::utc_now()));
        result.header.task_version = curriculum::shipped_task("diathermy_ring")->version;
        result.header.seed = order.seed;
        result.header.mode = "exam";
        result.header.started_utc = db::utc_now();
        result.exam = order.context;
        result.order = "order of " + login;
        record_to(folder.file(login + ".placode"), result, db::order_checksum(*result.order));
        return store->attempts().save(who, result);
    };
    const int64_t of_anna = exam_of("anna", anna_), of_eva = exam_of("eva", eva);
    const auto judge = [&](const char* login, int64_t id) {
        // As the shell's work in the background: a program, in the name of who has signed in.
        const auto store = open_at_station();
        store->act_as(login);
        db::Attempts& attempts = store->attempts();
        const auto waiting = attempts.waiting_for_replay();
        const bool may = attempts.judges_replay(id);
        EXPECT_EQ(std::count(waiting.begin(), waiting.end(), id), may ? 1 : 0) << login;
        const auto refused =
            AnyOf(HasSubstr("you may not do this on the server"), HasSubstr("there is no attempt"));
        if (may) {
            attempts.set_read(id);
            attempts.set_replay(id, db::ReplayState::kIdentical);
        } else {
            EXPECT_THAT(
                failure_of([&] { attempts.set_replay(id, db::ReplayState::kIdentical); }).what(),
                refused)
                << login;
            EXPECT_THAT(failure_of([&] { attempts.set_read(id); }).what(), refused) << login;
        }
        return may;
    };
    const auto state_of = [&](int64_t id) {
        return raw().value("SELECT replay || void_reason FROM attempts WHERE id = " +
                           std::to_string(id));
    };
    EXPECT_EQ(state_of(of_anna), "1");
    EXPECT_FALSE(judge("anna", of_anna));
    EXPECT_FALSE(judge("anna", of_eva));
    EXPECT_FALSE(judge("eva", of_eva)) << "the own";
    EXPECT_EQ(state_of(of_anna), "1");
    EXPECT_TRUE(judge("eva", of_anna));
    EXPECT_EQ(state_of(of_anna), "2");
    const auto night = open();
    EXPECT_THAT(night->attempts().waiting_for_replay(), testing::ElementsAre(of_eva));
    night->attempts().set_replay(of_eva, db::ReplayState::kIdentical);
    EXPECT_THAT(seals(), IsEmpty());
}

// Rules that somebody has taken away, or of an older version: nobody works on without them.
TEST_P(StationGuard, WithoutTheRulesAStationOpensNothingUntilTheOwnerRenewsThem) {
    for (const char* harm :
         {"DROP POLICY station_changes ON accounts",
          "ALTER TABLE persons DISABLE ROW LEVEL SECURITY",
          "ALTER TABLE persons NO FORCE ROW LEVEL SECURITY",
          "CREATE POLICY mine ON accounts USING (true)",
          "ALTER TABLE attempts DISABLE TRIGGER watch_attempt",
          "DROP TRIGGER need_recording ON attempts",
          "CREATE OR REPLACE FUNCTION placode_guard.version() RETURNS TEXT LANGUAGE sql IMMUTABLE "
          "SET search_path = pg_catalog, pg_temp AS $$ SELECT 'older'::TEXT $$"}) {
        ASSERT_TRUE(raw().run(harm)) << harm;
        const StoreError refused = failure_of([&] { (void)open_at_station(); });
        EXPECT_EQ(refused.kind(), StoreError::Kind::kRefused) << harm;
        EXPECT_THAT(refused.what(), HasSubstr("placodectl station role --apply")) << harm;
        raw().run("DROP POLICY IF EXISTS mine ON accounts");
        owner()->give_station_role();
        EXPECT_NO_THROW((void)open_at_station()) << harm;
    }
    // As an older version left it: the owner only has to open the store.
    for (const char* older : {"DROP SCHEMA placode_guard CASCADE",
                              "GRANT SELECT, UPDATE, INSERT ON accounts TO placode_station"})
        ASSERT_TRUE(raw().run(older)) << older;
    EXPECT_EQ(failure_of([&] { (void)open_at_station(); }).kind(), StoreError::Kind::kRefused);
    (void)owner();
    EXPECT_NO_THROW((void)open_at_station());
    EXPECT_FALSE(at_the_station().run("SELECT password_hash FROM accounts"));
}

}  // namespace THIS_TEST
