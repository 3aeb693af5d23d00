// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/translation.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

namespace placode::sim {
namespace THIS_TEST {

/// "%1" and "%2" of "%2 have passed; it takes %1", which may stand in another order.
std::set<std::string> places_of(std::string_view text) {
    std::set<std::string> places;
    for (size_t at = text.find('%'); at != std::string_view::npos; at = text.find('%', at + 1))
        if (at + 1 < text.size() && text[at + 1] >= '1' && text[at + 1] <= '9')
            places.emplace(text.substr(at, 2));
    return places;
}

TEST(Translation, EveryTextHasPolishWithTheSamePlaces) {
    std::set<std::string_view> contexts;
    for (const Translation& text : embedded_translations()) {
        contexts.insert(text.context);
        const bool counts = text.english.find("%n") != std::string_view::npos;
        for (size_t form = 0; form < (counts ? 3U : 1U); ++form) {
            EXPECT_FALSE(text.polish[form].empty()) << text.english;
            EXPECT_EQ(places_of(text.polish[form]), places_of(text.english)) << text.english;
        }
        for (const std::string_view form : text.counted) {
            EXPECT_EQ(form.empty(), !counts) << text.english;
            if (counts) {
                EXPECT_EQ(places_of(form), places_of(text.english)) << text.english;
            }
        }
    }
    EXPECT_EQ(contexts, (std::set<std::string_view>{"Attempt", "Bilingual", "Key"}));
    EXPECT_GT(embedded_translations().size(), 300U);
}

TEST(Translation, EveryTextIsFound) {
    for (const Translation& text : embedded_translations()) {
        EXPECT_EQ(translated(text.context, text.english, "pl"), text.polish[0]);
        EXPECT_EQ(translated(text.context, text.english, "en"), text.english);
        // As XML has it, a quotation mark would stand in the picture as &quot;.
        EXPECT_EQ(text.polish[0].find('&'), std::string_view::npos) << text.polish[0];
    }
}

TEST(Translation, WhatIsInNoFileStaysEnglish) {
    EXPECT_EQ(translated("Attempt", "not in the file", "pl"), "not in the file");
    EXPECT_EQ(translated("no context", "Paused", "pl"), "Paused");
    EXPECT_EQ(translated("Attempt", "Paused", "de"), "Paused");
    EXPECT_EQ(translated("Bilingual", "%n not in the file", "pl", 3), "%n not in the file");
}

TEST(Translation, ANumberChoosesItsForm) {
    const std::string_view english = "%n attempt(s) is (are) left.";
    const auto form = [&](int64_t number) {
        return translated("Bilingual", english, "pl", number);
    };
    std::set<std::string_view> forms{form(1), form(2), form(5)};
    EXPECT_EQ(forms.size(), 3U);
    for (const int few : {3, 4, 22, 24, 102}) EXPECT_EQ(form(few), form(2)) << few;
    for (const int many : {0, 11, 12, 14, 21, 25, 112}) EXPECT_EQ(form(many), form(5)) << many;
    EXPECT_EQ(translated("Bilingual", english, "en", 1), "%n attempt is left.");
    for (const int others : {0, 2, 21})
        EXPECT_EQ(translated("Bilingual", english, "en", others), "%n attempts are left.");
}

}  // namespace THIS_TEST
}  // namespace placode::sim
