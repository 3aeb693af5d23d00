// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// People come into the portal from a learning platform (LTI 1.3), or are refused, over the network
// as browsers and platforms do it.

#include <sys/stat.h>

#include "tests/mock_platform.h"
#include "tests/web_world.h"
#include "ui/lti/settings.h"
#include "ui/web/lti_visitors.h"

namespace placode::test {

namespace THIS_TEST {

/// What a platform has a browser send.
struct Answered {
    std::string state, token, hint;
    [[nodiscard]] httplib::Params form() const { return {{"state", state}, {"id_token", token}}; }
};

class WebLtiTest : public WebTest {
 protected:
    void ready() override {
        write_key(tool_key().private_pem());
        write_settings();
        WebTest::ready();
        (void)open()->attempts().save(people.of["trainee"].person,
                                      attempt_of(81.5, assessment::Verdict::kPassed, 1));
        begin_at("http://127.0.0.1:" + std::to_string(portal->port()));
    }
    void arrange(web::PortalOptions& portal_options) override {
        portal_options.lti_file = settings_file();
        portal_options.log = [this](const std::string& line) {
            const std::lock_guard lock(log_mutex);
            log += line + "\n";
        };
    }
    [[nodiscard]] std::string settings_file() const { return folder.file("lti.json"); }
    void write_key(const std::string& pem) const {
        std::ofstream(folder.file("tool.pem")) << pem;
        ASSERT_EQ(::chmod(folder.file("tool.pem").c_str(), 0600), 0);
    }
    void write_settings() {
        PlainJson of_platform = platform.settings();
        if (people.of.contains("trainee"))
            for (const auto& [subject, login] : linked)
                of_platform["links"].push_back(
                    {{"sub", subject}, {"account", people.of[login].person}, {"login", login}});
        std::ofstream(settings_file()) << PlainJson{{"version", 1},
                                                    {"tool_url", tool_url},
                                                    {"private_key_file", "tool.pem"},
                                                    {"platforms", {of_platform}}};
    }
    void begin_at(const std::string& url) {
        tool_url = url;
        platform.launch_url = url + "/lti/launch";
        write_settings();
    }

    [[nodiscard]] static std::string login_path(const std::string& subject) {
        return "/lti/login?iss=https%3A%2F%2Fmoodle.example.edu&client_id=placode-7&login_hint=" +
               subject + "&target_link_uri=https%3A%2F%2Fx.example&lti_message_hint=hint-7";
    }
    /// The browser goes where the portal sends it, and comes back with what the platform says.
    [[nodiscard]] Answered asked(const Seen& login) {
        EXPECT_EQ(login.status, 303);
        // The client has decoded it; that it is encoded is for web_client_test.
        const std::string there = login.header("Location"), host = platform.url("");
        EXPECT_TRUE(there.starts_with(host)) << there;
        httplib::Client client("127.0.0.1", platform.port());
        client.set_url_encode(false);
        const auto said = client.Get(there.substr(std::min(host.size(), there.size())));
        if (!said || said->status != 200) {
            ADD_FAILURE() << login.header("Location");
            return {};
        }
        const auto json = PlainJson::parse(said->body);
        EXPECT_EQ(json["action"], platform.launch_url);
        return {json["state"], json["id_token"], json["hint"]};
    }
    Seen launch(Browser& one, const std::string& subject = "sub-1") {
        return one.post("/lti/launch", asked(one.get(login_path(subject))).form());
    }
    Seen launch_spoilt(Browser& one, const std::function<void(Saying&)>& spoil) {
        platform.spoil = spoil;
        const Seen seen = launch(one);
        platform.spoil = nullptr;
        return seen;
    }
    void expect_nobody(Browser& one, const std::string& what) {
        EXPECT_FALSE(one.cookies.contains("placode")) << what;
        EXPECT_EQ(one.get("/").header("Location"), "/sign-in") << what;
    }

