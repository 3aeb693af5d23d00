// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The settings of learning platforms: what is refused and how it is said, links, files that are
// for their owner alone, what was sent.

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/store_fixture.h"
#include "ui/lti/grades.h"
#include "ui/lti/sent_file.h"
#include "ui/lti/settings.h"
#include "ui/lti/statements.h"

namespace placode::lti {
namespace THIS_TEST {

using testing::HasSubstr;
using PlainJson = nlohmann::ordered_json;

class LtiSettings : public testing::Test {
 protected:
    [[nodiscard]] std::string file() const { return folder.file("lti.json"); }
    void write(const PlainJson& json) const { write(json.dump()); }
    void write(const std::string& text) const { std::ofstream(file()) << text; }
    [[nodiscard]] std::string problem() const {
        try {
            (void)read_settings(file());
        } catch (const SettingsError& error) {
            return error.what();
        }
        return "";
    }
    [[nodiscard]] static PlainJson good() {
        return PlainJson::parse(R"({"version": 1, "tool_url": "https://placode.example.org/",
            "private_key_file": "keys/tool.pem", "platforms": [{
            "issuer": "https://moodle.example.edu", "client_id": "abc", "deployment_ids": ["1"],
            "authorization_url": "https://moodle.example.edu/auth.php",
            "token_url": "https://moodle.example.edu/token.php",
            "jwks_url": "https://moodle.example.edu/certs.php",
            "links": [{"sub": "4", "account": 7, "login": "anna"}],
            "line_items": [{"task": "diathermy_ring", "url": "https://moodle.example.edu/i/2/lineitem"},
                           {"task": "lift", "url": "https://moodle.example.edu/i/3", "take": "latest"}]}]})");
    }
    test::TemporaryFolder folder;
};

TEST_F(LtiSettings, AreReadWhole) {
    write(good());
    ASSERT_EQ(problem(), "");
    const Settings settings = read_settings(file());
    EXPECT_EQ(settings.tool_url, "https://placode.example.org");
    EXPECT_EQ(settings.launch_url(), "https://placode.example.org/lti/launch");
    EXPECT_EQ(settings.private_key_file, folder.file("keys/tool.pem"));
    const Platform* platform = settings.platform("https://moodle.example.edu", "");
    ASSERT_NE(platform, nullptr);
    EXPECT_EQ(platform->token_audience, platform->token_url);
    EXPECT_EQ(platform->link_of("4")->login, "anna");
    EXPECT_EQ(platform->link_of("5"), nullptr);
    EXPECT_EQ(platform->line_items[0].take, Take::kBest);
    EXPECT_EQ(platform->line_items[1].take, Take::kLatest);
    EXPECT_EQ(settings.platform("https://moodle.example.edu", "other"), nullptr);
    EXPECT_EQ(settings.platform("https://moodle.example.edu/", ""), nullptr);
}

TEST_F(LtiSettings, AMistakeIsNamedWithItsPlace) {
    struct Mistake {
        const char *pointer, *value, *said;
    };
    const std::string platform = "/platforms/0";
    for (const Mistake& each : std::vector<Mistake>{
             {"/version", "2", "/version: expected 1"},
             {"/colour", "1", "/: \"colour\" is unknown"},
             {"/tool_url", "\"http://placode.example.org\"", "/tool_url"},
             {"/tool_url", "\"https://placode.example.org/portal\"", "a host of its own"},
             {"/platforms", "{}", "/platforms: expected a list"},
             {"/platforms/0/issuer", "7", "/platforms/0/issuer: expected a text"},
             {"/platforms/0/client", "\"a\"", "/platforms/0: \"client\" is unknown"},
             {"/platforms/0/deployment_ids", "[]", "expected at least one"},
             {"/platforms/0/deployment_ids", "[1]", "deployment_ids/0: expected a text"},
             {"/platforms/0/token_url", "\"http://moodle.example.edu/t\"", "expected https"},
             {"/platforms/0/jwks_url", "\"file:///etc/passwd\"", "does not begin with https"},
             {"/platforms/0/jwks_file", "\"k.json\"", "either jwks_url or jwks_file"},
             {"/platforms/0/links/0/account", "0", "links/0/account: expected the number"},
             {"/platforms/0/links/0/account", "\"7\"", "links/0/account: expected the number"},
             {"/platforms/0/links/0/sub", "\"\"", "links/0/sub: expected a text"},
             {"/platforms/0/links/1", R"({"sub":"4","account":8,"login":"b"})",
              "sub is there twice"},
             {"/platforms/0/links/1", R"({"sub":"5","account":7,"login":"b"})",
              "account is there twice"},
             {"/platforms/0/line_items/0/take", "\"mean\"", "expected best or latest"},
             {"/platforms/0/line_items/0/url", "\"http://x.example/\"", "expected https"}}) {
        PlainJson json = good();
        json[PlainJson::json_pointer(each.pointer)] = PlainJson::parse(each.value);
        write(json);
        EXPECT_THAT(problem(), HasSubstr(each.said)) << each.pointer << each.value;
        EXPECT_THAT(problem(), HasSubstr(file()));
    }
    for (const char* key :
         {"issuer", "client_id", "deployment_ids", "authorization_url", "token_url", "jwks_url"}) {
        PlainJson json = good();
        json["platforms"][0].erase(key);
        write(json);
        EXPECT_THAT(problem(), HasSubstr(key));
    }
    write(std::string(R"({"version": 1e999})"));
    EXPECT_EQ(problem(), file() + ": holds a number beyond 1.7e308");
    PlainJson twice = good();
    twice["platforms"].push_back(twice["platforms"][0]);
    write(twice);
    EXPECT_THAT(problem(), HasSubstr("there twice"));
    for (const char* text : {"", "[", "7", "null", "[]"}) {
        write(std::string(text));
        EXPECT_NE(problem(), "") << text;
    }
}

TEST_F(LtiSettings, OpenFilesAreRefused) {
    write(good());
    for (const mode_t mode : {0620, 0602, 0666}) {
        ASSERT_EQ(::chmod(file().c_str(), mode), 0);
        EXPECT_THAT(problem(), HasSubstr("chmod go-w"));
    }
    for (const mode_t mode : {0600, 0640, 0444}) {
        ASSERT_EQ(::chmod(file().c_str(), mode), 0);
        EXPECT_EQ(problem(), "");
    }
    const std::string secret = folder.file("secret");
    std::ofstream(secret) << "anna:pass word\nmore";
    for (const mode_t mode : {0640, 0604, 0644, 0610}) {
        ASSERT_EQ(::chmod(secret.c_str(), mode), 0);
        try {
            (void)read_secret(secret);
            ADD_FAILURE() << std::oct << mode;
        } catch (const SettingsError& error) {
            EXPECT_THAT(error.what(), HasSubstr("chmod 600"));
            EXPECT_THAT(error.what(), testing::Not(HasSubstr("pass")));
        }
    }
    ASSERT_EQ(::chmod(secret.c_str(), 0600), 0);
    EXPECT_EQ(read_user_pass(secret), "anna:pass word");
    std::ofstream(secret) << "pass word";
    EXPECT_THROW((void)read_user_pass(secret), SettingsError);
    EXPECT_THROW((void)read_secret(folder.file("none")), SettingsError);
    EXPECT_THROW((void)read_secret(folder.path().string()), SettingsError);
}

TEST_F(LtiSettings, LinksAreWrittenAndTheRestStays) {
    write(good());
    ASSERT_EQ(::chmod(file().c_str(), 0640), 0);
    add_link(file(), "https://moodle.example.edu", "abc", {"5", 8, "bela"});
    add_link(file(), "https://moodle.example.edu", "", {"4", 9, "carl"});  // Instead of anna.
    const Settings settings = read_settings(file());
    EXPECT_EQ(settings.platforms[0].links.size(), 2U);
    EXPECT_EQ(settings.platforms[0].link_of("4")->login, "carl");
    struct stat status {};
    ASSERT_EQ(::stat(file().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640U);
    PlainJson now = PlainJson::parse(test::read_text(file())), before = good();
    now["platforms"][0].erase("links");
    before["platforms"][0].erase("links");
    EXPECT_EQ(now, before);
    // What would not be read again is not written.
    const std::string text = test::read_text(file());
    EXPECT_THROW(add_link(file(), "https://moodle.example.edu", "", {"6", 8, "bela"}),
                 SettingsError);
    EXPECT_THROW(add_link(file(), "https://other.example", "", {"6", 10, "d"}), SettingsError);
    EXPECT_EQ(test::read_text(file()), text);
    EXPECT_TRUE(remove_link(file(), "https://moodle.example.edu", "", "4"));
    EXPECT_FALSE(remove_link(file(), "https://moodle.example.edu", "", "4"));
    EXPECT_EQ(read_settings(file()).platforms[0].links.size(), 1U);
    int files = 0;
    for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(folder.path()))
        ++files;
    EXPECT_EQ(files, 1) << "nothing is left beside it";
}

TEST_F(LtiSettings, WhatWasSentIsKeptForItsOwnerAloneByOneProgram) {
    const std::string path = folder.file("sent");
    {
        SentFile sent(path);
        EXPECT_FALSE(sent.find("a"));
        sent.set("a", "71.30");
        sent.keep();
        EXPECT_THROW(SentFile second(path), SettingsError);
    }
    EXPECT_EQ(SentFile(path).find("a"), "71.30");
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0600U);
    std::ofstream(path) << "{}";
    EXPECT_THROW(SentFile broken(path), SettingsError);
}

