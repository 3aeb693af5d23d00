// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/timing.h"

#include <gtest/gtest.h>

namespace placode::bench {
namespace THIS_TEST {

TEST(Timing, RatesCountEveryRunButTheFirst) {
    int runs = 0, substeps = 0;
    const Rates rates = measure_rates({3, 40}, [&](int n) {
        ++runs;
        substeps += n;
    });
    EXPECT_EQ(runs, 4);
    EXPECT_EQ(substeps, 10 + 3 * 40);
    EXPECT_GT(rates.slowest, 0);
    EXPECT_LE(rates.slowest, rates.median);
    EXPECT_LE(rates.median, rates.fastest);
}

TEST(Timing, TheSlopeIsTheExponentOfAPower) {
    EXPECT_NEAR(log_slope({1, 10, 100}, {3, 3 * std::pow(10, 1.5), 3000}), 1.5, 1e-12);
    EXPECT_EQ(log_slope({2, 2}, {1, 5}), 0);
}

TEST(Timing, TheSlabIsHeldAtBothEnds) {
    const sim::SoftBody body = slab(sim::Method::kVbd, {4, 2, 2});
    EXPECT_EQ(body.tet_count(), 6 * 4 * 2 * 2);
    EXPECT_EQ(body.spec().fixed.size(), 2u * 3 * 3);
}

}  // namespace THIS_TEST
}  // namespace placode::bench
