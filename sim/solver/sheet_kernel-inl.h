// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of sheets (sheet.h) in 16 vertices of one colour: the fan of triangles round each is
// walked once (sheet_strips.h). What add_sheet() does in double precision for one vertex, with the
// angles from half their tangent instead of atan2.

#if defined(PLACODE_SIM_SHEET_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLACODE_SIM_SHEET_KERNEL_INL
#undef PLACODE_SIM_SHEET_KERNEL_INL
#else
#define PLACODE_SIM_SHEET_KERNEL_INL
#endif

#include "sim/solver/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

// Below these (in units of length: edges are near 1) a triangle or an edge counts as gone.
constexpr float kNoArea = 1e-24F, kNoEdge = 1e-14F;
constexpr float kFlatHinge = 1e-8F;  // as in has_hinge()

/// Symmetric 3x3 systems.
struct Systems {
    V3 gradient;
    V xx, xy, xz, yy, yz, zz;
    V floor;  ///< Lower bound of every pivot.
};

HWY_INLINE void AddOuter(V s, const V3& a, Systems& out) {
    const V3 scaled = Scale(s, a);
    out.xx = hn::MulAdd(scaled.x, a.x, out.xx);
    out.xy = hn::MulAdd(scaled.x, a.y, out.xy);
    out.xz = hn::MulAdd(scaled.x, a.z, out.xz);
    out.yy = hn::MulAdd(scaled.y, a.y, out.yy);
    out.yz = hn::MulAdd(scaled.y, a.z, out.yz);
    out.zz = hn::MulAdd(scaled.z, a.z, out.zz);
}

/// a b^T + b a^T with b as a sum that holds half of a's own part.
HWY_INLINE void AddPair(const V3& a, const V3& b, Systems& out) {
    const D d;
    const V two = hn::Set(d, 2.0F);
    out.xx = hn::MulAdd(hn::Mul(two, a.x), b.x, out.xx);
    out.yy = hn::MulAdd(hn::Mul(two, a.y), b.y, out.yy);
    out.zz = hn::MulAdd(hn::Mul(two, a.z), b.z, out.zz);
    out.xy = hn::MulAdd(a.x, b.y, hn::MulAdd(a.y, b.x, out.xy));
    out.xz = hn::MulAdd(a.x, b.z, hn::MulAdd(a.z, b.x, out.xz));
    out.yz = hn::MulAdd(a.y, b.z, hn::MulAdd(a.z, b.y, out.yz));
}

/// 2 atan(t), |t| <= 1: polynomial through Chebyshev's points, 2e-8 off.
HWY_INLINE V TwiceArcTangent(V t) {
    const D d;
    constexpr float kTerms[] = {0.999999982F,  -0.333330367F,  0.19991872F,
                                -0.141977978F, 0.106183706F,   -0.0745685483F,
                                0.0421376236F, -0.0157312491F, 0.0027662835F};
    const V u = hn::Mul(t, t);
    V p = hn::Set(d, kTerms[8]);
    for (int i = 7; i >= 0; --i) p = hn::MulAdd(p, u, hn::Set(d, kTerms[i]));
    return hn::Mul(hn::Add(t, t), p);
}

/// 1 / x, 0 where `there` says no.
HWY_INLINE V InverseWhere(M there, V x) {
    const V one = hn::Set(D(), 1.0F);
    return hn::IfThenElseZero(there, hn::Div(one, hn::IfThenElse(there, x, one)));
}

/// A triangle: normal (twice its area), its square and one over it (0 for a degenerate one).
struct Face {
    V3 normal;
    V square, inverse;
};

HWY_INLINE Face FaceOf(const V3& a, const V3& b) {
    const D d;
    const V3 n = Cross(a, b);
    const V square = Dot(n, n);
    return {n, square, InverseWhere(hn::Gt(square, hn::Set(d, kNoArea)), square)};
}

/// Angle from rest over an edge of squared length e2, `across` from the edge to the other corner.
/// With u, w from the edge e to the two corners, (w x e) x (e x u) = e (w . (e x u)): the sine is
/// |e| (w . own) over both normals. The tangent of half an angle is S / (|(S, C)| + C).
HWY_INLINE V AngleFromRest(const Face& own, const Face& other, V e2, V length, const V3& across,
                           const float* rest, M& sound) {
    const D d;
    const V zero = hn::Zero(d);
    const V least = hn::Mul(hn::Set(d, kFlatHinge), hn::Mul(e2, e2));
    sound =
        hn::And(hn::Gt(hn::Min(own.square, other.square), least), hn::Gt(e2, hn::Set(d, kNoEdge)));
    const V s = hn::Mul(length, Dot(across, own.normal)), c = Dot(own.normal, other.normal);
    const V size = hn::Sqrt(hn::Mul(own.square, other.square));
    const V rest_c = hn::Load(d, rest), rest_s = hn::Load(d, rest + kLanes);
    const V sine = hn::NegMulAdd(c, rest_s, hn::Mul(s, rest_c));
    const V cosine = hn::MulAdd(s, rest_s, hn::Mul(c, rest_c));
    const V below = hn::IfThenElse(sound, hn::Add(size, hn::Abs(cosine)), hn::Set(d, 1.0F));
    const V half = TwiceArcTangent(hn::Div(sine, below));
    const V half_turn = hn::CopySign(hn::Set(d, 3.14159265F), sine);
    const V angle = hn::IfThenElse(hn::Lt(cosine, zero), hn::Sub(half_turn, half), half);
    return hn::IfThenElseZero(sound, angle);
}

