// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the kernels see a soft body: batches of 16 vertices of one colour (VBD) or of 16
// disjoint tets (XPBD, sweep_plan.h).
// Internal to the solver.
//
// Edge form: |F|^2 = sum over the six edges of a_ij |x_i - x_j|^2, a_ij = -b_i . b_j with the rest
// gradients b_i of the barycentric coordinates, and J = r det(e1, e2, e3), r = 1 / (6 V). Neither F
// nor the inverse rest matrix is needed.
//
// VBD goes further. In one vertex x the energy of its tets is
//   1/2 sum_j w_j |x - x_j|^2 + 1/2 sum_t s_t (det_t - q_t)^2 + const,
// w_j = sum over tets at edge (x, x_j) of mu V a, s = lambda V r^2, q = 6 V gamma, det_t taken with
// the three opposite vertices. The neighbours are visited as a strip over the link of the vertex
// (link_strip.h), so that each tet costs one position to load instead of three.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/aligned_vector.h"
#include "sim/core/fields.h"
#include "sim/solver/sheet.h"
#include "sim/solver/sheet_strips.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

inline constexpr int kLanes = 16;
inline constexpr int kSpringRows = 13;  ///< K xx xy xz yy yz zz, rest xyz, force xyz, least K.
inline constexpr int kTetRows = 8;      ///< b11 b22 b33 b12 b13 b23, r, mu / lambda.

/// 16 vertices of one colour. Rows of `lanes` from lane_start: sum of w, then w, s, q of each step.
struct alignas(64) VertexBatch {
    std::array<float, kLanes> mass_kg{};
    std::array<float, kLanes> limit_m{};     ///< Step limit: 1/4 of the shortest edge.
    std::array<uint16_t, kLanes> self{};     ///< 2 (vertex - base): byte offset / 8 of a Float4.
    std::array<int32_t, kLanes> vertex{};    ///< Lanes from `count` on repeat lane 0.
    int32_t base = 0;                        ///< Smallest vertex that the batch reads.
    int32_t count = 0, steps = 0;            ///< Used lanes; strip length of the longest lane.
    int64_t step_start = 0, lane_start = 0;  ///< Into `strip` (in steps) and `lanes`.
    int64_t spring_start = -1;               ///< Into `springs`, -1 = none in this batch.
};
template <class Visit>
void fields(Of<VertexBatch> auto& s, Visit&& visit) {
    auto& [mass_kg, limit_m, self, vertex, base, count, steps, step_start, lane_start,
           spring_start] = s;
    visit.state(mass_kg, limit_m, self, vertex, base, count, steps, step_start, lane_start,
                spring_start);
}

/// 16 disjoint tets.
struct TetBatch {
    int32_t base = 0, count = 0;
    bool apart = false;  ///< As in SweepPlan.
};
template <class Visit>
void fields(Of<TetBatch> auto& s, Visit&& visit) {
    auto& [base, count, apart] = s;
    visit.state(base, count, apart);
}

struct KernelLayout {
    // Vertices. Batches of job j: [job_start[j], job_start[j + 1]), one after the other; behind the
    // last job follow vertices that the sweep leaves out (fixed, tethered, in a sheet) but whose
    // forces are asked for. Jobs, phases and colours: VertexPlan. XPBD needs of this only where the
    // springs are: its batches have no steps, and what a strip is made of is empty.
    std::vector<VertexBatch> batches;
    std::vector<int32_t> job_start, phase_start;
    std::vector<int32_t> job, colour;  ///< (V) -1 = left out
    AlignedVector<uint16_t> strip;     ///< (steps x 16) as VertexBatch::self
    std::vector<uint16_t> keep;    ///< (steps) bit per lane: 1 = keep the older vertex of the pair
    AlignedVector<float> springs;  ///< (spring batches x 13 x 16)
    std::vector<int32_t> slot;     ///< (V) 16 batch + lane
    std::vector<int32_t> corner_lane;      ///< (4 T) place of s of this corner in the state's lanes
    std::vector<uint8_t> corner_sign;      ///< (T) bit per corner: 1 = its q is negative
    std::vector<float> edge_weight_n_m;    ///< (6 T) mu V a, edges 01 02 03 12 13 23
    std::vector<int32_t> spring_vertices;  ///< That springs hold, ascending.
    std::vector<float> damping_per_s;      ///< (V) mass-weighted mean

