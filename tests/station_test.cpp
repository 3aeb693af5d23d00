// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/station.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "haptics/axes.h"
#include "haptics/real_time.h"

namespace placode::haptics {
namespace THIS_TEST {

using ::testing::HasSubstr;

std::string error_of(const std::string& text) {
    try {
        (void)Station::parse(text, "station.conf");
    } catch (const DeviceError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Station, ReadsLinesWithCommentsAndBlanks) {
    const Station station = Station::parse(
        "# arms\n\n openhaptics.right = Right arm  # the old one\r\nlimit.force_n=0.5\n", "x");
    EXPECT_EQ(station.text("openhaptics.right"), "Right arm");
    EXPECT_DOUBLE_EQ(station.number("limit.force_n"), 0.5);
    EXPECT_DOUBLE_EQ(station.number("limit.stiffness_n_m"), 300) << "the default";
    EXPECT_EQ(station.text("openhaptics.left"), "");
}

TEST(Station, NamesFileLineValueAndRange) {
    EXPECT_THAT(error_of("\nlimit.force_n = 50\n"), HasSubstr("station.conf, line 2"));
    EXPECT_THAT(error_of("limit.force_n = 50"),
                HasSubstr("\"50\", expected a number from 0.1 to 10"));
    EXPECT_THAT(error_of("limit.force_n = 0,5"), HasSubstr("\"0,5\""));
    EXPECT_THAT(error_of("limit.force_n = nan"), HasSubstr("expected a number"));
    EXPECT_THAT(error_of("arm.mapping = inverse"), HasSubstr("expected handle or tip"));
    EXPECT_THAT(error_of("arm.speed = 3"),
                HasSubstr("unknown key \"arm.speed\"; known are: arm.mapping"));
    EXPECT_THAT(error_of("nonsense"), HasSubstr("expected key = value"));
}

TEST(Station, WritesAFileThatItReads) {
    Station station;
    station.set("haply.right", "04EA");
    station.set("arm.scale", "0.5");
    const std::string text = station.file_text();
    const Station back = Station::parse(text, "x");
    EXPECT_EQ(back.text("haply.right"), "04EA");
    EXPECT_DOUBLE_EQ(back.number("arm.scale"), 0.5);
    EXPECT_EQ(back.file_text(), text);
    for (const StationKey& key : station_keys()) {
        EXPECT_THAT(text, HasSubstr(std::string(key.key)));
        EXPECT_FALSE(key.meaning.empty());
        // Every default is a value that may be set.
        Station one;
        EXPECT_NO_THROW(one.set(key.key, key.otherwise)) << key.key;
    }
}

TEST(Station, IsReadFromTheFileThatTheEnvironmentNames) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("station_test_" + std::to_string(::getpid()) + ".conf");
    std::ofstream(path) << "arm.scale = 2\n";
    setenv("PLACODE_STATION", path.c_str(), 1);
    EXPECT_DOUBLE_EQ(Station::of_this_computer().number("arm.scale"), 2);
    std::filesystem::remove(path);
    EXPECT_THROW((void)Station::of_this_computer(), DeviceError) << "named, but not there";
    unsetenv("PLACODE_STATION");
    setenv("XDG_CONFIG_HOME", "/nowhere", 1);
    EXPECT_EQ(Station::path_of_this_computer(), "/nowhere/placode/station.conf");
    EXPECT_DOUBLE_EQ(Station::of_this_computer().number("arm.scale"), 1) << "no file, no complaint";
    const char* set = std::getenv("HOME");
    const std::string before = set != nullptr ? set : "";
    setenv("XDG_CONFIG_HOME", "relative", 1);
    setenv("HOME", "/home/ada", 1);
    EXPECT_EQ(Station::path_of_this_computer(), "/home/ada/.config/placode/station.conf");
    unsetenv("HOME");
    EXPECT_EQ(Station::path_of_this_computer(), "");
    if (set != nullptr) setenv("HOME", before.c_str(), 1);
    unsetenv("XDG_CONFIG_HOME");
}

TEST(Station, IsSavedWithTheCommentsOfWhoWroteTheFile) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("station_save_" + std::to_string(::getpid()));
    const std::string path = (folder / "deep" / "station.conf").string();
    Station station;
    station.set("haply.right", "04EA");
    station.save(path);
    const auto text = [&] {
        std::ifstream in(path);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    EXPECT_EQ(Station::parse(text(), path).text("haply.right"), "04EA");
    std::ofstream(path) << "# my bench\nhaply.right = 04EA  # the good one\narm.scale = 2";
    Station changed = Station::parse(text(), path);
    changed.set("arm.scale", "0.5");
    changed.set("haply.left", "BEEF");
    changed.save(path);
    EXPECT_EQ(text(),
              "# my bench\nhaply.right = 04EA  # the good one\narm.scale = 0.5\n"
              "haply.left = BEEF\n");
    EXPECT_FALSE(std::filesystem::exists(path + ".new"));
    std::filesystem::remove_all(folder);
    EXPECT_THROW(changed.save("/proc/nothing/station.conf"), DeviceError);
    EXPECT_THROW(changed.save(""), DeviceError);
}

TEST(DeviceAxes, TurnVectorsOfADevice) {
    const Mat3 axes = device_axes("x z -y", "k");
    EXPECT_EQ(axes * Vec3(1, 2, 3), Vec3(1, 3, -2));
    EXPECT_EQ(device_axes("+x, +y, +z", "k"), Mat3::Identity());
    for (const char* bad : {"", "x y", "x y y", "x y z z", "x z y", "a b c", "-x y z"})
        EXPECT_THROW((void)device_axes(bad, "haply.axes"), DeviceError) << bad;
}

TEST(RealTime, SaysWhatIsMissingAndHowToGrantIt) {
    EXPECT_EQ(missing_rights(true, true), "");
    EXPECT_THAT(missing_rights(false, true), HasSubstr("@placode - rtprio 85"));
    EXPECT_EQ(missing_rights(false, true).find("memlock"), std::string::npos);
    EXPECT_THAT(missing_rights(true, false), HasSubstr("@placode - memlock unlimited"));
    // The file that is offered grants what the message asks for.
    EXPECT_THAT(limits_file(), HasSubstr("@placode - rtprio 85\n"));
    EXPECT_THAT(limits_file(), HasSubstr("@placode - memlock unlimited\n"));
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
