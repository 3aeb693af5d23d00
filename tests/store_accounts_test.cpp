// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts and the audit trail: the same tests for both engines.

#include <gmock/gmock.h>

#include "tests/store_cases.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// --- accounts ----------------------------------------------------------------------------------

TEST_P(StoreTest, APersonWithTheRightPasswordSignsIn) {
    const auto store = open();
    db::NewUser user = trainee("Anna");
    user.roles = 5;
    user.demonstration = true;
    const int64_t id = store->accounts().create(user);
    const db::SignIn sign_in = store->accounts().sign_in(" anna ", kPassword);
    ASSERT_EQ(sign_in.outcome, db::SignInOutcome::kOk);
    ASSERT_TRUE(sign_in.user.has_value());
    EXPECT_EQ(sign_in.user->id, id);
    EXPECT_EQ(sign_in.user->login, "Anna");
    EXPECT_EQ(sign_in.user->display_name, "Name of Anna");
    EXPECT_EQ(sign_in.user->roles, 5);
    EXPECT_TRUE(sign_in.user->demonstration);
    EXPECT_TRUE(sign_in.user->active);
    EXPECT_FALSE(sign_in.user->created_utc.empty());
}

TEST_P(StoreTest, ItIsKnownWhetherSomebodyElseChoseThePassword) {
    const auto store = open();
    const int64_t own = store->accounts().create(trainee("anna"));
    EXPECT_FALSE(store->accounts().find(own)->password_given);
    db::NewUser user = trainee("bert");
    user.password_given = true;
    const int64_t given = store->accounts().create(user);
    EXPECT_TRUE(open()->accounts().sign_in("bert", kPassword).user->password_given);
    store->accounts().set_password(given, "one of my own 1");
    EXPECT_FALSE(open()->accounts().sign_in("bert", "one of my own 1").user->password_given);
    store->accounts().set_password(own, "forgotten, given anew", true);
    EXPECT_TRUE(store->accounts().find(own)->password_given);
    EXPECT_TRUE(open()->accounts().find(own)->password_given) << "it is kept";
}

TEST_P(StoreTest, AccountsAreStillThereAfterClosing) {
    const int64_t id = open()->accounts().create(trainee("anna"));
    const auto store = open();
    ASSERT_EQ(store->accounts().list().size(), 1u);
    EXPECT_EQ(store->accounts().find(id)->login, "anna");
    EXPECT_EQ(store->accounts().find_login("ANNA")->id, id);
    EXPECT_FALSE(store->accounts().find(id + 1).has_value());
    EXPECT_FALSE(store->accounts().find_login("bert").has_value());
}

