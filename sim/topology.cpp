// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/topology.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "sim/bounded_strip.h"
#include "sim/event.h"

namespace placode::sim {
namespace {

constexpr int kSpareSteps = 48;   // strip steps of a batch of copies
constexpr int kFarthest = 32767;  // 16-bit offsets in steps of 8 bytes

size_t at(int64_t i) { return static_cast<size_t>(i); }

/// Room for the strip of a vertex whose surroundings are cut: the strip of a torn link is longer.
int32_t room_for(int32_t steps) { return steps + steps / 2 + 6; }

/// Lays the batches out anew: room behind every strip, empty batches behind all others.
class Relayout {
 public:
    Relayout(const SoftBody& body, Topology& out) : body_(body), from_(body.packed()), out_(out) {}

    void run() {
        PackedElements& to = out_.packed;
        to = from_;
        to.batches.clear();
        to.strip.clear();
        to.keep.clear();
        const size_t tail = from_.batches.empty() ? 0 : end_of_lanes(from_.batches.back());
        to.lane_count = 0;
        for (const VertexBatch& b : from_.batches) copy(b);
        add_pool();
        move_tail(tail);
        to.lane_count += 2 * kLanes;  // for corners that found no room
        to.slot.resize(out_.origin.size(), -1);
        to.damping_per_s.resize(out_.origin.size(), 0.0F);
        // No tethers at copies.
        to.tether_start.resize(out_.origin.size() + 1, to.tether_start.back());
    }

 private:
    static size_t end_of_lanes(const VertexBatch& b) {
        return at(b.lane_start) + at(kLanes) * at(1 + 3 * b.steps);
    }

    /// Enough for every spare vertex, however the copies fall upon jobs and colours.
    void add_pool() {
        PackedElements& to = out_.packed;
        const auto jobs = to.job_start.size() - 1;
        const int colours = 1 + *std::max_element(to.colour.begin(), to.colour.end());
        const int spares = static_cast<int>(out_.origin.size()) - body_.vertex_count();
        const int pool = std::min(spares, spares / kLanes + static_cast<int>(jobs) * colours);
        out_.pool_first = static_cast<int32_t>(to.batches.size());
        for (int i = 0; i < pool; ++i) add_spare();
        out_.pool_next.assign(at(pool), -1);
        out_.pool_colour.assign(at(pool), -1);
        out_.job_first.assign(jobs, -1);
        out_.job_last.assign(jobs, -1);
    }

    void add_room(VertexBatch& b, int32_t capacity) {
        PackedElements& to = out_.packed;
        b.step_start = static_cast<int64_t>(to.keep.size());
        b.lane_start = to.lane_count;
        to.keep.resize(to.keep.size() + at(capacity), 0);
        to.strip.resize(to.keep.size() * kLanes, 0);
        to.lane_count += kLanes * (1 + 3 * capacity);
        out_.capacity.push_back(capacity);
        to.batches.push_back(b);
    }

    void copy(const VertexBatch& old) {
        PackedElements& to = out_.packed;
        VertexBatch b = old;
        add_room(b, room_for(old.steps));
        const VertexBatch& now = to.batches.back();
        std::copy_n(from_.keep.begin() + old.step_start, old.steps,
                    to.keep.begin() + now.step_start);
        std::copy_n(from_.strip.begin() + old.step_start * kLanes, old.steps * kLanes,
                    to.strip.begin() + now.step_start * kLanes);
        // Steps that nobody uses yet load the vertex itself.
        for (int32_t s = old.steps; s < out_.capacity.back(); ++s) {
            std::copy_n(old.self.begin(), kLanes, to.strip.begin() + (now.step_start + s) * kLanes);
        }
        for (int lane = 0; lane < old.count; ++lane) {
            const int32_t v = old.vertex[at(lane)];
            to.slot[at(v)] = static_cast<int32_t>((to.batches.size() - 1) * kLanes) + lane;
            for (const int32_t t : body_.tets_of(v)) {
                const auto& tet = body_.mesh().tets[at(t)];
                const size_t k = at(std::find(tet.begin(), tet.end(), v) - tet.begin());
                to.corner_lane[4 * at(t) + k] +=
                    static_cast<int32_t>(now.lane_start - old.lane_start);
            }
        }
    }

    void add_spare() {
        VertexBatch b;
        b.spring_start = -1;
        b.limit_m.fill(std::numeric_limits<float>::infinity());
        b.mass_kg.fill(1.0F);
        add_room(b, kSpareSteps);
    }

