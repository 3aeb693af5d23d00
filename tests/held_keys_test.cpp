// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/held_keys.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace placode::view {
namespace THIS_TEST {

constexpr int kEnter = 257, kX = 88, kEnterScan = 36, kXScan = 53;
using Codes = std::vector<int>;

DownKeys down(std::initializer_list<size_t> scancodes) {
    DownKeys keys;
    for (const size_t code : scancodes) keys.set(code);
    return keys;
}

TEST(HeldKeys, AreLostWhenTheKeyboardSaysSoTwice) {
    HeldKeys held;
    held.pressed(kEnter, kEnterScan);
    held.pressed(kX, kXScan);
    EXPECT_EQ(held.lost(down({kEnterScan, kXScan})), Codes{});
    EXPECT_EQ(held.lost(down({kEnterScan})), Codes{}) << "its release may be on its way";
    EXPECT_EQ(held.lost(down({kEnterScan})), Codes{kX});
    EXPECT_FALSE(held.has(kX));
    EXPECT_EQ(held.lost(down({kEnterScan})), Codes{}) << "once";
    EXPECT_TRUE(held.has(kEnter));
}

TEST(HeldKeys, ForgetWhatWasUpBeforeANewPress) {
    HeldKeys held;
    held.pressed(kX, kXScan);
    EXPECT_EQ(held.lost({}), Codes{});
    held.released(kX);
    held.pressed(kX, kXScan);
    EXPECT_EQ(held.lost({}), Codes{});
    EXPECT_EQ(held.lost(down({kXScan})), Codes{});
    EXPECT_EQ(held.lost({}), Codes{}) << "not twice in a row";
    held.clear();
    EXPECT_EQ(held.lost({}), Codes{});
}

TEST(HeldKeys, KeepAKeyThatTheKeyboardDoesNotKnow) {
    HeldKeys held;
    held.pressed(kX, -1);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(held.lost({}), Codes{});
}

TEST(HeldKeys, AreLookedAtTenTimesASecondWhileAnyIsDown) {
    HeldKeys held;
    EXPECT_FALSE(held.due(1));
    held.pressed(kX, kXScan);
    int looks = 0;
    for (int ms = 1000; ms < 2000; ++ms) looks += held.due(ms * 0.001) ? 1 : 0;
    EXPECT_NEAR(looks, 10, 1);
    held.released(kX);
    EXPECT_FALSE(held.due(9));
}

}  // namespace THIS_TEST
}  // namespace placode::view
