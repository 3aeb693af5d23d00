// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/window_keys.h"

#include <gtest/gtest.h>

namespace placode::view {
namespace THIS_TEST {

TEST(WindowKeys, AreKnownByTheirPlace) {
    EXPECT_EQ(key_of('L'), sim::Key::kL);
    EXPECT_EQ(key_of('1'), sim::Key::kCut);
    EXPECT_EQ(key_of(';'), sim::Key::kSemicolon);
    EXPECT_EQ(key_of(-1), sim::Key::kCount);
}

TEST(WindowKeys, SayALetterOnlyWhereItIsNoAscii) {
    EXPECT_EQ(other_letter(nullptr), 0U);
    EXPECT_EQ(other_letter(""), 0U);
    EXPECT_EQ(other_letter("l"), 0U);
    EXPECT_EQ(other_letter("\xD0\xB4"), 0x0434U);      // Cyrillic
    EXPECT_EQ(other_letter("\xE1\x83\x9A"), 0x10DAU);  // Georgian
    EXPECT_EQ(other_letter("\xD0"), 0U) << "cut short";
    EXPECT_EQ(other_letter("\xE1\x83"), 0U) << "cut short";
}

}  // namespace THIS_TEST
}  // namespace placode::view
