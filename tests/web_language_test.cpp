// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The portal in two languages: every page of a filled store, the switch, the cookie, what the
// browser asks for, and readers of both at once.

#include <regex>
#include <set>

#include "tests/portal_words.h"
#include "tests/web_world.h"
#include "ui/web/words.h"

namespace placode::test {

namespace THIS_TEST {

class WebLanguageTest : public WebTest {
 protected:
    void ready() override {
        WebTest::ready();
        fill_for_pages(*open(), people);
        std::set<std::string> polish, english;
        for (const PortalWords& each : portal_words("pl")) {
            if (!each.counted) english.emplace(without_meaning(each.english));
            for (const std::string& form : each.forms) polish.insert(form);
        }
        for (const PortalWords& each : portal_words("en"))
            for (const std::string& form : each.forms) english.insert(form);
        polish.insert("Placode");  // The program's name is the same; the part of the body is not.
        for (const std::string& each : english) no_polish_page_has.add(each, polish);
        for (const std::string& each : polish) no_english_page_has.add(each, english);
    }

    /// Pages with who may see them.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> pages() const {
        const auto of = [&](const char* login) { return people.of.at(login); };
        std::vector<std::pair<std::string, std::string>> all;
        for (const auto& [login, role] : RightsWorld::kActors) all.emplace_back(login, "/");
        const std::string stuck = "/people/" + std::to_string(of("grouped").person);
        for (const std::string& path : std::vector<std::string>{
                 "/cohort",
                 "/help",
                 "/refreshers",
                 "/refreshers?after=5",
                 "/scores",
                 "/attempts",
                 "/attempts?page=2",
                 "/standards",
                 "/norms",
                 "/norms/1",
                 "/people",
                 "/people?page=2",
                 "/people?find=grouped",
                 "/people?find=nikt",
                 stuck,
                 stuck + "/attempts",
                 stuck + "/attempts?task=diathermy_ring",
                 stuck + "/tasks/diathermy_ring",
                 "/attempts/" + std::to_string(of("grouped").attempt),
                 "/attempts/" + std::to_string(of("grouped").attempt + 20),
                 "/attempts/" + std::to_string(of("grouped").attempt + 20) + "/review",
                 "/studies",
                 "/no",
                 "/people/999999",
                 "/norms/77",
                 stuck + "/tasks/none"})
            all.emplace_back("educator", path);
        all.emplace_back("coordinator", "/studies");
        for (const std::string study : {RightsWorld::kStudy, kPublished, "none"})
            for (const char* part : {"", "/entries", "/deviations"})
                all.emplace_back("coordinator", "/studies/" + study + part);
        all.emplace_back("administrator", "/people");
        all.emplace_back("administrator", "/cohort");
        all.emplace_back("trainee", "/standards");
        return all;
    }
    [[nodiscard]] Browser speaking(const std::string& login, const std::string& code) const {
        Browser one = signed_in(login);
        one.cookies["placode-language"] = code;
        return one;
    }

