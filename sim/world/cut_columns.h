// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The planned incision as columns of tets from the surface to the target depth: what has to go so
// that a point of the contour counts as cut (see CutProgress).

#include "sim/world/cut_state.h"

namespace placode::sim {

struct Scene;

inline constexpr int kColumnsPerPoint = 11;
inline constexpr double kColumnSpacing = 0.0002;  ///< Between columns, across the contour [m].

/// Finds the tets of every column and fills `progress` for the untouched body.
[[nodiscard]] CutTables make_cut_tables(const Scene& scene, CutProgress& progress);

}  // namespace placode::sim
