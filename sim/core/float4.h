// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A vertex as the kernels keep it.

#include "sim/core/geometry.h"

namespace placode::sim {

/// Position and inverse mass, or velocity and padding, in one 16-byte slot.
struct alignas(16) Float4 {
    float x = 0, y = 0, z = 0, w = 0;
};
[[nodiscard]] inline Vec3 to_vec(const Float4& p) noexcept { return {p.x, p.y, p.z}; }

}  // namespace placode::sim
