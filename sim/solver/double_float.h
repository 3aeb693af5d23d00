// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a float has no room for: with low parts positions have 48 bits instead of 24, so that a
// place far from the origin does not hide what a vertex does in one short substep. For
// verification; the simulator rounds, its steps are long enough.

#include "sim/solver/soft_body.h"

namespace placode::sim {

/// From now on the sweeps of tets and vertices, and the begin and end of a substep, carry low
/// parts (`SoftBodyState::x_low`). Anchor springs and tethers read the rounded position, and so do
/// sheets in vertices that are solved one by one.
void use_double_float(SoftBodyState& state);

/// Where a vertex is now [m], with its low part if there is one.
[[nodiscard]] inline Vec3 exact_position(const SoftBodyState& state, int vertex) noexcept {
    const auto i = static_cast<size_t>(vertex);
    const Vec3 high = to_vec(state.x[i]);
    return state.x_low.empty() ? high : high + to_vec(state.x_low[i]);
}

/// How far a vertex has come in this substep [m], likewise.
[[nodiscard]] Vec3 moved_in_substep(const SoftBodyState& state, int vertex) noexcept;

/// Moves a vertex by `step` [m], rounded to a float itself, likewise.
void move_vertex(SoftBodyState& state, int vertex, const Vec3& step) noexcept;

/// Puts a vertex at `place` [m], likewise.
void put_vertex(SoftBodyState& state, int vertex, const Vec3& place) noexcept;

/// x + low += step without loss (Knuth's two-sum): x takes what a float has room for.
inline void carry(float& x, float& low, float step) noexcept {
    const float add = low + step, sum = x + add, added = sum - x;
    low = (x - (sum - added)) + (add - added);
    x = sum;
}

}  // namespace placode::sim
