// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// XPBD on 16 disjoint tets: C_D = sqrt(tr F^T F) with compliance 1 / (mu V), C_H = J - gamma with
// 1 / (lambda V), as a coupled 2x2 block.
//
// With C = C_D, G_i = C grad_i C_D = sum_j a_ij (x_i - x_j), c_i = grad_i J, b = h^2 mu V and
// dlambda_D = b C y, dlambda_H = b z, the block system times C (first row) and b reads
//   (b S_GG + C^2) y + b S_Gc z          = -C^2 - C l_D
//   b S_Gc y         + (b S_cc + mu/lambda) z = -(J - gamma) - mu/lambda l_H
// with S_uv = sum_i w_i u_i . v_i and the accumulated multipliers l = lambda / b. All terms are
// dimensionless: no square root without multipliers, no 0/0, no unit system in a guard.

#if defined(PLACODE_SIM_TET_CONSTRAINTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLACODE_SIM_TET_CONSTRAINTS_INL
#undef PLACODE_SIM_TET_CONSTRAINTS_INL
#else
#define PLACODE_SIM_TET_CONSTRAINTS_INL
#endif

#include "sim/solver/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

/// Gradients of |F|^2 / 2 and of J / r in the corners 1, 2, 3; `minus` is the one in corner 0 with
/// its sign turned, the sum of the three.
struct Gradient {
    V3 corner[3], minus;
};

struct TetGradients {
    Gradient deviatoric, volume;
    V c2, j_over_r;  ///< |F|^2 and J / r
};

/// Corners of 16 tets; `low` is what positions have beside the floats, or nullptr. It is known when
/// this is compiled, and costs nothing where it is not there.
struct TetPoints {
    V4* p;
    V3* low;

    HWY_INLINE V3 Edge(int corner) const {
        const V4 &a = p[0], &b = p[corner];
        const V3 e = Sub({b.x, b.y, b.z}, {a.x, a.y, a.z});
        return low == nullptr ? e : Add(e, Sub(low[corner], low[0]));
    }
    /// p += s u
    HWY_INLINE void Move(int corner, V s, const V3& u) const {
        V4& a = p[corner];
        if (low == nullptr) {
            a.x = hn::MulAdd(s, u.x, a.x);
            a.y = hn::MulAdd(s, u.y, a.y);
            a.z = hn::MulAdd(s, u.z, a.z);
            return;
        }
        Carry(a.x, low[corner].x, hn::Mul(s, u.x));
        Carry(a.y, low[corner].y, hn::Mul(s, u.y));
        Carry(a.z, low[corner].z, hn::Mul(s, u.z));
    }
};

HWY_INLINE TetGradients Gradients(const TetPoints& corners, const float* rows) {
    const D d;
    const auto row = [d, rows](size_t r) HWY_ATTR { return hn::Load(d, rows + r * kLanes); };
    const V3 e1 = corners.Edge(1), e2 = corners.Edge(2), e3 = corners.Edge(3);
    TetGradients g;
    V3* u = g.deviatoric.corner;
    u[0] = MulAdd(row(4), e3, MulAdd(row(3), e2, Scale(row(0), e1)));
    u[1] = MulAdd(row(5), e3, MulAdd(row(3), e1, Scale(row(1), e2)));
    u[2] = MulAdd(row(5), e2, MulAdd(row(4), e1, Scale(row(2), e3)));
    g.deviatoric.minus = Add(Add(u[0], u[1]), u[2]);
    V3* c = g.volume.corner;
    c[0] = Cross(e2, e3);
    c[1] = Cross(e3, e1);
    c[2] = Cross(e1, e2);
    g.volume.minus = Add(Add(c[0], c[1]), c[2]);
    // sum_ij a_ij |x_i - x_j|^2 = sum_i x_i . G_i, and J is linear in e1.
    g.c2 = hn::Add(Dot(e1, u[0]), hn::Add(Dot(e2, u[1]), Dot(e3, u[2])));
    g.j_over_r = Dot(e1, c[0]);
    return g;
}

/// sum_i w_i u_i . v_i
HWY_INLINE V Weighted(const V4* p, const Gradient& u, const Gradient& v) {
    V sum = hn::Mul(p[0].w, Dot(u.minus, v.minus));
    for (int i = 0; i < 3; ++i) {
        sum = hn::MulAdd(p[i + 1].w, Dot(u.corner[i], v.corner[i]), sum);
    }
    return sum;
}

/// x_i += w_i u_i
HWY_INLINE void Move(const TetPoints& corners, const V* w, const Gradient& u) {
    corners.Move(0, hn::Neg(w[0]), u.minus);
    for (int i = 1; i < 4; ++i) corners.Move(i, w[i], u.corner[i - 1]);
}

/// C^2 is dimensionless and 3 at rest; a collapsed tet may have 0.
constexpr float kLeastC2 = 1e-6F;

struct Multipliers {
    V deviatoric, volume;  ///< lambda / b before and after
};