TEST(LtiGrades, ScoresHaveWhatThePlatformNeeds) {
    const Grade grade{"sub-1", "anna", "lift", "https://x.example/2/lineitem?type_id=1", 71.3};
    EXPECT_EQ(nlohmann::json::parse(score_text(grade, "2026-11-21T18:03:00.123Z")),
              nlohmann::json::parse(R"({"userId": "sub-1", "timestamp": "2026-11-21T18:03:00.123Z",
                  "scoreGiven": 71.3, "scoreMaximum": 100, "activityProgress": "Completed",
                  "gradingProgress": "FullyGraded"})"));
    const Grade none{"sub-1", "anna", "lift", "", {}};
    EXPECT_EQ(nlohmann::json::parse(score_text(none, "t")),
              nlohmann::json::parse(R"({"userId": "sub-1", "timestamp": "t",
                  "activityProgress": "Initialized", "gradingProgress": "NotReady"})"));
    EXPECT_EQ(scores_address(grade.line_item), "https://x.example/2/lineitem/scores?type_id=1");
    EXPECT_EQ(scores_address("https://x.example/2"), "https://x.example/2/scores");
    EXPECT_EQ(scores_address("https://x.example/2/"), "https://x.example/2/scores");
}

}  // namespace THIS_TEST
}  // namespace placode::lti
