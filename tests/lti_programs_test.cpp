// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl sends grades to a learning platform and statements to a record store.

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/mock_platform.h"
#include "tests/programs_fixture.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

test::World* const world = test::World::install();

class LtiPrograms : public Programs {
 protected:
    void SetUp() override {
        Programs::SetUp();
        secret("tool.pem", tool_key().private_pem());
        secret("lrs", platform.record_store_user + "\n");
        PlainJson of_platform = platform.settings();
        of_platform["line_items"] = {
            {{"task", "diathermy_ring"}, {"url", platform.url("/lineitems/a?type_id=1")}},
            {{"task", "diathermy_ring"},
             {"url", platform.url("/lineitems/b")},
             {"take", "latest"}}};
        write_text(file("lti.json"), PlainJson{{"version", 1},
                                               {"tool_url", "https://placode.example.org"},
                                               {"private_key_file", "tool.pem"},
                                               {"platforms", {of_platform}}}
                                         .dump());
    }
    void secret(const std::string& name, const std::string& text) const {
        write_text(file(name), text);
        ASSERT_EQ(::chmod(file(name).c_str(), 0600), 0);
    }
    /// Accounts with attempts in this order: 40, 71.3 and 55 points.
    void add_people() const {
        const auto direct = db::open_store("sqlite:" + store);
        (void)direct->accounts().create({"boss", "Boss", "long enough 1", 8});
        for (const char* login : {"anna", "bela", "idle"})
            (void)direct->accounts().create(
                {login, "Name of " + std::string(login), "long enough 1", 1});
        (void)direct->accounts().create({"teacher", "Teacher", "long enough 1", 2});
        for (const double points : {40.0, 71.3, 55.0}) (void)attempt("anna", points);
        (void)attempt("bela", 90, sim::EndReason::kInterrupted);
        (void)attempt("bela", 12.345678);
    }
    int64_t attempt(const std::string& login, double points,
                    sim::EndReason end = sim::EndReason::kFinished) const {
        const auto direct = db::open_store("sqlite:" + store);
        direct->act_as("test");
        db::AttemptResult result = make_result();
        result.header.demonstration = false;  // It would be nobody's grade.
        result.score.points = points;
        result.end.reason = end;
        result.header.started_utc = "2026-01-02T03:04:0" + std::to_string(++second_) + ".000Z";
        return direct->attempts().save(direct->accounts().find_login(login)->id, result);
    }
    [[nodiscard]] Outcome link(const std::string& subject, const std::string& login) const {
        return ctl("lti link --config lti.json --issuer https://moodle.example.edu --sub " +
                   subject + " --user " + login);
    }
    [[nodiscard]] Outcome grades(const std::string& more = "") const {
        return ctl("lti grades --config lti.json --wait 0.01 " + more);
    }
    /// "sub points" of what arrived at a column since the last time.
    [[nodiscard]] std::vector<std::string> arrived(const std::string& line_item) {
        std::vector<std::string> all;
        for (const PlainJson& each : platform.scores)
            if (each["lineitem"] == line_item)
                all.push_back(each["userId"].get<std::string>() + " " +
                              (each.contains("scoreGiven") ? each["scoreGiven"].dump() : "none"));
        return all;
    }

    MockPlatform platform;

 private:
    mutable int second_ = 0;
};

