// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far apart colours look to people who see all of them and to those whose eyes lack a cone.

#include <QColor>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace placode::test {

using Matrix = std::array<std::array<double, 3>, 3>;

struct Vision {
    const char* name;
    Matrix seen;  ///< Of linear RGB.
};
/// Machado, Oliveira, Fernandes, IEEE TVCG 15 (2009), severity 1.
inline constexpr Vision kVisions[]{{"all colours", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                                   {"no long cones",
                                    {{{0.152286, 1.052583, -0.204868},
                                      {0.114503, 0.786281, 0.099216},
                                      {-0.003882, -0.048116, 1.051998}}}},
                                   {"no middle cones",
                                    {{{0.367322, 0.860646, -0.227968},
                                      {0.280085, 0.672501, 0.047413},
                                      {-0.011820, 0.042940, 0.968881}}}},
                                   {"no short cones",
                                    {{{1.255528, -0.076749, -0.178779},
                                      {-0.078411, 0.930809, 0.147602},
                                      {0.004733, 0.691367, 0.303900}}}}};

/// Three times what is just noticed (Mahy et al. 1994: 2.3 in CIELAB).
inline constexpr double kToldApart = 6.9;

/// CIELAB (D65) of an sRGB colour as it is seen.
inline std::array<double, 3> lab(const QColor& colour, const Matrix& seen) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const auto times = [](const Matrix& m, const std::array<double, 3>& v) {
        std::array<double, 3> r{};
        for (size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
        return r;
    };
    constexpr Matrix kToXyz{{{0.4124564, 0.3575761, 0.1804375},
                             {0.2126729, 0.7151522, 0.0721750},
                             {0.0193339, 0.1191920, 0.9503041}}};
    std::array<double, 3> rgb =
        times(seen, {linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())});
    for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
    const std::array<double, 3> xyz = times(kToXyz, rgb);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f(xyz[0] / 0.95047), y = f(xyz[1]), z = f(xyz[2] / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The smallest distance of two of them.
inline double closest(const std::vector<QColor>& colours, const Matrix& seen) {
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < colours.size(); ++i)
        for (size_t j = i + 1; j < colours.size(); ++j) {
            const auto a = lab(colours[i], seen), b = lab(colours[j], seen);
            least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
        }
    return least;
}

}  // namespace placode::test
