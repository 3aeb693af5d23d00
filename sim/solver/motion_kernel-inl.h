// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Begin and end of a substep over whole registers of vertices (one Float4 each). Both stop before
// the first register that needs more than the common case: the caller does that one vertex by
// vertex. Which vertices that are depends on where a thread's share ends, so the bits have to be
// those of vertex_motion.cpp: the same operations in the same order, fused alike.

#if defined(PLACODE_SIM_MOTION_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLACODE_SIM_MOTION_KERNEL_INL
#undef PLACODE_SIM_MOTION_KERNEL_INL
#else
#define PLACODE_SIM_MOTION_KERNEL_INL
#endif

#include "sim/solver/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE size_t BeginMotion(const MotionArguments&, size_t first, size_t) { return first; }
HWY_INLINE size_t EndMotion(const MotionArguments&, size_t first, size_t) { return first; }
#else

/// Lanes x, y, z of every point.
HWY_INLINE M PointLanes() {
    const D d;
    alignas(64) static constexpr std::array<float, 16> kPoint{1, 1, 1, 0, 1, 1, 1, 0,
                                                              1, 1, 1, 0, 1, 1, 1, 0};
    return hn::Gt(hn::Load(d, kPoint.data()), hn::Zero(d));
}

/// The four numbers of `xyzw` in every point.
HWY_INLINE V EveryPoint(const std::array<float, 4>& xyzw) {
    return hn::LoadDup128(D(), xyzw.data());
}

HWY_INLINE bool AllFinite(V a) {
    const D d;
    return hn::AllTrue(d, hn::Le(hn::Abs(a), hn::Set(d, std::numeric_limits<float>::max())));
}

/// What gravity adds to the guess of a register of vertices. False where they differ.
HWY_INLINE bool GuessGravity(const MotionArguments& a, size_t i, size_t points, V gravity, V& out) {
    size_t set = 0;
    for (size_t k = 0; k < points; ++k) set += a.free_vertex[i + k] != 0 ? 1U : 0U;
    out = a.gravity_in_guess || set == points ? gravity : hn::Zero(D());
    return a.gravity_in_guess || set == 0 || set == points;
}

HWY_INLINE size_t BeginMotion(const MotionArguments& a, size_t first, size_t last) {
    const D d;
    const size_t points = hn::Lanes(d) / 4;
    const V h = hn::Set(d, a.h), zero = hn::Zero(d);
    const V gravity = EveryPoint(a.fall_m_s);
    const M point = PointLanes();
    for (; first + points <= last; first += points) {
        const V x = hn::LoadU(d, &a.x[first].x), v = hn::LoadU(d, &a.v[first].x);
        V g;
        if (!AllFinite(hn::Add(x, v)) || !GuessGravity(a, first, points, gravity, g)) break;
        hn::StoreU(x, d, &a.x_start[first].x);
        const M moves = hn::And(point, hn::Gt(hn::Broadcast<3>(x), zero));
        hn::StoreU(hn::IfThenElse(moves, hn::MulAdd(h, hn::Add(v, g), x), x), d, &a.x[first].x);
    }
    return first;
}

HWY_INLINE size_t EndMotion(const MotionArguments& a, size_t first, size_t last) {
    const D d;
    const hn::RebindToSigned<D> di;
    const size_t points = hn::Lanes(d) / 4;
    alignas(64) static constexpr std::array<int32_t, 16> kPointOf{0, 0, 0, 0, 1, 1, 1, 1,
                                                                  2, 2, 2, 2, 3, 3, 3, 3};
    const auto point_of = hn::IndicesFromVec(d, hn::Load(di, kPointOf.data()));
    const V h = hn::Set(d, a.h), inverse_h = hn::Set(d, 1.0F / a.h), zero = hn::Zero(d);
    const V one = hn::Set(d, 1.0F), gravity = EveryPoint(a.fall_m_s);
    const M point = PointLanes();
    for (; first + 4 <= last; first += points) {
        const V x = hn::LoadU(d, &a.x[first].x), start = hn::LoadU(d, &a.x_start[first].x);
        const V v = hn::LoadU(d, &a.v[first].x);
        V g;
        if (!AllFinite(x) || !GuessGravity(a, first, points, gravity, g)) break;
        const M moves = hn::Gt(hn::Broadcast<3>(x), zero);
        const V base = hn::IfThenElseZero(moves, hn::Add(v, g));
        const V from = hn::MulAdd(h, base, start);
        // Four damping rates are read, as many as there are points are used.
        const V damping =
            hn::TableLookupLanes(hn::LoadDup128(d, a.damping_per_s + first), point_of);
        const V keep = hn::Div(one, hn::MulAdd(h, damping, one));
        const V moved = hn::Mul(keep, hn::MulAdd(hn::Sub(x, from), inverse_h, base));
        hn::StoreU(hn::IfThenElseZero(point, moved), d, &a.v[first].x);
    }
    return first;
}

#endif  // HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();
#endif  // include guard
