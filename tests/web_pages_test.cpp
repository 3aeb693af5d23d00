// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Who sees which page of the portal, that no page writes, and that nothing somebody typed becomes
// markup.

#include <QRegularExpression>
#include <cmath>
#include <ctime>
#include <regex>
#include <set>

#include "curriculum/utc_time.h"
#include "tests/web_fixture.h"
#include "ui/web/frame.h"

namespace placode::test {

namespace THIS_TEST {

constexpr const char* kScript = "<script>alert(\"1\")</script>";

class WebPagesTest : public WebTest {
 protected:
    /// Every page there is, with what its `*` stand for.
    [[nodiscard]] std::vector<std::string> pages() const {
        std::vector<std::string> all{"/",
                                     "/cohort",
                                     "/help",
                                     "/refreshers",
                                     "/refreshers?after=5",
                                     "/scores",
                                     "/attempts",
                                     "/standards",
                                     "/norms",
                                     "/norms/1",
                                     "/people",
                                     "/studies",
                                     "/people?find=grouped"};
        for (const char* part : {"", "/entries", "/deviations"})
            all.push_back(std::string("/studies/") + RightsWorld::kStudy + part);
        for (const auto& [login, mine] : people.of) {
            const std::string person = "/people/" + std::to_string(mine.person);
            for (const char* part : {"", "/attempts", "/tasks/diathermy_ring"})
                all.push_back(person + part);
            all.push_back("/attempts/" + std::to_string(mine.attempt));
        }
        return all;
    }
};

TEST_P(WebPagesTest, ShowEachRoleWhatTheTableOfRightsSays) {
    const auto person = [&](const char* login) {
        return "/people/" + std::to_string(people.of[login].person);
    };
    const auto attempt = [&](const char* login) {
        return "/attempts/" + std::to_string(people.of[login].attempt);
    };
    const std::string study = std::string("/studies/") + RightsWorld::kStudy;
    struct Case {
        std::string path, who;  ///< Roles that see it.
    };
    const std::vector<Case> cases{
        {"/", "trainee educator coordinator administrator"},
        {"/cohort", "educator"},
        {"/help", "educator"},
        {"/refreshers", "educator"},
        {"/scores", "educator"},
        {"/attempts", "educator"},
        {"/standards", "educator"},
        {"/norms", "educator"},
        {"/studies", "coordinator"},
        {study, "coordinator"},
        {study + "/entries", "coordinator"},
        {study + "/deviations", "coordinator"},
        {"/people", "educator administrator"},
        {person("grouped"), "educator"},
        {person("stranger"), "educator"},
        {person("stranger") + "/attempts", "educator"},
        {attempt("grouped"), "educator"},
        {attempt("stranger"), "educator"},
        {attempt("loner"), "educator coordinator"},  // Of the study.
    };
    for (const auto& [login, role] : RightsWorld::kActors) {
        Browser one = signed_in(login);
        for (const Case& each : cases) {
            const bool may = each.who.find(login) != std::string::npos;
            const Seen seen = one.get(each.path);
            EXPECT_EQ(seen.status, may ? 200 : 403) << login << " " << each.path;
            if (!may) {
                EXPECT_TRUE(seen.shows("You may not")) << login << " " << each.path;
                EXPECT_FALSE(seen.shows(folder.path().string())) << "where the store lies";
            }
        }
        EXPECT_EQ(one.get(person(login)).status, 200) << login;
        EXPECT_EQ(one.get(person(login) + "/attempts").status, 200) << login;
        EXPECT_EQ(one.get(attempt(login)).status, 200) << login;
    }
}

TEST_P(WebPagesTest, ShowNobodyAnything) {
    Browser nobody = browser();
    for (const std::string& path : pages()) {
        const Seen seen = nobody.get(path);
        EXPECT_EQ(seen.status, 303) << path;
        EXPECT_EQ(seen.header("Location"), "/sign-in") << path;
        EXPECT_TRUE(seen.body.empty()) << path;
    }
    EXPECT_EQ(nobody.get("/there/is/none").status, 303) << "nobody learns which pages there are";
}

// Signing in is the one thing that writes: it comes before the first checksum.
TEST_P(WebPagesTest, WriteNothing) {
    std::vector<Browser> browsers;
    for (const auto& [login, role] : RightsWorld::kActors) {
        browsers.push_back(browser());
        ASSERT_EQ(browsers.back().sign_in(login).status, 303);
    }
    const std::string before = checksum_of_the_store();
    int answered = 0;
    for (Browser& one : browsers)
        for (const std::string& path : pages()) {
            answered += one.get(path).status == 200 ? 1 : 0;
            for (const char* method : {"POST", "PUT", "PATCH", "DELETE"})
                EXPECT_EQ(one.send(method, path).status, 405) << method << " " << path;
        }
    EXPECT_GT(answered, 50);
    EXPECT_EQ(checksum_of_the_store(), before);
    ASSERT_EQ(browser().sign_in("trainee").status, 303);
    EXPECT_NE(checksum_of_the_store(), before) << "a sign-in shows in the checksum";
}

TEST_P(WebPagesTest, CarryTheHeadersAndNeitherScriptNorInlineStyle) {
    Browser one = signed_in("educator");
    std::vector<Seen> all{
        browser().get("/"),          browser().get("/sign-in"),
        browser().get("/style.css"), one.get("/there/is/none"),
        one.get("/people/x"),        one.get("/people/999999"),
        one.send("DELETE", "/"),     browser().sign_in("trainee", "wrong one 12")};
    for (const std::string& path : pages()) all.push_back(one.get(path));
    // Not std::regex: it calls itself for every letter of a picture that stands in the page.
    const QRegularExpression inline_style(R"(<[^>]*\s(style|on\w+)\s*=)");
    for (const Seen& seen : all) {
        EXPECT_EQ(seen.header("Content-Security-Policy"),
                  "default-src 'none'; style-src 'self'; img-src 'self' data:; form-action 'self'; "
                  "frame-ancestors 'none'; base-uri 'none'");
        EXPECT_EQ(seen.header("X-Content-Type-Options"), "nosniff");
        EXPECT_EQ(seen.header("Referrer-Policy"), "no-referrer");
        EXPECT_EQ(seen.header("Cache-Control"), "no-store");
        EXPECT_FALSE(seen.shows("<script"));
        EXPECT_FALSE(seen.shows("<style"));
        EXPECT_FALSE(QString::fromStdString(seen.body).contains(inline_style))
            << seen.body.substr(0, 300);
    }
}

TEST_P(WebPagesTest, MakeNoMarkupOfWhatSomebodyTyped) {
    const auto store = open();
    db::NewUser user = trainee("mark-up");
    user.display_name = kScript;
    const int64_t id = store->accounts().create(user);
    db::AttemptResult own = make_result();
    own.header.demonstration = false;
    const int64_t attempt = store->attempts().save(id, own);
    const int64_t group = store->groups().create(kScript);
    store->groups().set_role(group, id, db::GroupRole::kMember);
    store->reviews().add_comment({0, attempt, people.teacher, "", -1, kScript, ""});
    auto protocol =
        QJsonDocument::fromJson(
            QByteArray::fromStdString(curriculum::load_study("face_content_validity").json))
            .object();
    protocol["title"] = QJsonObject{{"en", kScript}, {"pl", kScript}};
    db::DefinitionRecord study;
    study.kind = "study";
    study.id = "face_content_validity";
    study.json = QJsonDocument(protocol).toJson().toStdString();
    study.version = protocol["version"].toInt(1);
    study.reason = kScript;
    store->definitions().publish(study);
    const std::string person = std::to_string(id);
    const std::vector<std::pair<const char*, std::string>> shown{
        {"educator", "/people/" + person},
        {"educator", "/people/" + person + "/attempts"},
        {"educator", "/people/" + person + "/tasks/diathermy_ring"},
        {"educator", "/attempts/" + std::to_string(attempt)},
        {"educator", "/attempts"},
        {"educator", "/cohort"},
        {"administrator", "/people"},
        {"administrator", std::string("/people?find=") + "%3Cscript%3E"},
        {"coordinator", "/studies"},
        {"coordinator", "/studies/face_content_validity"},
        {"mark-up", "/"}};
    for (const auto& [login, path] : shown) {
        const Seen seen = signed_in(login).get(path);
        EXPECT_EQ(seen.status, 200) << path;
        EXPECT_FALSE(seen.shows("<script")) << path;
        EXPECT_TRUE(seen.shows("&lt;script&gt;")) << path;
    }
}

TEST_P(WebPagesTest, HaveHeadingsCaptionsAndLabels) {
    Browser educator = signed_in("educator"), coordinator = signed_in("coordinator");
    for (const std::string& path : pages()) {
        Seen seen = educator.get(path);
        if (seen.status == 403) seen = coordinator.get(path);
        if (seen.status != 200) continue;
        EXPECT_TRUE(seen.shows("<html lang=\"en\">")) << path;
        EXPECT_TRUE(seen.shows("class=\"skip\" href=\"#content\"")) << path;
        const auto count = [&](const char* words) {
            int found = 0;
            for (size_t at = 0; (at = seen.body.find(words, at)) != std::string::npos; ++at)
                ++found;
            return found;
        };
        EXPECT_EQ(count("<h1>"), 1) << path;
        EXPECT_EQ(count("<table>"), count("<caption>")) << path;
        EXPECT_EQ(count("<img "), count("alt=\"")) << path;
        EXPECT_EQ(count("<select "), count("<label ") - count("type=\"search\"")) << path;
        EXPECT_FALSE(seen.shows("<th>")) << path << ": a head without scope";
    }
}

// The world's attempts were made on a day in January.
TEST_P(WebPagesTest, SayWhoIsDueForARefresher) {
    Browser one = signed_in("educator");
    for (const char* path : {"/refreshers", "/refreshers?after=5"}) {
        const Seen seen = one.get(path);
        EXPECT_TRUE(seen.shows("since 5 months")) << path;
        EXPECT_TRUE(seen.shows("2026-01-02")) << path;
    }
    db::AttemptResult fresh = make_result();
    fresh.header.demonstration = false;
    fresh.header.started_utc = curriculum::utc_text(std::time(nullptr));
    for (const auto& [login, mine] : people.of) (void)open()->attempts().save(mine.person, fresh);
    EXPECT_TRUE(one.get("/refreshers").shows("Nobody is due."));
}

TEST_P(WebPagesTest, LeaveOutWhoHasLeft) {
    const int64_t gone = people.of["grouped"].person;
    const auto store = open();
    for (int i = 0; i < 6; ++i) {
        db::AttemptResult result = make_result();
        result.header.device = "mouse";
        result.header.demonstration = false;
        result.header.started_utc = curriculum::utc_text(1'767'000'000 + 86400 * int64_t{i});
        result.end.reason = sim::EndReason::kFinished;
        result.score.points = 40;
        result.score.verdict = i == 0 ? assessment::Verdict::kPassed : assessment::Verdict::kFailed;
        (void)store->attempts().save(gone, result);
    }
    Browser one = signed_in("educator");
    const std::string link = "href=\"/people/" + std::to_string(gone);
    const auto listed = [&](const char* path) {
        return one.get(path).body.find(link) != std::string::npos;
    };
    for (const char* path : {"/cohort", "/help", "/refreshers"}) EXPECT_TRUE(listed(path)) << path;
    store->accounts().set_active(gone, false);
    for (const char* path : {"/cohort", "/help", "/refreshers"}) EXPECT_FALSE(listed(path)) << path;
    store->accounts().set_active(gone, true);
    for (const char* path : {"/cohort", "/help", "/refreshers"}) EXPECT_TRUE(listed(path)) << path;
}

// An amendment has no say in what somebody enrolled before it is to do.
TEST_P(WebPagesTest, NameTheStepsAsTheVersionOfTheParticipantDoes) {
    const auto store = open();
    std::vector<std::string> codes;
    for (const int version : {1, 2}) {
        db::DefinitionRecord study;
        study.kind = "study";
        study.id = "amended";
        study.version = version;
        study.reason = "the committee asked for it";
        study.json = R"({"id":"amended","version":)" + std::to_string(version) +
                     R"(,"title":{"en":"t"},"steps":[{"id":"run","kind":"procedure","title":)"
                     R"({"en":"Step of version )" +
                     std::to_string(version) + R"("},"task":"diathermy_ring"}]})";
        store->definitions().publish(study);
        codes.push_back(store->studies().new_participant("amended"));
        store->records().note_step("amended", codes.back(), 1, "run", "coughed");
    }
    Browser one = signed_in("coordinator");
    for (const char* path : {"/studies/amended", "/studies/amended/deviations"}) {
        const std::string body = one.get(path).body;
        for (const size_t i : {0U, 1U}) {
            const size_t row = body.find(codes[i]), step = body.find("Step of version ", row);
            ASSERT_NE(step, std::string::npos) << path;
            EXPECT_EQ(body.substr(step, 17), "Step of version " + std::to_string(i + 1)) << path;
        }
    }
}

