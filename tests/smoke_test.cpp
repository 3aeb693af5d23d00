// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/smoke.h"

#include <gtest/gtest.h>

#include "picture_fixture.h"

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

TEST(Smoke, GathersWithTheVaporisedVolumeAndClears) {
    Smoke smoke;
    Snapshot snapshot = small_field().snapshot;
    snapshot.tools[0].energised = 1;
    snapshot.vapour_rate_m3_s = 2e-9F;
    for (int i = 0; i < 300; ++i) {
        snapshot.time_s += 0.033;
        smoke.update(snapshot);
    }
    // 10 s at 12 W or so: some tens of puffs, a haze that is seen but does not blind.
    EXPECT_GT(smoke.puffs().size(), 30U);
    EXPECT_LT(smoke.puffs().size(), 161U);
    EXPECT_GT(smoke.haze(), 0.10);
    EXPECT_LT(smoke.haze(), 0.40);
    snapshot.vapour_rate_m3_s = 0;
    for (int i = 0; i < 600; ++i) {
        snapshot.time_s += 0.2;
        smoke.update(snapshot);
    }
    EXPECT_TRUE(smoke.puffs().empty());
    EXPECT_LT(smoke.haze(), 0.01);
}

}  // namespace THIS_TEST
