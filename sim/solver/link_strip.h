// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tets around a vertex as a strip over its link (the triangles opposite to the vertex).
// A kernel that walks the strip keeps the last two positions and loads one new position per
// triangle; a plain loop over the tets loads three.

#include <array>
#include <cstdint>
#include <vector>

namespace placode::sim {

/// Triangle opposite to the vertex in one of its tets, positively oriented seen from it.
struct LinkTriangle {
    std::array<int32_t, 3> vertex{};
    int32_t tet = -1;
};

/// One step: loads `vertex` as P. With the pair (A, B) before it this is the triangle of `tet`,
/// det(A, B, P) times `sign` positive at rest; tet -1 = no triangle. Then the pair becomes
/// (keep ? A : B, P).
struct StripStep {
    int32_t vertex = -1;
    int32_t tet = -1;
    int8_t sign = 1;
    bool keep = false;
};

/// A short strip that meets every triangle once. Greedy from every start; shortest wins, first on
/// a tie. At best triangles + 2 steps.
[[nodiscard]] std::vector<StripStep> link_strip(const std::vector<LinkTriangle>& triangles);

}  // namespace placode::sim