TEST_P(StoreTest, LoginsAreUniqueWithoutCase) {
    const auto store = open();
    store->accounts().create(trainee("Żaneta"));
    const auto error = failure_of([&] { store->accounts().create(trainee("żANETA")); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kConflict);
    EXPECT_THAT(error.what(), HasSubstr("taken"));
    EXPECT_EQ(store->accounts().list().size(), 1u);
}

TEST_P(StoreTest, ALoginIsNoNumberOfAnAccount) {
    const auto store = open();
    // As typed, in wide digits, with spaces that a key leaves out, and as the trail writes it.
    for (const char* login : {"1", "12345", " 3 ", "-3", "\xef\xbc\x93", "user 3", "User 3"}) {
        const auto error = failure_of([&] { store->accounts().create(trainee(login)); });
        EXPECT_EQ(error.kind(), StoreError::Kind::kRefused) << login;
        EXPECT_THAT(error.what(), HasSubstr("reads as the number of an account")) << login;
    }
    EXPECT_TRUE(store->accounts().list().empty());
    for (const char* login : {"s3", "3a", "user", "user3", "3.b"})
        EXPECT_NO_THROW(store->accounts().create(trainee(login))) << login;
}

TEST_P(StoreTest, NamesHoldOnlyWhatIsSeen) {
    const auto store = open();
    const auto refused = [](const auto& work, const std::string& what) {
        const auto error = failure_of(work);
        EXPECT_EQ(error.kind(), StoreError::Kind::kRefused) << what;
        EXPECT_THAT(error.what(), HasSubstr("letters that are not seen")) << what;
    };
    for (const std::string hidden :
         {"\n", "\t", "\r", "\x1b[2K", "\x7f", "\xC2\x9B", "\xE2\x80\xAE", "\xE2\x80\x8B",
          "\xE2\x81\xA6", "\xE2\x80\xA8", "\xFF"}) {
        db::NewUser user = trainee("an" + hidden + "na");
        user.display_name = "Anna";
        refused([&] { store->accounts().create(user); }, "login " + hidden);
        user = trainee("anna");
        user.display_name = "Anna" + hidden + "1  adam  administrator";
        refused([&] { store->accounts().create(user); }, "name " + hidden);
        refused([&] { store->groups().create("Autumn" + hidden); }, "group " + hidden);
        refused([&] { store->norms().trust_centre("key", "Here" + hidden); }, "centre " + hidden);
        db::InvitationRecord invitation;
        invitation.roles = 1;
        invitation.expires_utc = "2099-01-01";
        invitation.note = "for Olga" + hidden;
        refused([&] { (void)store->accounts().invite(invitation); }, "invitation " + hidden);
    }
    EXPECT_TRUE(store->accounts().list().empty());
    EXPECT_TRUE(store->groups().list().empty());
    db::NewUser user = trainee("łukasz.żółć");
    user.display_name = "Łukasz Żółć-O'Neil 中文";
    EXPECT_NO_THROW(store->accounts().create(user));
}

TEST_P(StoreTest, WeakPasswordsAreRefused) {
    const auto store = open();
    for (const auto& [login, password] :
         std::vector<std::pair<std::string, std::string>>{{"anna", "short"},
                                                          {"anna", "ąąąąąąąąą"},  // 9 characters
                                                          {"annaannaanna", "AnnaAnnaAnna"}}) {
        db::NewUser user = trainee(login);
        user.password = password;
        EXPECT_EQ(failure_of([&] { store->accounts().create(user); }).kind(),
                  StoreError::Kind::kRefused);
    }
    EXPECT_THAT(store->accounts().list(), IsEmpty());
    const int64_t id = store->accounts().create(trainee("anna"));
    EXPECT_EQ(failure_of([&] { store->accounts().set_password(id, "123456789"); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
}

TEST_P(StoreTest, AWrongPasswordIsNotToldFromAnUnknownLogin) {
    const auto store = open();
    store->accounts().create(trainee("anna"));
    EXPECT_EQ(store->accounts().sign_in("anna", "wrong password").outcome,
              db::SignInOutcome::kWrong);
    EXPECT_EQ(store->accounts().sign_in("nobody", "wrong password").outcome,
              db::SignInOutcome::kWrong);
    EXPECT_FALSE(store->accounts().sign_in("anna", "").user.has_value());
}

// A commit takes milliseconds: one more would tell from afar which log-ins there are.
TEST_P(StoreTest, AnUnknownLoginWritesAsMuchAsAWrongPassword) {
    const auto store = open();
    const auto entries = [&] { return std::stoi(raw().value("SELECT COUNT(*) FROM audit")); };
    const auto written_by = [&](const std::string& login) {
        const int before = entries();
        EXPECT_EQ(store->accounts().sign_in(login, "wrong password").outcome,
                  db::SignInOutcome::kWrong);
        return entries() - before;
    };
    EXPECT_EQ(written_by("nobody"), 0) << "where there is no account, no trail begins";
    store->accounts().create(trainee("anna"));
    EXPECT_EQ(written_by("anna"), 1);
    EXPECT_EQ(written_by("correct horse, typed into the wrong field"), 1);
    const db::AuditRecord entry = open()->audit().trail(1).front();
    EXPECT_EQ(entry.action, "sign_in.unknown");
    EXPECT_EQ(entry.object + entry.detail, "") << "it may have been a password";
    // Made-up names have no wait: their entries are bounded by the day.
    ASSERT_TRUE(
        raw().run("UPDATE sign_in_failures SET failures = 999 WHERE login_key = 'unknown'"));
    EXPECT_EQ(written_by("one more"), 1);
    EXPECT_EQ(written_by("and one too many"), 0);
    EXPECT_EQ(written_by("anna"), 1) << "a real account's are always there";
    now_ms += int64_t{24} * 3600 * 1000 + 1;
    EXPECT_EQ(written_by("of the next day"), 1);
}

TEST_P(StoreTest, AWrongPasswordIsToldUnderWhoeverIsSignedIn) {
    const auto store = open();
    const int64_t anna = store->accounts().create(trainee("anna"));
    db::NewUser proctor = trainee("ewa");
    proctor.roles = static_cast<db::Roles>(db::Role::kEducator);
    store->accounts().create(proctor);
    const auto last = [&] {
        const db::AuditRecord entry = open()->audit().trail(1).front();
        EXPECT_EQ(entry.action, "sign_in.wrong_password");
        return entry.actor;
    };
    store->sign_out();
    (void)store->accounts().sign_in("ewa", "wrong password");
    EXPECT_EQ(last(), "unknown");
    ASSERT_EQ(store->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
    (void)store->accounts().confirm("ewa", "wrong password");
    EXPECT_EQ(last(), "anna") << "tried in the session of user " << anna;
}

TEST_P(StoreTest, ThePasswordItselfIsNowhere) {
    open()->accounts().create(trainee("anna"));
    const std::string hash = raw().value("SELECT password_hash FROM accounts");
    EXPECT_THAT(hash, testing::StartsWith("$argon2id$"));
    EXPECT_THAT(hash, Not(HasSubstr(kPassword)));
}

TEST_P(StoreTest, NamesStandApartFromAccounts) {
    open()->accounts().create(trainee("anna"));
    EXPECT_EQ(raw().value("SELECT login FROM persons"), "anna");
    EXPECT_FALSE(raw().run("SELECT login FROM accounts"));
    EXPECT_FALSE(raw().run("SELECT display_name FROM attempts"));
}

TEST_P(StoreTest, AfterFiveWrongTriesEachFurtherOneWaitsLonger) {
    const auto store = open();
    store->accounts().create(trainee("anna"));
    for (const char* login : {"anna", "nobody"}) {
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(store->accounts().sign_in(login, "wrong password").outcome,
                      db::SignInOutcome::kWrong);
        const db::SignIn throttled = store->accounts().sign_in(login, kPassword);
        EXPECT_EQ(throttled.outcome, db::SignInOutcome::kThrottled) << "even the right one waits";
        EXPECT_EQ(throttled.wait_s, 5);
    }
    now_ms += 5000;
    EXPECT_EQ(store->accounts().sign_in("anna", "wrong password").outcome,
              db::SignInOutcome::kWrong);
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).wait_s, 10);
    // The wait is stored: another program does not go around it.
    EXPECT_EQ(open()->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kThrottled);
    now_ms += 10000;
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
    EXPECT_EQ(store->accounts().sign_in("anna", "wrong password").outcome,
              db::SignInOutcome::kWrong);
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk)
        << "count reset";
}

TEST_P(StoreTest, NoWaitIsLongerThanAQuarterOfAnHour) {
    const auto store = open();
    int longest = 0;
    for (int i = 0; i < 40; ++i) {
        const db::SignIn sign_in = store->accounts().sign_in("nobody", "wrong password");
        longest = std::max(longest, sign_in.wait_s);
        now_ms += int64_t{1000} * sign_in.wait_s;
    }
    EXPECT_EQ(longest, 900);
}

TEST_P(StoreTest, AClockSetBackLocksNobodyOutForLongerThanOneWait) {
    const auto store = open();
    store->accounts().create(trainee("anna"));
    const int64_t right = now_ms;
    now_ms += int64_t{4} * 365 * 86'400'000;  // The battery of the clock was empty.
    for (int i = 0; i < 5; ++i) (void)store->accounts().sign_in("anna", "wrong password");
    now_ms = right;
    const db::SignIn refused = store->accounts().sign_in("anna", kPassword);
    ASSERT_EQ(refused.outcome, db::SignInOutcome::kThrottled);
    EXPECT_EQ(refused.wait_s, 5);
    now_ms += 2000;
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).wait_s, 3) << "the wait passes";
    now_ms += 3000;
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
}

