// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `xpbd_pair`: C_D and then C_H instead of the 2x2 block, as the published prototype did. Kept to
// compare, and of no part in what trainees meet. Equations: tet_constraints-inl.h.
// Compiled once for every instruction set: Highway includes this file again and again.
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "sim/solver/soft_body_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/solver/xpbd_pair.cpp"
#include <hwy/foreach_target.h>
// Below foreach_target on purpose.
#include <hwy/highway.h>

#include "sim/solver/tet_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

/// x_i += w_i s u_i
HWY_INLINE void Move(const TetPoints& corners, V s, const Gradient& u) {
    const V4* p = corners.p;
    const V w[4] = {hn::Mul(p[0].w, s), hn::Mul(p[1].w, s), hn::Mul(p[2].w, s), hn::Mul(p[3].w, s)};
    Move(corners, w, u);
}

/// Zero unless finite.
HWY_INLINE V Finite(V a) { return hn::IfThenElseZero(FiniteLanes(a), a); }

struct PairProjection {
    template <bool kKept>
    static HWY_INLINE void Project(const TetPoints& corners, const float* rows, V half_b,
                                   Multipliers& l, const Ahead& ahead) {
        const D d;
        const V4* p = corners.p;
        const V b = hn::Add(half_b, half_b);
        const V r = hn::Load(d, rows + 6 * kLanes);
        const V ratio = hn::Load(d, rows + 7 * kLanes);  // mu / lambda
        TetGradients g = Gradients(corners, rows);
        ahead.Load(0);
        const V c2 = hn::Max(g.c2, hn::Set(d, kLeastC2));
        V c = hn::Zero(d), right = hn::Neg(c2);
        if constexpr (kKept) {
            c = hn::Sqrt(c2);
            right = hn::NegMulAdd(c, l.deviatoric, right);
        }
        const V s11 = hn::Mul(b, Weighted(p, g.deviatoric, g.deviatoric));
        ahead.Load(1);
        const V y = Finite(hn::Div(right, hn::Add(s11, c2)));
        Move(corners, hn::Mul(b, y), g.deviatoric);
        if constexpr (kKept) l.deviatoric = hn::MulAdd(c, y, l.deviatoric);
        g = Gradients(corners, rows);
        ahead.Load(2);
        right = hn::NegMulAdd(r, g.j_over_r, hn::Add(hn::Set(d, 1.0F), ratio));
        if constexpr (kKept) right = hn::NegMulAdd(ratio, l.volume, right);
        const V br = hn::Mul(b, r), s22 = hn::Mul(hn::Mul(br, r), Weighted(p, g.volume, g.volume));
        const V z = Finite(hn::Div(right, hn::Add(s22, ratio)));
        ahead.Load(3);
        Move(corners, hn::Mul(br, z), g.volume);
        if constexpr (kKept) l.volume = hn::Add(l.volume, z);
    }
};

void TetBatchesInPairs(const KernelArguments& arguments, int first, int last) {
    SolveTetJob<PairProjection>(arguments, first, last);
}

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace placode::sim {

HWY_EXPORT(TetBatchesInPairs);

void solve_tet_batches_in_pairs(const KernelArguments& arguments, int first, int last) noexcept {
    HWY_DYNAMIC_DISPATCH(TetBatchesInPairs)(arguments, first, last);
}

}  // namespace placode::sim
#endif  // HWY_ONCE
