// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/strings.h"

#include <gtest/gtest.h>

#include "ui/view/text.h"

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

TEST(Strings, SpeakPolishAndFallBackToEnglish) {
    EXPECT_EQ(translated("Paused", "pl"), "Pauza");
    EXPECT_EQ(translated("Paused", "en"), "Paused");
    EXPECT_EQ(translated("not in the table", "pl"), "not in the table");
    size_t at = 0;
    EXPECT_EQ(next_code_point("\xC5\x82", at), 0x142U);  // ł
    EXPECT_EQ(at, 2U);
    at = 0;
    EXPECT_EQ(next_code_point("\xC5", at), 0xFFFDU);
}

}  // namespace THIS_TEST
