// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/solver/topology.h"

#include <algorithm>
#include <cassert>

#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout_parts.h"

namespace placode::sim {
namespace {

void mark(Topology& topology, int32_t v) noexcept {
    if (topology.is_dirty[as_index(v)] != 0) return;
    topology.is_dirty[as_index(v)] = 1;
    topology.dirty[as_index(topology.dirty_count++)] = v;
}

/// A lane for a copy of `vertex`, among other copies of its job and colour; -1 when there is none.
int32_t new_lane(Topology& top, int32_t vertex) noexcept {
    const KernelLayout& packed = top.packed;
    const int32_t job = packed.job[as_index(top.origin[as_index(vertex)])];
    const int32_t colour = packed.colour[as_index(top.origin[as_index(vertex)])];
    if (job < 0) return -1;
    for (int32_t p = top.job_first[as_index(job)]; p >= 0; p = top.pool_next[as_index(p)]) {
        const int32_t batch = top.pool_first + p, count = packed.batches[as_index(batch)].count;
        if (top.pool_colour[as_index(p)] == colour && count < kLanes) return batch * kLanes + count;
    }
    if (as_index(top.pool_used) == top.pool_next.size()) return -1;
    const int32_t fresh = top.pool_used++, last = top.job_last[as_index(job)];
    (last < 0 ? top.job_first[as_index(job)] : top.pool_next[as_index(last)]) = fresh;
    top.job_last[as_index(job)] = fresh;
    top.pool_colour[as_index(fresh)] = colour;
    return (top.pool_first + fresh) * kLanes;
}

}  // namespace

void fill_mass(const SoftBody& body, Topology& topology, int v) noexcept {
    double mass = 0;
    for (int i = 0; i < topology.count[as_index(v)]; ++i) {
        const auto t = as_index(topology.around[as_index(topology.first[as_index(v)] + i)]);
        const auto& m = body.spec().materials[as_index(static_cast<int>(body.mesh().tissue[t]))];
        // Dead tets count: their mass stays with their vertices.
        mass += m.density_kg_m3 * static_cast<double>(topology.volume_m3[t]) / 4;
    }
    topology.mass_kg[as_index(v)] = static_cast<float>(mass);
    const int32_t slot = topology.packed.slot[as_index(v)];
    topology.packed.batches[as_index(slot / kLanes)].mass_kg[as_index(slot % kLanes)] =
        topology.mass_kg[as_index(v)];
}

int spares_left(const SoftBodyState& state) noexcept {
    if (!state.topology) return 0;
    return static_cast<int>(state.topology->origin.size()) - state.topology->vertices;
}

bool can_split(const SoftBodyState& state, int vertex) noexcept {
    return state.topology &&
           state.topology->whole[as_index(state.topology->origin[as_index(vertex)])] == 0;
}

int split_vertex(const SoftBody& body, SoftBodyState& state, int vertex,
                 std::span<const int32_t> moved) noexcept {
    assert(can_split(state, vertex));
    Topology& top = *state.topology;
    KernelLayout& packed = top.packed;
    if (spares_left(state) == 0) return -1;
    const int32_t slot = new_lane(top, vertex);
    if (slot < 0) return -1;
    const int32_t copy = top.vertices++;
    const auto old = as_index(vertex), now = as_index(copy);
    const bool held = state.x[old].w == 0;
    // The list of the old vertex is divided: what stays, then what goes.
    const auto begin = top.around.begin() + top.first[old];
    std::array<int32_t, kMostAround> goes{};
    int32_t going = 0, stays = 0;
    for (int32_t i = 0; i < top.count[old]; ++i) {
        const int32_t t = begin[i];
        if (std::find(moved.begin(), moved.end(), t) != moved.end()) {
            goes[as_index(going++)] = t;
        } else {
            begin[stays++] = t;
        }
    }
    std::copy_n(goes.begin(), going, begin + stays);
    top.first[now] = top.first[old] + stays;
    top.count[now] = going;
    top.count[old] = stays;
    top.origin[now] = top.origin[old];
    top.rest[now] = top.rest[old];
    for (int32_t i = 0; i < going; ++i) {
        auto& tet = top.tets[as_index(goes[as_index(i)])];
        tet[corner_of(tet, vertex)] = copy;
        for (const int32_t other : tet) mark(top, other);
        if (packed.tet_slot.empty()) continue;
        const int32_t place = packed.tet_slot[as_index(goes[as_index(i)])];
        const size_t k = corner_of(tet, copy);
        packed.tet_index[(as_index(place / kLanes) * 4 + k) * kLanes + as_index(place % kLanes)] =
            static_cast<uint16_t>(2 * (copy - packed.tet_batches[as_index(place / kLanes)].base));
    }
    mark(top, vertex);
    state.x[now] = state.x[old];
    state.v[now] = state.v[old];
    state.x_start[now] = state.x_start[old];
    state.free_vertex[now] = state.free_vertex[old];
    packed.damping_per_s[now] = packed.damping_per_s[old];
    packed.slot[now] = slot;
    VertexBatch& b = packed.batches[as_index(slot / kLanes)];
    const size_t lane = as_index(slot % kLanes);
    if (b.count == 0) {  // unused lanes of a batch repeat its first
        b.vertex.fill(copy);
        b.self.fill(static_cast<uint16_t>(2 * copy));
        std::fill_n(packed.strip.begin() + b.step_start * kLanes,
                    as_index(top.capacity[as_index(slot / kLanes)]) * kLanes, b.self[0]);
    }
    b.vertex[lane] = copy;
    b.self[lane] = static_cast<uint16_t>(2 * copy);
    b.limit_m[lane] = body.shortest_edge_m()[as_index(top.origin[now])] / 4;
    ++b.count;
    fill_mass(body, top, vertex);
    fill_mass(body, top, copy);
    if (!held) {
        state.x[old].w = 1.0F / top.mass_kg[old];
        state.x[now].w = 1.0F / top.mass_kg[now];
    }
    return copy;
}

}  // namespace placode::sim
