// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// XPBD on 16 disjoint tets: C_D = sqrt(tr F^T F) with compliance 1 / (mu V), C_H = J - gamma with
// 1 / (lambda V), as a coupled 2x2 block or one after the other.
//
// With C = C_D, G_i = C grad_i C_D = sum_j a_ij (x_i - x_j), c_i = grad_i J, b = h^2 mu V and
// dlambda_D = b C y, dlambda_H = b z, the block system times C (first row) and b reads
//   (b S_GG + C^2) y + b S_Gc z          = -C^2 - C l_D
//   b S_Gc y         + (b S_cc + mu/lambda) z = -(J - gamma) - mu/lambda l_H
// with S_uv = sum_i w_i u_i . v_i and the accumulated multipliers l = lambda / b. All terms are
// dimensionless: no square root without multipliers, no 0/0, no unit system in a guard.

#if defined(PLACODE_SIM_TET_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLACODE_SIM_TET_KERNEL_INL
#undef PLACODE_SIM_TET_KERNEL_INL
#else
#define PLACODE_SIM_TET_KERNEL_INL
#endif

#include "sim/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

/// Gradients of |F|^2 / 2 and of J in the four corners.
struct TetGradients {
    V3 deviatoric[4], volume[4];
    V c2, j;
};

HWY_INLINE TetGradients Gradients(const V4* p, const float* rows) {
    const D d;
    const auto row = [d, rows](size_t r) HWY_ATTR { return hn::Load(d, rows + r * kLanes); };
    const V3 x0 = {p[0].x, p[0].y, p[0].z};
    const V3 e1 = Sub({p[1].x, p[1].y, p[1].z}, x0), e2 = Sub({p[2].x, p[2].y, p[2].z}, x0),
             e3 = Sub({p[3].x, p[3].y, p[3].z}, x0);
    const V3 d12 = Sub(e1, e2), d13 = Sub(e1, e3), d23 = Sub(e2, e3);
    TetGradients g;
    g.deviatoric[1] = MulAdd(row(4), d13, MulAdd(row(3), d12, Scale(row(0), e1)));
    g.deviatoric[2] = MulAdd(row(5), d23, NegMulAdd(row(3), d12, Scale(row(1), e2)));
    g.deviatoric[3] = NegMulAdd(row(5), d23, NegMulAdd(row(4), d13, Scale(row(2), e3)));
    g.volume[1] = Scale(row(6), Cross(e2, e3));
    g.volume[2] = Scale(row(6), Cross(e3, e1));
    g.volume[3] = Scale(row(6), Cross(e1, e2));
    const V3 zero = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    g.deviatoric[0] = Sub(Sub(Sub(zero, g.deviatoric[1]), g.deviatoric[2]), g.deviatoric[3]);
    g.volume[0] = Sub(Sub(Sub(zero, g.volume[1]), g.volume[2]), g.volume[3]);
    // sum_ij a_ij |x_i - x_j|^2 = sum_i x_i . G_i, and J is linear in e1.
    g.c2 = hn::Add(Dot(e1, g.deviatoric[1]),
                   hn::Add(Dot(e2, g.deviatoric[2]), Dot(e3, g.deviatoric[3])));
    g.j = Dot(e1, g.volume[1]);
    return g;
}

/// sum_i w_i u_i . v_i
HWY_INLINE V Weighted(const V4* p, const V3* u, const V3* v) {
    V sum = hn::Mul(p[0].w, Dot(u[0], v[0]));
    for (int i = 1; i < 4; ++i) sum = hn::MulAdd(p[i].w, Dot(u[i], v[i]), sum);
    return sum;
}

/// x_i += w_i s u_i
HWY_INLINE void Move(V4* p, V s, const V3* u) {
    for (int i = 0; i < 4; ++i) {
        const V ws = hn::Mul(p[i].w, s);
        p[i].x = hn::MulAdd(ws, u[i].x, p[i].x);
        p[i].y = hn::MulAdd(ws, u[i].y, p[i].y);
        p[i].z = hn::MulAdd(ws, u[i].z, p[i].z);
    }
}

/// Zero unless finite.
HWY_INLINE V Finite(V a) {
    const D d;
    return hn::IfThenElseZero(hn::Le(hn::Abs(a), hn::Set(d, std::numeric_limits<float>::max())), a);
}

struct Multipliers {
    V deviatoric, volume;  ///< lambda / b before and after
};

