// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a hand goes from one place to another. Source: Flash & Hogan 1985.

#include <algorithm>

namespace placode::haptics {

/// Share of the way, 0 to 1, after the share `x` of the time; `x` outside 0 to 1 stays at its end.
[[nodiscard]] inline double minimum_jerk(double x) noexcept {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * x * (10 + x * (-15 + 6 * x));
}

}  // namespace placode::haptics