/// Corner of a membrane, as add_membrane() in sheet.cpp. `e` = b - a.
HWY_INLINE void AddMembrane(const float* row, const V3& a, const V3& b, const V3& e, V e2,
                            V inverse_e2, const Face& face, Systems& out) {
    const D d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0F), two = hn::Set(d, 2.0F);
    const auto at = [d, row](int r) HWY_ATTR { return hn::Load(d, row + r * kLanes); };
    const V edge_a = at(kEdgeA), edge_b = at(kEdgeB), r2 = at(kAreaScale);
    const V c = at(kStiffening);
    const V t = hn::Div(one, hn::MulAdd(c, hn::Mul(r2, face.square), one));
    const V slope = hn::Neg(hn::Mul(at(kPressure), hn::Mul(t, t)));
    const V curvature = hn::Neg(hn::Mul(hn::Mul(two, hn::Mul(c, t)), slope));
    // away = |e|^2 d - (e . d) e with d = -a
    const V3 away = Sub(Scale(Dot(e, a), e), Scale(e2, a));
    const V push = hn::Mul(hn::Mul(two, r2), slope);
    out.gradient = NegMulAdd(edge_a, a, NegMulAdd(edge_b, b, MulAdd(push, away, out.gradient)));
    const V shear = hn::Add(edge_a, edge_b);
    const V pressed = hn::MulAdd(push, e2, shear);
    const V across = hn::Max(zero, pressed);
    out.xx = hn::Add(out.xx, across);
    out.yy = hn::Add(out.yy, across);
    out.zz = hn::Add(out.zz, across);
    AddOuter(hn::Mul(hn::Sub(shear, across), inverse_e2), e, out);
    const V away2 = hn::Mul(e2, face.square);
    const V four_r4 = hn::Mul(hn::Mul(two, r2), hn::Mul(two, r2));
    const V in_plane = hn::Max(zero, hn::MulAdd(hn::Mul(four_r4, curvature), away2, pressed));
    const V along = hn::Mul(hn::Mul(hn::Sub(in_plane, across), inverse_e2), face.inverse);
    AddOuter(along, away, out);
}

/// Angles and gradients of a step's triangle that its last edge still waits for.
struct Bent {
    V spoke, rim, moment;  ///< `moment` of the far triangle on the edge between them.
    V3 spoke_gradient, rim_gradient;
};

/// The bending of a triangle: angles and gradients of its edges va, ab and (just found) bv.
HWY_INLINE void AddBending(const float* row, const Bent& bent, V last, const V3& last_gradient,
                           Systems& out) {
    const D d;
    const V half = hn::Set(d, 0.5F);
    const auto at = [d, row](int r) HWY_ATTR { return hn::Load(d, row + r * kLanes); };
    const V b00 = at(kBend00), b01 = at(kBend01), b02 = at(kBend02);
    const V b11 = at(kBend11), b12 = at(kBend12), b22 = at(kBend22);
    const V3 &g0 = bent.spoke_gradient, &g1 = bent.rim_gradient, &g2 = last_gradient;
    const V m0 = hn::MulAdd(b00, bent.spoke, hn::MulAdd(b01, bent.rim, hn::Mul(b02, last)));
    const V m1 = hn::Add(
        bent.moment, hn::MulAdd(b01, bent.spoke, hn::MulAdd(b11, bent.rim, hn::Mul(b12, last))));
    const V m2 = hn::MulAdd(b02, bent.spoke, hn::MulAdd(b12, bent.rim, hn::Mul(b22, last)));
    out.gradient = MulAdd(m0, g0, MulAdd(m1, g1, MulAdd(m2, g2, out.gradient)));
    AddPair(g0, MulAdd(hn::Mul(half, b00), g0, MulAdd(b01, g1, Scale(b02, g2))), out);
    AddPair(g1, MulAdd(hn::Mul(half, b11), g1, Scale(b12, g2)), out);
    AddOuter(b22, g2, out);
}

/// Reads positions from the vertex of each lane, in units of length.
template <bool kLow>
struct Around {
    const KernelArguments& a;
    V3 x, low;
    V scale;

    HWY_INLINE V3 operator()(const uint32_t* index) const {
        V3 p = Sub(Gather3(reinterpret_cast<const char*>(a.x), index), x);
        if constexpr (kLow)
            p = Add(p, Sub(Gather3(reinterpret_cast<const char*>(a.x_low), index), low));
        return Scale(scale, p);
    }
};

