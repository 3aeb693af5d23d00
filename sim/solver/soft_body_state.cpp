// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cassert>

#include "sim/core/as_index.h"
#include "sim/core/fnv_hash.h"
#include "sim/solver/kernel_layout_parts.h"
#include "sim/solver/topology.h"

namespace placode::sim {
SoftBodyState::SoftBodyState(const SoftBody& body) {
    const size_t n = as_index(body.vertex_capacity()), used = as_index(body.vertex_count());
    x.resize(n);
    v.resize(n);
    x_start.resize(n);
    for (size_t i = 0; i < used; ++i) {
        const Vec3f p = body.mesh().rest[i].cast<float>();
        x[i] = {p.x(), p.y(), p.z(), 1.0F / body.mass_kg()[i]};
    }
    for (const int32_t i : body.spec().fixed) x[as_index(i)].w = 0;
    x_start = x;
    tet_alive.assign(as_index(body.tet_count()), 1);
    contact_vertex.assign(n, 0);
    free_vertex.assign(n, 0);
    scratch.assign(n, 0);
    seen_tet.assign(as_index(body.tet_count()), 0);
    roused.assign(256, 0);
    tether_alive.assign(body.spec().tethers.size(), 1);
    tether_lambda_n.assign(body.spec().tethers.size(), 0.0F);
    if (n > used) {
        // Spares wait, held, where they disturb nothing.
        for (size_t i = used; i < n; ++i) x[i] = {x[0].x, x[0].y, x[0].z, 0.0F};
        x_start = x;
        topology.create(body);
    }
    const KernelLayout& packed = packed_of(body, *this);
    lanes = initial_lanes(body, packed);
    springs = packed.springs;
    awake.batches.reserve(packed.batches.size());
    awake.job_start.assign(packed.job_start.size(), 0);
    awake.vertices.reserve(n / 16 + 1);
    if (!packed.tet_batches.empty()) {
        awake.tets.reserve(packed.tet_batches.size());
        awake.tet_job_start.assign(packed.tet_job_start.size(), 0);
        awake.held.reserve(used);
        awake.held_w.reserve(used);
    }
    update_free_vertices(body, *this);
}

void rouse(SoftBodyState& state, int32_t vertex) noexcept {
    const auto room = static_cast<int32_t>(state.roused.size());
    if (state.roused_count < room) state.roused[as_index(state.roused_count)] = vertex;
    state.roused_count = std::min(state.roused_count + 1, room + 1);
}

void rouse_all(SoftBodyState& state) noexcept {
    state.roused_count = static_cast<int32_t>(state.roused.size()) + 1;
}

void hold_sleepers(SoftBodyState& state) noexcept {
    AwakeRuns& awake = state.awake;
    if (awake.holding || awake.all) return;
    awake.held_w.clear();
    for (const int32_t v : awake.held) {
        awake.held_w.push_back(state.x[as_index(v)].w);
        state.x[as_index(v)].w = 0;
    }
    awake.holding = true;
}

void release_sleepers(SoftBodyState& state) noexcept {
    AwakeRuns& awake = state.awake;
    if (!awake.holding) return;
    for (size_t i = 0; i < awake.held.size(); ++i)
        state.x[as_index(awake.held[i])].w = awake.held_w[i];
    awake.holding = false;
}

namespace {

/// What is held, spreading: free_vertex has bit 0 set where nothing that holds has been reached.
class Hold {
 public:
    Hold(const SoftBody& body, SoftBodyState& state) noexcept
        : body_(body), state_(state), packed_(packed_of(body, state)) {
        for (size_t t = 0; t < state.seen_tet.size(); ++t)
            state.seen_tet[t] = state.tet_alive[t] == 0 ? 1 : 0;
    }
    bool reach(int32_t v) noexcept {
        uint8_t& free = state_.free_vertex[as_index(v)];
        const bool is_new = (free & 1) != 0;
        free &= 2;
        return is_new;
    }
    /// Over all tets there and back until nothing new is reached. In RCM order two rounds are
    /// nearly always enough, and memory is read in order.
    void spread() noexcept {
        bool more = true;
        while (more) {
            more = false;
            const int32_t tets = body_.tet_count();
            for (int32_t t = 0; t < tets; ++t) more = visit(t) || more;
            for (int32_t t = tets - 1; t >= 0; --t) more = visit(t) || more;
            more = links() || more;
        }
    }

 private:
    [[nodiscard]] bool reached(int32_t v) const noexcept {
        return (state_.free_vertex[as_index(v)] & 1) == 0;
    }
    bool visit(int32_t t) noexcept {
        if (state_.seen_tet[as_index(t)] != 0) return false;
        return visit_all(corners(body_, state_, t), state_.seen_tet[as_index(t)]);
    }
    /// All corners once one of them is reached; sets `done`. True when that was new.
    template <class Corners>
    bool visit_all(const Corners& vertices, uint8_t& done) noexcept {
        bool any = false, more = false;
        for (const int32_t v : vertices) any = any || reached(v);
        if (!any) return false;
        done = 1;
        for (const int32_t v : vertices) more = reach(v) || more;
        return more;
    }
    bool links() noexcept {
        bool more = false;
        uint8_t done = 0;
        const auto& tethers = body_.spec().tethers;
        for (size_t i = 0; i < tethers.size(); ++i) {
            if (state_.tether_alive[i] != 0) more = visit_all(tethers[i].vertex, done) || more;
        }
        for (const auto& triangle : packed_.sheet.triangles)
            more = visit_all(triangle.v, done) || more;
        return more;
    }

