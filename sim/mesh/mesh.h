// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tetrahedral meshes at rest: storage, checks, quality, renumbering.

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/core/geometry.h"
#include "sim/core/tissue.h"

namespace placode::sim {

/// A mesh that cannot be used. The message names element, value and allowed range.
class MeshError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// Vertices and positively oriented tetrahedra at rest.
struct TetMesh {
    std::vector<Vec3> rest;                    ///< Rest positions (V x 3) [m].
    std::vector<std::array<int32_t, 4>> tets;  ///< Vertex indices (T x 4), positive volume.
    std::vector<Tissue> tissue;                ///< Label of each tet (T).
};

/// Signed volume [m^3] of tet `t` at rest.
[[nodiscard]] double rest_volume(const TetMesh& mesh, int t);

/// Quality 6 sqrt(2) V / l_rms^3, 1 for the regular tet, 0 when flat.
[[nodiscard]] double tet_quality(const TetMesh& mesh, int t);

/// Throws MeshError for indices out of range, non-finite vertices, inverted or degenerate tets
/// (volume below 1e-9 of the cube of the mean edge, so that the unit system does not matter),
/// duplicates and vertices that no tet uses.
/// @param elsewhere vertices that something else uses (V), which then needs no tet at all; or
/// empty.
void check_mesh(const TetMesh& mesh, const std::vector<uint8_t>& elsewhere = {});

/// Box of Kuhn tets, one corner at the origin: cells (nx, ny, nz), six tets each.
[[nodiscard]] TetMesh box_mesh(const Vec3& size_m, const std::array<int, 3>& cells,
                               Tissue tissue = Tissue::kSubcutis);

/// Reverse Cuthill-McKee order of the vertices: `order[new] = old` (V).
[[nodiscard]] std::vector<int32_t> rcm_order(const TetMesh& mesh);

/// The mesh with vertices renumbered by `order` and tets sorted by their smallest vertex.
[[nodiscard]] TetMesh renumbered(const TetMesh& mesh, const std::vector<int32_t>& order);

}  // namespace placode::sim
