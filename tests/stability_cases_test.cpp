// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases: whatever is done to a body, it holds, comes back, is re-seeded with an event, or was
// refused at load with a reason. The long versions run in `placodectl bench stability`.

#include "sim/verify/stability_cases.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace placode::sim {
namespace THIS_TEST {

StabilityResult run(const std::string& name, Method method = Method::kVbd) {
    StabilityOptions options;
    options.seconds = 1;
    options.rest_seconds = 1;
    options.poke_frames = 1500;
    return run_stability_case(name, method, options);
}

void expect_comes_back(const std::string& name, Method method) {
    const StabilityResult r = run(name, method);
    EXPECT_TRUE(r.verdict == StabilityVerdict::kHolds || r.verdict == StabilityVerdict::kRecovers)
        << name << ", " << r.method << ": " << verdict_name(r.verdict) << ", " << r.detail;
}

TEST(StabilityCases, FlatMirroredAndStretchedBlocksComeBack) {
    for (const char* name : {"flat", "mirrored", "stretch 50 %"}) {
        expect_comes_back(name, Method::kVbd);
        expect_comes_back(name, Method::kXpbd);
    }
}

TEST(StabilityCases, AScrambledBlockComesBackOrIsTakenOutOfItsFold) {
    expect_comes_back("random cube", Method::kXpbd);
    // Descent ends in another minimum: tets folded through each other, none of them inverted. There
    // it is given its rest shape, and says so.
    EXPECT_EQ(run("random cube", Method::kVbd).verdict, StabilityVerdict::kRestored);
}

TEST(StabilityCases, ABlockThatIsOnePointIsGivenItsRestShapeAndSaysSo) {
    EXPECT_EQ(run("exact point", Method::kVbd).verdict, StabilityVerdict::kRestored);
    EXPECT_EQ(run("exact point", Method::kXpbd).verdict, StabilityVerdict::kRestored);
}

TEST(StabilityCases, SliversHoldAndWhatWouldTrembleIsRefusedWithItsNumbers) {
    expect_comes_back("slivers", Method::kVbd);
    const StabilityResult nu = run("nu 0.499");
    EXPECT_EQ(nu.verdict, StabilityVerdict::kRefused);
    EXPECT_NE(nu.detail.find("poissons_ratio 0.499"), std::string::npos) << nu.detail;
    for (const char* name : {"slivers", "nu 0.499", "frames of 4 ms"}) {
        const StabilityResult r = run(name, Method::kXpbd);
        EXPECT_EQ(r.verdict, StabilityVerdict::kRefused) << name;
        EXPECT_NE(r.detail.find("Courant number"), std::string::npos) << r.detail;
    }
}

TEST(StabilityCases, AToolPushedThroughInOneStepLeavesTheBlockWhole) {
    expect_comes_back("pushed through", Method::kVbd);
}

TEST(StabilityCases, ABlockSqueezedBetweenTwoToolsComesBack) {
    expect_comes_back("squeezed", Method::kVbd);
}

TEST(StabilityCases, AtRestNothingDrifts) {
    EXPECT_EQ(run("rest", Method::kVbd).verdict, StabilityVerdict::kHolds) << run("rest").detail;
    const StabilityResult block = run("rest", Method::kXpbd);
    EXPECT_EQ(block.verdict, StabilityVerdict::kHolds) << block.detail;
    const StabilityResult pair = run("rest", Method::kXpbdPair);
    EXPECT_EQ(pair.verdict, StabilityVerdict::kHolds) << pair.detail;
}

TEST(StabilityCases, RandomPokesStayOutside) {
    const StabilityResult r = run("random pokes");
    EXPECT_EQ(r.verdict, StabilityVerdict::kHolds) << r.detail;
}

TEST(StabilityCases, AnUnknownNameIsRefused) {
    EXPECT_THROW(static_cast<void>(run("no such case")), std::invalid_argument);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
