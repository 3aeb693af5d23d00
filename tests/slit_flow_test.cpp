// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Flow through a stretch of a slit and the pressure on its walls, against closed forms and
// integrals.
#include "sim/contact/slit_flow.h"

#include <gtest/gtest.h>

#include <cmath>

namespace placode::sim {
namespace THIS_TEST {

constexpr double kPa = 588.4;

SlitStretch stretch(std::initializer_list<double> gaps_m, double depth_m = 0.8e-3) {
    SlitStretch s;
    s.length_m = 2e-3;
    s.layers = static_cast<int>(gaps_m.size()) - 1;
    size_t level = 0;
    for (const double gap : gaps_m) {
        s.gap_m[level] = gap;
        s.depth_m[level] = depth_m * static_cast<double>(level) / s.layers;
        ++level;
    }
    return s;
}

double gap_at(const SlitStretch& s, size_t segment, double share) {
    return std::lerp(s.gap_m[segment], s.gap_m[segment + 1], share);
}

TEST(SlitFlow, NarrowItIsViscousAndWideAnOrifice) {
    const double w = 2e-3, length = 0.8e-3, narrow = 1e-5, wide = 1e-3;
    const double viscous = w * narrow * narrow * narrow * kPa / (12 * kFluidPaS * length);
    EXPECT_NEAR(flow_through(stretch({narrow, narrow, narrow}), kPa).flow_m3_s / viscous, 1, 1e-3);
    const double orifice = kSlitDischarge * w * wide * std::sqrt(2 * kPa / kFluidKgM3);
    EXPECT_NEAR(flow_through(stretch({wide, wide, wide}), kPa).flow_m3_s / orifice, 1, 0.02);
}

TEST(SlitFlow, LeakGrowsWithTheCubeOfTheGap) {
    const auto at = [](double gap) {
        return flow_through(stretch({gap, gap, gap}), kPa).flow_m3_s;
    };
    EXPECT_NEAR(at(2e-6) / at(1e-6), 8, 1e-3);
}

TEST(SlitFlow, ThePressureIsSpentBetweenFloorAndSurface) {
    for (const auto& s : {stretch({3e-4, 1e-4, 6e-4}), stretch({1e-4, 3e-4, 5e-4}),
                          stretch({5e-4, 4e-4, 2e-4}), stretch({2e-4, 9e-5, 1e-4, 4e-4})}) {
        const SlitFlow flow = flow_through(s, kPa);
        const size_t segments = static_cast<size_t>(s.layers);
        size_t neck = 0;
        for (size_t k = 0; k <= segments; ++k)
            if (s.gap_m[k] < s.gap_m[neck]) neck = k;
        const double speed = flow.flow_m3_s / (kSlitDischarge * s.length_m * s.gap_m[neck]);
        const double jet_pa = 0.5 * kFluidKgM3 * speed * speed;
        // From the floor up, by small steps; what the neck takes is gone from there on.
        double pa = kPa - (neck == segments ? jet_pa : 0);
        constexpr int kSteps = 4000;
        for (size_t k = segments; k-- > 0;) {
            const double step_m = (s.depth_m[k + 1] - s.depth_m[k]) / kSteps;
            double mean = 0;
            for (int i = 0; i < kSteps; ++i) {
                const double g = gap_at(s, k, 1 - (i + 0.5) / kSteps);
                const double lost =
                    12 * kFluidPaS * flow.flow_m3_s * step_m / (s.length_m * g * g * g);
                mean += (pa - lost / 2) / kSteps;
                pa -= lost;
            }
            // The jet's share of a segment that ends in the neck is taken at that end alone, and
            // weighted as the walls are.
            const double end_share = s.gap_m[k] / (s.gap_m[k] + s.gap_m[k + 1]);
            if (neck == k) mean -= jet_pa * end_share;
            EXPECT_NEAR(flow.pressure_pa[k], mean, 1e-3 * kPa) << "segment " << k;
            if (neck == k) pa -= jet_pa;
        }
        EXPECT_NEAR(pa, 0, 1e-3 * kPa);
    }
}

TEST(SlitFlow, ShutAtAnyLevelNothingPassesAndOnlyWhatLiesBelowBearsPressure) {
    const SlitFlow shut = flow_through(stretch({2e-4, 0, 3e-4, 4e-4}), kPa);
    EXPECT_EQ(shut.flow_m3_s, 0);
    EXPECT_EQ(shut.pressure_pa[0], 0);
    EXPECT_EQ(shut.pressure_pa[1], kPa);
    EXPECT_EQ(shut.pressure_pa[2], kPa);
    const SlitFlow twice = flow_through(stretch({0, 2e-4, 0, 4e-4}), kPa);
    EXPECT_EQ(twice.pressure_pa[0], 0) << "the deepest one that is shut keeps it from the rest";
    EXPECT_EQ(twice.pressure_pa[1], 0);
    EXPECT_EQ(twice.pressure_pa[2], kPa);
    const SlitFlow corked = flow_through(stretch({1e-4, 1e-4, 0}), kPa);
    EXPECT_EQ(corked.pressure_pa[0], 0);
    EXPECT_EQ(corked.pressure_pa[1], 0);
    // The same as hardly open: the walls do not jump when it opens.
    const SlitFlow ajar = flow_through(stretch({2e-4, 1e-9, 3e-4, 4e-4}), kPa);
    for (size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(ajar.pressure_pa[k], shut.pressure_pa[k], 1e-4 * kPa);
}

TEST(SlitFlow, OddGapsAndPressuresGiveNumbers) {
    for (const double gap : {0.0, 1e-12, 1e-6, 1e-3, 1.0}) {
        for (const double pa : {-5.0, 0.0, 1e-9, 4000.0}) {
            const SlitFlow flow = flow_through(stretch({gap, 1e-4, gap}), pa);
            EXPECT_TRUE(std::isfinite(flow.flow_m3_s));
            EXPECT_GE(flow.flow_m3_s, 0);
            for (const double wall : flow.pressure_pa) {
                EXPECT_GE(wall, -1e-9 * std::abs(pa));
                EXPECT_LE(wall, std::max(0.0, pa));
            }
        }
    }
    SlitStretch none = stretch({1e-4, 1e-4});
    none.length_m = 0;
    EXPECT_EQ(flow_through(none, kPa).flow_m3_s, 0);
}

TEST(SlitFlow, MoreOpenOrUnderMorePressureItLeaksMore) {
    const double now = flow_through(stretch({2e-4, 1e-4, 3e-4}), kPa).flow_m3_s;
    for (const auto& more : {stretch({2.1e-4, 1e-4, 3e-4}), stretch({2e-4, 1.1e-4, 3e-4}),
                             stretch({2e-4, 1e-4, 3.1e-4}), stretch({2e-4, 1e-4, 3e-4}, 0.7e-3)})
        EXPECT_GT(flow_through(more, kPa).flow_m3_s, now);
    EXPECT_GT(flow_through(stretch({2e-4, 1e-4, 3e-4}), 1.1 * kPa).flow_m3_s, now);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
