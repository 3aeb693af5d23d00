// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of packing: the batches of VBD and of XPBD, and what is also needed when a tet is removed.
// Internal to the solver.

#include <algorithm>
#include <array>
#include <span>

#include "sim/solver/kernel_layout.h"

namespace placode::sim {

/// Local number of vertex `v` in a tet; 4 = it is no corner of it.
[[nodiscard]] inline size_t corner_of(const std::array<int32_t, 4>& tet, int32_t v) noexcept {
    return static_cast<size_t>(std::find(tet.begin(), tet.end(), v) - tet.begin());
}

/// Throws MeshError when two vertices of one batch are too far apart for 16-bit offsets.
void check_span(int32_t first, int32_t last);

/// Writes the constants of a tet for XPBD into its lane of `tet_rows`.
void write_tet_row(const TetConstants& constants, float* row) noexcept;

/// Writes the mu weights of vertex `v` from its living tets, so that removal leaves no residue.
void set_vertex_weights(const SoftBody& body, const KernelLayout& packed,
                        std::span<const uint8_t> tet_alive, int v, float* lanes) noexcept;

/// Weights of edges and damping of vertices.
void pack_vertex_constants(const SoftBody& body, KernelLayout& packed);
/// Tethers of every vertex, and which vertices are solved alone for theirs.
void pack_tethers(const SoftBody& body, KernelLayout& packed);

/// Makes constants, links and batches of vertices for VBD.
void pack_vertices(const SoftBody& body, KernelLayout& packed);

/// Appends batches of disjoint tets for XPBD.
void pack_tets(const SoftBody& body, KernelLayout& packed);

}  // namespace placode::sim
