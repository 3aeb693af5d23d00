// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Foot pedals through a pipe that carries events like an event device.
#include "haptics/pedal_watch.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "haptics/station.h"

namespace placode::haptics {
namespace THIS_TEST {

namespace fs = std::filesystem;

struct Folder {
    Folder() {
        std::string name = (fs::temp_directory_path() / "placode-pedals-XXXXXX").string();
        path = ::mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
    std::string path;
};

void press(int file, uint16_t code, int32_t value) {
    input_event event{};
    event.type = EV_KEY;
    event.code = code;
    event.value = value;
    ASSERT_EQ(::write(file, &event, sizeof event), static_cast<ssize_t>(sizeof event));
}

TEST(PedalWatch, ListsKeyboardsByTheNamesThatStay) {
    const Folder folder;
    for (const char* name : {"usb-b-event-kbd", "usb-a-event-kbd", "usb-a-event-mouse"})
        std::ofstream(folder.path + "/" + name) << "";
    EXPECT_THAT(pedal_devices(folder.path), testing::ElementsAre(folder.path + "/usb-a-event-kbd",
                                                                 folder.path + "/usb-b-event-kbd"));
    EXPECT_THAT(pedal_devices("/nowhere"), testing::IsEmpty());
}

TEST(PedalWatch, TellsTheKeyThatIsPressedAndThatItWasUnplugged) {
    const Folder folder;
    const std::string path = folder.path + "/pedals";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    const int keep = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
    const int file = ::open(path.c_str(), O_WRONLY | O_NONBLOCK);
    ASSERT_GE(file, 0);
    PedalWatch watch(path);
    ::close(keep);
    EXPECT_TRUE(watch.poll());
    EXPECT_EQ(watch.last_key(), 0);
    press(file, 48, 1);
    EXPECT_TRUE(watch.poll());
    EXPECT_EQ(watch.last_key(), 48);
    EXPECT_TRUE(watch.pressed());
    press(file, 30, 1);
    press(file, 48, 0);
    EXPECT_TRUE(watch.poll());
    EXPECT_EQ(watch.last_key(), 30);
    EXPECT_TRUE(watch.pressed()) << "another key was let go";
    press(file, 30, 0);
    EXPECT_TRUE(watch.poll());
    EXPECT_FALSE(watch.pressed());
    press(file, 31, 1);
    EXPECT_TRUE(watch.poll());
    EXPECT_TRUE(watch.pressed()) << "held while it is unplugged";
    ::close(file);
    EXPECT_FALSE(watch.poll());
    EXPECT_EQ(watch.last_key(), 31);
    EXPECT_FALSE(watch.pressed()) << "a pedal that is gone is not held";
}

TEST(PedalWatch, SaysWhyItCannotBeOpened) {
    try {
        const PedalWatch watch("/dev/input/by-id/nothing-event-kbd");
        FAIL() << "no error";
    } catch (const DeviceError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("No such file"));
        EXPECT_THAT(error.what(), testing::HasSubstr("group input"));
    }
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
