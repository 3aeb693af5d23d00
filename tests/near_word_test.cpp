// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/near_word.h"

#include <gtest/gtest.h>

namespace THIS_TEST {

using namespace placode::sim;

TEST(NearWord, DistanceCountsLettersAndSwaps) {
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("expert", "expert"), 0u);
    EXPECT_EQ(edit_distance("Expert", "eXpert"), 0u);
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);  // the textbook's
    EXPECT_EQ(edit_distance("exprt", "expert"), 1u);
    EXPECT_EQ(edit_distance("exepr", "exper"), 1u);  // two letters swapped
    EXPECT_EQ(edit_distance("ca", "abc"), 3u);       // not 2: no letter is moved twice
    for (const auto& [a, b] : {std::pair{"ring", "rnig"}, {"abcd", "dcba"}, {"", "x"}})
        EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
}

TEST(NearWord, TheNearestKnownWordIsNamedAndStrangersAreNot) {
    const std::vector<std::string> levels{"script:expert", "script:intermediate", "script:novice",
                                          "mouse", "keyboard"};
    EXPECT_EQ(nearest_word("script:exprt", levels), "script:expert");
    EXPECT_EQ(nearest_word("script:novcie", levels), "script:novice");
    EXPECT_EQ(nearest_word("Mouse", levels), "mouse");
    EXPECT_EQ(nearest_word("keybord", levels), "keyboard");
    EXPECT_EQ(nearest_word("theremin", levels), "");
    EXPECT_EQ(nearest_word("", levels), "");
    EXPECT_EQ(nearest_word("key", levels), "keyboard");  // the beginning of one
    EXPECT_EQ(nearest_word("script:", levels), "");      // of three
    EXPECT_EQ(nearest_word("x", {}), "");
    EXPECT_EQ(nearest_word(std::string(100000, 'a'), levels), "");
}

TEST(NearWord, TheQuestionIsPartOfTheSentenceOrMissing) {
    EXPECT_EQ(did_you_mean("exprt", {"export", "erase"}), "; did you mean \"export\"?");
    EXPECT_EQ(did_you_mean("zzz", {"export", "erase"}), "");
}

}  // namespace THIS_TEST
