// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a box of the surface's tree is from a point.

#include <algorithm>

#include "sim/mesh/surface_tree.h"

namespace placode::sim {

/// Square of the distance to a box grown by `stale_m` on every side, 0 inside [m^2]: boxes may be
/// those of the frame before (collect_candidates).
[[nodiscard]] inline double squared_distance(const SurfaceTree::Box& box, const Vec3& p,
                                             double stale_m) noexcept {
    double d2 = 0;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<size_t>(k);
        const double low = static_cast<double>(box.low[i]) - stale_m,
                     high = static_cast<double>(box.high[i]) + stale_m;
        const double d = std::max({low - p[k], p[k] - high, 0.0});
        d2 += d * d;
    }
    return d2;
}

}  // namespace placode::sim