    Foreign no_polish_page_has, no_english_page_has;
};

/// Words of English sentences, which no name, code or unit has. What people of the store typed and
/// are called is Polish or taken out.
std::string english_in(const std::vector<std::string>& said) {
    static const std::regex names("Name of [a-z0-9-]+|log-in|Placode burned");
    static const std::regex words(
        "\\b(the|of|and|with|is|are|was|were|by|for|from|not|has|have|this|that|there|point|points|"
        "score|attempt|attempts|person|people|last|best|step|page)\\b",
        std::regex::icase);
    for (const std::string& text : said) {
        std::string letters = std::regex_replace(text, names, "");
        // The bytes of ó are no border of a word.
        for (char& c : letters)
            if (static_cast<unsigned char>(c) >= 0x80) c = 'x';
        if (std::regex_search(letters, words)) return text;
    }
    return {};
}

TEST_P(WebLanguageTest, EveryPageSpeaksTheLanguageOfItsReader) {
    std::map<std::string, Browser> polish, english;
    for (const auto& [login, role] : RightsWorld::kActors) {
        polish.emplace(login, speaking(login, "pl"));
        english.emplace(login, speaking(login, "en"));
    }
    std::set<int> answered;
    for (const auto& [login, path] : pages()) {
        const std::string place = login + " " + path;
        const Seen pl = polish.at(login).get(path), en = english.at(login).get(path);
        answered.insert(pl.status);
        EXPECT_EQ(pl.status, en.status) << place;
        EXPECT_TRUE(pl.shows("<html lang=\"pl\">")) << place;
        EXPECT_TRUE(en.shows("<html lang=\"en\">")) << place;
        auto said = said_by(pl);
        if (path.starts_with("/people"))  // Log-in names of the list.
            std::erase_if(said, [](const std::string& text) {
                return std::any_of(RightsWorld::kActors.begin(), RightsWorld::kActors.end(),
                                   [&](const auto& actor) { return text == actor.first; });
            });
        EXPECT_GT(said.size(), 8U) << place;
        EXPECT_EQ(no_polish_page_has.found_in(said), "") << place;
        EXPECT_EQ(english_in(said), "") << place;
        EXPECT_EQ(no_english_page_has.found_in(said_by(en)), "") << place;
        EXPECT_FALSE(pl.shows("%1")) << place;
        EXPECT_FALSE(en.shows("%1")) << place;
    }
    EXPECT_EQ(answered, (std::set<int>{200, 403, 404}));
}

TEST_P(WebLanguageTest, NumbersDaysAndTitlesAreThoseOfTheLanguage) {
    const std::string attempt = "/attempts/" + std::to_string(people.of["grouped"].attempt);
    const Seen pl = speaking("educator", "pl").get(attempt),
               en = speaking("educator", "en").get(attempt);
    const curriculum::Task task = curriculum::load_task("diathermy_ring");
    EXPECT_TRUE(en.shows("71.3") && en.shows("2026-01-02</span> 03:04") && en.shows(task.title.en));
    EXPECT_TRUE(pl.shows("71,3") && pl.shows("2 sty 2026</span>, 03:04") &&
                pl.shows(task.title.pl));
    EXPECT_TRUE(pl.shows("Stała 0,33 s na godzinie 4.")) << "a reason with its own Polish pattern";
    EXPECT_TRUE(pl.shows("Postój w miejscu z włączoną energią")) << "the ledger's words";
    EXPECT_TRUE(pl.shows("Długość drogi")) << "the shell's name of a metric";
    EXPECT_TRUE(en.shows("Resting on one spot with energy on") && en.shows("Path length"));
    const Seen norms = speaking("educator", "pl").get("/norms/1");
    EXPECT_TRUE(norms.shows("eksperci: 5 osób") && norms.shows("10 prób"));
    EXPECT_TRUE(norms.shows("84,0") && !norms.shows("84.0"));
}

TEST_P(WebLanguageTest, TheSwitchKeepsThePageAndTheChoice) {
    Browser one = signed_in("educator");
    const Seen english = one.get("/attempts?group=1&page=2");
    EXPECT_TRUE(
        english.shows("href=\"/attempts?group=1&amp;page=2&amp;language=pl\" hreflang=\"pl\" "
                      "lang=\"pl\" aria-label=\"PL, polski\">PL</a>"));
    EXPECT_TRUE(
        english.shows("lang=\"en\" aria-label=\"EN, English\" aria-current=\"true\">EN</a>"));
    const Seen chosen = one.get("/attempts?group=1&page=2&language=pl");
    EXPECT_EQ(chosen.status, 303);
    EXPECT_EQ(chosen.header("Location"), "/attempts?group=1&page=2");
    EXPECT_EQ(chosen.header("Set-Cookie"),
              "placode-language=pl; Path=/; HttpOnly; SameSite=Strict; Max-Age=31536000");
    EXPECT_TRUE(one.get("/attempts?group=1&page=2").shows("<html lang=\"pl\">"));
    EXPECT_TRUE(one.get("/cohort").shows("<html lang=\"pl\">")) << "all pages from then on";
    const std::string token = Browser::token_of(one.get("/").body);
    EXPECT_EQ(one.post("/sign-out", {{"form_token", token}}).status, 303);
    EXPECT_TRUE(one.get("/sign-in").shows("<html lang=\"pl\">")) << "also after the session";
    (void)one.get("/sign-in?language=en");
    EXPECT_TRUE(one.get("/sign-in").shows("<html lang=\"en\">"));
    one.cookies["placode-language"] = "de";
    EXPECT_TRUE(one.get("/sign-in").shows("<html lang=\"en\">"));
    portal = start({}, true);
    Browser secure = browser();
    const Seen line = secure.get("/sign-in?language=pl");
    EXPECT_NE(line.header("Set-Cookie").find("__Host-placode-language=pl; "), std::string::npos);
    EXPECT_NE(line.header("Set-Cookie").find("; Secure"), std::string::npos);
    EXPECT_TRUE(secure.get("/sign-in").shows("<html lang=\"pl\">"));
}

TEST_P(WebLanguageTest, TheSwitchLeadsNowhereElse) {
    Browser one = signed_in("educator");
    for (const char* path : {"//evil.example/x", "/%2F/evil.example"})
        EXPECT_EQ(one.get(std::string(path) + "?language=pl").header("Location"), "/") << path;
    const Seen split = one.get("/x%0D%0ASet-Cookie:a=b?y%0D%0Aa=1&language=pl");
    EXPECT_EQ(split.headers.count("Set-Cookie"), 1U);
    EXPECT_EQ(one.get("/cohort?language=de").status, 200) << "no language of ours is no choice";
    EXPECT_EQ(one.send("POST", "/cohort?language=en").status, 405);
    // Who is nobody learns nothing by it: the same answer for every page, there or not.
    Browser nobody = browser();
    for (const char* path : {"/cohort", "/there/is/none"}) {
        EXPECT_EQ(nobody.get(std::string(path) + "?language=pl").header("Location"), path);
        EXPECT_EQ(nobody.get(path).header("Location"), "/sign-in");
    }
}

TEST(WebAddress, IsOneLineOnThisHostWithoutTheChoice) {
    const auto address = [](const std::string& path,
                            const std::map<std::string, std::string>& query = {}) {
        web::Request request;
        request.path = path;
        request.query = query;
        return web::address_of(request);
    };
    EXPECT_EQ(address("/attempts", {{"page", "2"}, {"group", ""}, {"language", "pl"}}),
              "/attempts?page=2");
    EXPECT_EQ(address("/people/1/tasks/żółw"), "/people/1/tasks/%C5%BC%C3%B3%C5%82w");
    for (const char* path : {"", "x", "//evil.example", "///evil.example", "http://evil.example"})
        EXPECT_EQ(address(path), "/") << path;
    EXPECT_EQ(address("/\\evil.example"), "/%5Cevil.example");
    EXPECT_EQ(address("/x\r\nSet-Cookie:a=b", {{"y\r\na", "1\n"}}),
              "/x%0D%0ASet-Cookie%3Aa%3Db?y%0D%0Aa=1%0A");
}

TEST_P(WebLanguageTest, WithoutAChoiceTheBrowserIsAsked) {
    Browser one = browser();
    one.languages = "de-DE,de;q=0.9,pl;q=0.8,en;q=0.7";
    EXPECT_TRUE(one.get("/sign-in").shows("<html lang=\"pl\">"));
    one.languages = "en-GB,en;q=0.9,pl;q=0.8";
    EXPECT_TRUE(one.get("/sign-in").shows("<html lang=\"en\">"));
    one.languages = "de";
    EXPECT_TRUE(one.get("/sign-in").shows("<html lang=\"en\">"));
    one.cookies["placode-language"] = "pl";
    EXPECT_TRUE(one.get("/sign-in").shows("<html lang=\"pl\">")) << "a choice is before it";
}

TEST_P(WebLanguageTest, SigningInAndRefusalsSpeakItToo) {
    Browser one = browser();
    one.languages = "pl";
    EXPECT_TRUE(one.get("/sign-in").shows("<label for=\"password\">Hasło</label>"));
    EXPECT_TRUE(one.sign_in("trainee", "wrong one 12").shows("hasło jest błędne"));
    EXPECT_TRUE(one.post("/sign-in", {{"login", "x"}}).shows("pliki cookie są wyłączone"));
    EXPECT_TRUE(one.sign_in("", "").shows("Wpisz login i hasło."));
    EXPECT_TRUE(one.send("DELETE", "/").shows("Na tę stronę nie można niczego wysłać."));
    EXPECT_TRUE(one.get("/" + std::string(600, 'a')).shows("Zbyt długie żądanie"));
    EXPECT_TRUE(one.post("/sign-in?x=1", {{"login", "x"}}).shows("Nie można odczytać żądania."));
    open()->accounts().set_active(people.of["loner"].person, false);
    EXPECT_TRUE(one.sign_in("loner").shows("To konto jest wyłączone."));
    open()->accounts().set_password(people.of["stranger"].person, "chosen by another", true);
    EXPECT_TRUE(one.sign_in("stranger", "chosen by another").shows("wybierz własne hasło"));
    for (int i = 0; i < 5; ++i) (void)one.sign_in("spare", "wrong password 1");
    EXPECT_TRUE(one.sign_in("spare").shows("Zbyt wiele błędnych haseł. Spróbuj ponownie za "));
    EXPECT_EQ(one.sign_in("trainee").status, 303);
    EXPECT_TRUE(one.post("/sign-out", {{"form_token", "guessed"}}).shows("Nie wylogowano"));
    const Seen refused = one.get("/cohort");
    EXPECT_EQ(refused.status, 403);
    EXPECT_TRUE(refused.shows("Nie możesz oglądać prób innych osób; może to zrobić instruktor."));
}

TEST_P(WebLanguageTest, ReadersOfBothLanguagesAtOnceDoNotMix) {
    const auto cookies = signed_in("educator").cookies;
    const std::string attempt = "/attempts/" + std::to_string(people.of["grouped"].attempt);
    std::atomic<int> right{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < 8; ++t)
        threads.emplace_back([&, code = std::string(t % 2 == 0 ? "pl" : "en")] {
            Browser one = browser();
            one.cookies = cookies;
            one.cookies["placode-language"] = code;
            const Foreign& foreign = code == "pl" ? no_polish_page_has : no_english_page_has;
            for (const std::string& path :
                 {attempt, std::string("/cohort"), std::string("/scores")}) {
                const Seen seen = one.get(path);
                // The name of a metric comes from the shell's file.
                const bool metric = path != attempt || seen.shows("Path length") == (code == "en");
                right += metric && foreign.found_in(said_by(seen)).empty() ? 1 : 0;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(right, 24);
}

INSTANTIATE_TEST_SUITE_P(Engines, WebLanguageTest, testing::Values("Sqlite"), engine_name);

}  // namespace THIS_TEST
}  // namespace placode::test
