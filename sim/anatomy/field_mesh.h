// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Mesh and landmarks of the operative field: the plane is triangulated, every point of it becomes a
// column of five vertices, every triangle a stack of four prisms, every prism three tets.

#include <cstdint>
#include <vector>

#include "sim/anatomy/field_shape.h"
#include "sim/anatomy/field_slit.h"
#include "sim/anatomy/planar_delaunay.h"

namespace placode::sim {

/// Vertices of one column, surface first.
inline constexpr int kColumnVertices = kFieldLayers + 1;

/// Tets of the field in RCM order, and the way back to columns.
struct FieldMesh {
    PlanarMesh plane;                  ///< One point per column (C).
    std::vector<FieldColumn> columns;  ///< (C)
    TetMesh mesh;                      ///< Renumbered.
    std::vector<int32_t> column;       ///< Column of each vertex (V).
    std::vector<int32_t> level;        ///< 0 = surface, 4 = bed (V).
    /// Of each column (C x 5); -1 in the opening of a slit.
    std::vector<std::array<int32_t, kColumnVertices>> vertices;
    std::vector<uint8_t> open;  ///< Of each triangle of the plane: 1 = it lies in a slit.
    Slit slit;
};

/// @throws MeshError when too many triangles would be needed, or a tet came out flat or inverted.
[[nodiscard]] FieldMesh build_field_mesh(const OperativeFieldSpec& spec, const FieldShape& shape);

/// A closed line of the plane laid on the meshed surface: points at equal distances in space.
struct SurfaceLine {
    std::vector<Vec3> points;            ///< In W [m].
    std::vector<ContourAnchor> anchors;  ///< One per point.
};
/// One point of the plane laid on the meshed surface.
[[nodiscard]] ContourAnchor anchor_on_surface(const FieldMesh& field, const Vec2& p);
[[nodiscard]] SurfaceLine laid_on_surface(const FieldMesh& field, const std::vector<Vec2>& line,
                                          int points);

}  // namespace placode::sim