// The same sheet comes again at every visit.
TEST_P(WebPagesTest, SayOfWhichVisitTheEntriesDiffer) {
    const auto store = open();
    db::AnswerRecord again = store->studies().answers(RightsWorld::kStudy).front();
    again.visit = 2;
    again.answers[people.item] = "2";
    const std::map<int64_t, std::string> typed_again{
        {people.answers, "5"},
        {db::submit_answers(*store, curriculum::load_questionnaire("sus"), again), "1"}};
    for (const db::AnswerRecord& each : store->studies().answers(RightsWorld::kStudy)) {
        db::SecondEntry entry;
        entry.answer_id = each.id;
        entry.answers = each.answers;
        entry.answers[people.item] = typed_again.at(each.id);
        store->records().save_second_entry(entry);
    }
    const Seen seen =
        signed_in("coordinator").get(std::string("/studies/") + RightsWorld::kStudy + "/entries");
    EXPECT_TRUE(seen.shows("<th scope=\"col\" class=\"number\">Visit</th>"));
    for (const auto& [visit, entries] : std::map<std::string, std::string>{
             {"1", "<td>4</td><td>5</td>"}, {"2", "<td>2</td><td>1</td>"}})
        EXPECT_TRUE(seen.shows("<td>sus</td><td class=\"number\">" + visit + "</td><td>" +
                               people.item + "</td>" + entries))
            << seen.body;
}

