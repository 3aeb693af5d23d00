// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Functions without the C library's, held against the library's in long double. Whether the rest of
// the simulation keeps to them is for architecture_test.
#include "sim/core/portable_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "sim/core/random.h"

namespace THIS_TEST {

using namespace placode::sim;
using std::numbers::pi;

constexpr int kTries = 50'000;

double relative(double found, long double right) {
    return static_cast<double>(std::abs(found / right - 1));
}
double absolute(double found, long double right) {
    return static_cast<double>(std::abs(found - right));
}

/// The largest error at `kTries` places from `low` to `high`, and at both of them.
template <class Error>
double worst(double low, double high, const Error& error) {
    SplitMix64 random(7);
    double most = std::max(error(low), error(high));
    for (int i = 0; i < kTries; ++i) most = std::max(most, error(random.uniform(low, high)));
    return most;
}

TEST(PortableMath, PowersOfEAreRightTo3e16) {
    const auto error = [](double x) {
        return relative(exp_portable(x), std::exp(static_cast<long double>(x)));
    };
    EXPECT_LT(worst(-700, 700, error), 3e-16);
    EXPECT_LT(worst(-40, 1, error), 3e-16);  // light through blood, pressure of a jet
    EXPECT_LT(worst(-1e-3, 1e-3, error), 3e-16);
    EXPECT_EQ(exp_portable(0), 1);
    EXPECT_EQ(exp_portable(-1e9), exp_portable(-700));
    EXPECT_EQ(exp_portable(std::numeric_limits<double>::infinity()), exp_portable(700));
    EXPECT_TRUE(std::isnan(exp_portable(std::numeric_limits<double>::quiet_NaN())));
}

TEST(PortableMath, LogarithmsAreRightTo3e16) {
    const auto error = [](double x) {
        return relative(log_portable(x), std::log(static_cast<long double>(x)));
    };
    EXPECT_LT(worst(0.01, 0.999999, error), 3e-16);
    EXPECT_LT(worst(1.000001, 100, error), 3e-16);
    EXPECT_LT(worst(1e-12, 1e-5, error), 3e-16);
    EXPECT_LT(worst(1e3, 1e30, error), 3e-16);
    EXPECT_LT(worst(-300, 300, [&](double x) { return error(std::pow(10.0, x)); }), 3e-16);
    EXPECT_LT(worst(1e-30, 1e-2,
                    [](double x) {
                        return relative(log2_portable(x), std::log2(static_cast<long double>(x)));
                    }),
              5e-16);
    EXPECT_EQ(log_portable(1), 0);
    for (int n = -40; n <= 40; ++n) EXPECT_NEAR(log2_portable(std::ldexp(1.0, n)), n, 5e-16 * 40);
}

TEST(PortableMath, PowersGrowInErrorWithTheirLogarithm) {
    for (const double exponent : {0.0, 0.75, 1.0, 3.5})
        EXPECT_LT(worst(1e-6, 1,
                        [&](double base) {
                            const auto exact = static_cast<long double>(base);
                            return relative(pow_portable(base, exponent),
                                            std::pow(exact, static_cast<long double>(exponent))) /
                                   (1 + std::abs(exponent * std::log(base)));
                        }),
                  5e-16)
            << exponent;
    EXPECT_EQ(pow_portable(1, 0.75), 1);
}

TEST(PortableMath, SinesAndCosinesAreRightTo3e16) {
    const auto error = [](double angle) {
        const SineAndCosine of = sin_cos_portable(angle);
        const auto exact = static_cast<long double>(angle);
        return std::max(absolute(of.sine, std::sin(exact)), absolute(of.cosine, std::cos(exact)));
    };
    EXPECT_LT(worst(-pi, pi, error), 3e-16);
    EXPECT_LT(worst(-99, 99, error), 3e-16);
    EXPECT_LT(worst(-99'999, 99'999, error), 3e-16);
    EXPECT_LT(worst(1e-9, pi / 4,
                    [](double angle) {
                        return relative(sin_cos_portable(angle).sine,
                                        std::sin(static_cast<long double>(angle)));
                    }),
              3e-16);
    // Quarters of a turn fall into the right quarter, and the other way round all is the same.
    for (int quarter = -9; quarter <= 9; ++quarter) EXPECT_LT(error(quarter * pi / 2), 3e-16);
    for (const double angle : {0.1, 0.8, 1.6, 2.4, 3.1}) {
        EXPECT_EQ(sin_cos_portable(-angle).sine, -sin_cos_portable(angle).sine);
        EXPECT_EQ(sin_cos_portable(-angle).cosine, sin_cos_portable(angle).cosine);
    }
}

TEST(PortableMath, TangentsAreRightTo1e15) {
    EXPECT_LT(worst(-1.5, 1.5,
                    [](double angle) {
                        return angle == 0 ? 0
                                          : relative(tan_portable(angle),
                                                     std::tan(static_cast<long double>(angle)));
                    }),
              1e-15);
    EXPECT_EQ(tan_portable(0), 0);
}

TEST(PortableMath, AnglesOfPointsAreRightTo5e16) {
    for (const double size : {1e-15, 1e-6, 1.0, 1e6}) {
        // All around, and next to both axes, where hinges that are nearly flat lie.
        for (const double across : {1.0, 1e-3, 1e-9}) {
            SplitMix64 random(11);
            double most = 0;
            for (int i = 0; i < kTries; ++i) {
                const double x = size * random.uniform(-1, 1);
                const double y = size * across * random.uniform(-1, 1);
                for (const auto& [b, a] : {std::pair{x, y}, {y, x}})
                    most = std::max(most, relative(atan2_portable(a, b),
                                                   std::atan2(static_cast<long double>(a),
                                                              static_cast<long double>(b))));
            }
            EXPECT_LT(most, 5e-16) << size << ", " << across;
        }
    }
}

TEST(PortableMath, AnglesOnTheAxesAreThoseOfTheLibraryToTheSignOfZero) {
    for (const double y : {0.0, -0.0, 1.0, -1.0}) {
        for (const double x : {0.0, -0.0, 1.0, -1.0}) {
            const double found = atan2_portable(y, x), right = std::atan2(y, x);
            EXPECT_DOUBLE_EQ(found, right) << y << ", " << x;
            EXPECT_EQ(std::signbit(found), std::signbit(right)) << y << ", " << x;
        }
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(atan2_portable(nan, 1)));
    EXPECT_TRUE(std::isnan(atan2_portable(1, nan)));
}

// On this and on every other computer: a change of any of these bits changes all replays.
TEST(PortableMath, TheBitsAreThese) {
    EXPECT_EQ(exp_portable(-0.7), 0x1.fc80db9dd5542p-2);
    EXPECT_EQ(exp_portable(3.3), 0x1.b1cd5e7807b7bp+4);
    EXPECT_EQ(log_portable(0.37), -0x1.fd0ea24bf89b8p-1);
    EXPECT_EQ(log2_portable(6e-6), -0x1.158bb2ce13ebep+4);
    EXPECT_EQ(sin_cos_portable(2.2).sine, 0x1.9df33d9aad708p-1);
    EXPECT_EQ(sin_cos_portable(2.2).cosine, -0x1.2d5004b88ad7p-1);
    EXPECT_EQ(tan_portable(0.03), 0x1.ebaae1e06955ep-6);
    EXPECT_EQ(atan2_portable(-0.4, 0.9), -0x1.ac42ffa7bcbcfp-2);
    EXPECT_EQ(atan2_portable(0.4, -0.3), 0x1.1b6e192ebbe44p+1);
}

}  // namespace THIS_TEST
