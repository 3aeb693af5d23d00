// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Four floats at once, for the small loops of the frame outside of the kernels: a point with its
// fourth number, or four elements side by side. Every instruction set has them, and no operation is
// fused, so that the bits are the same everywhere.

#include <array>
#include <cstdint>

#include "sim/core/float4.h"

namespace placode::sim {

using FloatLanes = float __attribute__((vector_size(16)));

[[nodiscard]] inline FloatLanes lanes_of(const Float4& p) noexcept {
    return FloatLanes{p.x, p.y, p.z, p.w};
}
[[nodiscard]] inline FloatLanes lanes_of(const std::array<float, 4>& p) noexcept {
    return FloatLanes{p[0], p[1], p[2], p[3]};
}
[[nodiscard]] inline FloatLanes every_lane(float a) noexcept { return FloatLanes{a, a, a, a}; }
/// Sum of the first three, of products.
[[nodiscard]] inline float dot3(FloatLanes a, FloatLanes b) noexcept {
    const FloatLanes c = a * b;
    return c[0] + c[1] + c[2];
}
// The second one where the first is not a number.
[[nodiscard]] inline FloatLanes least(FloatLanes a, FloatLanes b) noexcept { return a < b ? a : b; }
[[nodiscard]] inline FloatLanes most(FloatLanes a, FloatLanes b) noexcept { return a > b ? a : b; }

}  // namespace placode::sim