    /// What XPBD keeps behind the batches.
    void move_tail(size_t tail) {
        PackedElements& to = out_.packed;
        const int64_t shift = to.lane_count - static_cast<int64_t>(tail);
        to.lane_count += from_.lane_count - static_cast<int64_t>(tail);
        if (!to.tet_slot.empty()) to.tet_lane_start += shift;
        if (to.tet_lambda_start >= 0) to.tet_lambda_start += shift;
        if (to.spring_sum_start >= 0) to.spring_sum_start += shift;
    }

    const SoftBody& body_;
    const PackedElements& from_;
    Topology& out_;
};

size_t corner_of(const std::array<int32_t, 4>& tet, int32_t v) noexcept {
    return at(std::find(tet.begin(), tet.end(), v) - tet.begin());
}

void mark(Topology& topology, int32_t v) noexcept {
    if (topology.is_dirty[at(v)] != 0) return;
    topology.is_dirty[at(v)] = 1;
    topology.dirty[at(topology.dirty_count++)] = v;
}

/// A lane for a copy of `vertex`, among other copies of its job and colour; -1 when there is none.
int32_t new_lane(Topology& top, int32_t vertex) noexcept {
    const PackedElements& packed = top.packed;
    const int32_t job = packed.job[at(top.origin[at(vertex)])];
    const int32_t colour = packed.colour[at(top.origin[at(vertex)])];
    if (job < 0) return -1;
    for (int32_t p = top.job_first[at(job)]; p >= 0; p = top.pool_next[at(p)]) {
        const int32_t batch = top.pool_first + p, count = packed.batches[at(batch)].count;
        if (top.pool_colour[at(p)] == colour && count < kLanes) return batch * kLanes + count;
    }
    if (at(top.pool_used) == top.pool_next.size()) return -1;
    const int32_t fresh = top.pool_used++, last = top.job_last[at(job)];
    (last < 0 ? top.job_first[at(job)] : top.pool_next[at(last)]) = fresh;
    top.job_last[at(job)] = fresh;
    top.pool_colour[at(fresh)] = colour;
    return (top.pool_first + fresh) * kLanes;
}

void fill_mass(const SoftBody& body, Topology& topology, int32_t v) noexcept {
    double mass = 0;
    for (int i = 0; i < topology.count[at(v)]; ++i) {
        const auto t = at(topology.around[at(topology.first[at(v)] + i)]);
        const auto& m = body.spec().materials[at(static_cast<int>(body.mesh().tissue[t]))];
        // Dead tets count: their mass stays with their vertices.
        mass += m.density_kg_m3 * static_cast<double>(body.volume_m3()[t]) / 4;
    }
    topology.mass_kg[at(v)] = static_cast<float>(mass);
    const int32_t slot = topology.packed.slot[at(v)];
    topology.packed.batches[at(slot / kLanes)].mass_kg[at(slot % kLanes)] = topology.mass_kg[at(v)];
}

/// lambda V r^2 and 6 V gamma of the tets around v, as its lane has them.
struct CornerConstants {
    float stiffness = 0, rest = 0;
};

/// Writes strip and constants of a vertex into its lane.
void rebuild(SoftBodyState& state, Topology& topology, int32_t v) noexcept {
    PackedElements& packed = topology.packed;
    std::array<LinkTriangle, kMostAround> link;
    std::array<CornerConstants, kMostAround> constants;
    size_t n = 0;
    for (int i = 0; i < topology.count[at(v)]; ++i) {
        const int32_t t = topology.around[at(topology.first[at(v)] + i)];
        if (state.tet_alive[at(t)] == 0) continue;
        const auto& tet = topology.tets[at(t)];
        const size_t k = corner_of(tet, v);
        const auto& o = kOpposite[k];
        link[n] = {{tet[at(o[0])], tet[at(o[1])], tet[at(o[2])]}, static_cast<int32_t>(n)};
        const int64_t lane = packed.corner_lane[4 * at(t) + k];
        constants[n] = {state.lanes[at(lane)], std::abs(state.lanes[at(lane + kLanes)])};
        ++n;
    }
    BoundedStrip strip;
    strip.build({link.data(), n});
    const int32_t slot = packed.slot[at(v)];
    VertexBatch& b = packed.batches[at(slot / kLanes)];
    const size_t lane = at(slot % kLanes);
    if (strip.size() > topology.capacity[at(slot / kLanes)]) {
        ++topology.refused;  // the vertex keeps what fits; tests show that this does not happen
        state.flags |= kCutRefused;
    }
    const auto nowhere = static_cast<int32_t>(state.lanes.size()) - 2 * kLanes;
    const int32_t steps =
        std::min<int32_t>(static_cast<int32_t>(strip.size()), topology.capacity[at(slot / kLanes)]);
    b.steps = std::max(b.steps, steps);
    float* row = state.lanes.data() + b.lane_start + lane;
    const auto bit = static_cast<uint16_t>(1U << lane);
    const auto self = static_cast<uint16_t>(2 * (v - b.base));
    for (int32_t s = 0; s < topology.capacity[at(slot / kLanes)]; ++s) {
        uint16_t& entry = packed.strip[at(b.step_start + s) * kLanes + lane];
        uint16_t& keep = packed.keep[at(b.step_start + s)];
        float* values = row + kLanes * (1 + 3 * s);
        values[0] = values[kLanes] = values[2 * kLanes] = 0;
        keep = static_cast<uint16_t>(keep & ~bit);
        entry = self;
        if (s >= steps) continue;
        const StripStep& step = strip[s];
        entry = static_cast<uint16_t>(2 * (step.vertex - b.base));
        if (step.keep) keep = static_cast<uint16_t>(keep | bit);
        if (step.tet < 0) continue;
        // Step.tet counts living tets around v: find which one this is.
        const CornerConstants& c = constants[at(step.tet)];
        values[kLanes] = c.stiffness;
        values[2 * kLanes] = static_cast<float>(step.sign) * c.rest;
    }
    // Where each corner now lies.
    n = 0;
    for (int i = 0; i < topology.count[at(v)]; ++i) {
        const int32_t t = topology.around[at(topology.first[at(v)] + i)];
        if (state.tet_alive[at(t)] == 0) continue;
        const size_t k = corner_of(topology.tets[at(t)], v);
        const int64_t step = strip.step_of(n);
        packed.corner_lane[4 * at(t) + k] =
            step < steps ? static_cast<int32_t>(b.lane_start + static_cast<int64_t>(lane) +
                                                kLanes * (2 + 3 * step))
                         : nowhere;
        ++n;
    }
}

}  // namespace

Topology::Topology(const SoftBody& body) {
    const size_t n = at(body.vertex_count()), all = at(body.vertex_capacity());
    if (all > at(kFarthest)) {
        throw MeshError("cutting: " + std::to_string(all) + " vertices with spares, allowed " +
                        std::to_string(kFarthest) + "; take a coarser mesh");
    }
    tets = body.mesh().tets;
    origin.resize(all);
    first.assign(all, 0);
    count.assign(all, 0);
    mass_kg.assign(all, 1.0F);
    is_dirty.assign(all, 0);
    dirty.assign(all, 0);
    whole.assign(n, 0);
    vertices = static_cast<int32_t>(n);
    for (size_t v = 0; v < all; ++v) origin[v] = v < n ? static_cast<int32_t>(v) : 0;
    for (size_t v = 0; v < n; ++v) {
        first[v] = static_cast<int32_t>(around.size());
        const auto list = body.tets_of(static_cast<int>(v));
        around.insert(around.end(), list.begin(), list.end());
        count[v] = static_cast<int32_t>(list.size());
        mass_kg[v] = body.mass_kg()[v];
        if (list.size() > at(kMostAround)) whole[v] = 1;
    }
    for (const int32_t v : body.spec().fixed) whole[at(v)] = 1;
    for (const int32_t v : body.packed().spring_vertices) whole[at(v)] = 1;
    for (const Tether& t : body.spec().tethers) {
        for (const int32_t v : t.vertex) whole[at(v)] = 1;
    }
    for (const SheetTriangle& t : body.spec().sheet) {
        for (const int32_t v : t.vertex) whole[at(v)] = 1;
    }
    Relayout(body, *this).run();
}

int spares_left(const SoftBodyState& state) noexcept {
    if (!state.topology) return 0;
    return static_cast<int>(state.topology->origin.size()) - state.topology->vertices;
}

bool can_split(const SoftBodyState& state, int vertex) noexcept {
    return state.topology && state.topology->whole[at(state.topology->origin[at(vertex)])] == 0;
}

int split_vertex(const SoftBody& body, SoftBodyState& state, int vertex,
                 std::span<const int32_t> moved) noexcept {
    Topology& top = *state.topology;
    PackedElements& packed = top.packed;
    if (spares_left(state) == 0) return -1;
    const int32_t slot = new_lane(top, vertex);
    if (slot < 0) return -1;
    const int32_t copy = top.vertices++;
    const auto old = at(vertex), now = at(copy);
    const bool held = state.x[old].w == 0;
    // The list of the old vertex is divided: what stays, then what goes.
    const auto begin = top.around.begin() + top.first[old];
    std::array<int32_t, kMostAround> goes{};
    int32_t going = 0, stays = 0;
    for (int32_t i = 0; i < top.count[old]; ++i) {
        const int32_t t = begin[i];
        if (std::find(moved.begin(), moved.end(), t) != moved.end()) {
            goes[at(going++)] = t;
        } else {
            begin[stays++] = t;
        }
    }
    std::copy_n(goes.begin(), going, begin + stays);
    top.first[now] = top.first[old] + stays;
    top.count[now] = going;
    top.count[old] = stays;
    top.origin[now] = top.origin[old];
    for (int32_t i = 0; i < going; ++i) {
        auto& tet = top.tets[at(goes[at(i)])];
        tet[corner_of(tet, vertex)] = copy;
        for (const int32_t other : tet) mark(top, other);
        if (packed.tet_slot.empty()) continue;
        const int32_t place = packed.tet_slot[at(goes[at(i)])];
        const size_t k = corner_of(tet, copy);
        packed.tet_index[(at(place / kLanes) * 4 + k) * kLanes + at(place % kLanes)] =
            static_cast<uint16_t>(2 * (copy - packed.tet_batches[at(place / kLanes)].base));
    }
    mark(top, vertex);
    state.x[now] = state.x[old];
    state.v[now] = state.v[old];
    state.x_start[now] = state.x_start[old];
    state.free_vertex[now] = state.free_vertex[old];
    packed.damping_per_s[now] = packed.damping_per_s[old];
    packed.slot[now] = slot;
    VertexBatch& b = packed.batches[at(slot / kLanes)];
    const size_t lane = at(slot % kLanes);
    if (b.count == 0) {  // unused lanes of a batch repeat its first
        b.vertex.fill(copy);
        b.self.fill(static_cast<uint16_t>(2 * copy));
        std::fill_n(packed.strip.begin() + b.step_start * kLanes,
                    at(top.capacity[at(slot / kLanes)]) * kLanes, b.self[0]);
    }
    b.vertex[lane] = copy;
    b.self[lane] = static_cast<uint16_t>(2 * copy);
    b.limit_m[lane] = body.shortest_edge_m()[at(top.origin[now])] / 4;
    ++b.count;
    fill_mass(body, top, vertex);
    fill_mass(body, top, copy);
    if (!held) {
        state.x[old].w = 1.0F / top.mass_kg[old];
        state.x[now].w = 1.0F / top.mass_kg[now];
    }
    return copy;
}

void repack(SoftBodyState& state) noexcept {
    if (!state.topology || state.topology->dirty_count == 0) return;
    Topology& top = *state.topology;
    // A copy reads its constants where the old vertex had them: copies, the later ones, go first.
    std::sort(top.dirty.begin(), top.dirty.begin() + top.dirty_count, std::greater<>());
    for (int32_t i = 0; i < top.dirty_count; ++i) {
        const int32_t v = top.dirty[at(i)];
        rebuild(state, top, v);
        top.is_dirty[at(v)] = 0;
    }
    for (int32_t i = 0; i < top.dirty_count; ++i) reweigh(state, top.dirty[at(i)]);
    top.dirty_count = 0;
}

void reweigh(SoftBodyState& state, int vertex) noexcept {
    const Topology& top = *state.topology;
    const PackedElements& packed = top.packed;
    const auto v = at(vertex);
    const VertexBatch& b = packed.batches[at(packed.slot[v] / kLanes)];
    const size_t lane = at(packed.slot[v] % kLanes);
    float* rows = state.lanes.data() + b.lane_start + lane;
    const auto entry = [&](int32_t s) {
        return packed.strip[at(b.step_start + s) * kLanes + lane];
    };
    double total = 0;
    for (int32_t s = 0; s < b.steps; ++s) {
        float& weight = rows[kLanes * (1 + 3 * s)];
        weight = 0;
        const int32_t other = b.base + entry(s) / 2;
        if (other == vertex) continue;
        bool seen = false;
        for (int32_t p = 0; p < s && !seen; ++p) seen = entry(p) == entry(s);
        if (seen) continue;
        double sum = 0;
        for (int32_t i = 0; i < top.count[v]; ++i) {
            const int32_t t = top.around[at(top.first[v] + i)];
            if (state.tet_alive[at(t)] == 0) continue;
            const auto& tet = top.tets[at(t)];
            const size_t it = corner_of(tet, other);
            if (it < 4) {
                sum += static_cast<double>(
                    packed.edge_weight_n_m[6 * at(t) + at(kEdge[corner_of(tet, vertex)][it])]);
            }
        }
        weight = static_cast<float>(sum);
        total += sum;
    }
    rows[0] = static_cast<float>(std::max(total, 0.0));
}

}  // namespace placode::sim
