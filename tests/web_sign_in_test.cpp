// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Signing in to the portal and out of it, over the network as a browser does.

#include <set>

#include "tests/web_fixture.h"
#include "ui/web/sessions.h"

namespace placode::test {

namespace THIS_TEST {

class WebSignInTest : public WebTest {};

TEST_P(WebSignInTest, LeadsToTheOwnPageWithTheRightPasswordOnly) {
    Browser one = browser();
    EXPECT_EQ(one.get("/").header("Location"), "/sign-in");
    EXPECT_EQ(one.sign_in("trainee", "wrong password 1").status, 403);
    EXPECT_EQ(one.get("/").status, 303);
    const Seen seen = one.sign_in("trainee");
    EXPECT_EQ(seen.status, 303);
    EXPECT_EQ(seen.header("Location"), "/");
    EXPECT_TRUE(one.get("/").shows("Name of trainee"));
    EXPECT_EQ(one.get("/sign-in").header("Location"), "/");
}

TEST_P(WebSignInTest, SaysTheSameOfAWrongPasswordAndOfNobody) {
    const std::string wrong = browser().sign_in("trainee", "wrong password 1").body;
    const std::string nobody = browser().sign_in("nobody", "wrong password 1").body;
    const auto said = [](const std::string& body) {
        const size_t at = body.find("role=\"alert\"");
        return body.substr(at, body.find("</p>", at) - at);
    };
    EXPECT_EQ(said(wrong), said(nobody));
    EXPECT_NE(said(wrong).find("wrong"), std::string::npos);
}

TEST_P(WebSignInTest, WaitsAsTheStoreDoesAfterFiveWrongPasswords) {
    Browser one = browser();
    for (int i = 0; i < 5; ++i) (void)one.sign_in("trainee", "wrong password 1");
    const Seen seen = one.sign_in("trainee");
    EXPECT_EQ(seen.status, 429);
    EXPECT_FALSE(seen.header("Retry-After").empty());
    EXPECT_EQ(one.get("/").status, 303) << "the right password does not help while it waits";
}

TEST_P(WebSignInTest, WrongPasswordsInABrowserKeepNobodyOutOfAStation) {
    for (int i = 0; i < 10; ++i) (void)browser().sign_in("trainee", "wrong password 1");
    EXPECT_EQ(browser().sign_in("trainee").status, 429) << "or this proves nothing";
    const auto store = open();
    EXPECT_EQ(store->accounts().confirm("trainee", kPassword).outcome, db::SignInOutcome::kOk);
    EXPECT_EQ(store->accounts().sign_in("trainee", kPassword).outcome, db::SignInOutcome::kOk);
    EXPECT_EQ(browser().sign_in("trainee").status, 429) << "nor does that let a guesser go on";
    // A new password ends both waits, and erasing a person leaves no try behind.
    open()->accounts().set_password(people.of["trainee"].person, "another password 1");
    EXPECT_EQ(browser().sign_in("trainee", "another password 1").status, 303);
    for (int i = 0; i < 5; ++i) (void)browser().sign_in("trainee", "wrong password 1");
    open()->accounts().erase(people.of["trainee"].person, false);
    // Left is one row, which counts log-ins that nobody has.
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM sign_in_failures WHERE login_key <> 'unknown'"),
              "0");
}

TEST_P(WebSignInTest, RefusesClosedAccountsAndPasswordsOfSomebodyElse) {
    open()->accounts().set_active(people.of["loner"].person, false);
    EXPECT_TRUE(browser().sign_in("loner").shows("deactivated"));
    EXPECT_TRUE(browser().sign_in("loner", "wrong password 1").shows("is wrong"));
    open()->accounts().set_password(people.of["grouped"].person, "chosen by another", true);
    const Seen seen = browser().sign_in("grouped", "chosen by another");
    EXPECT_EQ(seen.status, 403);
    EXPECT_TRUE(seen.shows("choose your own"));
}

TEST_P(WebSignInTest, CookiesAreForThisSiteAndNoScript) {
    Browser one = browser();
    const std::string line = one.sign_in("trainee").header("Set-Cookie");
    for (const char* flag : {"HttpOnly", "SameSite=Strict", "Path=/"})
        EXPECT_NE(line.find(flag), std::string::npos) << line;
    EXPECT_EQ(line.find("Secure"), std::string::npos);
    EXPECT_GE(one.cookies.at("placode").size(), 52U);
    portal = start({}, true);
    Browser secure = browser();
    (void)secure.get("/sign-in");
    EXPECT_TRUE(secure.cookies.contains("__Host-placode-form"));
    const Seen seen = secure.sign_in("trainee");
    int secured = 0;
    for (const auto& [name, value] : seen.headers)
        if (name == "Set-Cookie") {
            EXPECT_NE(value.find("; Secure"), std::string::npos) << value;
            ++secured;
        }
    EXPECT_EQ(secured, 2);
    EXPECT_TRUE(secure.cookies.contains("__Host-placode"));
}

TEST_P(WebSignInTest, TakesNoFormFromElsewhere) {
    Browser one = browser();
    (void)one.get("/sign-in");
    const httplib::Params form{{"login", "trainee"}, {"password", kPassword}};
    EXPECT_EQ(one.post("/sign-in", form).status, 403);
    httplib::Params guessed = form;
    guessed.emplace("form_token", "guessed");
    EXPECT_EQ(one.post("/sign-in", guessed).status, 403);
    // A password in an address would stand in logs.
    EXPECT_EQ(one.post(std::string("/sign-in?login=trainee&password=x"), form).status, 400);
    Browser in = signed_in("trainee");
    EXPECT_EQ(in.post("/sign-out", {{"form_token", "guessed"}}).status, 403);
    EXPECT_EQ(in.get("/").status, 200);
}

TEST_P(WebSignInTest, SigningOutEndsTheSessionAlsoForACopiedCookie) {
    Browser one = signed_in("trainee");
    const auto copied = one.cookies;
    const std::string token = Browser::token_of(one.get("/").body);
    EXPECT_EQ(one.post("/sign-out", {{"form_token", token}}).status, 303);
    EXPECT_FALSE(one.cookies.contains("placode"));
    one.cookies = copied;
    EXPECT_EQ(one.get("/").status, 303);
}

TEST_P(WebSignInTest, SessionsEndWhenIdleAndAfterTwelveHours) {
    Browser idle = signed_in("trainee");
    now_s += web::Sessions::kIdleS - 1;
    EXPECT_EQ(idle.get("/").status, 200);
    now_s += web::Sessions::kIdleS;
    EXPECT_EQ(idle.get("/").status, 303);
    Browser busy = signed_in("trainee");
    for (int64_t s = 0; s < web::Sessions::kLongestS - 600; s += 600) {
        now_s += 600;
        ASSERT_EQ(busy.get("/sign-in").status, 303) << s;
    }
    now_s += 600;
    EXPECT_EQ(busy.get("/").header("Location"), "/sign-in");
}

TEST_P(WebSignInTest, ClosingAnAccountOrSettingItsPasswordEndsItsSessions) {
    Browser one = signed_in("loner"), other = signed_in("grouped");
    open()->accounts().set_active(people.of["loner"].person, false);
    open()->accounts().set_password(people.of["grouped"].person, "chosen by another", true);
    EXPECT_EQ(one.get("/").header("Location"), "/sign-in");
    EXPECT_EQ(other.get("/").header("Location"), "/sign-in");
    open()->accounts().set_active(people.of["loner"].person, true);
    EXPECT_EQ(one.get("/").status, 303) << "it does not come back with the account";
}

TEST_P(WebSignInTest, RolesThatWereTakenAwayCountAtTheNextPage) {
    Browser one = signed_in("educator");
    EXPECT_EQ(one.get("/cohort").status, 200);
    open()->accounts().set_roles(people.of["educator"].person,
                                 static_cast<db::Roles>(db::Role::kTrainee));
    EXPECT_EQ(one.get("/cohort").status, 403);
}

TEST(WebSessions, AreFewAndTheirTokensNeverTheSame) {
    int64_t now = 0;
    web::Sessions sessions([&] { return now; });
    std::set<std::string> tokens;
    const std::string first = sessions.begin(7);
    for (size_t i = 0; i < web::Sessions::kOfAccount; ++i) {
        ++now;
        tokens.insert(sessions.begin(7));
    }
    EXPECT_EQ(tokens.size(), web::Sessions::kOfAccount);
    EXPECT_EQ(sessions.count(), web::Sessions::kOfAccount);
    EXPECT_FALSE(sessions.find(first)) << "the one that was idle longest has gone";
    for (int64_t account = 100; account < 100 + 2 * int64_t{web::Sessions::kMost}; ++account)
        (void)sessions.begin(account);
    EXPECT_LE(sessions.count(), web::Sessions::kMost);
    EXPECT_FALSE(web::same_token("", ""));
    EXPECT_FALSE(web::same_token("abc", "abd"));
    EXPECT_TRUE(web::same_token("abc", "abc"));
}

INSTANTIATE_TEST_SUITE_P(Engines, WebSignInTest, testing::Values("Sqlite"), engine_name);

}  // namespace THIS_TEST
}  // namespace placode::test
