// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/slide_vertex.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "sim/core/as_index.h"
#include "sim/solver/double_float.h"
#include "sim/solver/kernel_layout_parts.h"
#include "sim/solver/topology.h"

namespace placode::sim {
namespace {

using Corners = std::array<Vec3, 4>;

double six_volumes(const Corners& x) noexcept {
    return (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]);
}

/// 6 sqrt(2) V / l_rms^3, as tet_quality().
double quality(const Corners& x) noexcept {
    double sum = 0;
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = i + 1; j < 4; ++j) sum += (x[i] - x[j]).squaredNorm();
    }
    const double rms = std::sqrt(sum / 6);
    return std::numbers::sqrt2 * six_volumes(x) / (rms * rms * rms);
}

Corners rest_corners(const SoftBody& body, const SoftBodyState& state, int tet) noexcept {
    Corners out;
    const auto& c = corners(body, state, tet);
    for (size_t k = 0; k < 4; ++k) out[k] = rest_place(body, state, c[k]);
    return out;
}

double mesh_six_volumes(const SoftBody& body, int tet) noexcept {
    Corners x;
    for (size_t k = 0; k < 4; ++k)
        x[k] = body.mesh().rest[as_index(body.mesh().tets[as_index(tet)][k])];
    return six_volumes(x);
}

/// A tet may not be turned inside out as it is now, or nearly.
bool stays_upright(const SoftBody& body, const SoftBodyState& state, int tet, int vertex,
                   const Vec3& now) noexcept {
    constexpr double kLeast = 0.2;  // of the volume it has now: J jumps by no more than 1 / 0.2
    const auto& c = corners(body, state, tet);
    Corners y;
    for (size_t i = 0; i < 4; ++i) y[i] = exact_position(state, c[i]);
    const double before = six_volumes(y);
    y[corner_of(c, vertex)] = now;
    return six_volumes(y) > kLeast * std::max(before, 0.0);
}

/// The kernels' constants of a tet, anew from its corners at rest.
void write_constants(const SoftBody& body, SoftBodyState& state, int tet) noexcept {
    Topology& top = *state.topology;
    KernelLayout& packed = top.packed;
    const auto t = as_index(tet);
    const Corners rest = rest_corners(body, state, tet);
    const TetConstants k = tet_constants(body.spec(), tet, rest);
    top.volume_m3[t] = static_cast<float>(six_volumes(rest) / 6);
    for (size_t e = 0; e < 6; ++e)
        packed.edge_weight_n_m[6 * t + e] =
            static_cast<float>(k.material.mu_pa * k.volume_m3 * k.a[e]);
    const double six_v = 6 * k.volume_m3;
    for (size_t corner = 0; corner < 4 && has_strips(packed); ++corner) {
        float* row = state.lanes.data() + packed.corner_lane[4 * t + corner];
        row[0] = static_cast<float>(k.material.lambda_pa * k.volume_m3 / (six_v * six_v));
        row[kLanes] = std::copysign(static_cast<float>(six_v * k.material.gamma), row[kLanes]);
    }
    if (packed.tet_slot.empty()) return;
    const auto slot = as_index(packed.tet_slot[t]);
    write_tet_row(k, packed.tet_rows.data() + slot / kLanes * kTetRows * kLanes + slot % kLanes);
    state.lanes[as_index(packed.tet_lane_start) + slot] =
        static_cast<float>(k.material.mu_pa * k.volume_m3);
}

/// True when a living tet has the vertex and all that it slides towards.
bool share_a_tet(const SoftBody& body, const SoftBodyState& state, const Slide& slide) noexcept {
    for (const int32_t t : tets_around(body, state, slide.vertex)) {
        if (state.tet_alive[as_index(t)] == 0) continue;
        const auto& c = corners(body, state, t);
        if (std::all_of(slide.towards.begin(), slide.towards.end(),
                        [&](int32_t v) { return v < 0 || corner_of(c, v) < 4; }))
            return true;
    }
    return false;
}