TEST_P(StoreTest, SettingTheClockBackDoesNotShortenAWait) {
    const auto store = open();
    store->accounts().create(trainee("anna"));
    for (int i = 0; i < 5; ++i) (void)store->accounts().sign_in("anna", "wrong password");
    now_ms -= 60'000;
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).wait_s, 5);
    now_ms += 5000;
    EXPECT_EQ(store->accounts().sign_in("anna", "wrong password").outcome,
              db::SignInOutcome::kWrong);
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).wait_s, 10) << "tries still count";
}

TEST_P(StoreTest, RolesAreChangedAndTheTrailSaysFromWhatToWhat) {
    const auto store = open();
    const auto roles = [](auto... role) {
        return static_cast<db::Roles>((int{} | ... | int(role)));
    };
    const int64_t boss = store->accounts().create(
        {"boss", "Boss", kPassword, roles(db::Role::kAdministrator), false});
    const int64_t anna = store->accounts().create(trainee("anna"));
    store->act_as("boss");
    store->accounts().set_roles(anna, roles(db::Role::kTrainee, db::Role::kEducator));
    EXPECT_EQ(store->accounts().find(anna)->roles, roles(db::Role::kTrainee, db::Role::kEducator));
    const auto entry = store->audit().trail(1).at(0);
    EXPECT_EQ(entry.action, "user.roles");
    EXPECT_EQ(entry.actor, "boss");
    EXPECT_EQ(entry.object, "user " + std::to_string(anna));
    EXPECT_THAT(entry.detail, testing::HasSubstr(" -> "));
    // The same roles again are no change, and no entry.
    store->accounts().set_roles(anna, roles(db::Role::kTrainee, db::Role::kEducator));
    EXPECT_EQ(store->audit().trail(1).at(0).id, entry.id);
    EXPECT_EQ(failure_of([&] { store->accounts().set_roles(anna, 0); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(
        failure_of([&] { store->accounts().set_roles(boss, roles(db::Role::kTrainee)); }).kind(),
        StoreError::Kind::kRefused)
        << "the last administrator";
    store->accounts().set_roles(anna, roles(db::Role::kAdministrator));
    store->accounts().set_roles(boss, roles(db::Role::kTrainee));
    EXPECT_THAT(store->check(), testing::IsEmpty());
}

TEST_P(StoreTest, ADeactivatedPersonCannotSignIn) {
    const auto store = open();
    const int64_t id = store->accounts().create(trainee("anna"));
    store->accounts().set_active(id, false);
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome,
              db::SignInOutcome::kDeactivated);
    EXPECT_EQ(store->accounts().sign_in("anna", "wrong password").outcome,
              db::SignInOutcome::kWrong);
    store->accounts().set_active(id, true);
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
}

TEST_P(StoreTest, TheLastAdministratorStays) {
    const auto store = open();
    db::NewUser admin = trainee("admin");
    admin.roles = static_cast<db::Roles>(db::Role::kAdministrator);
    const int64_t first = store->accounts().create(admin);
    EXPECT_EQ(failure_of([&] { store->accounts().set_active(first, false); }).kind(),
              StoreError::Kind::kRefused);
    admin.login = "second";
    store->accounts().create(admin);
    store->accounts().set_active(first, false);
    EXPECT_FALSE(store->accounts().find(first)->active);
}

TEST_P(StoreTest, ANewPasswordReplacesTheOldOneAndEndsTheWait) {
    const auto store = open();
    const int64_t id = store->accounts().create(trainee("anna"));
    for (int i = 0; i < 6; ++i) (void)store->accounts().sign_in("anna", "wrong password");
    store->accounts().set_password(id, "another long password");
    EXPECT_EQ(store->accounts().sign_in("anna", kPassword).outcome, db::SignInOutcome::kWrong);
    EXPECT_EQ(store->accounts().sign_in("anna", "another long password").outcome,
              db::SignInOutcome::kOk);
    EXPECT_EQ(
        failure_of([&] { open()->accounts().set_password(999, "another long password"); }).kind(),
        StoreError::Kind::kNotFound);
}

// --- audit -------------------------------------------------------------------------------------

TEST_P(StoreTest, EveryChangeLeavesATraceWithItsActor) {
    const auto store = open();
    store->act_as("setup");
    const int64_t id = store->accounts().create(trainee("anna"));
    (void)store->accounts().sign_in("anna", kPassword);
    store->attempts().save(id, make_result());
    store->audit().write("anna", "export", "study pilot", "3 rows");
    const auto reader = open();  // Anna may not see the trail.
    const auto trail = reader->audit().trail(10);
    ASSERT_EQ(trail.size(), 4u);  // Newest first.
    EXPECT_EQ(trail[0].action, "export");
    EXPECT_EQ(trail[0].detail, "3 rows");
    EXPECT_EQ(trail[1].action, "attempt.save");
    EXPECT_EQ(trail[1].actor, "anna");
    EXPECT_EQ(trail[2].action, "sign_in");
    EXPECT_EQ(trail[3].actor, "setup");
    EXPECT_EQ(trail[3].object, "user " + std::to_string(id));
    EXPECT_EQ(reader->audit().trail(2).size(), 2u);
}

TEST_P(StoreTest, TheAuditTrailCannotBeChanged) {
    const auto store = open();
    store->audit().write("anna", "export", "study", "");
    RawConnection forger = raw();
    EXPECT_FALSE(forger.run("UPDATE audit SET actor = 'bert'"));
    EXPECT_THAT(forger.problem(), HasSubstr("append-only"));
    EXPECT_FALSE(forger.run("DELETE FROM audit"));
    if (!is_sqlite()) {
        EXPECT_FALSE(forger.run("TRUNCATE audit"));
    }
    EXPECT_EQ(store->audit().trail(10).at(0).actor, "anna");
}

TEST_P(StoreTest, AForgedAuditTrailIsFound) {
    const auto store = open();
    for (int i = 0; i < 3; ++i)
        store->audit().write("anna", "export", "study " + std::to_string(i), "");
    EXPECT_THAT(store->check(), IsEmpty());
    RawConnection forger = raw();
    if (is_sqlite()) {
        ASSERT_TRUE(forger.run("DROP TRIGGER audit_is_never_changed"));
    } else {
        ASSERT_TRUE(forger.run("ALTER TABLE audit DISABLE TRIGGER ALL"));
    }
    ASSERT_TRUE(forger.run("UPDATE audit SET actor = 'bert' WHERE id = 2"));
    ASSERT_EQ(store->check().size(), 1u);
    EXPECT_THAT(store->check()[0], HasSubstr("entry 2"));
}

}  // namespace THIS_TEST
