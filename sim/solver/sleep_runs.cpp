// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/sleep_runs.h"

#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout.h"
#include "sim/solver/topology.h"

namespace placode::sim {
namespace {

bool batch_awake(const Sleep& sleep, const VertexBatch& batch) noexcept {
    for (int lane = 0; lane < batch.count; ++lane) {
        const int32_t v = batch.vertex[as_index(lane)];
        if (v >= static_cast<int32_t>(sleep.block.size())) return true;  // a copy
        const int32_t block = sleep.block[as_index(v)];
        if (block < 0 || sleep.asleep[as_index(block)] == 0) return true;
    }
    return false;
}

void mark_leaves(Sleep& sleep) noexcept {
    for (size_t n = 0; n + 1 < sleep.leaf_start.size(); ++n) {
        uint8_t moves = 0;
        for (int32_t i = sleep.leaf_start[n]; i < sleep.leaf_start[n + 1]; ++i) {
            const int32_t b = sleep.leaf_block[as_index(i)];
            if (b == sleep.blocks() || sleep.asleep[as_index(b)] == 0) moves = 1;
        }
        sleep.leaf_moves[n] = moves;
    }
}

/// Appends [first, last) to the runs that begin at `from`, or lengthens the last of them.
void add_run(std::vector<AwakeRuns::Run>& runs, int32_t from, int32_t first,
             int32_t last) noexcept {
    if (static_cast<int32_t>(runs.size()) > from && runs.back()[1] == first)
        runs.back()[1] = last;
    else
        runs.push_back({first, last});
}

void keep_awake(Sleep& sleep, int32_t v) noexcept {
    sleep.chunk[as_index(v / kChunk)] = 1;
    sleep.vertex_asleep[as_index(v)] = 0;
}

/// VBD solves whole batches: all of their vertices are awake.
void set_vertex_jobs(const KernelLayout& packed, AwakeRuns& awake, Sleep& sleep) noexcept {
    for (size_t j = 0; j + 1 < packed.job_start.size(); ++j) {
        const auto first_run = static_cast<int32_t>(awake.batches.size());
        awake.job_start[j] = first_run;
        for (int32_t b = packed.job_start[j]; b < packed.job_start[j + 1]; ++b) {
            const VertexBatch& batch = packed.batches[as_index(b)];
            if (!batch_awake(sleep, batch)) continue;
            for (int lane = 0; lane < batch.count; ++lane)
                keep_awake(sleep, batch.vertex[as_index(lane)]);
            add_run(awake.batches, first_run, b, b + 1);
        }
    }
    awake.job_start.back() = static_cast<int32_t>(awake.batches.size());
    // Behind the last job the sheet, while it is awake.
    const auto& sheet = packed.sheet_strips.batches;
    if (sheet.empty()) return;
    const int32_t own =
        sleep.block[as_index(packed.batches[as_index(sheet.front().batch)].vertex[0])];
    if (own >= 0 && sleep.asleep[as_index(own)] != 0) return;
    for (int32_t i = own < 0 ? 0 : sleep.member_start[as_index(own)];
         own >= 0 && i < sleep.member_start[as_index(own) + 1]; ++i)
        keep_awake(sleep, sleep.member[as_index(i)]);
    awake.batches.push_back({sheet.front().batch, sheet.back().batch + 1});
}

/// XPBD solves batches of tets with a vertex that is awake, and the springs of batches likewise.
void set_tet_jobs(const KernelLayout& packed, AwakeRuns& awake, Sleep& sleep) noexcept {
    std::fill(sleep.tets_move.begin(), sleep.tets_move.end(), uint8_t{0});
    for (int b = 0; b <= sleep.blocks(); ++b) {
        if (b < sleep.blocks() && sleep.asleep[as_index(b)] != 0) continue;
        for (int32_t i = sleep.tets_start[as_index(b)]; i < sleep.tets_start[as_index(b) + 1]; ++i)
            sleep.tets_move[as_index(sleep.tets[as_index(i)])] = 1;
        if (b == sleep.blocks()) continue;
        for (int32_t i = sleep.member_start[as_index(b)]; i < sleep.member_start[as_index(b) + 1];
             ++i)
            keep_awake(sleep, sleep.member[as_index(i)]);
    }
    awake.tets.clear();
    for (size_t j = 0; j + 1 < packed.tet_job_start.size(); ++j) {
        const auto first_run = static_cast<int32_t>(awake.tets.size());
        awake.tet_job_start[j] = first_run;
        for (int32_t b = packed.tet_job_start[j]; b < packed.tet_job_start[j + 1]; ++b) {
            if (sleep.tets_move[as_index(b)] != 0) add_run(awake.tets, first_run, b, b + 1);
        }
    }
    awake.tet_job_start.back() = static_cast<int32_t>(awake.tets.size());
    for (int32_t b = 0; b < static_cast<int32_t>(packed.batches.size()); ++b) {
        const VertexBatch& batch = packed.batches[as_index(b)];
        if (batch.spring_start >= 0 && batch_awake(sleep, batch))
            add_run(awake.batches, 0, b, b + 1);
    }
}

/// XPBD: the members of sleeping blocks that meet what is awake in a batch or in a run of vertices.
void set_held(AwakeRuns& awake, const Sleep& sleep) noexcept {
    awake.held.clear();
    for (int b = 0; b < sleep.blocks(); ++b) {
        if (sleep.asleep[as_index(b)] == 0) continue;
        bool meets = false;
        for (int32_t i = sleep.tets_start[as_index(b)];
             i < sleep.tets_start[as_index(b) + 1] && !meets; ++i)
            meets = sleep.tets_move[as_index(sleep.tets[as_index(i)])] != 0;
        for (int32_t i = sleep.member_start[as_index(b)]; i < sleep.member_start[as_index(b) + 1];
             ++i) {
            const int32_t v = sleep.member[as_index(i)];
            if (meets || sleep.chunk[as_index(v / kChunk)] != 0) awake.held.push_back(v);
        }
    }
}

}  // namespace

void set_runs(const SoftBody& body, SoftBodyState& state, Sleep& sleep) noexcept {
    const KernelLayout& packed = packed_of(body, state);
    AwakeRuns& awake = state.awake;
    awake.all = sleep.asleep_count == 0;
    awake.batches.clear();
    awake.vertices.clear();
    std::fill(sleep.chunk.begin(), sleep.chunk.end(), uint8_t{0});
    std::fill(sleep.vertex_asleep.begin(), sleep.vertex_asleep.end(), uint8_t{1});
    const bool tets = !sleep.tets_start.empty();
    if (tets)
        set_tet_jobs(packed, awake, sleep);
    else
        set_vertex_jobs(packed, awake, sleep);
    for (const int32_t v : sleep.unblocked) keep_awake(sleep, v);
    for (int32_t v = body.vertex_count(); v < (state.topology ? state.topology->vertices : 0);
         ++v) {
        keep_awake(sleep, v);
    }
    const auto end = static_cast<int32_t>(state.x.size());
    for (int32_t i = 0; i < static_cast<int32_t>(sleep.chunk.size()); ++i) {
        if (sleep.chunk[as_index(i)] != 0)
            add_run(awake.vertices, 0, kChunk * i, std::min(end, kChunk * (i + 1)));
    }
    if (tets) set_held(awake, sleep);
    for (int b = 0; b < sleep.blocks(); ++b) {
        sleep.near_awake[as_index(b)] = 0;
        if (sleep.asleep[as_index(b)] == 0) continue;
        for (int32_t i = sleep.border_start[as_index(b)]; i < sleep.border_start[as_index(b) + 1];
             ++i) {
            if (sleep.vertex_asleep[as_index(sleep.border[as_index(i)])] == 0)
                sleep.near_awake[as_index(b)] = 1;
        }
    }
    mark_leaves(sleep);
}

}  // namespace placode::sim
