// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// XPBD's sweep over batches of up to 16 disjoint tets, there or back. `Projection` says what is
// done to a tet (BlockProjection in tet_constraints-inl.h).

#if defined(PLACODE_SIM_TET_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLACODE_SIM_TET_KERNEL_INL
#undef PLACODE_SIM_TET_KERNEL_INL
#else
#define PLACODE_SIM_TET_KERNEL_INL
#endif

#include "sim/solver/tet_constraints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

/// Tets of larger meshes come from memory, and the processor by itself stops asking at the end of a
/// page: their rows are asked for six batches ahead (slab of 642,000 tets: 1.1 to 1.6 times as
/// fast). At 43,200 that would cost 2 to 4 %.
constexpr size_t kBatchesInCache = 6000;

/// As many tets of one batch as a vector has lanes.
struct TetGroup {
    int batch = 0;
    size_t lane = 0;
};

HWY_INLINE const uint16_t* Corners(const KernelArguments& a, TetGroup g) {
    return a.packed->tet_index.data() + static_cast<size_t>(g.batch) * 4 * kLanes + g.lane;
}

HWY_INLINE char* Points(const KernelArguments& a, Float4* of, TetGroup g) {
    return reinterpret_cast<char*>(of + a.packed->tet_batches[static_cast<size_t>(g.batch)].base);
}

HWY_INLINE TetGroup After(const KernelArguments& a, TetGroup g) {
    const size_t lane = g.lane + hn::Lanes(D());
    const TetBatch& batch = a.packed->tet_batches[static_cast<size_t>(g.batch)];
    return lane < static_cast<size_t>(batch.count) ? TetGroup{g.batch, lane}
                                                   : TetGroup{g.batch + a.direction, 0};
}

/// Solves `now`, whose corners are in `p`, and loads those of the group after it into `q`.
/// `end` is the batch behind the last one, in the sweep's direction.
template <typename Projection, bool kKept, bool kLow>
HWY_INLINE TetGroup SolveTets(const KernelArguments& a, TetGroup now, int end, V4* p, V4* q) {
    const D d;
    const KernelLayout& packed = *a.packed;
    const auto at = static_cast<size_t>(now.batch);
    const TetGroup next = After(a, now);
    Ahead following;
    if (next.batch != end) following = {Points(a, a.x, next), Corners(a, next), q};
    const int upper = std::max(now.batch, next.batch);
    const bool waits = next.batch != end && next.batch != now.batch &&
                       !packed.tet_batches[static_cast<size_t>(upper)].apart;
    const Ahead ahead = waits ? Ahead() : following;
    const float* rows = packed.tet_rows.data() + at * kTetRows * kLanes + now.lane;
    if (HWY_UNLIKELY(packed.tet_batches.size() > kBatchesInCache)) {
        const float* later = rows + 6 * kTetRows * kLanes;
        for (size_t k = 0; k < kTetRows; ++k) hwy::Prefetch(later + k * kLanes);
    }
    const V stiffness =
        hn::Load(d, a.lanes + static_cast<size_t>(packed.tet_lane_start) + at * kLanes + now.lane);
    Multipliers l = {hn::Zero(d), hn::Zero(d)};
    [[maybe_unused]] float* memory = nullptr;
    if constexpr (kKept) {
        memory = a.lanes + packed.tet_lambda_start + at * 2 * kLanes + now.lane;
        l = {hn::Load(d, memory), hn::Load(d, memory + kLanes)};
    }
    const uint16_t* corners = Corners(a, now);
    const int count = packed.tet_batches[at].count - static_cast<int>(now.lane);
    V4 x[4] = {p[0], p[1], p[2], p[3]};  // in registers
    const V half_b = hn::Mul(hn::Set(d, 0.5F * a.h * a.h), stiffness);
    if constexpr (kLow) {
        char* lows = Points(a, a.x_low, now);
        V3 low[4];
        for (size_t c = 0; c < 4; ++c) low[c] = Gather3(lows, corners + c * kLanes);
        Projection::template Project<kKept>({x, low}, rows, half_b, l, ahead);
        for (size_t c = 0; c < 4; ++c)
            Scatter({low[c].x, low[c].y, low[c].z, hn::Zero(d)}, lows, corners + c * kLanes, count);
    } else {
        Projection::template Project<kKept>({x, nullptr}, rows, half_b, l, ahead);
    }
    if constexpr (kKept) {
        hn::Store(l.deviatoric, d, memory);
        hn::Store(l.volume, d, memory + kLanes);
    }
    char* points = Points(a, a.x, now);
    Scatter(x[0], points, corners, count);
    Scatter(x[1], points, corners + kLanes, count);
    Scatter(x[2], points, corners + 2 * kLanes, count);
    Scatter(x[3], points, corners + 3 * kLanes, count);
    if (HWY_UNLIKELY(waits)) following.LoadAll();
    return next;
}

template <typename Projection, bool kKept, bool kLow>
void SolveTetBatches(const KernelArguments& a, int first, int last) {
    if (first >= last) return;
    const bool backward = a.direction < 0;
    const int end = backward ? first - 1 : last;
    V4 p[4], q[4];
    TetGroup now{backward ? last - 1 : first, 0};
    Ahead{Points(a, a.x, now), Corners(a, now), p}.LoadAll();
    while (true) {
        now = SolveTets<Projection, kKept, kLow>(a, now, end, p, q);
        if (now.batch == end) return;
        now = SolveTets<Projection, kKept, kLow>(a, now, end, q, p);
        if (now.batch == end) return;
    }
}

/// Batches [first, last) of one job; each of the four sweeps is compiled for itself.
template <typename Projection>
void SolveTetJob(const KernelArguments& a, int first, int last) {
    const bool kept = a.packed->tet_lambda_start >= 0;
    if (a.x_low != nullptr) {
        kept ? SolveTetBatches<Projection, true, true>(a, first, last)
             : SolveTetBatches<Projection, false, true>(a, first, last);
    } else {
        kept ? SolveTetBatches<Projection, true, false>(a, first, last)
             : SolveTetBatches<Projection, false, false>(a, first, last);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();
#endif  // include guard
