// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sheets: triangles with a thickness, for tissue that is thin and free on both sides. They hang on
// vertices of the mesh and may have vertices of their own, beyond the tetrahedra they are welded
// to. What a tetrahedron of that thickness would do at a thousand times the Courant number, they
// do with two terms:
//
// In the plane, the tissue's own energy with the thickness free (plane stress). A sheet stretched
// to the area ratio A has J = c A with the stretch c along its normal; dPsi/dc = 0 gives
// c = (lambda + mu) A / (mu + lambda A^2), and with it, q = A^2 = det C, C = F^T F (F is 3 x 2):
//   Psi = mu/2 (tr C - 2) + W(q) - W(1),  W(q) = mu (lambda + mu)^2 / (2 lambda (mu + lambda q)),
// so that E and nu mean what they mean in the tetrahedra, at any strain, and the rest shape is free
// of stress: W'(1) = -mu/2.
//
// Out of the plane, the bending energy of a plate, D/2 ((tr K)^2 - 2 (1 - nu) det K) with
// D = E t^3 / (12 (1 - nu^2)), K the curvature of a triangle from the angles to its neighbours,
// K = sum 2 / (h + h') (theta - theta_rest) n n^T over its edges (h, h' heights of the two
// triangles over the edge, n its normal in the plane). On a regular mesh that is exact for every
// quadratic surface, in every direction; where diagonals alternate, twisting is up to 2.9 times too
// stiff and a supported plate sags 0.65 of what it should. At a free edge K may take what costs
// least (no moment). A quadratic through six points instead (Flores & Onate 2005) was tried: 1.4
// to 1.75 times too soft where diagonals alternate. Source: Grinspun et al. 2006 "Computing
// discrete shape operators on general meshes" (without its extra unknowns); Tamstorf & Grinspun
// 2013 for the derivative of the angle.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/mesh/mesh.h"

namespace placode::sim {

struct SoftBodySpec;
struct Float4;

/// One triangle of a sheet.
struct SheetTriangle {
    std::array<int32_t, 3> vertex{};  ///< Of the body's mesh; welded by being the same.
    Tissue tissue = Tissue::kSkin;    ///< Its material: Young's modulus, Poisson's ratio, ...
    double thickness_m = 1e-4;        ///< [m]
};

/// Throws MeshError, by number of the triangle, for vertices that do not exist or are there twice,
/// degenerate triangles (area below 1e-6 of the squared longest edge), duplicates, edges with more
/// than two triangles and thicknesses that are not above 0.
void check_sheet(const std::vector<Vec3>& rest, std::span<const SheetTriangle> sheet);

/// Plane-stress energy density as a function of q, up to a constant.
struct SheetMaterial {
    double mu_pa = 0, lambda_pa = 0;
    /// W' and W'' [Pa].
    [[nodiscard]] double slope(double q) const noexcept {
        const double s = mu_pa + lambda_pa;
        return -mu_pa * s * s / (2 * (mu_pa + lambda_pa * q) * (mu_pa + lambda_pa * q));
    }
    [[nodiscard]] double curvature(double q) const noexcept {
        return -2 * lambda_pa * slope(q) / (mu_pa + lambda_pa * q);
    }
};

/// A triangle with its constants at rest. Edge k runs from corner k to corner k + 1.
struct SheetElement {
    std::array<int32_t, 3> v{};
    std::array<int32_t, 3> flap{-1, -1, -1};  ///< Vertex beyond each edge, -1 = free edge.
    std::array<double, 3> edge_n_m{};         ///< mu V a of each edge, a = -b_i . b_j [N/m]
    std::array<double, 3> rest_angle{};       ///< [rad]
    double r2 = 0;                            ///< q = r2 |e x d|^2 [1/m^4]
    double volume_m3 = 0;
    SheetMaterial material;
    Mat3 bending = Mat3::Zero();  ///< Energy 1/2 s^T B s, s angles from rest [N m]; or zero.
};

/// All triangles of a body, and which of them a vertex takes part in.
struct SheetElements {
    std::vector<SheetElement> triangles;
    std::vector<int32_t> start, of;  ///< Of vertex v: of[start[v] .. start[v + 1]); empty = none.

    /// Triangles that vertex v is a corner of, or across an edge of.
    [[nodiscard]] std::span<const int32_t> around(int32_t v) const noexcept {
        if (triangles.empty() || v + 1 >= static_cast<int32_t>(start.size())) return {};
        const auto i = static_cast<size_t>(v);
        return {of.data() + start[i], static_cast<size_t>(start[i + 1] - start[i])};
    }
};
[[nodiscard]] SheetElements sheet_elements(const SoftBodySpec& spec);

/// Adds dE/dx of one vertex [N] and a positive semidefinite approximation of its Hessian [N/m]:
/// exact in the plane where the sheet is in tension, with the negative eigenvalues of compression
/// left out, and without the second derivative of the angles.
void add_sheet(const SheetElements& sheet, const Float4* x, int32_t vertex, Vec3& gradient,
               Mat3& hessian) noexcept;

/// 1 for the vertices of the sheet (V); empty without one.
[[nodiscard]] std::vector<uint8_t> sheet_vertices(const SoftBodySpec& spec);

/// Area of a triangle [m^2].
[[nodiscard]] double area_of(const std::vector<Vec3>& rest, const SheetTriangle& t) noexcept;

}  // namespace placode::sim
