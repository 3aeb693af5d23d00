// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/gamepad_search.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "haptics/catalogue/open_device.h"

using namespace placode::haptics;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

namespace THIS_TEST {

// As the kernel writes them: a wheel mouse, a keyboard (cut short) and a pad with BTN_GAMEPAD
// (0x130, bit 48 of the fifth word).
constexpr const char* kMouse = "70000 0 0 0 0";
constexpr const char* kKeyboard = "120013 c00000000000 0 fffffffffffffffe";
constexpr const char* kPad = "7cdb000000000000 0 0 0 0";

/// What /sys/class/input and /dev/input look like.
class Gamepads : public testing::Test {
 protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "placode-input-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        folders = {folder + "/sys", folder + "/dev"};
        fs::create_directories(folders.list);
        fs::create_directories(folders.devices);
    }
    void TearDown() override { fs::remove_all(folder); }
    void add(const std::string& node, const std::string& name, const std::string& keys,
             bool readable = true) const {
        const fs::path device = fs::path(folders.list) / node / "device";
        fs::create_directories(device / "capabilities");
        std::ofstream(device / "name") << name << "\n";
        std::ofstream(device / "capabilities/key") << keys << "\n";
        if (readable) std::ofstream(folders.devices + "/" + node) << "";
    }
    std::string folder;
    InputFolders folders;
};

TEST_F(Gamepads, MouseAndKeyboardAreNoGamepads) {
    add("event0", "Wheel Mouse", kMouse);
    add("event1", "Keyboard", kKeyboard);
    const GamepadSearch search = look_for_gamepads(folders);
    EXPECT_THAT(search.found, IsEmpty());
    EXPECT_EQ(search.looked_at, 2);
    EXPECT_THAT(search.reason(folders), HasSubstr("none of the 2 input devices"));
    EXPECT_THAT(search.reason(folders), HasSubstr("Plug one in"));
}

TEST_F(Gamepads, APadIsFoundByItsButtonsAndNamed) {
    add("event0", "Wheel Mouse", kMouse);
    add("event7", "Pad of somebody", kPad);
    const GamepadSearch search = look_for_gamepads(folders);
    EXPECT_THAT(search.found, ElementsAre("Pad of somebody"));
    EXPECT_EQ(search.reason(folders), "");
}

TEST_F(Gamepads, APadThatMayNotBeReadIsNoPadButNoNothingEither) {
    add("event3", "Pad of root", kPad, false);
    const GamepadSearch search = look_for_gamepads(folders);
    EXPECT_THAT(search.found, IsEmpty());
    EXPECT_THAT(search.unreadable, ElementsAre(folders.devices + "/event3"));
    EXPECT_THAT(search.reason(folders), HasSubstr("may not be read"));
    EXPECT_THAT(search.reason(folders), HasSubstr("group input"));
}

TEST_F(Gamepads, NoFoldersAndOddFilesAreNoPads) {
    EXPECT_THAT(look_for_gamepads({folder + "/nothing", folder + "/nothing"}).found, IsEmpty());
    add("event0", "Odd", "zzz");
    add("event1", "Empty", "");
    add("mouse0", "Not an event device", kPad);
    EXPECT_THAT(look_for_gamepads(folders).found, IsEmpty());
}

TEST(GamepadListing, TheListSaysWhatTheSearchFound) {
    const GamepadSearch here = look_for_gamepads();
    for (const DeviceListing& listing : list_devices()) {
        if (listing.name != "gamepad") continue;
        EXPECT_EQ(listing.available, !here.found.empty());
        EXPECT_EQ(listing.found, here.found);
        if (!listing.available) {
            EXPECT_EQ(listing.detail, here.reason());
        }
    }
}

}  // namespace THIS_TEST
