// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt in three dimensions in the browser: who may see it, what the page and its parts bring,
// and what is said where there is no recording or it cannot be simulated.

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <chrono>
#include <regex>

#include "curriculum/attempt_runner.h"
#include "tests/web_fixture.h"
#include "ui/web/answers.h"

namespace placode::test {

namespace THIS_TEST {

class WebReviewTest : public WebTest {
 protected:
    /// Five seconds of an expert, stored for a person with its recording.
    int64_t store_attempt(const std::string& login) {
        const std::string path = folder.file("seen.placode");
        curriculum::AttemptOptions options;
        options.device = "script:expert";
        options.fast = true;
        options.threads = 1;
        options.duration_s = 5;
        curriculum::AttemptRunner runner(curriculum::load_task("touch_targets"), 1, options,
                                         db::create_recording_file(path));
        runner.start();
        runner.wait();
        db::AttemptResult result = make_result();
        result.header.task_id = "touch_targets";
        result.recording_file = path;
        return open()->attempts().save(people.of.at(login).person, result);
    }
    /// Asks again as the browser does.
    static Seen until_shown(Browser& one, const std::string& path) {
        for (;;) {
            Seen seen = one.get(path);
            if (seen.header("Refresh").empty()) return seen;
            EXPECT_EQ(seen.status, 200);
            EXPECT_TRUE(seen.shows("role=\"status\""));
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    }
};

TEST_P(WebReviewTest, ShowsAnAttemptToWhoMaySeeIt) {
    const std::string path = "/attempts/" + std::to_string(store_attempt("grouped")) + "/review";
    Browser educator = signed_in("educator");
    EXPECT_EQ(educator.get(path + "/track").status, 404) << "before anybody opened the page";
    const Seen page = until_shown(educator, path);
    ASSERT_EQ(page.status, 200);
    EXPECT_TRUE(page.shows("review-picture"));
    EXPECT_TRUE(page.shows("every recorded state came out the same"));
    EXPECT_EQ(page.headers.count("Content-Security-Policy"), 1U);
    EXPECT_EQ(page.header("Content-Security-Policy"), web::policy_with_script());
    EXPECT_EQ(page.body.find("<script"), page.body.rfind("<script"));
    const Seen track = educator.get(path + "/track");
    ASSERT_EQ(track.status, 200);
    EXPECT_EQ(track.header("Content-Type"), "application/json");
    const QJsonObject head =
        QJsonDocument::fromJson(QByteArray::fromStdString(track.body)).object();
    ASSERT_EQ(head["parts"].toInt(), 2) << "five seconds, four to a part";
    for (const char* part : {"0", "1"}) {
        const Seen seen = educator.get(path + "/parts/" + part);
        EXPECT_EQ(seen.status, 200);
        EXPECT_EQ(seen.header("Content-Type"), "application/octet-stream");
        EXPECT_FALSE(
            qUncompress(QByteArray(4, '\x04') + QByteArray::fromStdString(seen.body)).isEmpty());
    }
    for (const char* part : {"2", "-1", "x", "0x", "99999999999999999999", "../track"})
        EXPECT_EQ(educator.get(path + "/parts/" + part).status, 404) << part;

    Browser stranger = signed_in("trainee"), nobody = browser();
    for (const std::string& each : {path, path + "/track", path + "/parts/0"}) {
        EXPECT_EQ(stranger.get(each).status, 403) << each;
        EXPECT_EQ(signed_in("coordinator").get(each).status, 403) << each;
        EXPECT_EQ(nobody.get(each).status, 303) << each;
        EXPECT_EQ(educator.send("POST", each).status, 405) << each;
    }
}

TEST_P(WebReviewTest, ShowsTheirOwnToTrainees) {
    const int64_t id = store_attempt("trainee");
    Browser trainee = signed_in("trainee");
    const std::string attempt = "/attempts/" + std::to_string(id);
    EXPECT_TRUE(trainee.get(attempt).shows("href=\"" + attempt + "/review\""));
    EXPECT_TRUE(until_shown(trainee, attempt + "/review").shows("review-picture"));
    trainee.cookies["placode-language"] = "pl";
    const Seen polish = trainee.get(attempt + "/review");
    EXPECT_TRUE(polish.shows("data-play=\"Odtwórz\""));
    EXPECT_TRUE(polish.shows("każdy zapisany stan wyszedł taki sam"));
    EXPECT_FALSE(polish.shows(">Play<"));
}

TEST_P(WebReviewTest, SaysWhyThereIsNothingToSee) {
    Browser educator = signed_in("educator");
    const int64_t without = open()->attempts().save(people.of.at("grouped").person, make_result());
    EXPECT_TRUE(educator.get("/attempts/" + std::to_string(without) + "/review")
                    .shows("kept without its recording"));
    // The recording of RightsWorld names no task that could be built.
    const std::string odd =
        "/attempts/" + std::to_string(people.of.at("grouped").attempt) + "/review";
    EXPECT_TRUE(until_shown(educator, odd).shows("cannot be simulated by this version"));
    EXPECT_EQ(educator.get("/attempts/999999/review").status, 404);
}

TEST_P(WebReviewTest, BringsScriptsAndWhatTheyImport) {
    Browser nobody = browser();
    const std::regex import(R"(from "\./([a-z]+\.js)\")");
    std::vector<std::string> wanted{"page.js"};
    for (size_t i = 0; i < wanted.size(); ++i) {
        const Seen script = nobody.get("/review/" + wanted[i]);
        ASSERT_EQ(script.status, 200) << wanted[i];
        EXPECT_EQ(script.header("Content-Type"), "text/javascript; charset=utf-8");
        for (std::sregex_iterator each(script.body.begin(), script.body.end(), import), end;
             each != end; ++each)
            if (std::find(wanted.begin(), wanted.end(), (*each)[1]) == wanted.end())
                wanted.push_back((*each)[1]);
    }
    EXPECT_GE(wanted.size(), 7U);
    for (const char* path : {"/review/", "/review/none.js", "/review/../main.cpp",
                             "/review/%2e%2e/%2e%2e/i18n/placode_pl.qm", "/review/page"})
        EXPECT_EQ(nobody.get(path).status, 404) << path;
}

INSTANTIATE_TEST_SUITE_P(Engines, WebReviewTest, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

}  // namespace THIS_TEST
}  // namespace placode::test
