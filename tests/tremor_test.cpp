// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/tremor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

using placode::assessment::band_power;

namespace THIS_TEST {

std::vector<double> wave(double amplitude, double f_hz, double rate_hz, double seconds,
                         double drift_per_s = 0) {
    std::vector<double> out;
    for (int i = 0; i < static_cast<int>(seconds * rate_hz); ++i) {
        const double t = i / rate_hz;
        out.push_back(amplitude * std::sin(2 * std::numbers::pi * f_hz * t) + drift_per_s * t);
    }
    return out;
}

TEST(Tremor, ASineInTheBandHasHalfItsSquaredAmplitude) {
    // 1e-5: leakage of the Hann window outside the band (SciPy: 0.004999999619 of 0.005).
    EXPECT_NEAR(*band_power(wave(0.1, 10, 100, 10), 100), 0.005, 1e-5 * 0.005);
    EXPECT_NEAR(*band_power(wave(0.1, 10, 1000, 10), 1000), 0.005, 1e-5 * 0.005);
}

TEST(Tremor, SlowMovementAndDriftAreNotTremor) {
    EXPECT_LT(*band_power(wave(5, 1, 100, 10, 3), 100), 1e-6);
    EXPECT_NEAR(*band_power(wave(0.1, 10, 100, 10, 20), 100), 0.005, 1e-4 * 0.005);
}

TEST(Tremor, NeedsOneWholeWindow) {
    EXPECT_FALSE(band_power(wave(0.1, 10, 100, 1.9), 100));
    EXPECT_FALSE(band_power({}, 100));
}

}  // namespace THIS_TEST
