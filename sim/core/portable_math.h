// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sines, logarithms and the like from sums, products, quotients and roots alone, which IEEE 754
// rounds the same way everywhere. The C library's have another last bit in another version and on
// another processor, and a recording must replay with the same bits on both: a frame calls none of
// them (tests/architecture_test.cpp). Errors are bounds that tests/portable_math_test.cpp holds
// against the library's.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace placode::sim {

namespace portable {

/// ln 2 = kLn2High + kLn2Low; the first has 20 zeros at its end, so that its product with an
/// exponent is exact. Likewise pi / 2.
inline constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;
inline constexpr double kLog2E = 0x1.71547652b82fep+0;
inline constexpr double kHalfPiHigh = 0x1.921fb544p+0, kHalfPiLow = 0x1.0b4611a626331p-34;
inline constexpr double kPi = 0x1.921fb54442d18p+1;

/// Sum of c_k x^k: even and odd powers side by side, because each is a chain.
template <size_t N>
[[nodiscard]] inline double polynomial(const std::array<double, N>& c, double x) noexcept {
    const double x2 = x * x;
    double even = 0, odd = 0;
    for (size_t k = N; k-- > 0;) {
        double& sum = k % 2 == 0 ? even : odd;
        sum = c[k] + x2 * sum;
    }
    return even + x * odd;
}

/// 1 / k! for k = first, first + step, ..., with changing signs where `sign` is -1.
template <size_t N>
[[nodiscard]] constexpr std::array<double, N> taylor(int first, int step, int sign) noexcept {
    std::array<double, N> c{};
    double factorial = 1;
    int k = 1;
    for (size_t i = 0; i < N; ++i) {
        for (; k <= first + static_cast<int>(i) * step; ++k) factorial *= k;
        c[i] = (sign < 0 && i % 2 == 1 ? -1 : 1) / factorial;
    }
    return c;
}

}  // namespace portable

/// e^x. Relative error below 3e-16; beyond 700 to either side that of 700 itself, so that neither 0
/// nor infinity comes out. NaN gives NaN.
[[nodiscard]] inline double exp_portable(double x) noexcept {
    using namespace portable;
    if (std::isnan(x)) return x;
    x = x < -700 ? -700 : x > 700 ? 700 : x;
    const double whole = std::floor(x * kLog2E + 0.5);
    const double y = (x - whole * kLn2High) - whole * kLn2Low;
    // 1 / 2! to 1 / 13!: the first term left out is below 1e-17.
    constexpr std::array<double, 12> kTerms = taylor<12>(2, 1, 1);
    const auto exponent = static_cast<uint64_t>(static_cast<int64_t>(whole) + 1023);
    return (1 + (y + y * y * polynomial(kTerms, y))) * std::bit_cast<double>(exponent << 52);
}

/// Natural logarithm. Relative error below 3e-16. @pre x is normal, positive and finite.
[[nodiscard]] inline double log_portable(double x) noexcept {
    using namespace portable;
    // x = 2^exponent (1 + f), f from 1 / sqrt(2) - 1 to sqrt(2) - 1.
    const auto bits = std::bit_cast<uint64_t>(x);
    int64_t exponent = static_cast<int64_t>(bits >> 52) - 1023;
    double f = std::bit_cast<double>((bits & 0xfffffffffffffULL) | (1023ULL << 52)) - 1;
    if (f > 0x1.a827999fcef32p-2) {
        f = (f - 1) / 2;
        ++exponent;
    }
    // ln((1 + s) / (1 - s)) = 2 s + s r; f itself is exact, and what is taken off it is small.
    const double s = f / (2 + f), s2 = s * s;
    constexpr std::array<double, 10> kTerms{2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                            2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
    const double r = s2 * polynomial(kTerms, s2);
    const auto e = static_cast<double>(exponent);
    return e * kLn2High + (f - (s * (f - r) - e * kLn2Low));
}

/// Logarithm to base 2. Relative error below 5e-16. @pre as log_portable().
[[nodiscard]] inline double log2_portable(double x) noexcept {
    return log_portable(x) * portable::kLog2E;
}

/// base^exponent. Relative error below 5e-16 (1 + |exponent ln(base)|). @pre base as for
/// log_portable()
[[nodiscard]] inline double pow_portable(double base, double exponent) noexcept {
    return exp_portable(exponent * log_portable(base));
}

struct SineAndCosine {
    double sine = 0, cosine = 1;
};

/// Of an angle [rad]. Absolute errors below 3e-16, of the sine of |angle| < pi / 4 relative ones.
/// @pre |angle| < 1e5
[[nodiscard]] inline SineAndCosine sin_cos_portable(double angle) noexcept {
    using namespace portable;
    const double quarters = std::floor(angle * (2 / kPi) + 0.5);
    const double y = (angle - quarters * kHalfPiHigh) - quarters * kHalfPiLow, y2 = y * y;
    // To y^17 and y^18, |y| <= pi / 4: the first terms left out are below 1e-18.
    constexpr std::array<double, 8> kSine = taylor<8>(3, 2, -1);
    constexpr std::array<double, 9> kCosine = taylor<9>(2, 2, -1);
    const double sine = y - y * y2 * polynomial(kSine, y2);
    const double cosine = 1 - y2 * polynomial(kCosine, y2);
    switch (static_cast<int64_t>(quarters) & 3) {
        case 0:
            return {sine, cosine};
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        default:
            return {-cosine, sine};
    }
}

/// Relative error below 1e-15 where |angle| < 1.5. @pre as sin_cos_portable().
[[nodiscard]] inline double tan_portable(double angle) noexcept {
    const SineAndCosine of = sin_cos_portable(angle);
    return of.sine / of.cosine;
}

/// Angle of (x, y) in [-pi, pi] [rad], with the signs and zeros of std::atan2. Relative error below
/// 5e-16. @pre both are finite, and |x| + |y| too.
[[nodiscard]] inline double atan2_portable(double y, double x) noexcept {
    using namespace portable;
    // atan t = t - t^3 p(t^2) up to tan(pi / 8): Chebyshev's points, below 1e-17 off.
    constexpr std::array<double, 11> kTerms{
        0.3333333333333333,  -0.1999999999999552,   0.14285714284666542,  -0.11111111015256361,
        0.09090904578123901, -0.07692183190826087,  0.06664511447381939,  -0.05858148912802137,
        0.05085449737939879, -0.039231658295576184, 0.019176887119048774,
    };
    constexpr double kEighth = 0.41421356237309503;  // tan(pi / 8)
    const double across = std::abs(y), along = std::abs(x);
    const bool steep = across > along;
    const double small = steep ? along : across, big = steep ? across : along;
    // tan(a - pi / 4) = (tan a - 1) / (tan a + 1)
    const bool turned = small > kEighth * big;
    const double over = turned ? small - big : small, under = turned ? small + big : big;
    const double t = under > 0 ? over / under : under, t2 = t * t;
    double angle = t - t * t2 * polynomial(kTerms, t2);
    if (turned) angle += kPi / 4;
    if (steep) angle = kPi / 2 - angle;
    if (std::signbit(x)) angle = kPi - angle;
    return std::copysign(angle, y);
}

}  // namespace placode::sim