    MockPlatform platform;
    std::string tool_url = "http://127.0.0.1:1";
    std::map<std::string, std::string> linked{{"sub-1", "trainee"},
                                              {"sub-2", "grouped"},
                                              {"sub-boss", "administrator"},
                                              {"sub-educator", "educator"}};
    std::mutex log_mutex;
    std::string log;
};

TEST_P(WebLtiTest, StartsTheSessionOfTheLinkedAccount) {
    Browser one = browser();
    const Seen login = one.get(login_path("sub-1"));
    EXPECT_TRUE(login.header("Location").starts_with(platform.url("/authorize?from=placode&")));
    const std::string cookie = login.header("Set-Cookie");
    EXPECT_TRUE(cookie.starts_with("placode-lti=")) << cookie;
    EXPECT_NE(cookie.find("; Path=/; HttpOnly; Max-Age=300"), std::string::npos) << cookie;
    const Answered answered = asked(login);
    EXPECT_EQ(answered.hint, "hint-7") << "what the platform wants to have back";
    const Seen seen = one.post("/lti/launch", answered.form());
    EXPECT_EQ(seen.status, 200) << seen.body;
    EXPECT_TRUE(seen.shows("You are signed in as Name of trainee."));
    EXPECT_FALSE(one.cookies.contains("placode-lti")) << "it has done its work";
    const std::string page =
        "/people/" + std::to_string(people.of["trainee"].person) + "/tasks/diathermy_ring";
    EXPECT_EQ(seen.header("Refresh"), "0; url=" + page);
    EXPECT_TRUE(seen.shows("href=\"" + page + "\""));
    EXPECT_EQ(one.get(page).status, 200);
    EXPECT_TRUE(one.get("/").shows("Name of trainee"));
    EXPECT_EQ(one.get("/cohort").status, 403) << "with the rights of that account";
    EXPECT_TRUE(platform.odd.empty()) << platform.odd.front();
    EXPECT_NE(log.find("line item " + platform.url("/lineitems/a?type_id=1")), std::string::npos);
}

TEST_P(WebLtiTest, TheSessionEndsWithItsLink) {
    Browser one = browser(), other = browser();
    ASSERT_EQ(launch(one, "sub-1").status, 200);
    ASSERT_EQ(launch(other, "sub-2").status, 200);
    linked.erase("sub-1");
    write_settings();
    EXPECT_EQ(one.get("/").header("Location"), "/sign-in");
    EXPECT_EQ(other.get("/").status, 200) << "another's link is not touched";
    EXPECT_NE(log.find("its link with " + std::string(MockPlatform::kIssuer) + " is gone"),
              std::string::npos);
    linked["sub-1"] = "trainee";
    write_settings();
    EXPECT_EQ(one.get("/").header("Location"), "/sign-in") << "and does not come back with it";
    std::swap(linked["sub-1"], linked["sub-2"]);
    write_settings();
    EXPECT_EQ(other.get("/").header("Location"), "/sign-in") << "the link is another person's now";
}

TEST_P(WebLtiTest, SettingsThatCannotBeReadLetNobodyStay) {
    Browser one = browser();
    ASSERT_EQ(launch(one).status, 200);
    std::ofstream(settings_file()) << "{";
    EXPECT_EQ(one.get("/").header("Location"), "/sign-in");
}

TEST_P(WebLtiTest, TheSignInMayBeginByPost) {
    Browser one = browser();
    const Seen login = one.post("/lti/login", {{"iss", MockPlatform::kIssuer},
                                               {"login_hint", "sub-2"},
                                               {"target_link_uri", "https://x.example"}});
    EXPECT_EQ(one.post("/lti/launch", asked(login).form()).status, 200);
    EXPECT_TRUE(one.get("/").shows("Name of grouped"));
}

TEST_P(WebLtiTest, LeadsToTheOwnPageWithoutATaskThatHasBeenDone) {
    for (const char* task : {"", "incision_flat", "../../x", "no such task"}) {
        Browser one = browser();
        const Seen seen = launch_spoilt(one, [&](Saying& saying) {
            saying.claims[kLtiClaim + "custom"] = {{"task", task}};
        });
        EXPECT_EQ(seen.header("Refresh"), "0; url=/") << task;
    }
    Browser one = browser();
    EXPECT_EQ(launch_spoilt(one, [](Saying& saying) { saying.claims.erase(kLtiClaim + "custom"); })
                  .header("Refresh"),
              "0; url=/");
}

using Spoil = std::function<void(Saying&)>;
struct Forgery {
    const char *what, *words;
    int status;
    Spoil spoil;
};

Spoil claim(const std::string& key, const PlainJson& value) {
    return [key, value](Saying& saying) { saying.claims[key] = value; };
}

std::string keyed_hash(const std::string& key, const std::string& bytes) {
    unsigned char hash[32];
    unsigned length = 0;
    HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
         reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), hash, &length);
    return {reinterpret_cast<char*>(hash), length};
}

