// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/user_settings.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace placode::ui {
namespace THIS_TEST {

class UserSettingsTest : public testing::Test {
 protected:
    void SetUp() override {
        std::string name = std::filesystem::temp_directory_path() / "placode-settings-XXXXXX";
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
        ::setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    void write(const std::string& text) const {
        std::filesystem::create_directories(folder_ / "placode");
        std::ofstream(folder_ / "placode" / "window") << text;
    }
    std::filesystem::path folder_;
};

TEST_F(UserSettingsTest, AWindowComesBackInItsSize) {
    EXPECT_FALSE(load_window_size());
    save_window_size({1011, 707});
    const auto size = load_window_size();
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 1011);
    EXPECT_EQ(size->height, 707);
}

TEST_F(UserSettingsTest, WhatIsNoSizeIsForgotten) {
    for (const char* text : {"", "wide", "1280", "1280 x 800", "0 0", "-1280 -800", "99999 99999",
                             "1e9 1e9", "1280 nan"}) {
        write(text);
        EXPECT_FALSE(load_window_size()) << '"' << text << '"';
    }
    save_window_size({900, 600});
    save_window_size({1, 1});  // a window that is being closed
    ASSERT_TRUE(load_window_size());
    EXPECT_EQ(load_window_size()->width, 900);
}

TEST_F(UserSettingsTest, AFolderThatCannotBeWrittenCostsOnlyTheMemory) {
    std::ofstream(folder_ / "placode") << "a file where the folder should be";
    EXPECT_NO_THROW(save_window_size({900, 600}));
    EXPECT_FALSE(load_window_size());
}

TEST_F(UserSettingsTest, WithoutAHomeNothingLiesWhereTheProgramWasStarted) {
    const char* set = std::getenv("HOME");
    const std::string before = set != nullptr ? set : "";
    const std::filesystem::path started = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    ::setenv("XDG_CONFIG_HOME", "relative", 1);
    ::unsetenv("HOME");
    EXPECT_EQ(settings_file("window"), "");
    save_window_size({900, 600});
    EXPECT_FALSE(load_window_size());
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
    std::filesystem::current_path(started);
    ::setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
    if (set != nullptr) ::setenv("HOME", before.c_str(), 1);
}

TEST_F(UserSettingsTest, PicturesGoWhereTheDesktopKeepsThem) {
    ::setenv("HOME", folder_.c_str(), 1);
    EXPECT_EQ(pictures_folder(), folder_);  // no desktop said anything
    std::filesystem::create_directories(folder_ / "Obrazy");
    const auto say = [&](const std::string& line) {
        std::ofstream(folder_ / "user-dirs.dirs") << "# comment\n" << line << '\n';
        return pictures_folder();
    };
    EXPECT_EQ(say("XDG_PICTURES_DIR=\"$HOME/Obrazy\""), folder_ / "Obrazy");
    EXPECT_EQ(say("XDG_PICTURES_DIR=\"" + (folder_ / "Obrazy").string() + "\""),
              folder_ / "Obrazy");
    for (const char* other :
         {"XDG_PICTURES_DIR=\"$HOME/gone\"", "XDG_PICTURES_DIR=\"",
          "XDG_PICTURES_DIR=", "XDG_PICTURES_DIR=\"Obrazy\"", "XDG_MUSIC_DIR=\"$HOME/Obrazy\""})
        EXPECT_EQ(say(other), folder_) << other;
}

}  // namespace THIS_TEST
}  // namespace placode::ui