TEST_F(LtiPrograms, GradesOfWhoIsLinkedGoToTheGradebookOnce) {
    ASSERT_NE(world, nullptr);
    add_people();
    EXPECT_EQ(link("sub-1", "anna").status, 0);
    EXPECT_EQ(link("sub-2", "bela").status, 0);
    EXPECT_EQ(link("sub-3", "idle").status, 0);
    const Outcome boss = link("sub-4", "boss");
    EXPECT_EQ(boss.status, 2);
    EXPECT_THAT(boss.err, HasSubstr("administrator"));

    const Outcome dry = grades("--dry-run");
    EXPECT_EQ(dry.status, 0) << dry.err;
    EXPECT_THAT(dry.out, AllOf(HasSubstr("71.30"), HasSubstr("12.35"), HasSubstr("to be sent"),
                               HasSubstr("4 scores to be sent; nothing was")));
    EXPECT_EQ(platform.tokens_given, 0);
    EXPECT_TRUE(platform.scores.empty());

    const Outcome first = grades();
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.out, AllOf(HasSubstr("4 scores sent"), HasSubstr("no attempt that counts")));
    EXPECT_EQ(arrived("a"), (std::vector<std::string>{"sub-1 71.3", "sub-2 12.35"})) << "the best";
    EXPECT_EQ(arrived("b"), (std::vector<std::string>{"sub-1 55.0", "sub-2 12.35"}))
        << "the latest";
    EXPECT_EQ(platform.scores[0]["query"], "1");
    EXPECT_EQ(platform.tokens_given, 1) << "one token for all";
    const PlainJson& score = platform.scores[0];
    EXPECT_EQ(score["scoreMaximum"], 100);
    EXPECT_EQ(score["activityProgress"], "Completed");
    EXPECT_EQ(score["gradingProgress"], "FullyGraded");
    EXPECT_THAT(score["timestamp"].get<std::string>(),
                testing::MatchesRegex("20..-..-..T..:..:..\\....Z"));

    const Outcome again = ctl("--json lti grades --config lti.json");
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(number_in(again.out, "sent"), 0);
    EXPECT_EQ(platform.tokens_given, 1) << "where nothing is due, nothing is asked";
    (void)attempt("anna", 60);
    EXPECT_THAT(grades().out, HasSubstr("1 score sent")) << "latest only";
    EXPECT_EQ(arrived("b").back(), "sub-1 60.0");
    (void)attempt("anna", 80);
    EXPECT_THAT(grades().out, HasSubstr("2 scores sent"));
    EXPECT_EQ(arrived("a").back(), "sub-1 80.0");
    EXPECT_THAT(grades("--task suture_bite").out, HasSubstr("0 scores sent"));
    const Outcome other =
        grades("--task diathermy_ring --line-item " + platform.url("/lineitems/c"));
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_EQ(arrived("c"), (std::vector<std::string>{"sub-1 80.0", "sub-2 12.35"}));
    EXPECT_THAT(ctl("audit").out, AllOf(HasSubstr("lti.grades"), HasSubstr("lti.link"),
                                        HasSubstr("https://moodle.example.edu")));
    struct stat status {};
    ASSERT_EQ(::stat(file("lti.json.sent").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0600U);
}

TEST_F(LtiPrograms, WhoWasErasedIsLeftOutAndNoFailure) {
    add_people();
    ASSERT_EQ(link("sub-1", "anna").status, 0);
    ASSERT_EQ(link("sub-2", "bela").status, 0);
    ASSERT_EQ(ctl("user erase anna --confirm anna").status, 0);
    const Outcome sent = grades();
    EXPECT_EQ(sent.status, 0) << sent.err;
    EXPECT_THAT(sent.err,
                AllOf(HasSubstr("sub \"sub-1\": account 2 was erased"), HasSubstr("lti unlink")));
    EXPECT_EQ(arrived("a"), (std::vector<std::string>{"sub-2 12.35"}));
    // The number of one and the log-in of another is nobody's.
    ASSERT_TRUE(
        RawConnection("QSQLITE", store)
            .run("UPDATE persons SET login = 'other', login_key = 'other' WHERE account_id = "
                 "3"));
    const Outcome other = grades();
    EXPECT_EQ(other.status, 1);
    EXPECT_THAT(other.err, HasSubstr("account 3 is not bela's (any more)"));
}

TEST_F(LtiPrograms, AScoreThatCountsNoMoreIsCleared) {
    add_people();
    const int64_t only = attempt("idle", 33);
    ASSERT_EQ(link("sub-3", "idle").status, 0);
    ASSERT_EQ(grades().status, 0);
    EXPECT_EQ(arrived("a"), (std::vector<std::string>{"sub-3 33.0"}));
    RawConnection raw("QSQLITE", store);
    ASSERT_TRUE(raw.run("UPDATE attempts SET end_reason = " +
                        std::to_string(static_cast<int>(sim::EndReason::kInterrupted)) +
                        " WHERE id = " + std::to_string(only)))
        << raw.problem();
    const Outcome outcome = grades();
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(arrived("a").back(), "sub-3 none");
    EXPECT_EQ(platform.scores.back()["gradingProgress"], "NotReady");
    EXPECT_THAT(grades().out, HasSubstr("0 scores sent"));
}

TEST_F(LtiPrograms, TroubleOfThePlatformIsSaidAndNothingIsLostOrSentTwice) {
    add_people();
    ASSERT_EQ(link("sub-1", "anna").status, 0);
    ASSERT_EQ(link("sub-2", "bela").status, 0);
    platform.answers_first = {503, 500};  // Twice, before the token.
    EXPECT_EQ(grades("--task diathermy_ring --line-item " + platform.url("/lineitems/a")).status,
              0);
    EXPECT_EQ(arrived("a").size(), 2U);
    platform.answers_first = {200, 403};  // A token without a token; then nothing else is tried.
    const Outcome no_token = grades();
    EXPECT_EQ(no_token.status, 1);
    EXPECT_THAT(no_token.err, AllOf(HasSubstr("/token: no token"), HasSubstr("client_id")));
    EXPECT_THAT(no_token.out, HasSubstr("NOT SENT"));
    EXPECT_EQ(platform.answers_first.size(), 1U);
    platform.answers_first.clear();
    EXPECT_THAT(grades().out, HasSubstr("4 scores sent"));
    (void)attempt("anna", 99);
    (void)attempt("bela", 98);
    // The token has run out: a new one. Then one person is refused, and the other is not.
    const std::string column = "--task diathermy_ring --line-item " + platform.url("/lineitems/a");
    const int tokens = platform.tokens_given;
    platform.scores_first = {401, 403};
    const Outcome one = grades(column);
    EXPECT_EQ(one.status, 1);
    EXPECT_THAT(one.err, AllOf(HasSubstr("anna: the server answered 403"), Not(HasSubstr("bela"))));
    EXPECT_EQ(platform.tokens_given, tokens + 2);
    EXPECT_EQ(arrived("a").back(), "sub-2 98.0");
    EXPECT_EQ(grades(column).status, 0);
    EXPECT_EQ(arrived("a").back(), "sub-1 99.0");
    platform.stop();
    (void)attempt("anna", 99.5);
    const Outcome away = grades(column);
    EXPECT_EQ(away.status, 1);
    EXPECT_THAT(away.err, AllOf(HasSubstr("it cannot be reached"), Not(HasSubstr("bearer"))));
    EXPECT_THAT(away.out, HasSubstr("run it again"));
}

TEST_F(LtiPrograms, OnlyWhoMayLinksAndSends) {
    add_people();
    ASSERT_EQ(link("sub-1", "anna").status, 0);
    EXPECT_EQ(ctl("--as anna lti grades --config lti.json", kRight).status, 1);
    EXPECT_EQ(
        ctl("--as anna lti link --config lti.json --issuer https://moodle.example.edu --sub x "
            "--user anna",
            kRight)
            .status,
        1);
    EXPECT_EQ(ctl("--as teacher lti link --config lti.json --issuer https://moodle.example.edu "
                  "--sub x --user bela",
                  kRight)
                  .status,
              1);
    EXPECT_TRUE(platform.scores.empty());
    const Outcome teacher = ctl("--as teacher lti grades --config lti.json", kRight);
    EXPECT_EQ(teacher.status, 0) << teacher.err;
    EXPECT_EQ(platform.scores.size(), 2U);
    const Outcome gone =
        ctl("lti unlink --config lti.json --issuer https://moodle.example.edu --sub sub-1");
    EXPECT_EQ(gone.status, 0) << gone.err;
    const std::string trail = ctl("--json audit").out;
    EXPECT_THAT(trail, HasSubstr("lti.unlink"));
    EXPECT_THAT(trail, Not(HasSubstr("sub-1"))) << "what the platform calls a person is a name";
    EXPECT_EQ(
        ctl("lti unlink --config lti.json --issuer https://moodle.example.edu --sub sub-1").status,
        2);
    EXPECT_EQ(link("sub-1", "nobody").status, 2);
    // Somebody changed the number by hand.
    ASSERT_EQ(link("sub-1", "anna").status, 0);
    std::string text = read_text(file("lti.json"));
    text.replace(text.find("\"login\": \"anna\""), 15, "\"login\": \"bela\"");
    write_text(file("lti.json"), text);
    const Outcome wrong = grades();
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.err, HasSubstr("is not bela's"));
    EXPECT_EQ(platform.scores.size(), 2U);
}