std::vector<Forgery> forged_signatures() {
    const char* not_rs256 = "not signed with RS256";
    const auto none = [](const PlainJson& header, const PlainJson& claims) {
        return to_base64url(header.dump()) + "." + to_base64url(claims.dump()) + ".";
    };
    const auto hashed = [](const PlainJson& header, const PlainJson& claims) {
        const std::string bytes = to_base64url(header.dump()) + "." + to_base64url(claims.dump());
        return bytes + "." + to_base64url(keyed_hash(platform_key().public_pem(), bytes));
    };
    const auto others = [](const PlainJson& header, const PlainJson& claims) {
        return signed_by(other_key(), header, claims);
    };
    const auto tampered = [](const PlainJson& header, const PlainJson& claims) {
        const std::string real = signed_by(platform_key(), header, claims);
        PlainJson other = claims;
        other["sub"] = "sub-2";
        return real.substr(0, real.find('.') + 1) + to_base64url(other.dump()) +
               real.substr(real.rfind('.'));
    };
    return {
        {"alg none", not_rs256, 403, [=](Saying& s) { s.header["alg"] = "none", s.sign = none; }},
        {"alg None", not_rs256, 403, [=](Saying& s) { s.header["alg"] = "None", s.sign = none; }},
        {"no alg", not_rs256, 403, [=](Saying& s) { s.header.erase("alg"), s.sign = none; }},
        {"HS256 with the public key", not_rs256, 403,
         [=](Saying& s) { s.header["alg"] = "HS256", s.sign = hashed; }},
        {"RS256 with a keyed hash", "signature of the platform", 403,
         [=](Saying& s) { s.sign = hashed; }},
        {"RS256 without a signature", "signature of the platform", 403,
         [=](Saying& s) { s.sign = none; }},
        {"another key under the same name", "signature of the platform", 403,
         [=](Saying& s) { s.sign = others; }},
        {"claims changed afterwards", "signature of the platform", 403,
         [=](Saying& s) { s.sign = tampered; }},
        {"unknown kid", "does not publish", 403,
         [=](Saying& s) { s.header["kid"] = other_key().id, s.sign = others; }},
        {"no kid", "does not publish", 403, [](Saying& s) { s.header.erase("kid"); }},
        {"a key in the head", "does not publish", 403,
         [=](Saying& s) {
             s.header["jwk"] = other_key().public_jwk();
             s.header["kid"] = other_key().id;
             s.sign = others;
         }},
        {"crit", not_rs256, 403, [](Saying& s) { s.header["crit"] = {"exp"}; }},
        {"no token", "incomplete", 400,
         [](Saying& s) { s.sign = [](const auto&, const auto&) { return ""; }; }},
        {"a token of two parts", "incomplete", 400,
         [](Saying& s) { s.sign = [](const auto&, const auto&) { return "e30.e30"; }; }},
        {"no JSON", "incomplete", 400,
         [](Saying& s) { s.sign = [](const auto&, const auto&) { return "%%%.e30.AA"; }; }},
    };
}