/// The far triangle of a step: angle and gradient of the edge between, moment from its own edges.
template <bool kLow>
HWY_INLINE void BendRim(const Around<kLow>& around, const float* row, const uint32_t* index,
                        const V3& a, const V3& b, const V3& e, V e2, const Face& face, Bent& bent) {
    const D d;
    M sound;
    const V3 o = around(index + kLanes), w = Sub(o, a);
    const Face far = FaceOf(w, e);
    const V length = hn::Sqrt(e2);
    bent.rim = AngleFromRest(face, far, e2, length, w, row + kRimCos * kLanes, sound);
    bent.rim_gradient =
        Scale(hn::IfThenElseZero(sound, hn::Mul(length, face.inverse)), face.normal);

    const V3 across1 = Sub(around(index + 2 * kLanes), a);
    const V w2 = Dot(w, w);
    const V first = AngleFromRest(far, FaceOf(across1, w), w2, hn::Sqrt(w2), across1,
                                  row + kFirstCos * kLanes, sound);
    const V3 across2 = Sub(around(index + 3 * kLanes), o), z = Sub(b, o);
    const V z2 = Dot(z, z);
    const V second = AngleFromRest(far, FaceOf(across2, z), z2, hn::Sqrt(z2), across2,
                                   row + kSecondCos * kLanes, sound);
    bent.moment = hn::MulAdd(hn::Load(d, row + kRimFirst * kLanes), first,
                             hn::Mul(hn::Load(d, row + kRimSecond * kLanes), second));
}

/// Adds dE/dx [N] and the positive semidefinite Hessian [N/m] of the vertices' sheets.
template <bool kLow>
HWY_INLINE void AddSheet(const KernelArguments& arguments, const SheetBatch& batch, size_t lane,
                         const V3& x, const V3& low, Systems& s) {
    const D d;
    const V zero = hn::Zero(d);
    const V3 none = {zero, zero, zero};
    const SheetStrips& strips = arguments.packed->sheet_strips;
    const V scale = hn::Set(d, strips.per_length);
    const Around<kLow> around{arguments, x, low, scale};
    const auto number = static_cast<size_t>(&batch - strips.batches.data());
    const uint32_t* entry = strips.entry.data() + number * 2 * kLanes + lane;
    const auto start = static_cast<size_t>(batch.start);
    const uint32_t* index = strips.index.data() + start * kSheetPoints * kLanes + lane;
    const float* row = strips.rows.data() + start * kSheetRows * kLanes + lane;
    Systems sum = {none, zero, zero, zero, zero, zero, zero, zero};
    Bent bent = {zero, zero, zero, none, none};
    V3 before = around(entry), a = around(entry + kLanes);
    Face last = FaceOf(before, a);
    for (int32_t step = 0; step <= batch.steps; ++step) {
        const V3 b = around(index);
        const Face face = FaceOf(a, b);
        const V3 e = Sub(b, a);
        const V e2 = Dot(e, e);
        if (strips.bends) {
            // The edge from the vertex to a, between the triangle before and this one.
            M sound;
            const V a2 = Dot(a, a), length = hn::Sqrt(a2);
            const V spoke =
                AngleFromRest(face, last, a2, length, before, row + kSpokeCos * kLanes, sound);
            const V over = InverseWhere(sound, length);
            const V own = hn::Mul(hn::Mul(over, face.inverse), hn::Sub(Dot(a, b), a2));
            const V other = hn::Mul(hn::Mul(over, last.inverse), hn::Sub(Dot(a, before), a2));
            const V3 gradient = MulAdd(own, face.normal, Scale(other, last.normal));
            if (step > 0) AddBending(row - kSheetRows * kLanes, bent, spoke, gradient, sum);
            if (step == batch.steps) break;
            bent.spoke = spoke;
            bent.spoke_gradient = gradient;
            BendRim(around, row, index, a, b, e, e2, face, bent);
        }
        const V inverse_e2 = InverseWhere(hn::Gt(e2, hn::Set(d, kNoEdge)), e2);
        AddMembrane(row, a, b, e, e2, inverse_e2, face, sum);
        before = a;
        a = b;
        last = face;
        index += kSheetPoints * kLanes;
        row += kSheetRows * kLanes;
    }
    const V square = hn::Mul(scale, scale);
    s.gradient = MulAdd(scale, sum.gradient, s.gradient);
    s.xx = hn::MulAdd(square, sum.xx, s.xx);
    s.xy = hn::MulAdd(square, sum.xy, s.xy);
    s.xz = hn::MulAdd(square, sum.xz, s.xz);
    s.yy = hn::MulAdd(square, sum.yy, s.yy);
    s.yz = hn::MulAdd(square, sum.yz, s.yz);
    s.zz = hn::MulAdd(square, sum.zz, s.zz);
}

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();
#endif  // include guard
