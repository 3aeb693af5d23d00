// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Foot pedals against a pipe that carries the events of an event device. No hardware.
#include "haptics/foot_pedals.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "haptics/catalogue/open_device.h"

namespace placode::haptics {
namespace THIS_TEST {

using ::testing::HasSubstr;

struct Pipe {
    Pipe()
        : path(std::filesystem::temp_directory_path() / ("pedals_" + std::to_string(::getpid()))) {
        std::filesystem::remove(path);
        (void)!mkfifo(path.c_str(), 0600);
        file = ::open(path.c_str(), O_RDWR | O_NONBLOCK);
        station.set("pedals.device", path);
    }
    ~Pipe() {
        if (file >= 0) ::close(file);
        std::filesystem::remove(path);
    }
    void key(int code, int value) {
        input_event event{};
        event.type = EV_KEY;
        event.code = static_cast<uint16_t>(code);
        event.value = value;
        (void)!::write(file, &event, sizeof event);
    }
    std::string path;
    int file = -1;
    Station station;
};

TEST(FootPedals, AreNoneWhenTheStationNamesNone) {
    FootPedals pedals{Station{}};
    EXPECT_EQ(pedals.poll(0), 0);
    EXPECT_FALSE(pedals.connected());
}

TEST(FootPedals, SayWhatIsMissing) {
    Station station;
    station.set("pedals.device", "/dev/input/nothing");
    try {
        FootPedals pedals(station);
        FAIL();
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/dev/input/nothing: No such file"));
        EXPECT_THAT(error.what(), HasSubstr("group input"));
    }
}

TEST(FootPedals, FollowTheirKeys) {
    Pipe pipe;
    FootPedals pedals(pipe.station);
    EXPECT_EQ(pedals.poll(0), 0);
    pipe.key(KEY_F13, 1);
    EXPECT_EQ(pedals.poll(0), sim::kPedalCut);
    pipe.key(KEY_F13, 2);  // repeated by the keyboard
    pipe.key(KEY_A, 1);    // none of ours
    EXPECT_EQ(pedals.poll(0), sim::kPedalCut);
    pipe.key(KEY_F14, 1);
    EXPECT_EQ(pedals.poll(0), sim::kPedalCut | sim::kPedalCoag);
    pipe.key(KEY_F13, 0);
    EXPECT_EQ(pedals.poll(0), sim::kPedalCoag);
    pipe.key(KEY_F14, 0);
    EXPECT_EQ(pedals.poll(0), 0);
}

TEST(FootPedals, LetGoWhenTheyArePulledOutAndComeBack) {
    Pipe pipe;
    FootPedals pedals(pipe.station);
    pipe.key(KEY_F13, 1);
    EXPECT_EQ(pedals.poll(0), sim::kPedalCut);
    ::close(pipe.file);  // no writer any more: end of file
    pipe.file = -1;
    EXPECT_EQ(pedals.poll(1), 0);
    EXPECT_FALSE(pedals.connected());
    pipe.file = ::open(pipe.path.c_str(), O_RDWR | O_NONBLOCK);
    EXPECT_EQ(pedals.poll(500'000'000), 0) << "looks once a second";
    EXPECT_EQ(pedals.poll(1'100'000'000), 0);
    EXPECT_TRUE(pedals.connected());
    pipe.key(KEY_F14, 1);
    EXPECT_EQ(pedals.poll(1'200'000'000), sim::kPedalCoag);
}

TEST(FootPedals, WorkBesideTheMouse) {
    Pipe pipe;
    DeviceConfig config;
    config.name = "mouse";
    config.tools.resize(1);
    config.station = pipe.station;
    const auto device = open_device(config);
    std::array<DeviceState, 1> states;
    device->read(1'000'000, states);
    pipe.key(KEY_F13, 1);
    device->read(2'000'000, states);
    EXPECT_EQ(states[0].pedals, sim::kPedalCut);
    // Let go after ten seconds, as every pedal.
    device->read(12'100'000'000, states);
    EXPECT_EQ(states[0].pedals, 0);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