std::vector<Forgery> wrong_claims() {
    const auto now = static_cast<int64_t>(std::time(nullptr));
    return {
        {"another issuer", "another platform", 403, claim("iss", "https://evil.example")},
        {"another audience", "for another tool", 403, claim("aud", "placode-8")},
        {"a list without us", "for another tool", 403, claim("aud", PlainJson{"a", "b"})},
        {"several, issued to nobody", "for another tool", 403,
         claim("aud", PlainJson{"placode-7", "b"})},
        {"issued to another", "for another tool", 403, claim("azp", "b")},
        {"no audience", "for another tool", 403, [](Saying& s) { s.claims.erase("aud"); }},
        {"over", "too old", 403, claim("exp", now - 61)},
        {"of the future", "too old", 403, claim("iat", now + 120)},
        {"without an end", "incomplete", 400, [](Saying& s) { s.claims.erase("exp"); }},
        {"an end that is no time", "incomplete", 400, claim("exp", "tomorrow")},
        {"an end beyond all time", "incomplete", 400, claim("exp", 1e300)},
        {"without a beginning", "incomplete", 400, [](Saying& s) { s.claims.erase("iat"); }},
        {"another nonce", "another sign-in", 403, claim("nonce", std::string(52, 'a'))},
        {"no nonce", "another sign-in", 403, [](Saying& s) { s.claims.erase("nonce"); }},
        {"another deployment", "deployment", 403, claim(kLtiClaim + "deployment_id", "2")},
        {"no deployment", "deployment", 403,
         [](Saying& s) { s.claims.erase(kLtiClaim + "deployment_id"); }},
        {"deep linking", "nothing else", 403,
         claim(kLtiClaim + "message_type", "LtiDeepLinkingRequest")},
        {"an older version", "nothing else", 403, claim(kLtiClaim + "version", "1.1")},
        {"a long sub", "incomplete", 400, claim("sub", std::string(256, 'a'))},
        {"no sub", "did not say who you are", 403, [](Saying& s) { s.claims.erase("sub"); }},
    };
}

TEST_P(WebLtiTest, RefusesWhatThePlatformDidNotSign) {
    for (const Forgery& each : forged_signatures()) {
        Browser one = browser();
        const Seen seen = launch_spoilt(one, each.spoil);
        EXPECT_EQ(seen.status, each.status) << each.what;
        EXPECT_TRUE(seen.shows(each.words)) << each.what << ": " << seen.body;
        expect_nobody(one, each.what);
    }
}

TEST_P(WebLtiTest, RefusesWhatIsNotMeantForThisSignIn) {
    for (const Forgery& each : wrong_claims()) {
        Browser one = browser();
        const Seen seen = launch_spoilt(one, each.spoil);
        EXPECT_EQ(seen.status, each.status) << each.what;
        EXPECT_TRUE(seen.shows(each.words)) << each.what << ": " << seen.body;
        expect_nobody(one, each.what);
    }
}

TEST_P(WebLtiTest, TakesWhatTheStandardAllows) {
    const auto now = static_cast<int64_t>(std::time(nullptr));
    const std::vector<std::pair<const char*, Spoil>> cases{
        {"a list of one", claim("aud", PlainJson::array({"placode-7"}))},
        {"several, issued to us",
         [](Saying& s) {
             s.claims["aud"] = {"placode-7", "b"};
             s.claims["azp"] = "placode-7";
         }},
        {"a clock that is slow", claim("exp", now - 30)},
        {"a clock that is fast", claim("iat", now + 30)},
        {"the other deployment", claim(kLtiClaim + "deployment_id", "3")}};
    for (const auto& [what, spoil] : cases) {
        Browser one = browser();
        EXPECT_EQ(launch_spoilt(one, spoil).status, 200) << what;
        EXPECT_TRUE(one.get("/").shows("Name of trainee")) << what;
    }
}

TEST_P(WebLtiTest, AnAnswerCountsOnce) {
    Browser one = browser();
    const Answered first = asked(one.get(login_path("sub-1")));
    const auto cookies = one.cookies;
    EXPECT_EQ(one.post("/lti/launch", first.form()).status, 200);
    Browser thief = browser();
    thief.cookies = {{"placode-lti", cookies.at("placode-lti")}};
    const Seen again = thief.post("/lti/launch", first.form());
    EXPECT_EQ(again.status, 400);
    EXPECT_TRUE(again.shows("was used already"));
    // The same token for a sign-in of the thief's own.
    Answered own = asked(thief.get(login_path("sub-2")));
    own.token = first.token;
    const Seen replayed = thief.post("/lti/launch", own.form());
    EXPECT_EQ(replayed.status, 403);
    EXPECT_TRUE(replayed.shows("another sign-in"));
    expect_nobody(thief, "replay");
}

