// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The colours that figures tell things apart by. palette_test simulates how people see them whose
// eyes lack a cone.

#include <QColor>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace placode::reports {

/// Of curves in one figure, ARGB; each has a sign of its own as well.
/// Source: Okabe and Ito, Color Universal Design (2008); the last one added.
inline constexpr std::array<unsigned, 8> kCurveColours{
    0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7, 0xff56b4e9, 0xffe69f00, 0xff000000, 0xff8c6d31};

/// Answer `index` of `width` on a scale: brown for the low half, teal for the high, grey for the
/// middle; towards the ends darker, so that the order shows without colour.
[[nodiscard]] inline QColor scale_colour(size_t index, size_t width) {
    const double middle = (static_cast<double>(width) - 1) / 2;
    const double away = (static_cast<double>(index) - middle) / std::max(0.5, middle);
    if (std::abs(away) < 1e-9) return {0xd9, 0xd9, 0xd4};
    const double strength = 0.35 + 0.65 * std::abs(away);
    const QColor end = away < 0 ? QColor(0x8c, 0x4a, 0x00) : QColor(0x0b, 0x6e, 0x77);
    const auto mix = [&](int channel) {
        return static_cast<int>(std::lround(255 + (channel - 255) * strength));
    };
    return {mix(end.red()), mix(end.green()), mix(end.blue())};
}

}  // namespace placode::reports
