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
    std::set<std::string> plain;
    std::set<std::pair<std::string, std::string>> counted;  ///< One, many.
};

/// What say(), words() and their counting sisters are called with.
void read_calls(const std::string& code, const std::string& file, Used& used) {
    for (const std::string call : {"say(", "words(", "say_count(", "words_count("})
        for (size_t found = code.find(call); found != std::string::npos;
             found = code.find(call, found + 1)) {
            const char before = found == 0 ? ' ' : code[found - 1];
            if (std::isalnum(static_cast<unsigned char>(before)) || before == '_') continue;
            size_t at = found + call.size();
            if (call.ends_with("count(")) {
                at = code.find('"', at);
                const std::string one = literals(code, at);
                ASSERT_EQ(code[at++], ',') << file << ": " << one;
                used.counted.emplace(one, literals(code, at));
            } else {
                const std::string text = literals(code, at);
                EXPECT_FALSE(text.empty()) << file << ": " << code.substr(found, 60);
                used.plain.insert(text);
            }
        }
}

Used used_in_the_source() {
    Used used;
    for (const auto& entry : std::filesystem::directory_iterator(PLACODE_SOURCE_DIR "/ui/web")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".cpp" || name == "words.cpp" || name == "polish.cpp")
            continue;
        std::ifstream in(entry.path());
        std::stringstream code;
        code << in.rdbuf();
        read_calls(code.str(), name, used);
    }
    return used;
}

/// "%1", "%2" in the order of the alphabet.
std::multiset<std::string> places_of(std::string_view text) {
    std::multiset<std::string> places;
    for (size_t at = text.find('%'); at != std::string_view::npos; at = text.find('%', at + 1))
        if (at + 1 < text.size() && text[at + 1] >= '1' && text[at + 1] <= '9')
            places.emplace(text.substr(at, 2));
    return places;
}

TEST(WebWords, EveryTextHasItsPolishAndNoneIsLeftOver) {
    const Used used = used_in_the_source();
    EXPECT_GE(used.plain.size(), 250U);
    EXPECT_GE(used.counted.size(), 10U);
    std::set<std::string> plain, counted;
    for (const Polish& each : polish_table()) {
        std::set<std::string>& kind = each.many.empty() ? plain : counted;
        EXPECT_TRUE(kind.emplace(each.english).second) << "twice: " << each.english;
        EXPECT_EQ(each.few.empty(), each.many.empty()) << each.english;
        EXPECT_FALSE(each.polish.empty()) << each.english;
        EXPECT_EQ(each.polish.find('@'), std::string_view::npos) << each.polish;
        const auto places = places_of(each.english);
        EXPECT_EQ(places_of(each.polish), places) << each.english;
        if (each.many.empty()) continue;
        EXPECT_EQ(places_of(each.few), places) << each.english;
        EXPECT_EQ(places_of(each.many), places) << each.english;
    }
    for (const std::string& english : used.plain)
        EXPECT_TRUE(plain.contains(english)) << "has no Polish: " << english;
    for (const std::string& english : plain)
        EXPECT_TRUE(used.plain.contains(english)) << "is used nowhere: " << english;
    std::set<std::string> many_forms;
    for (const auto& [one, many] : used.counted) {
        many_forms.insert(many);
        EXPECT_TRUE(counted.contains(many)) << "has no Polish: " << many;
        EXPECT_EQ(places_of(one), places_of(many)) << one;
    }
    for (const std::string& english : counted)
        EXPECT_TRUE(many_forms.contains(english)) << "is used nowhere: " << english;
}

std::string accounts(int number) { return words_count(number, "%1 account", "%1 accounts"); }

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
    EXPECT_EQ(say("Attempts of %1", text(std::string_view("<%1> & \"x\""))).escaped_text,
              "Próby: &lt;%1&gt; &amp; &quot;x&quot;");
    EXPECT_EQ(words("open@record"), "otwarty");
    const reports::Speaking english(locale_of("en"));
    EXPECT_EQ(words("open@record"), "open");
    EXPECT_EQ(say("Bands of persons' means, never of fewer than %1 people and never a single "
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
