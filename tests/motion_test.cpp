// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/attempt/motion.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace placode::ui {
namespace THIS_TEST {

TEST(Motion, StopsWhereTheDesktopSwitchedAnimationsOff) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("placode_motion_" + std::to_string(::getpid()));
    const auto write = [&](const char* file, const char* text) {
        std::filesystem::create_directories((folder / file).parent_path());
        std::ofstream(folder / file) << text;
    };
    EXPECT_TRUE(motion_wanted_in(folder)) << "nothing is set";
    write("gtk-3.0/settings.ini", "[Settings]\ngtk-enable-animations=true\n");
    EXPECT_TRUE(motion_wanted_in(folder));
    write("gtk-3.0/settings.ini", "[Settings]\ngtk-enable-animations = false\n");
    EXPECT_FALSE(motion_wanted_in(folder));
    write("gtk-3.0/settings.ini", "");
    write("kdeglobals", "[KDE]\nAnimationDurationFactor=0\n");
    EXPECT_FALSE(motion_wanted_in(folder));
    write("kdeglobals", "[KDE]\nAnimationDurationFactor=0.5\n");
    EXPECT_TRUE(motion_wanted_in(folder));
    std::filesystem::remove_all(folder);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
