// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::sim {

/// Smallest box around points; empty (min() above max()) without any.
[[nodiscard]] inline Eigen::AlignedBox3d bounds_of(const std::vector<Vec3>& points) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) box.extend(p);
    return box;
}

}  // namespace placode::sim