TEST_F(LtiPrograms, SettingsAreCheckedAndKeysKeptSecret) {
    add_people();
    const Outcome good = ctl("lti check --config lti.json");
    EXPECT_EQ(good.status, 0) << good.err;
    EXPECT_THAT(good.out, AllOf(HasSubstr("https://placode.example.org/lti/login"),
                                HasSubstr("https://placode.example.org/lti/launch"),
                                HasSubstr("https://placode.example.org/lti/jwks.json"),
                                HasSubstr("keys: 1 key")));
    const std::string pem = tool_key().private_pem();
    EXPECT_THAT(good.out + good.err, Not(HasSubstr(pem.substr(100, 30))));
    ASSERT_EQ(::chmod(file("tool.pem").c_str(), 0644), 0);
    for (const char* command : {"lti check --config lti.json", "lti grades --config lti.json"}) {
        const Outcome open = ctl(command);
        EXPECT_EQ(open.status, 2) << command;
        EXPECT_THAT(open.err, HasSubstr("chmod 600"));
    }
    const Outcome web = run("placode-web", "--store sqlite:" + store + " --lti lti.json");
    EXPECT_EQ(web.status, 2);
    EXPECT_THAT(web.err, HasSubstr("chmod 600"));
    secret("tool.pem", "-----BEGIN PRIVATE KEY-----\nbm8=\n-----END PRIVATE KEY-----\n");
    const Outcome broken = ctl("lti check --config lti.json");
    EXPECT_EQ(broken.status, 2);
    EXPECT_THAT(broken.err, AllOf(HasSubstr("tool.pem"), Not(HasSubstr("bm8="))));
    secret("tool.pem", pem);
    const Outcome plain = run("placode-web", "--store sqlite:" + store + " --lti lti.json");
    EXPECT_EQ(plain.status, 2);
    EXPECT_THAT(plain.err, HasSubstr("--behind-tls"));
    EXPECT_EQ(ctl("lti grades --config none.json").status, 2);
    EXPECT_EQ(grades("--line-item http://x.example/").status, 2);
    EXPECT_EQ(grades("--task diathermy_ring --line-item http://x.example/").status, 2);
    EXPECT_EQ(grades("--issuer https://other.example").status, 2);
}

class XapiPrograms : public LtiPrograms {
 protected:
    [[nodiscard]] Outcome send(const std::string& more, const std::string& who = "") const {
        return ctl(who + "--json xapi send --wait 0.01 --credentials lrs --endpoint " +
                       platform.url("/xapi/") + " " + more,
                   kRight);
    }
};

TEST_F(XapiPrograms, AStudysStatementsArriveAsTheyAreExportedAndOnce) {
    add_user("carl", "coordinator");
    ASSERT_EQ(ctl("--as carl study demo", kRight).status, 0);
    const std::string study = "--study face_content_validity";
    ASSERT_EQ(ctl("--as carl export xapi " + study, kRight).status, 0);
    const auto exported = PlainJson::parse(read_text(file("face_content_validity_xapi.json")));
    ASSERT_GT(exported.size(), 100U);
    const Outcome dry = send(study + " --dry-run", "--as carl ");
    EXPECT_EQ(dry.status, 0) << dry.err;
    EXPECT_TRUE(platform.statements.empty());
    const Outcome first = send(study, "--as carl ");
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(number_in(first.out, "sent"), static_cast<double>(exported.size()));
    ASSERT_EQ(platform.statements.size(), exported.size());
    for (const PlainJson& each : exported)
        EXPECT_EQ(platform.statements.at(each["id"]), each) << "as the export has it";
    EXPECT_EQ(platform.statement_posts, static_cast<int>((exported.size() + 49) / 50));
    const Outcome again = send(study, "--as carl ");
    EXPECT_EQ(number_in(again.out, "sent"), 0);
    EXPECT_EQ(number_in(again.out, "sent_before"), static_cast<double>(exported.size()));
    EXPECT_EQ(platform.statement_posts, static_cast<int>((exported.size() + 49) / 50));
    EXPECT_THAT(ctl("audit").out, AllOf(HasSubstr("xapi.send"), HasSubstr("study face_content")));
    // Where the memory is lost, the record store knows them by their ids.
    fs::remove(file("lrs.sent"));
    EXPECT_EQ(send(study, "--as carl ").status, 0);
    EXPECT_EQ(platform.statements.size(), exported.size());
    const Outcome none = send("--study none", "--as carl ");
    EXPECT_NE(none.status, 0);
    EXPECT_NE(send(study, "--as nobody ").status, 0);
}