double luminance(const std::string& hex) {
    const auto part = [&](size_t at) {
        const double value = std::stoi(hex.substr(at, 2), nullptr, 16) / 255.0;
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
}

TEST(WebStyle, EveryTextHasAContrastOfFourAndAHalf) {
    const std::string sheet(web::style_sheet());
    const size_t dark = sheet.find("prefers-color-scheme: dark");
    for (const std::string& theme : {sheet.substr(0, dark), sheet.substr(dark)}) {
        std::map<std::string, double> of;
        const std::regex token(R"(--([a-z-]+): (#[0-9A-F]{6}))");
        for (std::sregex_iterator each(theme.begin(), theme.end(), token), end; each != end; ++each)
            of[(*each)[1]] = luminance((*each)[2]);
        ASSERT_EQ(of.size(), 16U);
        for (const auto& [ink, paper] :
             std::vector<std::pair<const char*, const char*>>{{"text", "surface"},
                                                              {"text", "raised"},
                                                              {"text", "hover"},
                                                              {"text", "critical-soft"},
                                                              {"muted", "surface"},
                                                              {"muted", "raised"},
                                                              {"muted", "hover"},
                                                              {"accent", "surface"},
                                                              {"accent", "raised"},
                                                              {"accent", "hover"},
                                                              {"accent", "accent-soft"},
                                                              {"on-accent", "accent"},
                                                              {"good", "good-soft"},
                                                              {"warn", "warn-soft"},
                                                              {"critical", "critical-soft"}}) {
            const double a = of.at(ink), b = of.at(paper);
            EXPECT_GE((std::max(a, b) + 0.05) / (std::min(a, b) + 0.05), 4.5)
                << ink << " on " << paper;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, WebPagesTest, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

}  // namespace THIS_TEST
}  // namespace placode::test
