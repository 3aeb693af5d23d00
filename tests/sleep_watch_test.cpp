// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/sleep_watch.h"

#include <gtest/gtest.h>

#include "haptics/real_time.h"

namespace placode::curriculum {
namespace THIS_TEST {

constexpr int64_t kSecond = 1'000'000'000;

TEST(SleepWatch, TellsEverySleepOnceAndNoJitterOfTheClocks) {
    SleepWatch watch(500 * kSecond);  // of the days before
    EXPECT_EQ(watch.look(500 * kSecond), 0);
    EXPECT_EQ(watch.look(500 * kSecond + 1000), 0);
    EXPECT_EQ(watch.look(500 * kSecond - 1000), 0);
    EXPECT_DOUBLE_EQ(watch.look(560 * kSecond), 60);
    EXPECT_EQ(watch.look(560 * kSecond), 0);
    // Short ones add up.
    EXPECT_EQ(watch.look(560 * kSecond + kSecond * 3 / 4), 0);
    EXPECT_DOUBLE_EQ(watch.look(560 * kSecond + kSecond * 3 / 2), 1.5);
    EXPECT_DOUBLE_EQ(watch.total_s(), 61.5);
}

// A computer that goes on does not seem to sleep, however busy it is.
TEST(SleepWatch, TheClocksOfThisComputerAgree) {
    SleepWatch watch(haptics::asleep_ns());
    for (int i = 0; i < 100'000; ++i) ASSERT_EQ(watch.look(haptics::asleep_ns()), 0);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
