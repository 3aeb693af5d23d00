// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where a body that can be cut keeps its elements: as packed, with room to grow.
#include <algorithm>
#include <limits>

#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout_parts.h"
#include "sim/solver/topology.h"

namespace placode::sim {
namespace {

constexpr int kSpareSteps = 48;   // strip steps of a batch of copies
constexpr int kFarthest = 32767;  // 16-bit offsets in steps of 8 bytes

/// Room for the strip of a vertex whose surroundings are cut: the strip of a torn link is longer.
int32_t room_for(int32_t steps) { return steps + steps / 2 + 6; }

/// Lays the batches out anew: room behind every strip, empty batches behind all others.
class Relayout {
 public:
    Relayout(const SoftBody& body, Topology& out) : body_(body), from_(body.packed()), out_(out) {}

    void run() {
        KernelLayout& to = out_.packed;
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
        give_back_slack(to);
    }

 private:
    static size_t end_of_lanes(const VertexBatch& b) {
        return as_index(b.lane_start) + as_index(kLanes) * as_index(1 + 3 * b.steps);
    }

    /// Enough for every spare vertex, however the copies fall upon jobs and colours.
    void add_pool() {
        KernelLayout& to = out_.packed;
        const auto jobs = to.job_start.size() - 1;
        const int colours = 1 + *std::max_element(to.colour.begin(), to.colour.end());
        const int spares = static_cast<int>(out_.origin.size()) - body_.vertex_count();
        const int pool = std::min(spares, spares / kLanes + static_cast<int>(jobs) * colours);
        out_.pool_first = static_cast<int32_t>(to.batches.size());
        for (int i = 0; i < pool; ++i) add_spare();
        out_.pool_next.assign(as_index(pool), -1);
        out_.pool_colour.assign(as_index(pool), -1);
        out_.job_first.assign(jobs, -1);
        out_.job_last.assign(jobs, -1);
    }

    void add_room(VertexBatch& b, int32_t capacity) {
        KernelLayout& to = out_.packed;
        b.step_start = static_cast<int64_t>(to.keep.size());
        b.lane_start = to.lane_count;
        to.keep.resize(to.keep.size() + as_index(capacity), 0);
        to.strip.resize(to.keep.size() * kLanes, 0);
        to.lane_count += kLanes * (1 + 3 * capacity);
        out_.capacity.push_back(capacity);
        to.batches.push_back(b);
    }

    void copy(const VertexBatch& old) {
        KernelLayout& to = out_.packed;
        VertexBatch b = old;
        add_room(b, has_strips(from_) ? room_for(old.steps) : 0);
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
            const int32_t v = old.vertex[as_index(lane)];
            to.slot[as_index(v)] = static_cast<int32_t>((to.batches.size() - 1) * kLanes) + lane;
            if (!has_strips(from_)) continue;
            for (const int32_t t : body_.tets_of(v)) {
                const auto& tet = body_.mesh().tets[as_index(t)];
                const size_t k = corner_of(tet, v);
                to.corner_lane[4 * as_index(t) + k] +=
                    static_cast<int32_t>(now.lane_start - old.lane_start);
            }
        }
    }

    void add_spare() {
        VertexBatch b;
        b.spring_start = -1;
        b.limit_m.fill(std::numeric_limits<float>::infinity());
        b.mass_kg.fill(1.0F);
        add_room(b, has_strips(from_) ? kSpareSteps : 0);
    }

    /// What XPBD keeps behind the batches.
    void move_tail(size_t tail) {
        KernelLayout& to = out_.packed;
        const int64_t shift = to.lane_count - static_cast<int64_t>(tail);
        to.lane_count += from_.lane_count - static_cast<int64_t>(tail);
        if (!to.tet_slot.empty()) to.tet_lane_start += shift;
        if (to.tet_lambda_start >= 0) to.tet_lambda_start += shift;
        if (to.spring_sum_start >= 0) to.spring_sum_start += shift;
    }

    const SoftBody& body_;
    const KernelLayout& from_;
    Topology& out_;
};

}  // namespace

Topology::Topology(const SoftBody& body) {
    const size_t n = as_index(body.vertex_count()), all = as_index(body.vertex_capacity());
    if (all > as_index(kFarthest)) {
        throw MeshError("cutting: " + std::to_string(all) + " vertices with spares, allowed " +
                        std::to_string(kFarthest) + "; take a coarser mesh");
    }
    tets = body.mesh().tets;
    origin.resize(all);
    first.assign(all, 0);
    count.assign(all, 0);
    mass_kg.assign(all, 1.0F);
    rest = body.mesh().rest;
    rest.resize(all, Vec3::Zero());
    volume_m3.assign(body.volume_m3().begin(), body.volume_m3().end());
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
        if (list.size() > as_index(kMostAround)) whole[v] = 1;
    }
    for (const int32_t v : body.spec().fixed) whole[as_index(v)] = 1;
    for (const int32_t v : body.packed().spring_vertices) whole[as_index(v)] = 1;
    for (const Tether& t : body.spec().tethers) {
        for (const int32_t v : t.vertex) whole[as_index(v)] = 1;
    }
    for (const SheetTriangle& t : body.spec().sheet) {
        for (const int32_t v : t.vertex) whole[as_index(v)] = 1;
    }
    Relayout(body, *this).run();
}

}  // namespace placode::sim
