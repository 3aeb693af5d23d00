// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The arc tangent from sums and roots: the last bit of the library's depends on the processor.

#include <cmath>

namespace placode::sim {

/// Three times the half of the angle, then the series, whose first left-out term is below 1e-16
/// for every w. @pre |w| < 1e150
[[nodiscard]] inline double arc_tangent(double w) noexcept {
    double t = w;
    for (int i = 0; i < 3; ++i) t = t / (1 + std::sqrt(1 + t * t));
    const double t2 = t * t;
    double sum = 0;
    for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k - t2 * sum;
    return 8 * t * sum;
}

}  // namespace placode::sim