/// Weights and masses of the corners of the tets around a vertex, each corner once.
void renew_corners(const SoftBody& body, SoftBodyState& state,
                   std::span<const int32_t> around) noexcept {
    Topology& top = *state.topology;
    std::array<int32_t, 3 * kMostAround + 1> done{};
    size_t count = 0;
    for (const int32_t t : around) {
        if (state.tet_alive[as_index(t)] == 0) continue;
        for (const int32_t c : corners(body, state, t)) {
            const auto end = done.begin() + static_cast<ptrdiff_t>(count);
            if (std::find(done.begin(), end, c) != end) continue;
            done[count++] = c;
            if (has_strips(top.packed)) reweigh(state, c);
            fill_mass(body, top, c);
            Float4& x = state.x[as_index(c)];
            if (x.w > 0) x.w = 1.0F / top.mass_kg[as_index(c)];
            rouse(state, c);
        }
    }
}

}  // namespace

Vec3 slid_rest(std::span<const Vec3> rest, const Slide& slide) noexcept {
    const Vec3 from = rest[as_index(slide.vertex)];
    Vec3 to = from;
    for (size_t i = 0; i < 3; ++i) {
        if (slide.towards[i] >= 0)
            to += static_cast<double>(slide.share[i]) * (rest[as_index(slide.towards[i])] - from);
    }
    return to;
}

bool slide_fits(const SoftBody& body, const SoftBodyState& state, std::span<const Vec3> rest,
                const Slide& slide, const SlideLimits& limits) noexcept {
    const Vec3 to = slid_rest(rest, slide);
    for (const int32_t t : tets_around(body, state, slide.vertex)) {
        if (state.tet_alive[as_index(t)] == 0) continue;
        const auto& c = corners(body, state, t);
        Corners x;
        for (size_t k = 0; k < 4; ++k) x[k] = rest[as_index(c[k])];
        const double before = quality(x);
        x[corner_of(c, slide.vertex)] = to;
        if (!(six_volumes(x) >= limits.least_volume * mesh_six_volumes(body, t))) return false;
        if (!(quality(x) >= std::min(limits.least_quality, before))) return false;
    }
    return true;
}

bool slide_vertex(const SoftBody& body, SoftBodyState& state, const Slide& slide,
                  const SlideLimits& limits) noexcept {
    assert(state.topology && state.topology->dirty_count == 0);
    const int vertex = slide.vertex;
    const auto v = as_index(vertex);
    if (!can_split(state, vertex) || state.x[v].w == 0) return false;
    if (!share_a_tet(body, state, slide)) return false;
    Topology& top = *state.topology;
    if (!slide_fits(body, state, top.rest, slide, limits)) return false;
    const Vec3 rest = slid_rest(top.rest, slide);
    Vec3 now = exact_position(state, vertex), speed = to_vec(state.v[v]);
    const Vec3 old_now = now, old_speed = speed;
    for (size_t i = 0; i < 3; ++i) {
        if (slide.towards[i] < 0) continue;
        const auto part = static_cast<double>(slide.share[i]);
        now += part * (exact_position(state, slide.towards[i]) - old_now);
        speed += part * (to_vec(state.v[as_index(slide.towards[i])]) - old_speed);
    }
    const auto around = tets_around(body, state, vertex);
    for (const int32_t t : around) {
        if (state.tet_alive[as_index(t)] != 0 && !stays_upright(body, state, t, vertex, now))
            return false;
    }
    top.rest[v] = rest;
    put_vertex(state, vertex, now);
    const Vec3f u = speed.cast<float>();
    state.v[v] = {u.x(), u.y(), u.z(), state.v[v].w};
    for (const int32_t t : around) {
        if (state.tet_alive[as_index(t)] != 0) write_constants(body, state, t);
    }
    renew_corners(body, state, around);
    return true;
}

double least_quality(const SoftBody& body, const SoftBodyState& state) noexcept {
    double least = 1;
    for (int t = 0; t < body.tet_count(); ++t)
        least = std::min(least, quality(rest_corners(body, state, t)));
    return least;
}

}  // namespace placode::sim
