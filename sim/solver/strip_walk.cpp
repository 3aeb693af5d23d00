// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for every instruction set: Highway includes this file again and again.
#include "sim/solver/strip_walk.h"

#include <cassert>

#include "sim/core/as_index.h"
#include "sim/solver/double_float.h"
#include "sim/solver/soft_body.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/strip_walk.cpp"
#include <hwy/foreach_target.h>
// Below foreach_target on purpose.
#include <hwy/highway.h>

#ifndef PLACODE_STRIP_STEPS
#define PLACODE_STRIP_STEPS
namespace placode::sim {

/// Where the steps of a vertex's strip stand.
struct StripSteps {
    StripSteps(const KernelLayout& packed, const SoftBodyState& state, int vertex) noexcept {
        const int32_t slot = packed.slot[as_index(vertex)];
        const VertexBatch& b = packed.batches[as_index(slot / kLanes)];
        lane = as_index(slot % kLanes);
        own = state.lanes.data() + b.lane_start + lane;
        row = own + kLanes;
        neighbour = packed.strip.data() + as_index(b.step_start) * kLanes + lane;
        keep = packed.keep.data() + b.step_start;
        base = b.base;
        steps = as_index(b.steps);
    }
    [[nodiscard]] size_t other(size_t s) const noexcept {
        return as_index(base + neighbour[s * kLanes] / 2);
    }
    void add_own_weight(StripSums& sums) const noexcept {
        for (const size_t diagonal : {0, 5, 10})
            sums.hessian[diagonal] += static_cast<double>(*own);
    }
    [[nodiscard]] bool keeps_older(size_t s) const noexcept { return (keep[s] >> lane & 1) != 0; }

    const float* own;           ///< Sum of the weights of the edges [N/m].
    const float* row;           ///< Three rows a step: weight, stiffness, volume at rest.
    const uint16_t* neighbour;  ///< As VertexBatch::self.
    const uint16_t* keep;
    size_t lane, steps;
    int32_t base;
};

}  // namespace placode::sim
#endif

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

#if HWY_ARCH_X86 && HWY_TARGET <= HWY_AVX2
namespace hn = hwy::HWY_NAMESPACE;
using D4 = hn::FixedTag<double, 4>;
using V4 = hn::Vec<D4>;  // x, y, z and a number that is not looked at

HWY_INLINE V4 place_of(const SoftBodyState& state, size_t vertex) {
    const hn::FixedTag<float, 4> f;
    const V4 high = hn::PromoteTo(D4(), hn::Load(f, &state.x[vertex].x));
    if (state.x_low.empty()) return high;
    return hn::Add(high, hn::PromoteTo(D4(), hn::Load(f, &state.x_low[vertex].x)));
}

