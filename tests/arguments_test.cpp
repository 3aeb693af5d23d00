// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where the simulator's options come from when nobody gives them.
#include "ui/attempt/arguments.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace placode::ui {
namespace THIS_TEST {

std::string author_of(std::vector<std::string> words) {
    words.insert(words.begin(), {"placode-sim", "--task", "touch_targets"});
    std::vector<char*> arguments;
    for (std::string& each : words) arguments.push_back(each.data());
    bool exit_now = false;
    return parse_arguments(static_cast<int>(arguments.size()), arguments.data(), exit_now).author;
}

TEST(Arguments, TheAuthorIsWhoIsNamedThenTheEnvironmentThenTheLogIn) {
    ::setenv("USER", "ada", 1);
    ::unsetenv("PLACODE_AUTHOR");
    EXPECT_EQ(author_of({}), "ada");
    ::setenv("PLACODE_AUTHOR", "", 1);
    EXPECT_EQ(author_of({}), "ada");
    ::setenv("PLACODE_AUTHOR", "Dr. Example", 1);
    EXPECT_EQ(author_of({}), "Dr. Example");
    EXPECT_EQ(author_of({"--author", "Prof. Example"}), "Prof. Example");
    ::unsetenv("PLACODE_AUTHOR");
}

}  // namespace THIS_TEST
}  // namespace placode::ui
