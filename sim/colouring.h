// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which vertices can be solved at the same time. Greedy in index order, deterministic.
// Splitting a vertex or switching a tet off only removes conflicts: cutting needs no recolouring.

#include <cstdint>
#include <vector>

#include "sim/mesh.h"

namespace placode::sim {

/// Colour of each vertex (V): no two vertices of a tet share one. Vertices with skip[v] != 0 get
/// -1. `skip` is empty or (V).
[[nodiscard]] std::vector<int32_t> colour_vertices(const TetMesh& mesh,
                                                   const std::vector<uint8_t>& skip = {});

}  // namespace placode::sim