HWY_INLINE void Project(V4* p, const float* rows, V b, bool pair, Multipliers& l) {
    const D d;
    const V ratio = hn::Load(d, rows + 7 * kLanes);  // mu / lambda
    const V one = hn::Set(d, 1.0F);
    // C^2 is dimensionless and 3 at rest; a collapsed tet may have 0.
    const V least = hn::Set(d, 1e-6F);
    TetGradients g = Gradients(p, rows);
    V c2 = hn::Max(g.c2, least);
    V right_d = hn::Neg(hn::MulAdd(hn::Sqrt(c2), l.deviatoric, c2));
    const V a11 = hn::MulAdd(b, Weighted(p, g.deviatoric, g.deviatoric), c2);
    if (pair) {
        const V y = Finite(hn::Div(right_d, a11));
        Move(p, hn::Mul(b, y), g.deviatoric);
        l.deviatoric = hn::MulAdd(hn::Sqrt(c2), y, l.deviatoric);
        g = Gradients(p, rows);
    }
    const V right_h = hn::Neg(hn::MulAdd(ratio, l.volume, hn::Sub(hn::Sub(g.j, one), ratio)));
    const V a22 = hn::MulAdd(b, Weighted(p, g.volume, g.volume), ratio);
    if (pair) {
        const V z = Finite(hn::Div(right_h, a22));
        Move(p, hn::Mul(b, z), g.volume);
        l.volume = hn::Add(l.volume, z);
        return;
    }
    const V a12 = hn::Mul(b, Weighted(p, g.deviatoric, g.volume));
    // Positive by Cauchy-Schwarz; the guard is relative to a11 a22.
    const V product = hn::Mul(a11, a22);
    const V determinant =
        hn::Max(hn::NegMulAdd(a12, a12, product), hn::Mul(hn::Set(d, 1e-6F), product));
    const V inverse = hn::Div(one, determinant);
    const V y = Finite(hn::Mul(inverse, hn::NegMulAdd(a12, right_h, hn::Mul(a22, right_d))));
    const V z = Finite(hn::Mul(inverse, hn::NegMulAdd(a12, right_d, hn::Mul(a11, right_h))));
    // At rest the two parts cancel: add them before they meet the position, one rounding.
    V3 sum[4];
    for (int i = 0; i < 4; ++i) sum[i] = MulAdd(y, g.deviatoric[i], Scale(z, g.volume[i]));
    Move(p, b, sum);
    l.deviatoric = hn::MulAdd(hn::Sqrt(c2), y, l.deviatoric);
    l.volume = hn::Add(l.volume, z);
}

HWY_INLINE uint32_t SolveTetBatch(const KernelArguments& a, int number) {
    const D d;
    const PackedElements& packed = *a.packed;
    const auto at = static_cast<size_t>(number);
    const TetBatch& batch = packed.tet_batches[at];
    const bool kept = packed.tet_lambda_start >= 0;
    for (size_t lane = 0; lane < static_cast<size_t>(batch.count); lane += hn::Lanes(d)) {
        const uint16_t* index = packed.tet_index.data() + at * 4 * kLanes + lane;
        const float* rows = packed.tet_rows.data() + at * kTetRows * kLanes + lane;
        const V stiffness =
            hn::Load(d, a.lanes + static_cast<size_t>(packed.tet_lane_start) + at * kLanes + lane);
        V4 p[4];
        for (size_t k = 0; k < 4; ++k) {
            p[k] = Gather(reinterpret_cast<const char*>(a.x + batch.base), index + k * kLanes);
        }
        Multipliers l = {hn::Zero(d), hn::Zero(d)};
        float* memory = nullptr;
        if (kept) {
            memory = a.lanes + packed.tet_lambda_start + at * 2 * kLanes + lane;
            l = {hn::Load(d, memory), hn::Load(d, memory + kLanes)};
        }
        Project(p, rows, hn::Mul(hn::Set(d, a.h * a.h), stiffness), a.pair, l);
        if (kept) {
            hn::Store(l.deviatoric, d, memory);
            hn::Store(l.volume, d, memory + kLanes);
        }
        for (size_t k = 0; k < 4; ++k) {
            Scatter(p[k], reinterpret_cast<char*>(a.x + batch.base), index + k * kLanes,
                    batch.count - static_cast<int>(lane));
        }
    }
    return 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();
#endif  // include guard
