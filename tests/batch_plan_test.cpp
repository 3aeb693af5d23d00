// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `placodectl batch plan` over recordings: asked to stop it plans nothing.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/stopped_program.h"

namespace placode::test {
namespace THIS_TEST {

using testing::HasSubstr;

class BatchPlan : public Programs {};

TEST_F(BatchPlan, AskedToStopItPlansNothing) {
    // Checksums of 4 GB, most of it holes: seconds, if nobody stopped them.
    fs::create_directories(file("in"));
    write_text(file("in/0.placode"), "no recording");
    fs::resize_file(file("in/0.placode"), 20'000'000);
    for (int i = 1; i < 200; ++i)
        fs::create_hard_link(file("in/0.placode"), file("in/" + std::to_string(i) + ".placode"));
    for (const int signal : {SIGINT, SIGTERM}) {
        const Outcome ended = stopped(
            folder, {"batch", "plan", "rescore", "--recordings", "in", "--out", "b"}, signal);
        EXPECT_EQ(ended.status, 1) << signal;
        EXPECT_THAT(ended.err, HasSubstr("batch plan: stopped")) << signal;
        EXPECT_FALSE(fs::exists(file("b/manifest.json"))) << signal;
    }
}

}  // namespace THIS_TEST
}  // namespace placode::test
