// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Delaunay triangulation of points in a rectangle, with exact predicates, and the placing of points
// by a size field. Incremental insertion (Bowyer 1981, Watson 1981): points are rounded to a grid
// of 1 nm, so that orientation fits 64-bit and the in-circle determinant 128-bit integers, and no
// tolerance is needed anywhere.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/core/geometry.h"

namespace placode::sim {

/// Wanted edge length [m] at a point of the plane.
using SizeField = std::function<double(const Vec2&)>;

/// Triangles of the plane, counter-clockwise.
struct PlanarMesh {
    std::vector<Vec2> points;                       ///< [m], multiples of 1 nm.
    std::vector<std::array<int32_t, 3>> triangles;  ///< (N x 3)
};

/// Delaunay triangulation. The first four points are the corners of an axis-parallel rectangle,
/// counter-clockwise from the lower left; the others lie inside or on its sides.
/// @pre all points are less than 0.5 m from the origin.
/// @throws MeshError for a point outside of the rectangle or two points within the same 1 nm.
[[nodiscard]] std::vector<std::array<int32_t, 3>> delaunay(std::span<const Vec2> points);

/// Rounds to the 1 nm grid on which `delaunay` works.
[[nodiscard]] Vec2 on_grid(const Vec2& p);

/// Points along a polyline at about the wanted distance, equal in units of the size field. A closed
/// polyline gives at least 12 points; an open one has both ends among them.
[[nodiscard]] std::vector<Vec2> divided(std::span<const Vec2> polyline, bool closed,
                                        const SizeField& size);

/// Triangulates the rectangle [-half, half]: `curves` (closed) keep points along them, the rest
/// is filled by the size field and smoothed. Points of `kept` are points of the mesh, on its 1 nm
/// grid. Deterministic in `seed`.
/// @throws MeshError when more than `most_triangles` would be needed.
[[nodiscard]] PlanarMesh graded_mesh(const Vec2& half, std::span<const std::vector<Vec2>> curves,
                                     const SizeField& size, uint64_t seed, int most_triangles,
                                     std::span<const Vec2> kept = {});

}  // namespace placode::sim