    // XPBD, empty for VBD. Lane state of batch b: mu V from tet_lane_start + 16 b.
    std::vector<TetBatch> tet_batches;
    std::vector<int32_t> tet_job_start, tet_phase_start;  ///< As in SweepPlan.
    AlignedVector<uint16_t> tet_index;                    ///< (tet batches x 4 x 16)
    AlignedVector<float> tet_rows;                        ///< (tet batches x 8 x 16)
    std::vector<int32_t> tet_slot;                        ///< (T) 16 batch + lane
    int64_t tet_lane_start = 0;
    int64_t tet_lambda_start = -1;  ///< Two rows a batch of multipliers, -1 = one iteration.
    int64_t spring_sum_start = -1;  ///< Three rows a spring batch, likewise.

    // Tethers of vertex v: tether_of[tether_start[v] .. tether_start[v + 1]).
    std::vector<int32_t> tether_start, tether_of;
    SheetElements sheet;  ///< Empty in a body without triangles.
    /// Vertices of the sheet that move, solved colour by colour behind the jobs; their batches
    /// follow the last job.
    SheetStrips sheet_strips;
    /// Vertices that the sweep leaves out and that are solved one by one: tethered.
    std::vector<int32_t> single_vertices;

    int64_t lane_count = 0;  ///< Length of SoftBodyState::lanes, see initial_lanes().
};
template <class Visit>
void fields(Of<KernelLayout> auto& s, Visit&& visit) {
    auto& [batches, job_start, phase_start, job, colour, strip, keep, springs, slot, corner_lane,
           corner_sign, edge_weight_n_m, spring_vertices, damping_per_s, tet_batches, tet_job_start,
           tet_phase_start, tet_index, tet_rows, tet_slot, tet_lane_start, tet_lambda_start,
           spring_sum_start, tether_start, tether_of, sheet, sheet_strips, single_vertices,
           lane_count] = s;
    visit.kept(batches, strip, keep, slot, corner_lane, corner_sign, damping_per_s, tet_index,
               edge_weight_n_m, tet_rows);
    visit.constant(job_start, phase_start, job, colour, springs, spring_vertices, tet_batches,
                   tet_job_start, tet_phase_start, tet_slot, tet_lane_start, tet_lambda_start,
                   spring_sum_start, tether_start, tether_of, sheet, sheet_strips, single_vertices,
                   lane_count);
}

/// Constants of one tet at its (scaled) rest shape.
struct TetConstants {
    std::array<double, 6> a{};  ///< [1/m^2]
    double volume_m3 = 0;
    NeoHookean material;
};
[[nodiscard]] TetConstants tet_constants(const SoftBodySpec& spec, int t);
/// The same with its corners at `rest` instead of where the mesh has them.
[[nodiscard]] TetConstants tet_constants(const SoftBodySpec& spec, int t,
                                         const std::array<Vec3, 4>& rest) noexcept;

/// True where strips over the links are packed: the kernels of VBD walk along them.
[[nodiscard]] inline bool has_strips(const KernelLayout& packed) noexcept {
    return !packed.corner_lane.empty();
}

/// Builds everything above. @throws MeshError when a batch spans too many vertices.
[[nodiscard]] KernelLayout pack(const SoftBody& body);

/// Frees what the arrays that grew batch by batch have too much: up to a third of a body.
void give_back_slack(KernelLayout& packed);

/// What SoftBodyState::lanes starts as, in the layout of `packed` (the body's, or one with room to
/// grow): written anew for each state, because kept it would be a third of a body's memory.
[[nodiscard]] AlignedVector<float> initial_lanes(const SoftBody& body, const KernelLayout& packed);

/// Local vertices opposite to corner k, in the order that makes det positive.
inline constexpr std::array<std::array<int, 3>, 4> kOpposite{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
/// Number of the edge between two local vertices.
inline constexpr std::array<std::array<int, 4>, 4> kEdge{
    {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}}};

}  // namespace placode::sim
