// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/counted.h"

#include <gtest/gtest.h>

namespace placode::sim {
namespace THIS_TEST {

TEST(Counted, OneIsSingular) {
    EXPECT_EQ(counted(1, "file"), "1 file");
    EXPECT_EQ(counted(size_t{1}, "person", "people"), "1 person");
}

TEST(Counted, AllElseIsPlural) {
    EXPECT_EQ(counted(0, "attempt"), "0 attempts");
    EXPECT_EQ(counted(2, "attempt"), "2 attempts");
    EXPECT_EQ(counted(21, "person", "people"), "21 people");
}

}  // namespace THIS_TEST
}  // namespace placode::sim
