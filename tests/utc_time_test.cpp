// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/utc_time.h"

#include <gtest/gtest.h>

namespace THIS_TEST {

using namespace placode::curriculum;

TEST(UtcTime, ReadsDaysAndTimes) {
    EXPECT_EQ(utc_seconds("1970-01-01"), 0);
    EXPECT_EQ(utc_seconds("2000-03-01T00:00:00Z"), 951868800);
    EXPECT_EQ(utc_seconds("2026-11-21T18:03:59.123Z"), 1795284239);
    EXPECT_EQ(utc_seconds("2028-02-29"), 1835395200);
    EXPECT_EQ(utc_seconds("1969-12-31T23:59:59Z"), -1);
}

TEST(UtcTime, WhatIsNoDateIsNothing) {
    for (const char* text :
         {"", "2026", "2026-13-01", "2026-02-29", "2026-00-10", "2026-11-31", "2026/11/21",
          "2026-11-21T", "2026-11-21T18:03", "2026-11-21T18:03:59", "2026-11-21T24:00:00Z",
          "2026-11-21T18:03:59.Z", "2026-11-21T18:03:59.1x3Z", "2026-11-21 ", "21.11.2026"})
        EXPECT_FALSE(utc_seconds(text)) << text;
}

TEST(UtcTime, WritesWhatItReads) {
    for (const int64_t seconds : {0LL, 1795284239LL, 951868800LL, -1LL, -86401LL})
        EXPECT_EQ(utc_seconds(utc_text(seconds)), seconds) << utc_text(seconds);
    EXPECT_EQ(utc_text(1795284239), "2026-11-21T18:03:59Z");
    EXPECT_EQ(utc_day(1795284239), "2026-11-21");
    EXPECT_EQ(utc_day(-1), "1969-12-31");
}

}  // namespace THIS_TEST
