// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The strip of one vertex in double precision: what is touched, sewn or held is solved vertex by
// vertex, some hundred times a frame, and nine tenths of that is this walk. Internal to the solver.

#include <array>

#include "sim/solver/kernel_layout.h"

namespace placode::sim {

/// Gradient [N] and Hessian [N/m] of a vertex, the latter by rows of four, whose fourth number is
/// not looked at.
struct alignas(32) StripSums {
    std::array<double, 4> gradient{};
    std::array<double, 12> hessian{};
};

/// Adds what the tets of a vertex's strip ask for: -force, and its exact derivative. The same bits
/// with every instruction set, for nothing is fused.
/// @pre strips are packed.
void walk_strip(const KernelLayout& packed, const SoftBodyState& state, int vertex,
                StripSums& sums) noexcept;

/// The same in plain numbers: so go processors without AVX2.
void walk_strip_plainly(const KernelLayout& packed, const SoftBodyState& state, int vertex,
                        StripSums& sums) noexcept;

}  // namespace placode::sim
