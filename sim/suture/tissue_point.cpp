// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/tissue_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/tool_shape.h"
#include "sim/mesh/box_distance.h"
#include "sim/solver/vertex_stiffness.h"
#include "sim/suture/rest_walk.h"

namespace placode::sim {
namespace {

// Share of its volume at rest below which a tetrahedron does not say any more where a point is.
constexpr double kFlat = 0.02;
// Boxes of the tree are those of the frame's start: tissue and tip have moved by less since [m].
constexpr double kStaleM = 1e-3;

std::array<Vec3, 4> corner_places(const SuturedTissue& tissue, int32_t tet) noexcept {
    std::array<Vec3, 4> x;
    const auto& c = corners(tissue.body, tissue.state, tet);
    for (size_t k = 0; k < 4; ++k) x[k] = position(tissue.state, c[k]);
    return x;
}

/// How the weights change along `way`: its products with the gradients of the weights. False where
/// the tet is flat or inside out.
bool weights_along(const std::array<Vec3, 4>& x, const Vec3& offset, double rest_volume_m3,
                   std::array<double, 4>& change) noexcept {
    const double six = (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]);
    if (!(six > 6 * kFlat * rest_volume_m3)) return false;
    double sum = 0;
    for (size_t f = 1; f < 4; ++f) {
        const auto& face = kTetFaces[f];  // outward: the weight falls along its normal
        const Vec3& a = x[as_index(face[0])];
        const Vec3 normal = (x[as_index(face[1])] - a).cross(x[as_index(face[2])] - a);
        change[f] = -normal.dot(offset) / six;
        sum += change[f];
    }
    change[0] = -sum;
    return true;
}

/// As walk_to_face(), in a tet whose corners lie at `x`.
TissueWalk walk(const SuturedTissue& tissue, const TissuePoint& from, const std::array<Vec3, 4>& x,
                const Vec3& offset) noexcept {
    TissueWalk walk{from, 1, -1, WalkEnd::kArrived};
    std::array<double, 4> change{};
    const double volume = static_cast<double>(rest_volume_of(tissue.body, tissue.state, from.tet));
    if (!weights_along(x, offset, volume, change)) return {from, 0, -1, WalkEnd::kLost};
    for (size_t k = 0; k < 4; ++k) {
        if (!(change[k] < 0)) continue;
        const double share = std::max(0.0, from.b[k] / -change[k]);
        if (share < walk.share) {
            walk.share = share;
            walk.face = static_cast<int>(k);
        }
    }
    for (size_t k = 0; k < 4; ++k) walk.at.b[k] = from.b[k] + walk.share * change[k];
    if (walk.face < 0) return walk;
    walk.at.b[as_index(walk.face)] = 0;
    walk.end =
        tissue.faces.on_surface(from.tet, walk.face) ? WalkEnd::kAtSurface : WalkEnd::kAtFace;
    return walk;
}

}  // namespace

Vec3 place_of(const SuturedTissue& tissue, const TissuePoint& point) noexcept {
    const auto& c = corners(tissue.body, tissue.state, point.tet);
    Vec3 p = Vec3::Zero();
    for (size_t k = 0; k < 4; ++k) p += point.b[k] * position(tissue.state, c[k]);
    return p;
}

Vec3 rest_place_of(const SuturedTissue& tissue, const TissuePoint& point) noexcept {
    const auto& c = corners(tissue.body, tissue.state, point.tet);
    Vec3 p = Vec3::Zero();
    for (size_t k = 0; k < 4; ++k) p += point.b[k] * rest_place(tissue.body, tissue.state, c[k]);
    return p;
}

double answer_of(const SuturedTissue& tissue, const TissuePoint& point, double h_s) noexcept {
    double gives = 0;
    const auto& c = corners(tissue.body, tissue.state, point.tet);
    for (size_t k = 0; k < 4; ++k) {
        if (tissue.state.x[as_index(c[k])].w == 0 || point.b[k] == 0) continue;
        const double k_n_m = vertex_stiffness(tissue.body, tissue.state, c[k], h_s).trace() / 3;
        if (k_n_m > 0) gives += point.b[k] * point.b[k] / k_n_m;
    }
    return gives > 0 ? 1 / gives : 0;
}

TissueWalk walk_to_face(const SuturedTissue& tissue, const TissuePoint& from,
                        const Vec3& offset) noexcept {
    return walk(tissue, from, corner_places(tissue, from.tet), offset);
}