TEST_P(WebLtiTest, AnAnswerIsForTheBrowserThatAsked) {
    Browser one = browser(), other = browser();
    const Answered answered = asked(one.get(login_path("sub-1")));
    (void)other.get(login_path("sub-2"));
    const Seen seen = other.post("/lti/launch", answered.form());
    EXPECT_EQ(seen.status, 403);
    EXPECT_TRUE(seen.shows("another browser"));
    expect_nobody(other, "another's state");
    EXPECT_EQ(one.post("/lti/launch", answered.form()).status, 400) << "it was shown to somebody";
    Browser bare = browser();
    const Answered mine = asked(bare.get(login_path("sub-1")));
    bare.cookies.clear();
    EXPECT_EQ(bare.post("/lti/launch", mine.form()).status, 403);
    expect_nobody(bare, "no cookie");
    EXPECT_EQ(bare.post("/lti/launch", {{"state", "guessed"}, {"id_token", mine.token}}).status,
              400);
    EXPECT_EQ(bare.post("/lti/launch", {{"id_token", mine.token}}).status, 400);
}

TEST_P(WebLtiTest, ASignInIsOverAfterFiveMinutes) {
    Browser one = browser();
    Answered answered = asked(one.get(login_path("sub-1")));
    now_s += web::Arrivals::kLifeS;
    EXPECT_EQ(one.post("/lti/launch", answered.form()).status, 400);
    answered = asked(one.get(login_path("sub-1")));
    now_s += web::Arrivals::kLifeS - 1;
    EXPECT_EQ(one.post("/lti/launch", answered.form()).status, 200);
}

TEST_P(WebLtiTest, NobodyIsGuessedFromNameOrAddress) {
    Browser one = browser();
    const Seen seen = launch_spoilt(one, [](Saying& s) {
        s.claims["sub"] = "77<script>";
        s.claims["email"] = "trainee";
        s.claims["name"] = "Name of trainee";
        s.claims["preferred_username"] = "trainee";
    });
    EXPECT_EQ(seen.status, 403);
    EXPECT_TRUE(seen.shows("Give an administrator"));
    EXPECT_TRUE(seen.shows("<code>77&lt;script&gt;</code>"));
    EXPECT_TRUE(seen.shows(MockPlatform::kIssuer));
    expect_nobody(one, "not linked");
    EXPECT_NE(log.find("nobody is linked with \"77<script>\""), std::string::npos) << log;
    // A link counts from the moment when it is there.
    lti::add_link(settings_file(), MockPlatform::kIssuer, "",
                  {"77<script>", people.of["loner"].person, "loner"});
    EXPECT_EQ(launch_spoilt(one, claim("sub", "77<script>")).status, 200);
    EXPECT_TRUE(one.get("/").shows("Name of loner"));
}

TEST_P(WebLtiTest, ALinkOpensNoAccountThatIsClosedChangedOrAnAdministrators) {
    Browser one = browser();
    EXPECT_TRUE(launch(one, "sub-boss").shows("Administrators sign in with their password"));
    expect_nobody(one, "administrator");
    open()->accounts().set_password(people.of["grouped"].person, "chosen by another", true);
    EXPECT_TRUE(launch(one, "sub-2").shows("choose your own"));
    expect_nobody(one, "given password");
    open()->accounts().set_active(people.of["trainee"].person, false);
    Seen seen = launch(one, "sub-1");
    EXPECT_EQ(seen.status, 403);
    EXPECT_TRUE(seen.shows("closed or was changed"));
    expect_nobody(one, "closed");
    // The number of one person with the name of another.
    lti::add_link(settings_file(), MockPlatform::kIssuer, "",
                  {"sub-3", people.of["loner"].person, "stranger"});
    EXPECT_TRUE(launch(one, "sub-3").shows("closed or was changed"));
    lti::add_link(settings_file(), MockPlatform::kIssuer, "", {"sub-4", 99999, "stranger"});
    EXPECT_TRUE(launch(one, "sub-4").shows("closed or was changed"));
    expect_nobody(one, "not theirs");
    EXPECT_EQ(launch(one, "sub-educator").status, 200);
    EXPECT_EQ(one.get("/cohort").status, 200);
}

