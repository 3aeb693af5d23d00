// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// States that a method does not leave by itself get the rest shape back.

#include "sim/solver/soft_body.h"

namespace placode::sim {

/// Speed against its own mean below which a piece may be at rest [m/s].
inline constexpr double kRestoreSlow = 0.02;

/// Looks for tets that have shrunk to a point (every edge below 1e-3 of the rest length): there all
/// forces vanish. Every piece made of such tets gets its rest shape back, where it is (beside its
/// held vertices, if it has some) and with its mean velocity. So does a free piece that is at rest
/// in a fold: nothing moves faster than `slow_m_s`, no vertex is out of balance, and still an edge
/// is 40 % off. kRestShapeRestored is raised. Never allocates.
/// @returns the number of vertices that were placed anew.
int restore_collapsed(const SoftBody& body, SoftBodyState& state,
                      double slow_m_s = kRestoreSlow) noexcept;

}  // namespace placode::sim
