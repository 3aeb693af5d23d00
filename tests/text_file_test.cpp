// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/text_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace placode::sim {
namespace THIS_TEST {

TEST(TextFile, IsReadWholeUpToItsLimit) {
    const std::string long_text(200'000, 'x');
    for (const std::string& text : {std::string(), std::string("a\0b\n", 4), long_text}) {
        std::istringstream in(text);
        EXPECT_EQ(read_at_most(in, text.size()), text);
    }
    std::istringstream in(long_text);
    EXPECT_FALSE(read_at_most(in, long_text.size() - 1));
}

TEST(TextFile, ADeviceWithoutEndIsGivenUp) {
    std::ifstream zero("/dev/zero", std::ios::binary);
    ASSERT_TRUE(zero);
    EXPECT_FALSE(read_at_most(zero, size_t{1} << 20));
}

}  // namespace THIS_TEST
}  // namespace placode::sim