    const SoftBody& body_;
    SoftBodyState& state_;
    const KernelLayout& packed_;
};

}  // namespace

void update_free_vertices(const SoftBody& body, SoftBodyState& state) noexcept {
    // Until the end bit 1 remembers what was free before.
    auto& free = state.free_vertex;
    for (uint8_t& f : free) f = static_cast<uint8_t>(f << 1 | 1);
    Hold hold(body, state);
    for (size_t v = 0; v < free.size(); ++v) {
        if (state.x[v].w == 0) hold.reach(static_cast<int32_t>(v));
    }
    for (const int32_t v : body.packed().spring_vertices) hold.reach(v);
    hold.spread();
    for (size_t v = 0; v < free.size(); ++v) {
        if (free[v] == 1 || free[v] == 2) rouse(state, static_cast<int32_t>(v));
        free[v] &= 1;
    }
}

void remove_tet(const SoftBody& body, SoftBodyState& state, int tet) noexcept {
    const KernelLayout& packed = packed_of(body, state);
    if (state.tet_alive[as_index(tet)] == 0) return;
    state.tet_alive[as_index(tet)] = 0;
    for (size_t k = 0; k < 4; ++k) {
        if (has_strips(packed))
            state.lanes[as_index(packed.corner_lane[4 * as_index(tet) + k])] = 0;
        const int32_t v = corners(body, state, tet)[k];
        rouse(state, v);
        if (state.topology) {
            reweigh(state, v);
        } else {
            set_vertex_weights(body, packed, state.tet_alive, v, state.lanes.data());
        }
    }
    if (!packed.tet_slot.empty()) {
        state.lanes[as_index(packed.tet_lane_start + packed.tet_slot[as_index(tet)])] = 0;
    }
}

namespace {

/// Of the anchor spring of a vertex; the next row stands kLanes further.
float* spring_of(const SoftBody& body, SoftBodyState& state, int vertex) noexcept {
    const KernelLayout& packed = packed_of(body, state);
    const int32_t slot = packed.slot[as_index(vertex)];
    assert(body.spec().solver.method == Method::kVbd && "xpbd knows no loads of springs");
    assert(packed.batches[as_index(slot / kLanes)].spring_start >= 0 && "no spring at the vertex");
    return state.springs.data() + packed.batches[as_index(slot / kLanes)].spring_start +
           slot % kLanes;
}

}  // namespace

void set_spring(const SoftBody& body, SoftBodyState& state, int vertex,
                const std::array<float, 6>& k_n_m, const Vec3f& anchor_m) noexcept {
    float* row = spring_of(body, state, vertex);
    for (size_t r = 0; r < k_n_m.size(); ++r) row[r * kLanes] = k_n_m[r];
    for (int i = 0; i < 3; ++i) {
        row[(6 + i) * kLanes] = anchor_m[i];
        row[(9 + i) * kLanes] = 0;
    }
    row[12 * kLanes] = 0;  // inertia alone bounds the pivots
}

void set_load(const SoftBody& body, SoftBodyState& state, int vertex, const Vec3f& load_n,
              const Vec3f& k_n_m, const Vec3f& anchor_m) noexcept {
    float* row = spring_of(body, state, vertex);
    // What set_load() leaves alone is that of a spring without stiffness.
    assert(row[1 * kLanes] == 0 && row[2 * kLanes] == 0 && row[4 * kLanes] == 0);
    const auto set = [row](int r, float value) { row[r * kLanes] = value; };
    set(0, k_n_m.x());
    set(3, k_n_m.y());
    set(5, k_n_m.z());
    for (int i = 0; i < 3; ++i) {
        set(6 + i, anchor_m[i]);
        set(9 + i, -load_n[i]);
    }
    set(12, k_n_m.minCoeff());
}

uint64_t state_hash(const SoftBodyState& state) noexcept {
    // A new field does not compile before it is said here whether it counts.
    const auto& [x, v, x_start, tet_alive, contact_vertex, free_vertex, tether_alive,
                 tether_lambda_n, force_n, pushed, x_low, x_start_low, lanes, springs, scratch,
                 seen_tet, topology, awake, roused, roused_count, flags, backward] = state;
    const auto without = [](const auto&...) {};
    FnvHash hash;
    for (size_t i = 0; i < x.size(); ++i) {
        hash.bytes(&x[i], sizeof(Float4));
        hash.bytes(&v[i], 3 * sizeof(float));
    }
    hash.bytes(tet_alive.data(), tet_alive.size());
    hash.bytes(tether_alive.data(), tether_alive.size());
    without(x_start, contact_vertex, free_vertex, tether_lambda_n, force_n, pushed, x_low,
            x_start_low, lanes, springs, scratch, seen_tet, topology, awake, roused, roused_count,
            flags, backward);
    return hash.value();
}

}  // namespace placode::sim