TissueWalk walk_at_rest(const SuturedTissue& tissue, const TissuePoint& from,
                        const Vec3& offset) noexcept {
    std::array<Vec3, 4> x;
    const auto& c = corners(tissue.body, tissue.state, from.tet);
    for (size_t k = 0; k < 4; ++k) x[k] = rest_place(tissue.body, tissue.state, c[k]);
    return walk(tissue, from, x, offset);
}

TissuePoint across_face(const SuturedTissue& tissue, const TissuePoint& at, int face) noexcept {
    TissuePoint out;
    out.tet = tissue.surface.neighbours()[as_index(at.tet)][as_index(face)];
    assert(out.tet >= 0 && tissue.state.tet_alive[as_index(out.tet)] != 0);
    const auto& from = corners(tissue.body, tissue.state, at.tet);
    const auto& to = corners(tissue.body, tissue.state, out.tet);
    for (size_t k = 0; k < 4; ++k) {
        const auto same = std::find(from.begin(), from.end(), to[k]);
        if (same != from.end()) out.b[k] = at.b[as_index(same - from.begin())];
    }
    return out;
}

SurfaceHit meet_surface(const SuturedTissue& tissue, const Vec3& from,
                        const Vec3& offset) noexcept {
    SurfaceHit hit;
    const Vec3 middle = from + 0.5 * offset;
    const double reach = 0.5 * offset.norm(), reach2 = reach * reach;
    tissue.faces.tree().walk(
        [&](const SurfaceTree::Box& box) noexcept {
            return squared_distance(box, middle, kStaleM) > reach2;
        },
        [&](int slot) noexcept {
            const SurfaceTriangle& tri = tissue.faces.triangles()[as_index(slot)];
            std::array<Vec3, 3> x;
            for (size_t k = 0; k < 3; ++k) x[k] = position(tissue.state, tri.vertex[k]);
            // Moeller & Trumbore 1997; outward faces that the way runs into.
            const Vec3 e1 = x[1] - x[0], e2 = x[2] - x[0], across = offset.cross(e2);
            const double det = e1.dot(across);
            if (!(det > 0)) return;
            const Vec3 from0 = from - x[0], q = from0.cross(e1);
            const double u = from0.dot(across) / det, v = offset.dot(q) / det;
            const double share = e2.dot(q) / det;
            if (u < 0 || v < 0 || u + v > 1 || share < 0 || !(share < hit.share)) return;
            hit.share = share;
            hit.tissue = tri.tissue;
            hit.at = {tri.tet, {}};
            const auto& c = corners(tissue.body, tissue.state, tri.tet);
            const std::array<double, 3> weight{1 - u - v, u, v};
            for (size_t k = 0; k < 3; ++k) {
                const auto same = std::find(c.begin(), c.end(), tri.vertex[k]);
                hit.at.b[as_index(same - c.begin())] = weight[k];
            }
        });
    return hit;
}

SurfacePlane nearest_surface(const SuturedTissue& tissue, const Vec3& p, double within_m) noexcept {
    double best = within_m * within_m;
    SurfacePlane plane;
    tissue.faces.tree().walk(
        [&](const SurfaceTree::Box& box) noexcept {
            return squared_distance(box, p, kStaleM) >= best;
        },
        [&](int slot) noexcept {
            const SurfaceTriangle& tri = tissue.faces.triangles()[as_index(slot)];
            Triangle x;
            for (size_t k = 0; k < 3; ++k) x[k] = position(tissue.state, tri.vertex[k]);
            const Vec3 w = closest_on_triangle(p, x);
            const Vec3 offset = p - w.x() * x[0] - w.y() * x[1] - w.z() * x[2];
            const double d2 = offset.squaredNorm();
            if (!(d2 < best)) return;
            const Vec3 face = (x[1] - x[0]).cross(x[2] - x[0]);
            const double size = face.norm();
            if (!(size > 0)) return;
            best = d2;
            const double distance = std::sqrt(d2);
            const bool inside = offset.dot(face) < 0;
            plane.found = true;
            plane.gap_m = inside ? -distance : distance;
            // Beside an edge the way itself is the direction; on the face it is the face's.
            plane.n = inside || !(distance > 0) ? Vec3(face / size) : Vec3(offset / distance);
        });
    return plane;
}

}  // namespace placode::sim
