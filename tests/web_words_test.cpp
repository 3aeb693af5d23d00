// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every text of the portal's source has its Polish, with the same places, and no Polish is left
// over; which language a browser likes; forms of counted nouns.
#include "ui/web/words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "db/access.h"
#include "tests/portal_words.h"
#include "ui/web/answers.h"

namespace placode::web {
namespace THIS_TEST {

/// The string literals that begin at `at`, as one text; `at` goes behind them.
std::string literals(const std::string& code, size_t& at) {
    std::string all;
    const auto skip_spaces = [&] { at = std::min(code.find_first_not_of(" \n", at), code.size()); };
    for (skip_spaces(); at < code.size() && code[at] == '"'; skip_spaces())
        for (++at; code[at++] != '"';) {
            if (code[at - 1] == '\\') ++at;
            all += code[at - 1];
        }
    return all;
}

struct Used {
    std::set<std::string> plain, counted;
};

/// What the functions of class Web are called with.
void read_calls(const std::string& code, const std::string& file, Used& used) {
    const std::string before = "Web::";
    for (size_t found = code.find(before); found != std::string::npos;
         found = code.find(before, found + 1)) {
        size_t at = code.find('(', found);
        const std::string call = code.substr(found + before.size(), at - found - before.size());
        ++at;
        const std::string text = literals(code, at);
        EXPECT_FALSE(text.empty()) << file << ": " << code.substr(found, 60);
        if (call == "phrase" || call == "plain_phrase")
            used.plain.insert(text);
        else if (call == "count_phrase" || call == "plain_count_phrase")
            used.counted.insert(text);
        else
            ADD_FAILURE() << file << ": the translation tool does not know " << before << call;
    }
}

Used used_in_the_source() {
    Used used;
    for (const auto& entry : std::filesystem::directory_iterator(PLACODE_SOURCE_DIR "/ui/web")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".cpp" || name == "words.cpp") continue;
        std::ifstream in(entry.path());
        std::stringstream code;
        code << in.rdbuf();
        read_calls(code.str(), name, used);
    }
    return used;
}

/// "%1", "%2", "%n" in the order of the alphabet.
std::multiset<std::string> places_of(std::string_view text) {
    std::multiset<std::string> places;
    for (size_t at = text.find('%'); at != std::string_view::npos; at = text.find('%', at + 1))
        if (at + 1 < text.size() &&
            ((text[at + 1] >= '1' && text[at + 1] <= '9') || text[at + 1] == 'n'))
            places.emplace(text.substr(at, 2));
    return places;
}

/// Texts of a language's file, each once, finished, with as many forms as the language has and with
/// the places of the English.
std::set<std::string> checked(const std::string& language, bool counted, size_t forms) {
    std::set<std::string> found;
    for (const test::PortalWords& each : test::portal_words(language)) {
        if (each.counted != counted) continue;
        EXPECT_TRUE(found.insert(each.english).second) << "twice: " << each.english;
        EXPECT_EQ(each.forms.size(), forms) << each.english;
        for (const std::string& form : each.forms) {
            EXPECT_FALSE(form.empty()) << each.english;
            EXPECT_EQ(form.find('@'), std::string::npos) << form;
            EXPECT_EQ(places_of(form), places_of(each.english)) << each.english;
        }
    }
    return found;
}

void expect_the_same(const std::set<std::string>& used, const std::set<std::string>& there) {
    for (const std::string& english : used)
        EXPECT_TRUE(there.contains(english)) << "has no words: " << english;
    for (const std::string& english : there)
        EXPECT_TRUE(used.contains(english)) << "is used nowhere: " << english;
}

TEST(WebWords, EveryTextHasItsPolishAndNoneIsLeftOver) {
    const Used used = used_in_the_source();
    EXPECT_GE(used.plain.size(), 250U);
    EXPECT_GE(used.counted.size(), 10U);
    expect_the_same(used.plain, checked("pl", false, 1));
    expect_the_same(used.counted, checked("pl", true, 3));
    // English stands in the source, but for the forms of counted nouns.
    expect_the_same(used.counted, checked("en", true, 2));
    expect_the_same({}, checked("en", false, 1));
}

// What the source's files say is what the program was built with.
TEST(WebWords, TheProgramHasThem) {
    const reports::Speaking polish(locale_of("pl"));
    for (const test::PortalWords& each : test::portal_words("pl")) {
        if (each.counted)
            EXPECT_NE(inside::counted(each.english.c_str(), 1).find('1'), std::string::npos);
        else
            EXPECT_EQ(inside::translated(each.english.c_str()), each.forms.at(0));
    }
}

std::string accounts(int number) { return Web::plain_count_phrase("%n account(s)", number); }

TEST(WebWords, NumbersHaveTheirForm) {
    const reports::Speaking english(locale_of("en"));
    EXPECT_EQ(accounts(1), "1 account");
    EXPECT_EQ(accounts(2), "2 accounts");
    EXPECT_EQ(accounts(0), "0 accounts");
    const reports::Speaking polish(locale_of("pl"));
    for (const int few : {2, 3, 4, 22, 104})
        EXPECT_EQ(accounts(few), std::to_string(few) + " konta");
    for (const int many : {0, 5, 11, 12, 14, 21, 25, 112, 1000})
        EXPECT_EQ(accounts(many), std::to_string(many) + " kont");
    EXPECT_EQ(accounts(1), "1 konto");
}

TEST(WebWords, WhatIsFilledInIsEscapedOnceAndHasNoPlaces) {
    const reports::Speaking polish(locale_of("pl"));
    EXPECT_EQ(Web::phrase("Attempts of %1", text(std::string_view("<%1> & \"x\""))).escaped_text,
              "Próby: &lt;%1&gt; &amp; &quot;x&quot;");
    EXPECT_EQ(Web::plain_phrase("open@record"), "otwarty");
    const reports::Speaking english(locale_of("en"));
    EXPECT_EQ(Web::plain_phrase("open@record"), "open");
    EXPECT_EQ(
        Web::phrase("Bands of persons' means, never of fewer than %1 people and never a single "
                    "attempt, signed by their centre.",
                    text(5))
            .escaped_text.substr(0, 22),
        "Bands of persons&#39; ");
}

TEST(WebWords, ARefusalSaysWhoMayAndNoAddress) {
    using db::StoreError;
    const auto told = [](const db::Said& said) {
        return trouble(StoreError(StoreError::Kind::kRefused, "open x: ", said), {}).body;
    };
    EXPECT_NE(told(db::refusal(db::Action::kViewAudit)).find("You may not see the audit trail; an"),
              std::string::npos);
    const std::string moved = told(db::Said::that("the store was moved to %1").with("x:1"));
    EXPECT_EQ(moved.find("x:1"), std::string::npos);
    EXPECT_NE(moved.find("You may not see this."), std::string::npos);
}

TEST(WebWords, ALanguageGoesWithItsThreadAndEnds) {
    {
        const reports::Speaking polish(locale_of("pl"));
        EXPECT_EQ(spoken_code(), "pl");
        EXPECT_EQ(number_text("3.5").escaped_text, "3,5");
        {
            const reports::Speaking english(locale_of("en"));
            EXPECT_EQ(number_text("3.5").escaped_text, "3.5");
        }
        EXPECT_EQ(spoken_code(), "pl");
    }
    EXPECT_EQ(reports::spoken(), QLocale());
}

TEST(WebWords, TheLanguageIsTheOneABrowserLikesBest) {
    for (const char* header : {"pl", "pl-PL", "PL", "pl-PL,pl;q=0.9,en;q=0.8", "de, pl;q=0.5",
                               "en;q=0.5, pl;q=0.8", " pl ; q=0.3 ", "en;q=0, pl;q=0.001"})
        EXPECT_EQ(liked_language(header), "pl") << header;
    for (const char* header :
         {"", "en", "de", "*", "pl;q=0", "en-GB,pl;q=0.9", "en,pl", "pl;q=0.5,en;q=0.5000001,*",
          "polish", ";;,,=", "pl;q=", "pl;q=x", "*;q=0.8,pl;q=0.5"})
        EXPECT_EQ(liked_language(header), "en") << header;
}

// Words in markup do not compile: this is what the compiler asks.
static_assert(!says_something("<p class=\"muted\">"));
static_assert(!says_something("\" name=\"x\"><br>"));
static_assert(!says_something("</h1>\n<p>"));
static_assert(!says_something("\"></label><input id=\"find\" value=\""));
static_assert(!says_something(" · "));
static_assert(!says_something("<nav aria-label=\""));
static_assert(says_something("Attempts"));
static_assert(says_something("<p>None.</p>"));
static_assert(says_something("\"><b>x"));
static_assert(says_something("<nav aria-label=\"Main\">"));
static_assert(says_something("<img alt=\"x"));

}  // namespace THIS_TEST
}  // namespace placode::web
