// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/hidden_letters.h"

#include <gtest/gtest.h>

namespace THIS_TEST {

using namespace placode::sim;

const std::string kMark = "\xEF\xBF\xBD";  // U+FFFD

TEST(HiddenLetters, AreControlsDirectionsZeroWidthsAndEndsOfLines) {
    for (const char32_t code :
         {0x00,   0x09,   0x0A,   0x0D,   0x1B,   0x1F,    0x7F,    0x80,    0x85,
          0x9B,   0x9F,  // Cc
          0xAD,   0x061C, 0x180E, 0x200B, 0x200D, 0x200E,  0x200F,  0x202A,  0x202E,
          0x2060, 0x2066, 0x2069, 0xFEFF, 0xFFF9, 0xE0001, 0xE0041, 0xE007F,  // Cf
          0x2028, 0x2029})                                                    // Zl, Zp
        EXPECT_TRUE(is_hidden_letter(code)) << std::hex << static_cast<uint32_t>(code);
    for (const char32_t code : {0x20, 0x7E, 0xA0, 0xAC, 0xAE, 0x0142, 0x0301, 0x0606, 0x200A,
                                0x2010, 0x2027, 0x202F, 0x2065, 0x4E2D, 0xFFFC, 0xFFFD, 0x1F600})
        EXPECT_FALSE(is_hidden_letter(code)) << std::hex << static_cast<uint32_t>(code);
}

TEST(HiddenLetters, TextWithoutThemStaysAsItIs) {
    for (const char* text : {"", "Anna Nowak", "Łukasz Żółć-O'Neil", "中文 \xF0\x9F\x98\x80"}) {
        EXPECT_FALSE(has_hidden_letters(text)) << text;
        EXPECT_EQ(without_hidden_letters(text), text);
    }
}

TEST(HiddenLetters, EachShowsAsOneMark) {
    const std::pair<std::string, std::string> cases[]{
        {"a\x1b[2Kb", "a" + kMark + "[2Kb"},
        {"a\nb\tc\r", "a" + kMark + "b" + kMark + "c" + kMark},
        {"a\xE2\x80\xAE"
         "b",
         "a" + kMark + "b"},  // U+202E
        {"a\xC2\x9B"
         "b",
         "a" + kMark + "b"},                                 // CSI as one letter
        {"a\xE2\x80\xA8\xE2\x80\xA9", "a" + kMark + kMark},  // line, paragraph
        {"a\x9B"
         "b",
         "a" + kMark + "b"},                                  // CSI as a byte
        {"a\xC5", "a" + kMark},                               // cut off
        {"\xC0\x8A", kMark + kMark},                          // a line end, too long
        {"\xED\xA0\x80", kMark + kMark + kMark},              // half a pair
        {"\xF4\x90\x80\x80", kMark + kMark + kMark + kMark},  // beyond Unicode
        {std::string("a\0b", 3), "a" + kMark + "b"}};
    for (const auto& [text, shown] : cases) {
        EXPECT_TRUE(has_hidden_letters(text)) << shown;
        EXPECT_EQ(without_hidden_letters(text), shown);
        EXPECT_FALSE(has_hidden_letters(shown)) << shown;
    }
}

TEST(HiddenLetters, SomeMayStay) {
    EXPECT_FALSE(has_hidden_letters("a\nb\t", "\n\t"));
    EXPECT_TRUE(has_hidden_letters("a\nb\r", "\n\t"));
    EXPECT_EQ(without_hidden_letters("a\nb\r", "\n\t"), "a\nb" + kMark);
}

}  // namespace THIS_TEST
