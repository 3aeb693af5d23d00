// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/draft_text.h"

#include <gtest/gtest.h>

#include "curriculum/definitions.h"
#include "curriculum/study.h"

namespace placode::curriculum {
namespace THIS_TEST {

TEST(DraftText, FindsTheTextInBothLanguages) {
    const auto found = draft_text(
        R"({"id": "s", "consent": {"information": [{"en": "Fine."},
            {"en": "DRAFT: to be approved.", "pl": "WERSJA ROBOCZA: do zatwierdzenia."}]}})");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->in("en"), "DRAFT: to be approved.");
    EXPECT_EQ(found->in("pl"), "WERSJA ROBOCZA: do zatwierdzenia.");
}

TEST(DraftText, OneLanguageIsEnough) {
    EXPECT_TRUE(draft_text(R"({"title": {"en": "Consent", "pl": "WERSJA ROBOCZA"}})"));
    EXPECT_TRUE(draft_text(R"({"note": "a DRAFT"})"));
}

TEST(DraftText, OnlyTheWordInCapitalsCounts) {
    EXPECT_FALSE(draft_text(R"({"source": "the text here is a draft", "id": "REDRAFTED"})"));
    EXPECT_FALSE(draft_text(R"({"DRAFT": "a key is no text"})"));
    EXPECT_FALSE(draft_text("DRAFT, but no JSON"));
    EXPECT_FALSE(draft_text("[]"));
}

TEST(DraftText, TheShippedConsentIsOne) {
    EXPECT_TRUE(draft_text(load_study("face_content_validity").json));
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
