// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A frame of physics allocates nothing and locks nothing, whatever is cut, torn, grasped or heated:
// "never grows" seen over attempts of every task.

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "tests/count_allocations.h"
#include "tests/live_attempt.h"

namespace placode {
namespace THIS_TEST {

struct Case {
    const char* task;
    double end_s;  ///< Until the instrument is at work; PLACODE_LONG_TESTS takes whole attempts.
};
constexpr Case kCases[]{
    {"familiarisation", 12},    {"touch_targets", 6},
    {"trace_contour", 6},       {"grasp_and_lift", 8},
    {"two_handed_traction", 8}, {"diathermy_ring_small", 5},
    {"diathermy_ring", 5},      {"scissors_resection", 9},
    {"sb_dissection", 5},       {"sb_dissection_cystic", 5},
    {"needle_handover", 12},    {"suture_bite", 6},
    {"suture_run", 6},          {"suture_slit", 6},
    {"patch_place", 8},         {"irrigate", 8},
    {"undermine", 8},           {"wound_closure", 8},
};

class FrameAllocation : public testing::TestWithParam<Case> {};

TEST_P(FrameAllocation, AFrameAllocatesAndLocksNothing) {
    const bool whole = std::getenv("PLACODE_LONG_TESTS") != nullptr;
    test::LiveAttempt attempt(GetParam().task, whole ? 0 : GetParam().end_s);
    const sim::State& state = attempt.state();
    const long probe = test::allocations;
    std::make_unique<std::vector<int>>(100).reset();
    ASSERT_GT(test::allocations, probe) << "the interposer counts";
    bool contact = false;
    while (!attempt.over()) {
        attempt.look();
        const long before = test::allocations + test::locks;
        attempt.simulate();
        ASSERT_EQ(test::allocations + test::locks, before)
            << "frame " << state.frame << ", " << state.time_s << " s";
        for (const sim::ToolState& tool : state.tools) contact |= tool.in_contact != 0;
        contact |= state.suturing.entered > 0;         // the needle, not its driver
        contact |= state.suturing.handover.last >= 0;  // likewise, in the open
        contact |= state.irrigation.loaded_count > 0;  // the jet, not its nozzle
    }
    ASSERT_GT(state.frame, 1000);
    EXPECT_TRUE(contact) << "nothing was touched: the test would see little";
}

INSTANTIATE_TEST_SUITE_P(Tasks, FrameAllocation, testing::ValuesIn(kCases),
                         [](const auto& info) { return info.param.task; });

}  // namespace THIS_TEST
}  // namespace placode
