// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far the planned incision has come, and the constant tables that it is counted with.
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"

namespace placode::sim {

/// How far the incision has come. A contour point counts as cut when one of its eleven columns is
/// gone: straight lines along the surface normal at rest, at 0, +-0.2 .. +-1.0 mm across the
/// contour, from the surface to the target depth. A column is gone when every tet that it crosses
/// in that range of depths has left the body. What was cut stays cut.
struct CutProgress {
    std::vector<uint8_t> cut;  ///< One per contour point: 1 = cut through to target depth there.
    int cut_count = 0;
    std::vector<uint8_t> column_left;  ///< Tets that a column still holds (11 per contour point).
};
template <class Visit>
void fields(Of<CutProgress> auto& s, Visit&& visit) {
    auto& [cut, cut_count, column_left] = s;
    visit.state(cut, cut_count, column_left);
}

/// Constant: which columns of the planned contour a tet belongs to (compressed rows).
struct CutTables {
    std::vector<int32_t> start;   // (T + 1)
    std::vector<int32_t> column;  // contour point * kColumnsPerPoint + column
};

}  // namespace placode::sim