TEST_P(WebLtiTest, WritesNothing) {
    const std::string before = checksum_of_the_store();
    for (const auto& [subject, login] : linked) {
        Browser one = browser();
        (void)launch(one, subject);
        (void)one.get("/");
        (void)one.get("/lti/jwks.json");
    }
    Browser one = browser();
    (void)launch(one, "nobody");
    for (const Forgery& each : forged_signatures()) (void)launch_spoilt(one, each.spoil);
    EXPECT_EQ(checksum_of_the_store(), before);
}

TEST_P(WebLtiTest, FollowsAPlatformThatChangesItsKey) {
    Browser one = browser();
    EXPECT_EQ(launch(one).status, 200);
    EXPECT_EQ(launch(one).status, 200);
    EXPECT_EQ(platform.asked_for_keys, 1) << "kept";
    const auto by_new_key = [](Saying& s) {
        s.header["kid"] = other_key().id;
        s.sign = [](const PlainJson& h, const PlainJson& c) {
            return signed_by(other_key(), h, c);
        };
    };
    // Whoever makes up names of keys does not have the platform asked each time.
    for (int i = 0; i < 10; ++i) EXPECT_EQ(launch_spoilt(one, by_new_key).status, 403);
    EXPECT_EQ(platform.asked_for_keys, 1);
    platform.keys = {other_key().public_jwk()};
    now_s += lti::PlatformKeys::kAskAgainS;
    EXPECT_EQ(launch_spoilt(one, by_new_key).status, 200);
    EXPECT_EQ(platform.asked_for_keys, 2);
    EXPECT_EQ(launch(one).status, 403) << "the old key is not among the new ones";
    // A key that was taken back is not used for longer than an hour.
    platform.keys = {platform_key().public_jwk()};
    now_s += lti::PlatformKeys::kKeptS;
    Browser other = browser();
    EXPECT_EQ(launch_spoilt(other, by_new_key).status, 403);
    expect_nobody(other, "a key taken back");
}

TEST_P(WebLtiTest, TakesNobodyInWhileThePlatformsKeysCannotBeRead) {
    Browser one = browser();
    platform.keys = {
        PlainJson{{"kty", "RSA"}, {"kid", platform_key().id}, {"n", "AQAB"}, {"e", "AQAB"}}};
    EXPECT_TRUE(launch(one).shows("signature of the platform")) << "a key of 24 bits";
    now_s += lti::PlatformKeys::kKeptS;
    const Answered answered = asked(one.get(login_path("sub-1")));
    platform.stop();
    const Seen seen = one.post("/lti/launch", answered.form());
    EXPECT_EQ(seen.status, 403);
    EXPECT_TRUE(seen.shows("keys cannot be read now"));
    EXPECT_NE(log.find("/jwks: it cannot be reached"), std::string::npos) << log;
}

TEST_P(WebLtiTest, ReadsKeysFromAFile) {
    std::ofstream(folder.file("keys.json"))
        << PlainJson{{"keys", {platform_key().public_jwk()}}}.dump();
    PlainJson settings = PlainJson::parse(read_text(settings_file()));
    settings["platforms"][0].erase("jwks_url");
    settings["platforms"][0]["jwks_file"] = "keys.json";
    std::ofstream(settings_file()) << settings;
    Browser one = browser();
    EXPECT_EQ(launch(one).status, 200);
    EXPECT_EQ(platform.asked_for_keys, 0);
}

