// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever is said at the rim of the picture is said in Polish as well.

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "ui/view/strings.h"

namespace placode::view {
namespace THIS_TEST {

// The phrases stand in the code as plain literals: read there, so that a new one cannot be
// forgotten.
TEST(OverlayWords, EveryLiveWarningHasItsPolish) {
    std::ifstream in(PLACODE_SOURCE_DIR "/curriculum/live_warnings.cpp");
    std::stringstream text;
    text << in.rdbuf();
    const std::string code = text.str();
    static const std::regex phrase(R"re((?:return |say\()"([A-Z][^"]+)")re");
    int found = 0;
    for (std::sregex_iterator i(code.begin(), code.end(), phrase), end; i != end; ++i, ++found) {
        const std::string english = (*i)[1];
        EXPECT_NE(translated(english, "pl"), english) << english;
    }
    EXPECT_GE(found, 13);
}

}  // namespace THIS_TEST
}  // namespace placode::view
