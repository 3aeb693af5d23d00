// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which thread solves which vertices, and which of them at the same time.
//
// The vertices (in RCM order) are cut into a few ranges of equal work, the domains. What has no
// neighbour in a later domain is a job of phase 0; no two of these jobs meet. The thin separators
// between the domains are the jobs of phase 1, whatever separators meet each other one job of
// phase 2. A sweep costs two or three barriers instead of one for every colour, and a job stays in
// the cache of its thread. Inside a job the vertices are coloured: those of one colour are
// independent and can share a SIMD batch.
//
// The plan depends on the mesh alone, so the results do not depend on the number of threads.
// Splitting a vertex or switching a tet off only removes conflicts: cutting needs no new plan.

#include <cstdint>
#include <span>
#include <vector>

#include "sim/mesh/mesh.h"

namespace placode::sim {

struct VertexPlan {
    std::vector<int32_t> job;          ///< (V) -1 = left out
    std::vector<int32_t> colour;       ///< (V) within its job, -1 = left out
    std::vector<int32_t> phase_start;  ///< Phase p owns jobs [phase_start[p], phase_start[p + 1]).
};

/// `skip` (V): 1 = left out of the sweep. `work` (V): cost of a vertex, to balance the domains.
[[nodiscard]] VertexPlan plan_vertices(const TetMesh& mesh, std::span<const uint8_t> skip,
                                       std::span<const int32_t> work, int domains);

}  // namespace placode::sim