TEST_P(WebLtiTest, PublishesItsOwnKeyAndNothingSecret) {
    const Seen seen = browser().get("/lti/jwks.json");
    EXPECT_EQ(seen.status, 200);
    EXPECT_EQ(seen.header("Content-Type"), "application/json");
    const auto keys = PlainJson::parse(seen.body)["keys"];
    ASSERT_EQ(keys.size(), 1U);
    PlainJson expected = tool_key().public_jwk();
    expected["kid"] = keys[0]["kid"];
    EXPECT_EQ(keys[0], expected);
}

TEST_P(WebLtiTest, ManyAtOnceWait) {
    Browser one = browser();
    int refused = 0;
    for (int i = 0; i < 220; ++i) {
        const Seen seen = one.get(login_path("sub-1"));
        if (seen.status != 429) continue;
        ++refused;
        EXPECT_EQ(seen.header("Retry-After"), "1");
        EXPECT_TRUE(seen.shows("Many people are signing in"));
    }
    EXPECT_EQ(refused, 20);
    refused = 0;
    for (int i = 0; i < 220; ++i)
        refused += one.post("/lti/launch", {{"state", "guessed"}}).status == 429 ? 1 : 0;
    EXPECT_EQ(refused, 20);
    now_s += 1;
    EXPECT_EQ(launch(one).status, 200);
}

TEST_P(WebLtiTest, AsksNoPlatformThatIsNotRegistered) {
    Browser one = browser();
    for (const char* query :
         {"", "?login_hint=1", "?iss=https%3A%2F%2Fevil.example&login_hint=1",
          "?iss=https%3A%2F%2Fmoodle.example.edu&client_id=other&login_hint=1"}) {
        const Seen seen = one.get(std::string("/lti/login") + query);
        EXPECT_EQ(seen.status, 400) << query;
        EXPECT_TRUE(seen.shows("not registered here")) << query;
        EXPECT_EQ(seen.header("Location"), "");
    }
    EXPECT_EQ(one.get("/lti/login?iss=https%3A%2F%2Fmoodle.example.edu").status, 400);
    // What platforms send along may be long, and not without an end.
    EXPECT_EQ(one.get(login_path("sub-1") + std::string(1500, 'a')).status, 303);
    EXPECT_EQ(one.get(login_path("sub-1") + std::string(4100, 'a')).status, 414);
    EXPECT_EQ(one.post("/lti/login?iss=x", {{"login_hint", "1"}}).status, 400);
    for (const char* path : {"/lti/launch", "/lti/", "/lti/x"})
        EXPECT_EQ(one.get(path).status, 404) << path;
    for (const char* method : {"PUT", "PATCH", "DELETE"})
        for (const char* path : {"/lti/launch", "/lti/login", "/lti/jwks.json"})
            EXPECT_EQ(one.send(method, path).status, 405) << method << path;
    EXPECT_EQ(one.send("POST", "/lti/jwks.json").status, 405);
}

TEST_P(WebLtiTest, SaysWhyThePlatformDidNotSignIn) {
    Browser one = browser();
    Answered answered = asked(one.get(login_path("sub-1")));
    Seen seen = one.post("/lti/launch", {{"state", answered.state}, {"error", "login_required"}});
    EXPECT_EQ(seen.status, 403);
    EXPECT_TRUE(seen.shows("did not sign you in: login_required"));
    answered = asked(one.get(login_path("sub-1")));
    seen = one.post("/lti/launch", {{"state", answered.state}, {"error", "<b>Call 0700"}});
    EXPECT_FALSE(seen.shows("Call 0700"));
}

TEST_P(WebLtiTest, SpeaksPolish) {
    Browser one = browser();
    one.languages = "pl";
    EXPECT_TRUE(launch(one, "nobody").shows("Podaj administratorowi Placode"));
    EXPECT_TRUE(launch_spoilt(one, claim("aud", "x")).shows("dla innego narzędzia"));
    const Seen seen = launch(one);
    EXPECT_TRUE(seen.shows("<html lang=\"pl\">") && seen.shows("Zalogowano jako Name of trainee."));
}

