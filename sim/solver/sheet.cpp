// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/sheet.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/as_index.h"
#include "sim/core/number_text.h"
#include "sim/mesh/dihedral.h"
#include "sim/solver/sheet_terms.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {
namespace {

constexpr double kFlat = 1e-6;  // area over squared longest edge

[[noreturn]] void fail(size_t triangle, const std::string& text) {
    throw MeshError("sheet triangle " + std::to_string(triangle) + ": " + text);
}

/// One side of an edge: its vertices in rising order, then 3 triangle + edge.
using EdgeSide = std::array<int32_t, 3>;

std::vector<EdgeSide> sorted_edges(std::span<const SheetTriangle> sheet) {
    std::vector<EdgeSide> out;
    for (size_t t = 0; t < sheet.size(); ++t) {
        for (size_t k = 0; k < 3; ++k) {
            const int32_t a = sheet[t].vertex[k], b = sheet[t].vertex[(k + 1) % 3];
            out.push_back({std::min(a, b), std::max(a, b), static_cast<int32_t>(3 * t + k)});
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

bool same_edge(const EdgeSide& a, const EdgeSide& b) { return a[0] == b[0] && a[1] == b[1]; }

void check_triangle(const std::vector<Vec3>& rest, const SheetTriangle& t, size_t number) {
    const auto vertices = static_cast<int32_t>(rest.size());
    for (const int32_t v : t.vertex) {
        if (v < 0 || v >= vertices)
            fail(number, "vertex " + std::to_string(v) + " is outside 0 .. " +
                             std::to_string(vertices - 1));
        if (!rest[as_index(v)].allFinite())
            fail(number, "vertex " + std::to_string(v) + ": position is not finite");
    }
    double longest = 0;
    for (size_t k = 0; k < 3; ++k) {
        if (t.vertex[k] == t.vertex[(k + 1) % 3])
            fail(number, "vertex " + std::to_string(t.vertex[k]) + " is there twice");
        longest = std::max(
            longest,
            (rest[as_index(t.vertex[(k + 1) % 3])] - rest[as_index(t.vertex[k])]).squaredNorm());
    }
    const double area = area_of(rest, t);
    if (!(area > kFlat * longest))
        fail(number, "area " + rounded_text(area * 1e6, 4) +
                         " mm^2 is degenerate, must be above 1e-6 of the squared longest edge (" +
                         rounded_text(longest * 1e6, 4) + " mm^2)");
    if (!(t.thickness_m > 0) || !std::isfinite(t.thickness_m))
        fail(number, "thickness " + rounded_text(t.thickness_m, 4) + " m, must be above 0");
    if (static_cast<int>(t.tissue) >= kTissueCount) fail(number, "unknown tissue");
}

/// Rest values and in-plane stiffness of a triangle.
SheetElement element_of(const SoftBodySpec& spec, const SheetTriangle& t) {
    SheetElement out;
    out.v = t.vertex;
    const auto corner = [&](size_t k) { return spec.mesh.rest[as_index(t.vertex[k % 3])]; };
    const double area = area_of(spec.mesh.rest, t);
    const Material& m = material_of(spec, t);
    const NeoHookean c = neo_hookean(m.youngs_modulus_pa, m.poissons_ratio);
    out.material = {c.mu_pa, c.lambda_pa};
    out.volume_m3 = area * t.thickness_m;
    out.r2 = 1 / (4 * area * area);
    for (size_t k = 0; k < 3; ++k) {
        // b_i . b_j = -e_i . e_j' / (2 A)^2 with the edges that meet in the third corner.
        const Vec3 to_first = corner(k) - corner(k + 2), to_second = corner(k + 1) - corner(k + 2);
        out.edge_n_m[k] = c.mu_pa * out.volume_m3 * out.r2 * to_first.dot(to_second);
    }
    return out;
}

/// Leaves the rows in `kept`, and what the others answer when no moment holds them.
Mat3 condensed(const Mat3& full, const std::array<bool, 3>& kept) {
    Mat3 b = full;
    for (int i = 0; i < 3; ++i) {
        if (kept[as_index(i)]) continue;
        const double pivot = b(i, i);
        if (pivot > 1e-12 * full.trace()) b -= Mat3(b.col(i) * b.row(i) / pivot);
        b.row(i).setZero();
        b.col(i).setZero();
    }
    return b;
}

/// Sets the vertex across every edge and the angle there.
void find_flaps(const SoftBodySpec& spec, std::vector<SheetElement>& triangles) {
    const auto& rest = spec.mesh.rest;
    const std::vector<EdgeSide> edges = sorted_edges(spec.sheet);
    for (size_t i = 1; i < edges.size(); ++i) {
        if (!same_edge(edges[i], edges[i - 1])) continue;
        for (const auto& [mine, others] :
             {std::pair{edges[i - 1][2], edges[i][2]}, std::pair{edges[i][2], edges[i - 1][2]}}) {
            SheetElement& t = triangles[as_index(mine / 3)];
            const size_t k = as_index(mine % 3);
            t.flap[k] = triangles[as_index(others / 3)].v[as_index((others + 2) % 3)];
            t.rest_angle[k] =
                hinge_angle({rest[as_index(t.v[k])], rest[as_index(t.v[(k + 1) % 3])],
                             rest[as_index(t.v[(k + 2) % 3])], rest[as_index(t.flap[k])]});
        }
    }
}

/// B = D A (nu w_i w_j + (1 - nu) w_i w_j (n_i . n_j)^2), w = 2 / (h + h').
void add_bending(const SoftBodySpec& spec, std::vector<SheetElement>& triangles) {
    find_flaps(spec, triangles);
    const auto& rest = spec.mesh.rest;
    for (size_t i = 0; i < triangles.size(); ++i) {
        SheetElement& t = triangles[i];
        const Material& m = material_of(spec, spec.sheet[i]);
        const double nu = m.poissons_ratio, thickness = spec.sheet[i].thickness_m;
        const double rigidity = spec.sheet_bending * m.youngs_modulus_pa * thickness * thickness *
                                thickness / (12 * (1 - nu * nu));
        std::array<Vec3, 3> along;
        std::array<double, 3> weight{};
        for (size_t k = 0; k < 3; ++k) {
            const Vec3& x = rest[as_index(t.v[k])];
            const Vec3 edge = rest[as_index(t.v[(k + 1) % 3])] - x;
            along[k] = edge.normalized();
            const double own = 1 / std::sqrt(t.r2) / edge.norm();
            const double other =
                t.flap[k] < 0 ? own : along[k].cross(rest[as_index(t.flap[k])] - x).norm();
            weight[k] = 2 / (own + other);
        }
        Mat3 full;
        for (int k = 0; k < 3; ++k) {
            for (int l = 0; l < 3; ++l) {
                const double cosine = along[as_index(k)].dot(along[as_index(l)]);
                full(k, l) = rigidity * t.volume_m3 / thickness * weight[as_index(k)] *
                             weight[as_index(l)] * (nu + (1 - nu) * cosine * cosine);
            }
        }
        t.bending = condensed(full, {t.flap[0] >= 0, t.flap[1] >= 0, t.flap[2] >= 0});
    }
}

/// Corner k of a triangle, in the plane. With e the edge opposite and d from it to the corner,
/// q = r2 |e x d|^2 = r2 d . (|e|^2 - e e^T) d. The Hessian has the axes e, u (in the plane) and n
/// (its normal).
void add_membrane(const SheetElement& t, size_t k, const Float4* x, Vec3& gradient,
                  Mat3& hessian) noexcept {
    const Vec3 here = to_vec(x[t.v[k]]);
    const Vec3 p1 = to_vec(x[t.v[(k + 1) % 3]]), p2 = to_vec(x[t.v[(k + 2) % 3]]);
    const Vec3 e = p2 - p1, d = here - p1;
    const double a1 = t.edge_n_m[k], a2 = t.edge_n_m[(k + 2) % 3], shear = a1 + a2;
    const double e2 = e.squaredNorm();
    const Vec3 away = e2 * d - e.dot(d) * e;
    const double q = t.r2 * d.dot(away), slope = t.volume_m3 * t.material.slope(q);
    gradient += a1 * d + a2 * (here - p2) + 2 * t.r2 * slope * away;
    const double across = std::max(0.0, shear + 2 * t.r2 * slope * e2);
    hessian.diagonal().array() += across;
    if (!(e2 > 0)) return;
    hessian += (shear - across) / e2 * e * e.transpose();
    const double away2 = away.squaredNorm();
    if (!(away2 > 1e-16 * e2 * e2 * (e2 + d.squaredNorm()))) return;
    const double in_plane = shear + 2 * t.r2 * slope * e2 +
                            4 * t.r2 * t.r2 * t.volume_m3 * t.material.curvature(q) * away2;
    hessian += (std::max(0.0, in_plane) - across) / away2 * away * away.transpose();
}

/// Angles are what it costs: without the force nobody needs them.
template <bool kForce, bool kStiffness>
void add_hinges(const SheetElement& t, int32_t vertex, const Float4* x, Vec3& gradient,
                Mat3& hessian) noexcept {
    Vec3 s = Vec3::Zero();
    Mat3 g = Mat3::Zero();  // column i: gradient of angle i
    for (size_t i = 0; i < 3; ++i) {
        if (t.flap[i] < 0) continue;
        const std::array<int32_t, 4> v{t.v[i], t.v[(i + 1) % 3], t.v[(i + 2) % 3], t.flap[i]};
        const HingePoints<double> p{to_vec(x[v[0]]), to_vec(x[v[1]]), to_vec(x[v[2]]),
                                    to_vec(x[v[3]])};
        if (!has_hinge(p)) continue;
        const auto c = static_cast<Eigen::Index>(i);
        if constexpr (kForce) s[c] = angle_from(hinge_angle(p), t.rest_angle[i]);
        const auto* const found = std::find(v.begin(), v.end(), vertex);
        if (found != v.end()) g.col(c) = hinge_gradient<double>(p)[as_index(found - v.begin())];
    }
    if constexpr (kForce) gradient += g * (t.bending * s);
    if constexpr (kStiffness) hessian += g * t.bending * g.transpose();
}

template <bool kForce, bool kStiffness>
void add_elements(const SheetElements& sheet, const Float4* x, int32_t vertex, Vec3& gradient,
                  Mat3& hessian) noexcept {
    for (const int32_t i : sheet.around(vertex)) {
        const SheetElement& t = sheet.triangles[as_index(i)];
        for (size_t k = 0; k < 3; ++k) {
            if (t.v[k] == vertex) add_membrane(t, k, x, gradient, hessian);
        }
        if (t.bending(0, 0) + t.bending(1, 1) + t.bending(2, 2) > 0)
            add_hinges<kForce, kStiffness>(t, vertex, x, gradient, hessian);
    }
}

}  // namespace

double area_of(const std::vector<Vec3>& rest, const SheetTriangle& t) noexcept {
    const Vec3& a = rest[as_index(t.vertex[0])];
    return (rest[as_index(t.vertex[1])] - a).cross(rest[as_index(t.vertex[2])] - a).norm() / 2;
}

std::vector<uint8_t> sheet_vertices(const SoftBodySpec& spec) {
    if (spec.sheet.empty()) return {};
    std::vector<uint8_t> out(spec.mesh.rest.size(), 0);
    for (const SheetTriangle& t : spec.sheet) {
        for (const int32_t v : t.vertex) out[as_index(v)] = 1;
    }
    return out;
}

/// Triangles are counted in their sheet: those of one tissue follow each other.
size_t number_in_sheet(std::span<const SheetTriangle> sheet, size_t t) {
    size_t first = t;
    while (first > 0 && sheet[first - 1].tissue == sheet[t].tissue) --first;
    return t - first;
}

/// Triangle `other` in a message about triangle `t`.
std::string other_name(std::span<const SheetTriangle> sheet, size_t other, size_t t) {
    return std::to_string(number_in_sheet(sheet, other)) +
           (sheet[other].tissue == sheet[t].tissue ? "" : " of another sheet");
}

void check_sheet(const std::vector<Vec3>& rest, std::span<const SheetTriangle> sheet) {
    std::vector<std::array<int32_t, 4>> keys;
    for (size_t t = 0; t < sheet.size(); ++t) {
        check_triangle(rest, sheet[t], number_in_sheet(sheet, t));
        auto v = sheet[t].vertex;
        std::sort(v.begin(), v.end());
        keys.push_back({v[0], v[1], v[2], static_cast<int32_t>(t)});
    }
    std::sort(keys.begin(), keys.end());
    for (size_t i = 1; i < keys.size(); ++i) {
        if (!std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin())) continue;
        const size_t t = as_index(keys[i][3]);
        fail(number_in_sheet(sheet, t), "duplicate of triangle " +
                                            other_name(sheet, as_index(keys[i - 1][3]), t) +
                                            ": same three vertices");
    }
    const std::vector<EdgeSide> edges = sorted_edges(sheet);
    for (size_t i = 2; i < edges.size(); ++i) {
        if (!same_edge(edges[i], edges[i - 2])) continue;
        const size_t t = as_index(edges[i][2] / 3);
        fail(number_in_sheet(sheet, t),
             "the edge between vertices " + std::to_string(edges[i][0]) + " and " +
                 std::to_string(edges[i][1]) + " has more than two triangles (also " +
                 other_name(sheet, as_index(edges[i - 2][2] / 3), t) + " and " +
                 other_name(sheet, as_index(edges[i - 1][2] / 3), t) + ")");
    }
}

SheetElements sheet_elements(const SoftBodySpec& spec) {
    SheetElements out;
    if (spec.sheet.empty()) return out;
    for (const SheetTriangle& t : spec.sheet) out.triangles.push_back(element_of(spec, t));
    if (spec.sheet_bending > 0) add_bending(spec, out.triangles);
    std::vector<std::vector<int32_t>> of(spec.mesh.rest.size());
    for (size_t i = 0; i < out.triangles.size(); ++i) {
        const SheetElement& t = out.triangles[i];
        for (const auto& corners : {t.v, t.flap}) {
            for (const int32_t v : corners) {
                if (v < 0) continue;
                auto& list = of[as_index(v)];
                if (list.empty() || list.back() != static_cast<int32_t>(i))
                    list.push_back(static_cast<int32_t>(i));
            }
        }
    }
    out.start.push_back(0);
    for (const auto& list : of) {
        out.of.insert(out.of.end(), list.begin(), list.end());
        out.start.push_back(static_cast<int32_t>(out.of.size()));
    }
    return out;
}

void add_sheet(const SheetElements& sheet, const Float4* x, int32_t vertex, Vec3& gradient,
               Mat3& hessian) noexcept {
    add_elements<true, true>(sheet, x, vertex, gradient, hessian);
}

void add_sheet_force(const SheetElements& sheet, const Float4* x, int32_t vertex,
                     Vec3& gradient) noexcept {
    Mat3 ignored = Mat3::Zero();
    add_elements<true, false>(sheet, x, vertex, gradient, ignored);
}

void add_sheet_stiffness(const SheetElements& sheet, const Float4* x, int32_t vertex,
                         Mat3& hessian) noexcept {
    Vec3 ignored = Vec3::Zero();
    add_elements<false, true>(sheet, x, vertex, ignored, hessian);
}

}  // namespace placode::sim