void Walk(const KernelLayout& packed, const SoftBodyState& state, int vertex, StripSums& sums) {
    const D4 d;
    alignas(32) static constexpr int64_t kNext[] = {1, 2, 0, 3}, kX[] = {0, 0, 0, 0},
                                         kY[] = {1, 1, 1, 1}, kZ[] = {2, 2, 2, 2};
    const auto next = hn::SetTableIndices(d, kNext), all_x = hn::SetTableIndices(d, kX),
               all_y = hn::SetTableIndices(d, kY), all_z = hn::SetTableIndices(d, kZ);
    const StripSteps strip(packed, state, vertex);
    strip.add_own_weight(sums);
    const V4 x = place_of(state, as_index(vertex));
    V4 gradient = hn::Load(d, sums.gradient.data());
    V4 row_x = hn::Load(d, sums.hessian.data()), row_y = hn::Load(d, sums.hessian.data() + 4),
       row_z = hn::Load(d, sums.hessian.data() + 8);
    V4 older = hn::Zero(d), newer = older;
    const float* row = strip.row;
    for (size_t s = 0; s < strip.steps; ++s, row += 3 * kLanes) {
        const V4 p = hn::Sub(place_of(state, strip.other(s)), x);
        const auto number = [&](size_t r) { return static_cast<double>(row[r * kLanes]); };
        gradient = hn::Sub(gradient, hn::Mul(hn::Set(d, number(0)), p));
        if (row[kLanes] > 0) {
            const V4 a = hn::Sub(newer, older), b = hn::Sub(p, older);
            // a x b, turned by one place: its z comes first.
            const V4 turned = hn::Sub(hn::Mul(a, hn::TableLookupLanes(b, next)),
                                      hn::Mul(hn::TableLookupLanes(a, next), b));
            const V4 n = hn::TableLookupLanes(turned, next);
            const V4 dots = hn::Mul(n, older);
            // Summed in the order of Eigen, with which the plain numbers go.
            const V4 dot = hn::Add(
                hn::Add(hn::TableLookupLanes(dots, all_x), hn::TableLookupLanes(dots, all_y)),
                hn::TableLookupLanes(dots, all_z));
            const V4 k = hn::Set(d, number(1)), kn = hn::Mul(k, n);
            const V4 force = hn::Mul(k, hn::Sub(dot, hn::Set(d, number(2))));
            gradient = hn::Sub(gradient, hn::Mul(force, n));
            row_x = hn::Add(row_x, hn::Mul(hn::TableLookupLanes(kn, all_x), n));
            row_y = hn::Add(row_y, hn::Mul(hn::TableLookupLanes(kn, all_y), n));
            row_z = hn::Add(row_z, hn::Mul(hn::TableLookupLanes(kn, all_z), n));
        }
        if (!strip.keeps_older(s)) older = newer;
        newer = p;
    }
    hn::Store(gradient, d, sums.gradient.data());
    hn::Store(row_x, d, sums.hessian.data());
    hn::Store(row_y, d, sums.hessian.data() + 4);
    hn::Store(row_z, d, sums.hessian.data() + 8);
}
#else
void Walk(const KernelLayout& packed, const SoftBodyState& state, int vertex, StripSums& sums) {
    walk_strip_plainly(packed, state, vertex, sums);
}
#endif

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace placode::sim {

HWY_EXPORT(Walk);

void walk_strip(const KernelLayout& packed, const SoftBodyState& state, int vertex,
                StripSums& sums) noexcept {
    assert(has_strips(packed) && "xpbd packs no strips");
    HWY_DYNAMIC_DISPATCH(Walk)(packed, state, vertex, sums);
}

void walk_strip_plainly(const KernelLayout& packed, const SoftBodyState& state, int vertex,
                        StripSums& sums) noexcept {
    assert(has_strips(packed) && "xpbd packs no strips");
    const StripSteps strip(packed, state, vertex);
    strip.add_own_weight(sums);
    const Vec3 x = exact_position(state, vertex);
    Vec3 older = Vec3::Zero(), newer = Vec3::Zero();
    const float* row = strip.row;
    for (size_t s = 0; s < strip.steps; ++s, row += 3 * kLanes) {
        const Vec3 p = exact_position(state, static_cast<int>(strip.other(s))) - x;
        const auto add_force = [&](double k, const Vec3& along) {
            for (int i = 0; i < 3; ++i) sums.gradient[as_index(i)] -= k * along[i];
        };
        add_force(static_cast<double>(row[0]), p);
        const double stiffness = row[kLanes];
        if (stiffness > 0) {
            const Vec3 n = (newer - older).cross(p - older);
            const double excess = n.dot(older) - static_cast<double>(row[2 * kLanes]);
            add_force(stiffness * excess, n);
            for (int i = 0; i < 3; ++i) {
                const double kn = stiffness * n[i];
                for (int j = 0; j < 3; ++j) sums.hessian[as_index(4 * i + j)] += kn * n[j];
            }
        }
        if (!strip.keeps_older(s)) older = newer;
        newer = p;
    }
}

}  // namespace placode::sim
#endif  // HWY_ONCE
