// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout_parts.h"

#include <algorithm>

#include "sim/solver/sweep_plan.h"

namespace placode::sim {
namespace {

/// First step of the lane that loads `vertex`, -1 = none. Padding steps load the vertex itself.
int64_t step_of(const KernelLayout& packed, const VertexBatch& b, size_t lane,
                int32_t vertex) noexcept {
    const auto wanted = static_cast<uint16_t>(2 * (vertex - b.base));
    for (int64_t s = 0; s < b.steps; ++s) {
        if (packed.strip[as_index(b.step_start + s) * kLanes + lane] == wanted) return s;
    }
    return -1;
}

void add_tet_batch(const SoftBody& body, KernelLayout& out, std::span<const int32_t> members,
                   bool apart) {
    TetBatch b;
    b.apart = apart;
    b.count = static_cast<int32_t>(members.size());
    b.base = body.vertex_count();
    int32_t last = 0;
    for (const int32_t t : members) {
        for (const int32_t v : body.mesh().tets[as_index(t)]) {
            b.base = std::min(b.base, v);
            last = std::max(last, v);
        }
    }
    check_span(b.base, last);
    const size_t index = out.tet_index.size(), rows = out.tet_rows.size();
    out.tet_index.resize(index + 4 * kLanes);
    out.tet_rows.resize(rows + kTetRows * kLanes);
    out.lane_count += kLanes;  // unused lanes keep 0: switched off
    for (size_t lane = 0; lane < kLanes; ++lane) {
        const int32_t t = members[lane < members.size() ? lane : 0];
        for (size_t k = 0; k < 4; ++k) {
            out.tet_index[index + kLanes * k + lane] =
                static_cast<uint16_t>(2 * (body.mesh().tets[as_index(t)][k] - b.base));
        }
        write_tet_row(tet_constants(body.spec(), t), out.tet_rows.data() + rows + lane);
        if (lane < members.size()) {
            out.tet_slot[as_index(t)] =
                static_cast<int32_t>(out.tet_batches.size() * kLanes + lane);
        }
    }
    out.tet_batches.push_back(b);
}

}  // namespace

void write_tet_row(const TetConstants& constants, float* row) noexcept {
    // b_1.b_1 b_2.b_2 b_3.b_3 b_1.b_2 b_1.b_3 b_2.b_3 from a_ij = -b_i.b_j.
    const auto& e = constants.a;
    const std::array<double, 6> dots{
        e[0] + e[3] + e[4], e[1] + e[3] + e[5], e[2] + e[4] + e[5], -e[3], -e[4], -e[5]};
    for (size_t k = 0; k < 6; ++k) row[kLanes * k] = static_cast<float>(dots[k]);
    row[size_t{kLanes} * 6] = static_cast<float>(1 / (6 * constants.volume_m3));
    row[size_t{kLanes} * 7] = static_cast<float>(constants.material.gamma - 1);
}

void set_vertex_weights(const SoftBody& body, const KernelLayout& packed,
                        std::span<const uint8_t> tet_alive, int v, float* lanes) noexcept {
    const VertexBatch& b = packed.batches[as_index(packed.slot[as_index(v)] / kLanes)];
    const size_t lane = as_index(packed.slot[as_index(v)] % kLanes);
    float* rows = lanes + b.lane_start + lane;
    for (int64_t s = 0; s < b.steps; ++s) rows[kLanes * (1 + 3 * s)] = 0.0F;
    // Neighbour by neighbour in the order of their first step, each sum in double and in tet order.
    double total = 0;
    for (int64_t s = 0; s < b.steps; ++s) {
        const int32_t other = b.base + packed.strip[as_index(b.step_start + s) * kLanes + lane] / 2;
        if (other == v || step_of(packed, b, lane, other) != s) continue;
        double sum = 0;
        for (const int32_t t : body.tets_of(v)) {
            if (!tet_alive.empty() && tet_alive[as_index(t)] == 0) continue;
            const auto& tet = body.mesh().tets[as_index(t)];
            const auto me = corner_of(tet, v);
            const auto it = corner_of(tet, other);
            if (it < 4) sum += packed.edge_weight_n_m[6 * as_index(t) + as_index(kEdge[me][it])];
        }
        rows[kLanes * (1 + 3 * s)] = static_cast<float>(sum);
        total += sum;
    }
    rows[0] = static_cast<float>(std::max(total, 0.0));
}

void pack_tets(const SoftBody& body, KernelLayout& out) {
    const SweepPlan plan =
        plan_tets(body.mesh().tets, body.vertex_count(), domains_for(body.tet_count()));
    out.tet_slot.resize(as_index(body.tet_count()));
    out.tet_lane_start = out.lane_count;
    for (size_t b = 0; b < plan.batches.size(); ++b) {
        add_tet_batch(body, out, plan.batches[b], plan.apart[b] != 0);
    }
    out.tet_job_start = plan.job_start;
    out.tet_phase_start = plan.phase_start;
    if (body.spec().solver.iterations > 1) {
        out.tet_lambda_start = out.lane_count;
        out.lane_count += static_cast<int64_t>(out.tet_batches.size()) * 2 * kLanes;
        out.spring_sum_start = out.lane_count;
        out.lane_count += static_cast<int64_t>(out.springs.size()) / kSpringRows * 3;
    }
}

}  // namespace placode::sim
