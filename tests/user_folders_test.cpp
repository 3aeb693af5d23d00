// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A user's folders as the XDG Base Directory Specification finds them.
#include "sim/core/user_folders.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <string>

namespace placode::sim {
namespace THIS_TEST {

struct Row {
    UserFolder which;
    const char* variable;
    const char* at_home;
};
constexpr Row kRows[] = {{UserFolder::kConfig, "XDG_CONFIG_HOME", "/home/ada/.config"},
                         {UserFolder::kData, "XDG_DATA_HOME", "/home/ada/.local/share"},
                         {UserFolder::kCache, "XDG_CACHE_HOME", "/home/ada/.cache"}};

class UserFolders : public testing::Test {
 protected:
    void SetUp() override {
        for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) {
            if (const char* value = std::getenv(name)) before_[name] = value;
            ::unsetenv(name);
        }
        ::setenv("HOME", "/home/ada", 1);
    }
    void TearDown() override {
        for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
            ::unsetenv(name);
        for (const auto& [name, value] : before_) ::setenv(name.c_str(), value.c_str(), 1);
    }
    std::map<std::string, std::string> before_;
};

TEST_F(UserFolders, LieBelowHomeWhereNothingElseIsSaid) {
    for (const Row& row : kRows) EXPECT_EQ(user_folder(row.which), row.at_home) << row.variable;
    EXPECT_EQ(home_folder(), "/home/ada");
}

TEST_F(UserFolders, LieWhereTheirOwnVariableSays) {
    for (const Row& row : kRows) {
        ::setenv(row.variable, "/else/where", 1);
        for (const Row& other : kRows)
            EXPECT_EQ(user_folder(other.which),
                      other.which == row.which ? "/else/where" : other.at_home)
                << row.variable << ", " << other.variable;
        ::unsetenv(row.variable);
    }
}

TEST_F(UserFolders, AnEmptyOrRelativeValueCountsAsNone) {
    for (const Row& row : kRows)
        for (const char* value : {"", "relative", "./here", "../there", "~/.config"}) {
            ::setenv(row.variable, value, 1);
            EXPECT_EQ(user_folder(row.which), row.at_home) << row.variable << '=' << value;
        }
}

TEST_F(UserFolders, AreNotKnownWithoutAHome) {
    for (const char* home : {static_cast<const char*>(nullptr), "", "ada"}) {
        home != nullptr ? ::setenv("HOME", home, 1) : ::unsetenv("HOME");
        EXPECT_EQ(home_folder(), "");
        for (const Row& row : kRows) {
            EXPECT_EQ(user_folder(row.which), "") << row.variable;
            EXPECT_EQ(user_path(row.which, "placode/file"), "") << "not in the working folder";
            ::setenv(row.variable, "/else/where", 1);
            EXPECT_EQ(user_path(row.which, "placode/file"), "/else/where/placode/file");
            ::setenv(row.variable, "else/where", 1);
            EXPECT_EQ(user_folder(row.which), "") << row.variable;
            ::unsetenv(row.variable);
        }
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim
