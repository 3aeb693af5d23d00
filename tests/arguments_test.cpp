// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where the simulator's options come from when nobody gives them, and which numbers are none.
#include "ui/attempt/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace placode::ui {
namespace THIS_TEST {

Arguments parsed(std::vector<std::string> words) {
    words.insert(words.begin(), {"placode-sim", "--task", "touch_targets"});
    std::vector<char*> arguments;
    for (std::string& each : words) arguments.push_back(each.data());
    bool exit_now = false;
    return parse_arguments(static_cast<int>(arguments.size()), arguments.data(), exit_now);
}

std::string author_of(const std::vector<std::string>& words) { return parsed(words).author; }

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

TEST(Arguments, WhatIsNoNumberIsRefusedWithItsOption) {
    for (const std::string option :
         {"--duration", "--speed", "--from", "--min-duration", "--test-force"}) {
        for (const std::string value : {"nan", "-nan", "NAN", "nan(1)", "inf", "-inf", "1e400"}) {
            try {
                (void)parsed({"--study", option + "=" + value});
                ADD_FAILURE() << option << " " << value << ": no error";
            } catch (const UsageError& error) {
                EXPECT_THAT(error.what(),
                            testing::StartsWith(option + ": found \"" + value + "\"; expected "));
            }
        }
    }
    EXPECT_DOUBLE_EQ(parsed({"--test-force", "10"}).test_force_n, 10);
    EXPECT_DOUBLE_EQ(parsed({"--duration", "0.001"}).duration_s, 0.001);
}

TEST(Arguments, AStageIsForPracticeAlone) {
    EXPECT_EQ(parsed({}).stage, 0);
    EXPECT_EQ(parsed({"--stage", "0", "--exam"}).stage, 0);
    EXPECT_EQ(parsed({"--stage", "2"}).stage, 2);
    const auto refusal = [](const std::vector<std::string>& words) -> std::string {
        try {
            (void)parsed(words);
            return "taken";
        } catch (const UsageError& error) {
            return error.what();
        }
    };
    for (const char* wrong : {"-1", "9", "1.5", "two", ""})
        EXPECT_THAT(refusal({"--stage=" + std::string(wrong)}), testing::HasSubstr("--stage"));
    EXPECT_THAT(refusal({"--stage", "1", "--exam"}),
                testing::HasSubstr("begins with the beginning"));
    EXPECT_THAT(refusal({"--stage", "1", "--study"}),
                testing::HasSubstr("begins with the beginning"));
    EXPECT_THAT(refusal({"--stage", "1", "--device", "play:a.placode"}),
                testing::HasSubstr("begins as its attempt did"));
}

}  // namespace THIS_TEST
}  // namespace placode::ui
