// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One person alone on a computer: in without a password, and an account later.

#include <gmock/gmock.h>

#include "tests/store_cases.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;
using db::SignInOutcome;
using db::StoreError;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class LocalProfileTest : public StoreTest {};
INSTANTIATE_TEST_SUITE_P(Engines, LocalProfileTest, testing::Values("Sqlite"), engine_name);
class ServerProfileTest : public StoreTest {};
INSTANTIATE_TEST_SUITE_P(Engines, ServerProfileTest, testing::Values("Postgresql"), engine_name);

db::NewUser named(const std::string& login) {
    return {login, "Anna Nowak", kPassword, static_cast<db::Roles>(db::Role::kTrainee), false};
}

TEST_P(LocalProfileTest, OnePersonBeginsAndComesBackWithoutAPassword) {
    auto store = open();
    store->sign_out();
    EXPECT_FALSE(store->accounts().local_profile());
    EXPECT_EQ(store->accounts().enter().outcome, SignInOutcome::kWrong);
    const int64_t id = store->accounts().begin_alone("Guest");
    store = open();
    store->sign_out();
    ASSERT_TRUE(store->accounts().local_profile());
    EXPECT_EQ(store->accounts().local_profile()->id, id);
    const db::SignIn in = store->accounts().enter();
    ASSERT_EQ(in.outcome, SignInOutcome::kOk);
    EXPECT_EQ(in.user->display_name, "Guest");
    EXPECT_TRUE(db::has_role(in.user->roles, db::Role::kTrainee));
    EXPECT_TRUE(db::has_role(in.user->roles, db::Role::kAdministrator));
    EXPECT_EQ(store->accounts().list().size(), 1u);
    EXPECT_THAT(open()->check(), IsEmpty());
}

TEST_P(LocalProfileTest, NoPasswordFitsIt) {
    const auto store = open();
    store->accounts().begin_alone("Guest");
    store->sign_out();
    for (const char* typed : {"", "guest", kPassword})
        EXPECT_EQ(store->accounts().sign_in("guest", typed).outcome, SignInOutcome::kWrong);
}

TEST_P(LocalProfileTest, NobodyElseComesIntoItsStore) {
    const auto store = open();
    store->accounts().begin_alone("Guest");
    ASSERT_EQ(store->accounts().enter().outcome, SignInOutcome::kOk);
    const auto error = failure_of([&] { store->accounts().create(trainee("bert")); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("create the user \"bert\""),
                                    HasSubstr("make an account of that profile first")));
    EXPECT_EQ(failure_of([&] {
                  (void)store->accounts().invite({0, 1, 0, "", {}, {}, "2099-01-01", {}});
              }).kind(),
              StoreError::Kind::kRefused);
    const auto twice = failure_of([&] { store->accounts().begin_alone("Again"); });
    EXPECT_EQ(twice.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(twice.what(), HasSubstr("begin without an account in"));
    EXPECT_EQ(store->accounts().list().size(), 1u);
}

TEST_P(LocalProfileTest, WhereThereIsAnAccountNobodyBeginsAlone) {
    const auto store = open();
    store->accounts().create(trainee("anna"));
    EXPECT_EQ(failure_of([&] { store->accounts().begin_alone("Guest"); }).kind(),
              StoreError::Kind::kRefused);
    store->sign_out();
    EXPECT_EQ(failure_of([&] { store->accounts().begin_alone("Guest"); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_FALSE(store->accounts().local_profile());
}

TEST_P(LocalProfileTest, ItBecomesAnAccountAsAllOthers) {
    auto store = open();
    const int64_t id = store->accounts().begin_alone("Guest");
    ASSERT_EQ(store->accounts().enter().outcome, SignInOutcome::kOk);
    db::NewUser weak = named("anna");
    weak.password = "short";
    EXPECT_EQ(failure_of([&] { store->accounts().name_local_profile(weak); }).kind(),
              StoreError::Kind::kRefused);
    ASSERT_TRUE(store->accounts().local_profile()) << "a refusal changes nothing";
    store->accounts().name_local_profile(named("anna"));
    EXPECT_FALSE(store->accounts().local_profile());
    store->accounts().create(trainee("bert"));
    store = open();
    store->sign_out();
    EXPECT_EQ(store->accounts().enter().outcome, SignInOutcome::kWrong);
    const db::SignIn in = store->accounts().sign_in("anna", kPassword);
    ASSERT_EQ(in.outcome, SignInOutcome::kOk);
    EXPECT_EQ(in.user->id, id) << "the attempts so far stay this person's";
    EXPECT_EQ(in.user->display_name, "Anna Nowak");
    EXPECT_TRUE(db::has_role(in.user->roles, db::Role::kAdministrator));
    EXPECT_THAT(open()->check(), IsEmpty()) << "the seals follow";
}

// There it could not come in any more.
TEST_P(LocalProfileTest, ItsStoreMovesToNoServerBeforeItHasAPassword) {
    const auto store = open();
    store->accounts().begin_alone("Guest");
    ASSERT_EQ(store->accounts().enter().outcome, SignInOutcome::kOk);
    const char* nowhere = "postgresql://owner:x@127.0.0.1:1/placode";
    db::MoveOptions look;
    look.dry_run = true;
    for (const bool dry : {true, false}) {
        const auto error =
            failure_of([&] { (void)store->move_to(nowhere, dry ? look : db::MoveOptions()); });
        EXPECT_EQ(error.kind(), StoreError::Kind::kRefused);
        EXPECT_THAT(error.what(), AllOf(HasSubstr("move "), HasSubstr("make an account of that")));
    }
    store->accounts().name_local_profile(named("anna"));
    EXPECT_EQ(failure_of([&] { (void)store->move_to(nowhere, look); }).kind(),
              StoreError::Kind::kUnavailable);
}

TEST_P(LocalProfileTest, OnlyItselfMakesAnAccountOfIt) {
    const auto store = open();
    store->accounts().begin_alone("Guest");
    store->sign_out();
    EXPECT_EQ(failure_of([&] { store->accounts().name_local_profile(named("eve")); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_TRUE(store->accounts().local_profile());
}

TEST_P(LocalProfileTest, AnErasedPersonIsNoLocalProfile) {
    const auto store = open();
    db::NewUser admin = trainee("ada");
    admin.roles = static_cast<db::Roles>(db::Role::kAdministrator);
    store->accounts().create(admin);
    store->accounts().erase(store->accounts().create(trainee("anna")), true);
    EXPECT_FALSE(store->accounts().local_profile());
    store->accounts().create(trainee("bert"));
}

TEST_P(ServerProfileTest, OnAServerEverybodyHasAPassword) {
    const auto store = open();
    store->sign_out();
    EXPECT_THAT(failure_of([&] { store->accounts().begin_alone("Guest"); }).what(),
                HasSubstr("everybody has an account"));
    EXPECT_FALSE(store->accounts().local_profile());
    EXPECT_EQ(store->accounts().enter().outcome, SignInOutcome::kWrong);
}

}  // namespace THIS_TEST
