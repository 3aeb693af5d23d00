// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Connectivity that scissors change. A cut separates faces; a vertex whose tets no longer hang
// together over faces is split into one vertex for each part. Elements keep their shape, so no
// volume is lost and nothing beyond the cut changes; a copy of a vertex meets a subset of the
// neighbours of the old one and never the old one itself, so the colours of the solver stay valid.
//
// Bodies are given spare vertices (SoftBodySpec::spare_vertices) for the copies; a body without
// spares has no Topology and pays nothing. Everything is allocated by the constructor. Internal to
// sim; the rest of the program asks through the free functions.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/fields.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {

/// Most tets around a vertex that can be cut.
inline constexpr int kMostAround = 96;

struct Topology {
    explicit Topology(const SoftBody& body);

    std::vector<std::array<int32_t, 4>> tets;  ///< (T) current corners.
    std::vector<int32_t> origin;               ///< (V + spares) vertex of the mesh it came from.
    std::vector<int32_t> around;               ///< Tets of a vertex: around[first .. first + count)
    std::vector<int32_t> first, count;         ///< (V + spares)
    std::vector<float> mass_kg;                ///< (V + spares)
    std::vector<Vec3> rest;  ///< (V + spares) at rest [m]: slide_vertex() moves it, a copy takes
                             ///< it along.
    std::vector<float> volume_m3;   ///< (T) at rest, unscaled; dead tets keep theirs.
    std::vector<uint8_t> whole;     ///< (V) 1 = never split: held or in a sheet.
    int32_t vertices = 0;           ///< In use; the spares follow.
    KernelLayout packed;            ///< As the body's, with room to grow.
    std::vector<int32_t> capacity;  ///< (batches) strip steps that fit.
    // Batches for copies: a pool behind all others. Those of a job form a list in order of need.
    int32_t pool_first = 0, pool_used = 0;
    std::vector<int32_t> pool_next;            ///< (pool) the next of the job, -1 = the last.
    std::vector<int32_t> pool_colour;          ///< (pool) of its vertices.
    std::vector<int32_t> job_first, job_last;  ///< (jobs) -1 = no copies yet.
    std::vector<int32_t> dirty;                ///< Vertices whose strip is out of date.
    std::vector<uint8_t> is_dirty;             ///< (V + spares)
    int32_t dirty_count = 0;
    int32_t refused = 0;  ///< Splits that did not fit (0 in a sound scene).
};
template <class Visit>
void fields(Of<Topology> auto& s, Visit&& visit) {
    auto& [tets, origin, around, first, count, mass_kg, rest, volume_m3, whole, vertices, packed,
           capacity, pool_first, pool_used, pool_next, pool_colour, job_first, job_last, dirty,
           is_dirty, dirty_count, refused] = s;
    visit.state(tets, origin, around, first, count, mass_kg, rest, volume_m3, whole, vertices,
                pool_first, pool_used, pool_next, pool_colour, job_first, job_last, dirty, is_dirty,
                dirty_count, refused);
    visit.kept(packed, capacity);
}

/// Spare vertices that are left.
[[nodiscard]] int spares_left(const SoftBodyState& state) noexcept;

/// Gives `moved` (living tets around `vertex`, not all of them) a vertex of their own at the same
/// place, with the same velocity and their share of the mass. -1 when no spare is left. Strips are
/// rebuilt by `repack`. @pre can_split.
int split_vertex(const SoftBody& body, SoftBodyState& state, int vertex,
                 std::span<const int32_t> moved) noexcept;

/// False for vertices that a bed, a spring or a tether holds, and in bodies without spares.
[[nodiscard]] bool can_split(const SoftBodyState& state, int vertex) noexcept;

/// Mass of a vertex from its tets, dead ones too, as they are now.
void fill_mass(const SoftBody& body, Topology& topology, int vertex) noexcept;

/// Visits the batches of the copies of a job, in a fixed order.
template <class Visit>
void for_copies(const SoftBodyState& state, int job, Visit&& visit) noexcept {
    if (!state.topology) return;
    const Topology& top = *state.topology;
    for (int32_t p = top.job_first[static_cast<size_t>(job)]; p >= 0;
         p = top.pool_next[static_cast<size_t>(p)]) {
        visit(top.pool_first + p);
    }
}

/// Brings the kernels' strips up to date after splits. Call before the next substep.
void repack(SoftBodyState& state) noexcept;

/// As set_vertex_weights, for a body with a Topology.
void reweigh(SoftBodyState& state, int vertex) noexcept;

}  // namespace placode::sim