TEST_F(XapiPrograms, PeopleAreNumbersAndOnlyWhatIsNewGoes) {
    add_people();
    ASSERT_EQ(send("--user anna").status, 0);
    EXPECT_EQ(platform.statements.size(), 3U);
    for (const auto& [id, each] : platform.statements) {
        EXPECT_THAT(each.dump(), AllOf(Not(HasSubstr("anna")), Not(HasSubstr("Name of"))));
        EXPECT_EQ(each["actor"]["account"]["name"], "U2");
    }
    (void)attempt("anna", 77);
    EXPECT_EQ(number_in(send("--user anna bela").out, "sent"), 3);
    EXPECT_EQ(platform.statements.size(), 6U);
    EXPECT_EQ(number_in(send("--user anna --since 2026-01-03").out, "sent_before"), 0);
    EXPECT_EQ(send("--user anna --since today").status, 2);
    ASSERT_EQ(link("sub-3", "idle").status, 0);
    (void)attempt("idle", 5);
    EXPECT_EQ(number_in(send("--linked lti.json").out, "sent"), 1);
    // Who was erased is left out; a log-in that somebody else took since is not followed.
    ASSERT_EQ(link("sub-1", "anna").status, 0);
    ASSERT_EQ(ctl("user erase anna --confirm anna").status, 0);
    ASSERT_EQ(ctl("user add anna", "PLACODE_NEW_PASSWORD='long enough 1'").status, 0);
    (void)attempt("anna", 6);
    (void)attempt("idle", 7);
    const Outcome linked = send("--linked lti.json");
    EXPECT_EQ(linked.status, 0) << linked.err;
    EXPECT_EQ(number_in(linked.out, "sent"), 1) << "of idle";
    EXPECT_THAT(linked.err, HasSubstr("account 2 was erased"));
    EXPECT_EQ(send("--user anna", "--as bela ").status, 1) << "nobody else's";
    EXPECT_EQ(send("--user bela", "--as bela ").status, 0);
    EXPECT_EQ(send("").status, 2);
    EXPECT_EQ(send("--user anna --study x").status, 2);
}

TEST_F(XapiPrograms, AnAttemptIsSentWhenItIsVerifiedAndNotBefore) {
    add_people();
    const auto direct = db::open_store("sqlite:" + store);
    direct->act_as("test");
    const int64_t exam = attempt("anna", 88);
    direct->attempts().set_replay(exam, db::ReplayState::kWaiting);
    EXPECT_EQ(number_in(send("--user anna").out, "sent"), 3) << "the others";
    const auto others = platform.statements;
    direct->attempts().set_replay(exam, db::ReplayState::kIdentical);
    EXPECT_EQ(number_in(send("--user anna").out, "sent"), 1);
    ASSERT_EQ(platform.statements.size(), 4U);
    for (const auto& [id, each] : platform.statements) {
        if (others.contains(id)) continue;
        EXPECT_EQ(each["result"]["score"]["raw"], 88);
        EXPECT_THAT(each["verb"]["id"].get<std::string>(), testing::EndsWith("/passed"));
    }
    EXPECT_EQ(number_in(send("--user anna").out, "sent"), 0);
}

TEST_F(XapiPrograms, TroubleOfTheRecordStoreIsSaidWithoutThePassword) {
    add_people();
    platform.answers_first = {503, 500};
    EXPECT_EQ(send("--user anna").status, 0);
    EXPECT_EQ(platform.statements.size(), 3U);
    // It has one of them in other words: that one stays, the others come.
    const std::string id = platform.statements.begin()->first;
    platform.statements = {{id, PlainJson{{"id", id}, {"version", "other"}}}};
    fs::remove(file("lrs.sent"));
    const Outcome conflict = send("--user anna");
    EXPECT_EQ(conflict.status, 0) << conflict.err;
    EXPECT_EQ(number_in(conflict.out, "sent"), 2);
    EXPECT_EQ(number_in(conflict.out, "there_already"), 1);
    EXPECT_EQ(platform.statements.size(), 3U);
    (void)attempt("anna", 50);
    secret("lrs", "placode:wr0ng word\n");
    const Outcome wrong = send("--user anna");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.err, AllOf(HasSubstr("401"), Not(HasSubstr("wr0ng"))));
    EXPECT_THAT(wrong.out, Not(HasSubstr("wr0ng")));
    ASSERT_EQ(::chmod(file("lrs").c_str(), 0644), 0);
    EXPECT_EQ(send("--user anna").status, 2);
    secret("lrs", platform.record_store_user);
    EXPECT_EQ(
        ctl("xapi send --credentials lrs --endpoint http://lrs.example.org --user anna").status, 2);
    EXPECT_EQ(number_in(send("--user anna").out, "sent"), 1) << "nothing was lost";
    platform.stop();
    (void)attempt("anna", 51);
    const Outcome away = send("--user anna");
    EXPECT_EQ(away.status, 1);
    EXPECT_THAT(away.err, HasSubstr("cannot be reached"));
}

}  // namespace THIS_TEST
