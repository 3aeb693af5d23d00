// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/lens.h"

#include <gtest/gtest.h>

namespace placode::view {

using namespace sim;

namespace THIS_TEST {

const Vec3 kScope(0, 0, 0.025);

/// Cuts for `seconds` with the tip this far from the lens.
void cut(Lens& lens, Snapshot& s, double seconds, double distance_m) {
    s.tool_count = 1;
    s.tools[0].energised = 1;
    s.tools[0].pose.p = kScope - Vec3(0, 0, distance_m);
    s.vapour_rate_m3_s = 0.55e-9F;  // measured: a 12 W ring
    for (double t = 0; t < seconds; t += 0.05) {
        s.time_s += 0.05;
        lens.update(s, kScope, false);
    }
    s.tools[0].energised = 0;
    s.vapour_rate_m3_s = 0;
}

void wait(Lens& lens, Snapshot& s, double seconds) {
    for (double t = 0; t < seconds; t += 0.05) {
        s.time_s += 0.05;
        lens.update(s, kScope, false);
    }
}

TEST(Lens, StaysCleanWhileNothingBoils) {
    Lens lens;
    Snapshot s;
    wait(lens, s, 60);
    EXPECT_EQ(lens.fog(), 0);
    EXPECT_TRUE(lens.drops().empty());
    EXPECT_EQ(lens.cloth(), 2);
}

TEST(Lens, FogsAndCollectsDropletsSoonerWhenNear) {
    Lens near, far;
    Snapshot a, b;
    cut(near, a, 10, 0.012);
    cut(far, b, 10, 0.025);
    EXPECT_GT(near.fog(), 2 * far.fog());
    EXPECT_GT(far.fog(), 0.05);
    EXPECT_GT(near.drops().size(), far.drops().size());
    for (const LensDrop& drop : near.drops()) EXPECT_LE(drop.at.norm(), 1);
}

TEST(Lens, FogDriesByItself) {
    Lens lens;
    Snapshot s;
    cut(lens, s, 20, 0.02);
    const double before = lens.fog();
    wait(lens, s, 35);
    EXPECT_NEAR(lens.fog() / before, 0.37, 0.02);  // one time constant
}

TEST(Lens, WipingClearsEverythingWithinASecond) {
    Lens lens;
    Snapshot s;
    cut(lens, s, 30, 0.010);
    ASSERT_FALSE(lens.drops().empty());
    lens.wipe();
    wait(lens, s, 0.4);
    EXPECT_LT(lens.cloth(), 1.5);  // the cloth is in the picture
    wait(lens, s, 0.7);
    EXPECT_EQ(lens.fog(), 0);
    EXPECT_TRUE(lens.drops().empty());
    EXPECT_EQ(lens.cloth(), 2);
}

TEST(Lens, TouchingTissueSmearsItOnce) {
    Lens lens;
    Snapshot s;
    for (int i = 0; i < 20; ++i) {
        s.time_s += 0.05;
        lens.update(s, kScope, i >= 5);
    }
    EXPECT_GT(lens.fog(), 0.3);
    EXPECT_LT(lens.fog(), 0.4);
}

/// Holds a jet of `length_m` down at `from` for `seconds`.
void irrigate(Lens& lens, Snapshot& s, double seconds, const Vec3& from, double length_m) {
    s.tool_count = 1;
    s.tools[0].pose.p = from;
    s.tools[0].pose.q = Quat(0, 1, 0, 0);  // looks down
    s.fluid.jet_m[0] = static_cast<float>(length_m);
    s.fluid.jet_radius_m[0] = s.fluid.jet_end_radius_m[0] = 5e-4F;
    wait(lens, s, seconds);
    s.fluid.jet_m[0] = 0;
}

TEST(Lens, IsSplashedByAJetThatLandsNearAndNotByAFarOne) {
    Lens near, far;
    Snapshot a, b;
    irrigate(near, a, 5, Vec3(0.008, 0, 0.035), 0.016);  // lands 10 mm away
    irrigate(far, b, 5, Vec3(0.030, 0, 0.035), 0.016);
    EXPECT_GE(near.drops().size(), 4u);
    EXPECT_TRUE(near.dirty());
    EXPECT_TRUE(far.drops().empty());
    EXPECT_EQ(near.fog(), 0);  // water, not steam
}

TEST(Lens, IsRinsedByAJetThatMeetsIt) {
    Lens lens;
    Snapshot s;
    cut(lens, s, 30, 0.010);
    ASSERT_TRUE(lens.dirty());
    s.tools[0].energised = 0;
    irrigate(lens, s, 1, kScope + Vec3(0.001, 0, 0.010), 0.040);
    EXPECT_LT(lens.fog(), 0.02);
    EXPECT_TRUE(lens.drops().empty());
}

}  // namespace THIS_TEST
}  // namespace placode::view
