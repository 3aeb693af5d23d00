// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/vertex_plan.h"

#include <algorithm>
#include <numeric>

#include "sim/core/as_index.h"

namespace placode::sim {
namespace {

/// Neighbours of each vertex, ascending, without itself.
class Adjacency {
 public:
    explicit Adjacency(const TetMesh& mesh) : start_(mesh.rest.size() + 1, 0) {
        std::vector<std::vector<int32_t>> around(mesh.rest.size());
        for (const auto& tet : mesh.tets) {
            for (const int32_t a : tet) {
                for (const int32_t b : tet) {
                    if (a != b) around[as_index(a)].push_back(b);
                }
            }
        }
        for (size_t v = 0; v < around.size(); ++v) {
            auto& list = around[v];
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
            all_.insert(all_.end(), list.begin(), list.end());
            start_[v + 1] = static_cast<int32_t>(all_.size());
        }
    }

    [[nodiscard]] std::span<const int32_t> of(size_t v) const {
        return {all_.data() + start_[v], as_index(start_[v + 1] - start_[v])};
    }

 private:
    std::vector<int32_t> start_, all_;
};

std::vector<int32_t> cut_domains(std::span<const int32_t> work, int domains) {
    const int64_t total =
        std::max<int64_t>(1, std::accumulate(work.begin(), work.end(), int64_t{0}));
    std::vector<int32_t> domain(work.size());
    int64_t before = 0;
    for (size_t v = 0; v < work.size(); ++v) {
        domain[v] = static_cast<int32_t>(std::min<int64_t>(before * domains / total, domains - 1));
        before += work[v];
    }
    return domain;
}

/// Job of each vertex as phase * domains + domain; the jobs without vertices are not gone yet.
std::vector<int32_t> place(const Adjacency& near, std::span<const uint8_t> skip,
                           const std::vector<int32_t>& domain, int domains) {
    std::vector<int32_t> job(domain.size(), -1);
    for (size_t v = 0; v < job.size(); ++v) {
        if (skip[v] != 0) continue;
        bool separator = false, met = false;
        for (const int32_t u : near.of(v)) {
            if (skip[as_index(u)] != 0 || domain[as_index(u)] == domain[v]) continue;
            separator |= domain[as_index(u)] > domain[v];
            // Only one of two separators that touch each other stays in phase 1.
            met |= job[as_index(u)] >= domains && job[as_index(u)] < 2 * domains;
        }
        job[v] = !separator ? domain[v] : met ? 2 * domains : domains + domain[v];
    }
    return job;
}

/// Numbers the jobs that have vertices and notes where the phases begin.
std::vector<int32_t> number(std::vector<int32_t>& job, int domains) {
    std::vector<int32_t> name(as_index(2 * domains + 1), -1);
    for (const int32_t j : job) {
        if (j >= 0) name[as_index(j)] = 0;
    }
    std::vector<int32_t> phase_start{0};
    int32_t next = 0;
    for (int32_t j = 0; j <= 2 * domains; ++j) {
        if (name[as_index(j)] == 0) name[as_index(j)] = next++;
        const bool phase_ends = j == 2 * domains || j % domains == domains - 1;
        if (phase_ends && next > phase_start.back()) phase_start.push_back(next);
    }
    for (int32_t& j : job) j = j < 0 ? -1 : name[as_index(j)];
    return phase_start;
}

/// Greedy in index order; only vertices of the same job can be in each other's way.
std::vector<int32_t> colour(const Adjacency& near, const std::vector<int32_t>& job) {
    std::vector<int32_t> colour(job.size(), -1);
    std::vector<uint8_t> taken;
    for (size_t v = 0; v < job.size(); ++v) {
        if (job[v] < 0) continue;
        taken.assign(near.of(v).size() + 1, 0);
        for (const int32_t u : near.of(v)) {
            const int32_t c = job[as_index(u)] == job[v] ? colour[as_index(u)] : -1;
            if (c >= 0 && as_index(c) < taken.size()) taken[as_index(c)] = 1;
        }
        colour[v] = static_cast<int32_t>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    }
    return colour;
}

}  // namespace

VertexPlan plan_vertices(const TetMesh& mesh, std::span<const uint8_t> skip,
                         std::span<const int32_t> work, int domains) {
    const Adjacency near(mesh);
    VertexPlan plan;
    plan.job = place(near, skip, cut_domains(work, domains), domains);
    plan.phase_start = number(plan.job, domains);
    plan.colour = colour(near, plan.job);
    return plan;
}

}  // namespace placode::sim
