// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// In which order a sweep visits its elements, and what several threads may do at the same time.
//
// The vertices (in RCM order) are cut into a few ranges, the domains. Elements inside one domain
// are one job; jobs of different domains touch nothing in common. Elements between two neighbouring
// domains are jobs of the next two phases, whatever is left one job of the last phase. Inside a job
// the order is local: batches are filled from a short window along the numbering, so that positions
// stay in the first-level cache, and need no colours. Batches one after the other share no vertex
// where that can be had, so that the next one can be loaded while this one is solved.
//
// The plan depends on the mesh alone, so the results do not depend on the number of threads.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace placode::sim {

/// Elements of each batch (at most `kLanes`, no two share a vertex), in order. Job j owns batches
/// [job_start[j], job_start[j + 1]), phase p the jobs [phase_start[p], phase_start[p + 1]).
struct SweepPlan {
    std::vector<std::vector<int32_t>> batches;
    std::vector<uint8_t> apart;  ///< 1 = shares no vertex with the batch before it in its job.
    std::vector<int32_t> job_start, phase_start;
};

/// Number of domains for a mesh of so many tets: a power of two, 1 to 8.
[[nodiscard]] int domains_for(int tets);

/// Plan for tets: no two tets of a batch, and no two jobs of a phase, share a vertex.
[[nodiscard]] SweepPlan plan_tets(std::span<const std::array<int32_t, 4>> tets, int vertices,
                                  int domains);

}  // namespace placode::sim
