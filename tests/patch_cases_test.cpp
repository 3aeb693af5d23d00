// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is done to the patch, it and the tissue stay numbers, in their place, and come to rest.
// The long versions run in `placodectl bench stability`.

#include "bench/patch_cases.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace placode::bench {
namespace THIS_TEST {

class PatchCases : public testing::TestWithParam<std::string> {};

TEST_P(PatchCases, Holds) {
    sim::StabilityOptions options;
    options.seconds = 1;
    options.rest_seconds = 2;
    options.poke_frames = 3000;
    const sim::StabilityResult result = run_patch_case(GetParam(), options);
    EXPECT_EQ(result.verdict, sim::StabilityVerdict::kHolds) << result.detail;
    RecordProperty("detail", result.detail);
}

INSTANTIATE_TEST_SUITE_P(All, PatchCases, testing::ValuesIn(patch_case_names()),
                         [](const auto& test) {
                             std::string name = test.param;
                             for (char& c : name)
                                 if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                             return name;
                         });

TEST(PatchCasesByName, AnUnknownOneIsRefused) {
    EXPECT_THROW((void)run_patch_case("none", {}), std::invalid_argument);
}

}  // namespace THIS_TEST
}  // namespace placode::bench
