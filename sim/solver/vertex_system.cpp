// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One vertex in double precision, from the same numbers as the kernels: contact and tether
// vertices are solved this way, and grasps read their force here.
#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/solver/double_float.h"
#include "sim/solver/kernel_layout_parts.h"
#include "sim/solver/sheet_terms.h"
#include "sim/solver/strip_walk.h"
#include "sim/solver/vertex_stiffness.h"

namespace placode::sim {
namespace {

/// From the strip of the vertex: adds -force to the gradient and its exact Hessian.
void add_strip(const KernelLayout& packed, const SoftBodyState& state, int vertex, Vec3& gradient,
               Mat3& hessian) noexcept {
    StripSums sums;
    auto& h = sums.hessian;
    for (int i = 0; i < 3; ++i) {
        sums.gradient[as_index(i)] = gradient[i];
        for (int j = 0; j < 3; ++j) h[as_index(4 * i + j)] = hessian(i, j);
    }
    walk_strip(packed, state, vertex, sums);
    gradient << sums.gradient[0], sums.gradient[1], sums.gradient[2];
    hessian << h[0], h[1], h[2], h[4], h[5], h[6], h[8], h[9], h[10];
}

/// The same from one of its tets, where no strips are packed (XPBD): from the kernel's own numbers.
void add_tet(const KernelLayout& packed, const SoftBodyState& state, int32_t tet,
             const std::array<int32_t, 4>& corners, int vertex, const Vec3& x, Vec3& gradient,
             Mat3& hessian) noexcept {
    const size_t me = corner_of(corners, vertex);
    const float* weights = packed.edge_weight_n_m.data() + 6 * as_index(tet);
    std::array<Vec3, 3> p;  // the others, so that det(p) is six volumes
    double sum = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t other = as_index(kOpposite[me][i]);
        p[i] = exact_position(state, corners[other]) - x;
        const double w = weights[kEdge[me][other]];
        gradient -= w * p[i];
        sum += w;
    }
    const int32_t slot = packed.tet_slot[as_index(tet)];
    const float* row = packed.tet_rows.data() + as_index(slot / kLanes) * kTetRows * kLanes +
                       as_index(slot % kLanes);
    const double r = row[6 * kLanes], mu_over_lambda = row[7 * kLanes];
    const double mu_v = state.lanes[as_index(packed.tet_lane_start + slot)];
    // s = lambda V r^2 and s (det - gamma / r), with one division.
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double s = mu_v * r * r / mu_over_lambda;
    gradient -= (s * normal.dot(p[0]) - mu_v * r * (1 + mu_over_lambda) / mu_over_lambda) * normal;
    hessian += s * normal * normal.transpose();
    hessian.diagonal().array() += sum;
}

void add_elastic(const SoftBody& body, const SoftBodyState& state, int vertex, Vec3& gradient,
                 Mat3& hessian) noexcept {
    const KernelLayout& packed = packed_of(body, state);
    if (has_strips(packed)) {
        add_strip(packed, state, vertex, gradient, hessian);
        return;
    }
    const Vec3 x = exact_position(state, vertex);
    for (const int32_t t : tets_around(body, state, vertex)) {
        if (state.tet_alive[as_index(t)] == 0) continue;
        add_tet(packed, state, t, corners(body, state, t), vertex, x, gradient, hessian);
    }
}

void add_springs(const SoftBody& body, const SoftBodyState& state, int vertex,
                 VertexSystem& out) noexcept {
    const KernelLayout& packed = packed_of(body, state);
    const VertexBatch& b = packed.batches[as_index(packed.slot[as_index(vertex)] / kLanes)];
    if (b.spring_start < 0) return;
    const float* k = state.springs.data() + b.spring_start + packed.slot[as_index(vertex)] % kLanes;
    const auto row = [k](int r) { return static_cast<double>(k[r * kLanes]); };
    Mat3 stiffness;
    stiffness << row(0), row(1), row(2), row(1), row(3), row(4), row(2), row(4), row(5);
    const Vec3 moved = to_vec(state.x[as_index(vertex)]) - Vec3(row(6), row(7), row(8));
    out.gradient += stiffness * moved + Vec3(row(9), row(10), row(11));
    out.hessian += stiffness;
}

/// Energy C^2 / (2 compliance), C = length - rest, only when stretched.
void add_tethers(const SoftBody& body, const SoftBodyState& state, int vertex,
                 VertexSystem& out) noexcept {
    const KernelLayout& packed = packed_of(body, state);
    for (int32_t i = packed.tether_start[as_index(vertex)];
         i < packed.tether_start[as_index(vertex) + 1]; ++i) {
        const auto index = as_index(packed.tether_of[as_index(i)]);
        if (state.tether_alive[index] == 0) continue;
        const Tether& tether = body.spec().tethers[index];
        const int32_t other = tether.vertex[tether.vertex[0] == vertex ? 1 : 0];
        const Vec3 d = to_vec(state.x[as_index(vertex)]) - to_vec(state.x[as_index(other)]);
        const double length = d.norm(), excess = length - tether.rest_m;
        if (!(excess > 0)) continue;
        const Vec3 u = d / length;
        const double k = 1 / tether.compliance_m_n;
        out.gradient += k * excess * u;
        const Mat3 along = u * u.transpose();
        out.hessian += k * (along + excess / length * (Mat3::Identity() - along));
    }
}

/// All of it but the sheets.
VertexSystem without_sheets(const SoftBody& body, const SoftBodyState& state, int vertex,
                            double h) noexcept {
    VertexSystem out;
    const auto i = as_index(vertex);
    const double inertia = static_cast<double>(mass_of(body, state, vertex)) / (h * h);
    // x - target, but from the small numbers: the target as a float has lost most of h^2 g.
    const Vec3 planned = h * to_vec(state.v[i]) + h * h * body.spec().solver.gravity_m_s2;
    if (!state.force_n.empty()) out.gradient = -to_vec(state.force_n[i]);
    out.gradient += inertia * (moved_in_substep(state, vertex) - planned);
    out.hessian.diagonal().setConstant(inertia);
    add_elastic(body, state, vertex, out.gradient, out.hessian);
    add_springs(body, state, vertex, out);
    add_tethers(body, state, vertex, out);
    return out;
}

}  // namespace

VertexSystem vertex_system(const SoftBody& body, const SoftBodyState& state, int vertex,
                           double h) noexcept {
    VertexSystem out = without_sheets(body, state, vertex, h);
    const SheetElements& sheet = packed_of(body, state).sheet;
    add_sheet(sheet, state.x.data(), vertex, out.gradient, out.hessian);
    return out;
}

Mat3 vertex_stiffness(const SoftBody& body, const SoftBodyState& state, int vertex,
                      double h) noexcept {
    Mat3 out = without_sheets(body, state, vertex, h).hessian;
    add_sheet_stiffness(packed_of(body, state).sheet, state.x.data(), vertex, out);
    return out;
}

Vec3 elastic_force(const SoftBody& body, const SoftBodyState& state, int vertex) noexcept {
    Vec3 gradient = Vec3::Zero();
    Mat3 hessian = Mat3::Zero();
    add_elastic(body, state, vertex, gradient, hessian);
    add_sheet_force(packed_of(body, state).sheet, state.x.data(), vertex, gradient);
    return -gradient;
}

}  // namespace placode::sim