/// The part that a tet's own effective mass (S_GG, S_Gc, S_cc above) has in the block. It comes in
/// as one half, which judges the constraints in the middle of the correction that they make
/// themselves and takes off most of what one sweep a substep is short of the implicit step. Where
/// the compliance is less than half of the mass it becomes just so much that no constraint is
/// carried past its zero: a relaxation by at most 1.5, so that stiff tets stay stable, and with
/// many sweeps the same solution.
HWY_INLINE void TakeOwnShare(V c2, V ratio, V& m11, V& m12, V& m22) {
    const D d;
    // Soft tets, the rule at a usual step, need neither a division nor the wait for one.
    const M soft = hn::And(hn::Ge(c2, m11), hn::Ge(ratio, m22));
    if (HWY_LIKELY(hn::AllTrue(d, soft))) return;
    const M first = hn::Lt(hn::Mul(c2, m22), hn::Mul(ratio, m11));
    const V least = hn::Div(hn::IfThenElse(first, c2, ratio), hn::IfThenElse(first, m11, m22));
    const V more = hn::Max(hn::Set(d, 1.0F), hn::Sub(hn::Set(d, 2.0F), least));
    m11 = hn::Mul(more, m11);
    m12 = hn::Mul(more, m12);
    m22 = hn::Mul(more, m22);
}

/// Corners of the tets that come next, loaded while these are solved: a batch is longer than what a
/// processor looks ahead.
struct Ahead {
    const char* base = nullptr;  ///< nullptr: they share vertices with these, and have to wait.
    const uint16_t* index = nullptr;
    V4* p = nullptr;
    HWY_INLINE void Load(size_t corner) const {
        if (base != nullptr) p[corner] = Gather(base, index + corner * kLanes);
    }
    HWY_INLINE void LoadAll() const {
        for (size_t corner = 0; corner < 4; ++corner) Load(corner);
    }
};

/// Both at once, what `xpbd` does. With m = half of b S, a = m + compliance and left_D = C^2 + C
/// l_D, y = -(m12 right_H + a22 left_D) / det and z = (m12 left_D + a11 right_H) / det; they are
/// kept doubled, because b comes in halved, and y with its sign turned.
struct BlockProjection {
    template <bool kKept>
    static HWY_INLINE void Project(const TetPoints& corners, const float* rows, V half_b,
                                   Multipliers& l, const Ahead& ahead) {
        const D d;
        const V4* p = corners.p;
        const V r = hn::Load(d, rows + 6 * kLanes);
        const V ratio = hn::Load(d, rows + 7 * kLanes);  // mu / lambda
        const TetGradients g = Gradients(corners, rows);
        const V c2 = hn::Max(g.c2, hn::Set(d, kLeastC2));
        V c = hn::Zero(d), left_d = c2;
        V right_h = hn::NegMulAdd(r, g.j_over_r, hn::Add(hn::Set(d, 1.0F), ratio));
        if constexpr (kKept) {
            c = hn::Sqrt(c2);
            left_d = hn::MulAdd(c, l.deviatoric, left_d);
            right_h = hn::NegMulAdd(ratio, l.volume, right_h);
        }
        const V half_br = hn::Mul(half_b, r);  // g.volume is the gradient of J / r.
        V m11 = hn::Mul(half_b, Weighted(p, g.deviatoric, g.deviatoric));
        V m22 = hn::Mul(hn::Mul(half_br, r), Weighted(p, g.volume, g.volume));
        ahead.Load(0);
        V m12 = hn::Mul(half_br, Weighted(p, g.deviatoric, g.volume));
        TakeOwnShare(c2, ratio, m11, m12, m22);
        const V a11 = hn::Add(m11, c2), a22 = hn::Add(m22, ratio);
        // Positive by Cauchy-Schwarz; the guard is relative to a11 a22.
        const V product = hn::Mul(a11, a22);
        const V determinant =
            hn::Max(hn::NegMulAdd(m12, m12, product), hn::Mul(hn::Set(d, 1e-6F), product));
        const V twice = hn::Div(hn::Set(d, 2.0F), determinant);
        ahead.Load(1);
        // While the division runs: what is finite here stays so, for m12^2 <= a11 a22.
        const M finite = hn::Le(hn::MulAdd(right_h, right_h, product),
                                hn::Set(d, std::numeric_limits<float>::max()));
        const V y2 = hn::IfThenElseZero(
            finite, hn::Mul(twice, hn::MulAdd(m12, right_h, hn::Mul(a22, left_d))));
        const V z2 = hn::IfThenElseZero(
            finite, hn::Mul(twice, hn::MulAdd(m12, left_d, hn::Mul(a11, right_h))));
        ahead.Load(2);
        // At rest the two parts cancel: add them before they meet the position, one rounding.
        const V by = hn::Mul(half_b, y2), brz = hn::Mul(half_br, z2);
        Gradient sum;
        for (int i = 0; i < 3; ++i) {
            sum.corner[i] = NegMulAdd(by, g.deviatoric.corner[i], Scale(brz, g.volume.corner[i]));
        }
        sum.minus = Add(Add(sum.corner[0], sum.corner[1]), sum.corner[2]);
        ahead.Load(3);
        const V w[4] = {p[0].w, p[1].w, p[2].w, p[3].w};
        Move(corners, w, sum);
        if constexpr (kKept) {
            const V half = hn::Set(d, 0.5F);
            l.deviatoric = hn::NegMulAdd(hn::Mul(half, c), y2, l.deviatoric);
            l.volume = hn::MulAdd(half, z2, l.volume);
        }
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();
#endif  // include guard