TEST_P(WebLtiTest, ItsCookieComesBackFromAnotherSiteByHttpsOnly) {
    portal = start({}, true);
    begin_at("https://placode.example.org");
    Browser one = browser();
    const Seen login = one.get(login_path("sub-1"));
    const std::string line = login.header("Set-Cookie");
    EXPECT_TRUE(line.starts_with("__Host-placode-lti=")) << line;
    EXPECT_NE(line.find("; Secure; SameSite=None"), std::string::npos) << line;
    EXPECT_NE(line.find("; HttpOnly"), std::string::npos) << line;
    const Seen seen = one.post("/lti/launch", asked(login).form());
    EXPECT_EQ(seen.status, 200);
    for (const auto& [name, value] : seen.headers)
        if (name == "Set-Cookie" && value.starts_with("__Host-placode=")) {
            EXPECT_NE(value.find("SameSite=Strict"), std::string::npos) << value;
        }
    EXPECT_TRUE(one.cookies.contains("__Host-placode"));
}

TEST_P(WebLtiTest, LogsNothingSecret) {
    Browser one = browser();
    const Seen login = one.get(login_path("sub-1"));
    const Answered answered = asked(login);
    const std::string cookie = one.cookies.at("placode-lti");
    (void)one.post("/lti/launch", answered.form());
    const std::string session = one.cookies.at("placode");
    (void)launch_spoilt(one, claim("aud", "x"));
    EXPECT_NE(log.find("signed in from"), std::string::npos);
    for (const std::string& secret : {answered.state, answered.token, cookie, session})
        EXPECT_EQ(log.find(secret), std::string::npos);
    EXPECT_EQ(log.find("Name of"), std::string::npos);
}

TEST_P(WebLtiTest, SettingsThatCannotBeReadLetNobodyIn) {
    Browser one = browser();
    const Answered answered = asked(one.get(login_path("sub-1")));
    ASSERT_EQ(::chmod(settings_file().c_str(), 0666), 0);
    for (const Seen& seen :
         {one.get(login_path("sub-1")), one.post("/lti/launch", answered.form())}) {
        EXPECT_EQ(seen.status, 500);
        EXPECT_FALSE(seen.shows(folder.path().string()));
    }
    expect_nobody(one, "open settings");
    EXPECT_NE(log.find("can be written by others"), std::string::npos) << log;
    ASSERT_EQ(::chmod(settings_file().c_str(), 0600), 0);
    ASSERT_EQ(::chmod(folder.file("tool.pem").c_str(), 0640), 0);
    const Seen keys = one.get("/lti/jwks.json");
    EXPECT_EQ(keys.status, 500);
    EXPECT_FALSE(keys.shows("\"n\""));
}

class WebWithoutLtiTest : public WebTest {};

TEST_P(WebWithoutLtiTest, HasNoWayInFromPlatforms) {
    Browser one = browser();
    for (const char* path : {"/lti/login", "/lti/launch", "/lti/jwks.json"}) {
        EXPECT_EQ(one.get(path).header("Location"), "/sign-in") << path;
        EXPECT_EQ(one.send("POST", path).status, 405) << path;
    }
}

TEST(WebArrivals, AreForgottenOneByOne) {
    web::Arrivals arrivals;
    const std::string first = arrivals.begin({"i", "c", "n", "b", 0});
    for (int64_t s = 0; s < 2 * web::Arrivals::kLifeS; ++s)
        (void)arrivals.begin({"i", "c", "n", "b", s});
    EXPECT_LE(arrivals.count(), static_cast<size_t>(web::Arrivals::kLifeS));
    EXPECT_FALSE(arrivals.take(first, 1));
    const std::string state = arrivals.begin({"i", "c", "nonce", "b", 700});
    EXPECT_EQ(arrivals.take(state, 701)->nonce, "nonce");
    EXPECT_FALSE(arrivals.take(state, 701));
}

INSTANTIATE_TEST_SUITE_P(Engines, WebLtiTest, testing::Values("Sqlite"), engine_name);
INSTANTIATE_TEST_SUITE_P(Engines, WebWithoutLtiTest, testing::Values("Sqlite"), engine_name);

}  // namespace THIS_TEST
}  // namespace placode::test
