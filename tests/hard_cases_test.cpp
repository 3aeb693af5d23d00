// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is done to needle, thread and patch, they stay numbers, the tissue stays in its place
// and comes to rest. The long versions run in `placodectl bench stability`.

#include "bench/hard_cases.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace placode::bench {
namespace THIS_TEST {

class HardCases : public testing::TestWithParam<std::string> {};

TEST_P(HardCases, Holds) {
    sim::StabilityOptions options;
    options.seconds = 1;
    options.rest_seconds = 2;
    options.poke_frames = 3000;
    const sim::StabilityResult result = run_hard_case(GetParam(), options);
    EXPECT_EQ(result.verdict, sim::StabilityVerdict::kHolds) << result.detail;
    RecordProperty("detail", result.detail);
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(hard_case_names()),
                         [](const auto& test) {
                             std::string name = test.param;
                             for (char& c : name)
                                 if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                             return name;
                         });

TEST(HardCasesByName, AnUnknownOneIsRefused) {
    EXPECT_THROW((void)run_hard_case("none", {}), std::invalid_argument);
}

}  // namespace THIS_TEST
}  // namespace placode::bench
