// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever the attempt's window says it says in Polish as well, and the list of its words has none
// that nobody says.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "sim/core/translation.h"

namespace placode::view {
namespace THIS_TEST {

bool has_polish(const std::string& english) {
    for (const sim::Translation& text : sim::embedded_translations())
        if (text.context == "Attempt" && text.english == english) return true;
    return false;
}

/// Text of a source, with literals that go on in the next line joined.
std::string code_of(const std::filesystem::path& path) {
    std::ifstream in(path);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    static const std::regex seam("\"\\s*\n\\s*\"");
    return std::regex_replace(text, seam, "");
}

std::string code_in(const std::vector<std::string>& folders) {
    std::string code;
    for (const std::string& folder : folders)
        for (const auto& entry :
             std::filesystem::directory_iterator(PLACODE_SOURCE_DIR "/" + folder))
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h")
                code += code_of(entry.path());
    return code;
}

// The phrases stand in the code as plain literals: read there, so that a new one cannot be
// forgotten.
TEST(OverlayWords, EveryLiveWarningHasItsPolish) {
    const std::string code = code_of(PLACODE_SOURCE_DIR "/curriculum/live_warnings.cpp");
    static const std::regex phrase(R"re((?:return |say\()"([A-Z][^"]+)")re");
    int found = 0;
    for (std::sregex_iterator i(code.begin(), code.end(), phrase), end; i != end; ++i, ++found)
        EXPECT_TRUE(has_polish((*i)[1])) << (*i)[1];
    EXPECT_GE(found, 13);
}

TEST(OverlayWords, EveryWordOfTheWindowHasItsPolish) {
    const std::string code = code_in({"ui/view", "ui/attempt"});
    // Of what is said all literals: `say(begun ? "this" : "that")`.
    static const std::regex said(
        R"re(\b(?:say|say_with|phrase|translated)\(((?:[^()]|\([^()]*\))*)\))re"),
        literal(R"re("([^"]*[A-Za-z]{2}[^"]*)")re");
    int found = 0;
    for (std::sregex_iterator i(code.begin(), code.end(), said), end; i != end; ++i) {
        const std::string words = (*i)[1];
        for (std::sregex_iterator j(words.begin(), words.end(), literal); j != end; ++j, ++found)
            EXPECT_TRUE(has_polish((*j)[1])) << (*j)[1];
    }
    EXPECT_GE(found, 70);
}

TEST(OverlayWords, NobodyTranslatesWhatIsNotSaid) {
    const std::string code = code_in({"ui/view", "ui/attempt", "haptics", "curriculum"});
    for (const sim::Translation& text : sim::embedded_translations()) {
        if (text.context != "Attempt") continue;
        EXPECT_NE(code.find('"' + std::string(text.english) + '"'), std::string::npos)
            << text.english;
    }
}

}  // namespace THIS_TEST
}  // namespace placode::view
