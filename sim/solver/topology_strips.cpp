// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The strips of VBD over the links of vertices whose surroundings were cut.
#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/solver/bounded_strip.h"
#include "sim/solver/kernel_layout_parts.h"
#include "sim/solver/topology.h"

namespace placode::sim {
namespace {

constexpr size_t kTwice = size_t{2} * kLanes;

/// lambda V r^2 and 6 V gamma of the tets around v, as its lane has them.
struct CornerConstants {
    float stiffness = 0, rest = 0;
};

/// The link of a vertex, and of each of its triangles the constants of the tet.
struct CutLink {
    std::array<LinkTriangle, kMostAround> triangle;
    std::array<CornerConstants, kMostAround> constants;
    size_t count = 0;
};

/// Calls `visit` with every living tet around v and v's corner of it, always in the same order.
template <class Visit>
void each_living(const SoftBodyState& state, const Topology& topology, int32_t v,
                 const Visit& visit) noexcept {
    for (int i = 0; i < topology.count[as_index(v)]; ++i) {
        const int32_t t = topology.around[as_index(topology.first[as_index(v)] + i)];
        if (state.tet_alive[as_index(t)] == 0) continue;
        visit(t, corner_of(topology.tets[as_index(t)], v));
    }
}

void read_link(const SoftBodyState& state, const Topology& topology, int32_t v,
               CutLink& link) noexcept {
    each_living(state, topology, v, [&](int32_t t, size_t k) noexcept {
        const auto& tet = topology.tets[as_index(t)];
        const auto& o = kOpposite[k];
        link.triangle[link.count] = {
            {tet[as_index(o[0])], tet[as_index(o[1])], tet[as_index(o[2])]},
            static_cast<int32_t>(link.count)};
        const int64_t lane = topology.packed.corner_lane[4 * as_index(t) + k];
        link.constants[link.count] = {state.lanes[as_index(lane)],
                                      std::abs(state.lanes[as_index(lane + kLanes)])};
        ++link.count;
    });
}

/// The first `steps` of a strip into the lane of v, nothing behind them.
void write_steps(SoftBodyState& state, Topology& topology, int32_t v, const BoundedStrip& strip,
                 int32_t steps, const CutLink& link) noexcept {
    KernelLayout& packed = topology.packed;
    const int32_t slot = packed.slot[as_index(v)];
    const VertexBatch& b = packed.batches[as_index(slot / kLanes)];
    const size_t lane = as_index(slot % kLanes);
    float* row = state.lanes.data() + b.lane_start + lane;
    const auto bit = static_cast<uint16_t>(1U << lane);
    const auto self = static_cast<uint16_t>(2 * (v - b.base));
    for (int32_t s = 0; s < topology.capacity[as_index(slot / kLanes)]; ++s) {
        uint16_t& entry = packed.strip[as_index(b.step_start + s) * kLanes + lane];
        uint16_t& keep = packed.keep[as_index(b.step_start + s)];
        float* values = row + as_index(kLanes) * as_index(1 + 3 * s);
        values[0] = values[kLanes] = values[kTwice] = 0;
        keep = static_cast<uint16_t>(keep & ~bit);
        entry = self;
        if (s >= steps) continue;
        const StripStep& step = strip[s];
        entry = static_cast<uint16_t>(2 * (step.vertex - b.base));
        if (step.keep) keep = static_cast<uint16_t>(keep | bit);
        if (step.tet < 0) continue;
        // Step.tet counts living tets around v: find which one this is.
        const CornerConstants& c = link.constants[as_index(step.tet)];
        values[kLanes] = c.stiffness;
        values[kTwice] = static_cast<float>(step.sign) * c.rest;
    }
}

/// Writes strip and constants of a vertex into its lane.
void rebuild(SoftBodyState& state, Topology& topology, int32_t v) noexcept {
    KernelLayout& packed = topology.packed;
    CutLink link;
    read_link(state, topology, v, link);
    BoundedStrip strip;
    strip.build({link.triangle.data(), link.count});
    const int32_t slot = packed.slot[as_index(v)];
    const int32_t capacity = topology.capacity[as_index(slot / kLanes)];
    VertexBatch& b = packed.batches[as_index(slot / kLanes)];
    if (strip.size() > capacity) {
        ++topology.refused;  // the vertex keeps what fits; tests show that this does not happen
        state.flags |= kCutRefused;
    }
    const int32_t steps = std::min<int32_t>(static_cast<int32_t>(strip.size()), capacity);
    b.steps = std::max(b.steps, steps);
    write_steps(state, topology, v, strip, steps, link);
    // Where each corner now lies.
    const auto nowhere = static_cast<int32_t>(state.lanes.size()) - 2 * kLanes;
    const int64_t first = b.lane_start + static_cast<int64_t>(slot % kLanes);
    size_t n = 0;
    each_living(state, topology, v, [&](int32_t t, size_t k) noexcept {
        const int64_t step = strip.step_of(n++);
        packed.corner_lane[4 * as_index(t) + k] =
            step < steps ? static_cast<int32_t>(first + kLanes * (2 + 3 * step)) : nowhere;
    });
}

}  // namespace

void repack(SoftBodyState& state) noexcept {
    if (!state.topology || state.topology->dirty_count == 0) return;
    Topology& top = *state.topology;
    // A copy reads its constants where the old vertex had them: copies, the later ones, go first.
    std::sort(top.dirty.begin(), top.dirty.begin() + top.dirty_count, std::greater<>());
    for (int32_t i = 0; i < top.dirty_count; ++i) {
        const int32_t v = top.dirty[as_index(i)];
        if (has_strips(top.packed)) rebuild(state, top, v);
        top.is_dirty[as_index(v)] = 0;
    }
    for (int32_t i = 0; i < top.dirty_count; ++i) reweigh(state, top.dirty[as_index(i)]);
    top.dirty_count = 0;
}

void reweigh(SoftBodyState& state, int vertex) noexcept {
    const Topology& top = *state.topology;
    const KernelLayout& packed = top.packed;
    const auto v = as_index(vertex);
    const VertexBatch& b = packed.batches[as_index(packed.slot[v] / kLanes)];
    const size_t lane = as_index(packed.slot[v] % kLanes);
    float* rows = state.lanes.data() + b.lane_start + lane;
    const auto entry = [&](int32_t s) {
        return packed.strip[as_index(b.step_start + s) * kLanes + lane];
    };
    double total = 0;
    for (int32_t s = 0; s < b.steps; ++s) {
        float& weight = rows[as_index(kLanes) * as_index(1 + 3 * s)];
        weight = 0;
        const int32_t other = b.base + entry(s) / 2;
        if (other == vertex) continue;
        bool seen = false;
        for (int32_t p = 0; p < s && !seen; ++p) seen = entry(p) == entry(s);
        if (seen) continue;
        double sum = 0;
        for (int32_t i = 0; i < top.count[v]; ++i) {
            const int32_t t = top.around[as_index(top.first[v] + i)];
            if (state.tet_alive[as_index(t)] == 0) continue;
            const auto& tet = top.tets[as_index(t)];
            const size_t it = corner_of(tet, other);
            if (it < 4) {
                sum += static_cast<double>(
                    packed.edge_weight_n_m[6 * as_index(t) +
                                           as_index(kEdge[corner_of(tet, vertex)][it])]);
            }
        }
        weight = static_cast<float>(sum);
        total += sum;
    }
    rows[0] = static_cast<float>(std::max(total, 0.0));
}

}  // namespace placode::sim
