// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex block descent on 16 vertices of one colour: one Newton step each with the exact Hessian,
// which is positive definite because J is linear in one vertex (kernel_layout.h).

#if defined(PLACODE_SIM_VERTEX_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLACODE_SIM_VERTEX_KERNEL_INL
#undef PLACODE_SIM_VERTEX_KERNEL_INL
#else
#define PLACODE_SIM_VERTEX_KERNEL_INL
#endif

#include "sim/solver/sheet_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {

/// So many floats ahead the rows are asked for: 24 steps, since the processor by itself stops at
/// the end of a page. Slab of 642,000 tets 1.1 to 1.4 times as fast, no difference at 43,200.
constexpr size_t kPrefetch = 24 * 3 * kLanes;

template <bool kLow>
HWY_INLINE void AddElastic(const KernelArguments& a, const VertexBatch& b, size_t lane, const V3& x,
                           const V3& x_low, Systems& s) {
    const D d;
    const char* points = reinterpret_cast<const char*>(a.x + b.base);
    [[maybe_unused]] const char* lows =
        reinterpret_cast<const char*>(a.x_low + (kLow ? b.base : 0));
    const uint16_t* strip = a.packed->strip.data() + b.step_start * kLanes + lane;
    const uint16_t* keep = a.packed->keep.data() + b.step_start;
    const float* row = a.lanes + b.lane_start + kLanes + lane;
    V3 gradient = s.gradient;
    V xx = s.xx, xy = s.xy, xz = s.xz, yy = s.yy, yz = s.yz, zz = s.zz;
    V3 older = {hn::Zero(d), hn::Zero(d), hn::Zero(d)}, newer = older;
    for (int32_t step = 0; step < b.steps; ++step) {
        for (size_t k = 0; k < 3; ++k) hwy::Prefetch(row + kPrefetch + k * kLanes);
        V3 p = Sub(Gather3(points, strip), x);
        if constexpr (kLow) p = Add(p, Sub(Gather3(lows, strip), x_low));
        gradient = NegMulAdd(hn::Load(d, row), p, gradient);
        const V stiffness = hn::Load(d, row + kLanes);
        const V3 normal = Cross(Sub(newer, older), Sub(p, older));
        const V excess = hn::Sub(Dot(normal, older), hn::Load(d, row + 2 * kLanes));
        gradient = NegMulAdd(hn::Mul(stiffness, excess), normal, gradient);
        const V3 scaled = Scale(stiffness, normal);
        xx = hn::MulAdd(scaled.x, normal.x, xx);
        xy = hn::MulAdd(scaled.x, normal.y, xy);
        xz = hn::MulAdd(scaled.x, normal.z, xz);
        yy = hn::MulAdd(scaled.y, normal.y, yy);
        yz = hn::MulAdd(scaled.y, normal.z, yz);
        zz = hn::MulAdd(scaled.z, normal.z, zz);
        uint64_t bits = static_cast<uint64_t>(keep[step]) >> lane;
        const M kept = hn::LoadMaskBits(d, reinterpret_cast<const uint8_t*>(&bits));
        older = Select(kept, older, newer);
        newer = p;
        strip += kLanes;
        row += 3 * kLanes;
    }
    s = {gradient, xx, xy, xz, yy, yz, zz, s.floor};
}

HWY_INLINE void AddSprings(const KernelArguments& a, const VertexBatch& b, size_t lane, const V3& x,
                           Systems& s) {
    if (b.spring_start < 0) return;
    const D d;
    const float* k = a.springs + b.spring_start + lane;
    const auto row = [d, k](size_t r) HWY_ATTR { return hn::Load(d, k + r * kLanes); };
    const V3 moved = Sub(x, {row(6), row(7), row(8)});
    const V3 force = {
        hn::Add(row(9), Dot({row(0), row(1), row(2)}, moved)),
        hn::Add(row(10), Dot({row(1), row(3), row(4)}, moved)),
        hn::Add(row(11), Dot({row(2), row(4), row(5)}, moved)),
    };
    s.gradient = {hn::Add(s.gradient.x, force.x), hn::Add(s.gradient.y, force.y),
                  hn::Add(s.gradient.z, force.z)};
    s.xx = hn::Add(s.xx, row(0));
    s.xy = hn::Add(s.xy, row(1));
    s.xz = hn::Add(s.xz, row(2));
    s.yy = hn::Add(s.yy, row(3));
    s.yz = hn::Add(s.yz, row(4));
    s.zz = hn::Add(s.zz, row(5));
    s.floor = hn::Add(s.floor, row(12));
}

/// -H^-1 g by L D L^T. Rounding may push a pivot below its exact bound: the floor stops that.
HWY_INLINE V3 Descend(const Systems& s) {
    const D d;
    const V one = hn::Set(d, 1.0F);
    const V i0 = hn::Div(one, hn::Max(s.xx, s.floor));
    const V l1 = hn::Mul(s.xy, i0), l2 = hn::Mul(s.xz, i0);
    const V i1 = hn::Div(one, hn::Max(hn::NegMulAdd(l1, s.xy, s.yy), s.floor));
    const V e = hn::NegMulAdd(l2, s.xy, s.yz);
    const V l3 = hn::Mul(e, i1);
    const V i2 =
        hn::Div(one, hn::Max(hn::NegMulAdd(l3, e, hn::NegMulAdd(l2, s.xz, s.zz)), s.floor));
    const V y0 = hn::Neg(s.gradient.x);
    const V y1 = hn::NegMulAdd(l1, y0, hn::Neg(s.gradient.y));
    const V y2 = hn::NegMulAdd(l3, y1, hn::NegMulAdd(l2, y0, hn::Neg(s.gradient.z)));
    const V z = hn::Mul(y2, i2);
    const V y = hn::NegMulAdd(l3, z, hn::Mul(y1, i1));
    const V x = hn::NegMulAdd(l2, z, hn::NegMulAdd(l1, y, hn::Mul(y0, i0)));
    return {x, y, z};
}

/// @param sheet nullptr, or (kSheet) what goes round the vertices of the batch.
template <bool kLow, bool kSheet>
HWY_INLINE uint32_t SolveVertexBatch(const KernelArguments& a, int number,
                                     [[maybe_unused]] const SheetBatch* sheet = nullptr) {
    const D d;
    const VertexBatch& b = a.packed->batches[static_cast<size_t>(number)];
    const V inverse_h2 = hn::Set(d, 1.0F / (a.h * a.h));
    const V h = hn::Set(d, a.h);
    const V3 fall = {hn::Set(d, a.planned_fall_m[0]), hn::Set(d, a.planned_fall_m[1]),
                     hn::Set(d, a.planned_fall_m[2])};
    const V zero = hn::Zero(d);
    uint32_t flags = 0;
    for (size_t lane = 0; lane < static_cast<size_t>(b.count); lane += hn::Lanes(d)) {
        const uint16_t* self = b.self.data() + lane;
        const V4 point = Gather(reinterpret_cast<const char*>(a.x + b.base), self);
        const V3 x = {point.x, point.y, point.z};
        const V3 start = Gather3(reinterpret_cast<const char*>(a.x_start + b.base), self);
        const V3 velocity = Gather3(reinterpret_cast<const char*>(a.v + b.base), self);
        // x - target from small numbers only; the target as a float has lost most of h^2 g.
        V3 offset = Sub(x, start), low = {zero, zero, zero};
        if constexpr (kLow) {
            low = Gather3(reinterpret_cast<const char*>(a.x_low + b.base), self);
            offset =
                Add(offset,
                    Sub(low, Gather3(reinterpret_cast<const char*>(a.x_start_low + b.base), self)));
        }
        const V3 off = Sub(offset, MulAdd(h, velocity, fall));
        const V inertia = hn::Mul(hn::Load(d, b.mass_kg.data() + lane), inverse_h2);
        const V diagonal = hn::Add(inertia, hn::Load(d, a.lanes + b.lane_start + lane));
        Systems s = {Scale(inertia, off), diagonal, zero, zero, diagonal, zero, diagonal, diagonal};
        AddElastic<kLow>(a, b, lane, x, low, s);
        AddSprings(a, b, lane, x, s);
        if constexpr (kSheet) AddSheet<kLow>(a, *sheet, lane, x, low, s);
        V3 step = Scale(hn::Set(d, a.over_relaxation), Descend(s));

        const V length2 = Dot(step, step);
        const V limit = hn::Load(d, b.limit_m.data() + lane);
        const M active = hn::Gt(point.w, zero);
        const M finite = hn::Le(length2, hn::Set(d, std::numeric_limits<float>::max()));
        const M sane = hn::And(active, finite);
        const M limited = hn::And(sane, hn::Gt(length2, hn::Mul(limit, limit)));
        if (HWY_UNLIKELY(!hn::AllFalse(d, limited))) {
            const V shorter = hn::Div(limit, hn::Sqrt(length2));
            step = Select(limited, Scale(shorter, step), step);
            flags |= kStepLimited;
        }
        // A step that is not finite is not taken, so that one bad vertex does not spread.
        step = Select(sane, step, {zero, zero, zero});
        const int count = b.count - static_cast<int>(lane);
        V3 moved = Add(x, step);
        if constexpr (kLow) {
            moved = x;
            Carry(moved.x, low.x, step.x);
            Carry(moved.y, low.y, step.y);
            Carry(moved.z, low.z, step.z);
            Scatter({low.x, low.y, low.z, zero}, reinterpret_cast<char*>(a.x_low + b.base), self,
                    count);
        }
        Scatter({moved.x, moved.y, moved.z, point.w}, reinterpret_cast<char*>(a.x + b.base), self,
                count);
    }
    return flags;
}

/// XPBD: a linear spring has an exact block, (m/h^2 + K) dx = -(K (x - rest) + f0) - m/h^2 sum,
/// where m/h^2 sum of the earlier dx is the accumulated multiplier.
HWY_INLINE void SolveSpringBatch(const KernelArguments& a, int number) {
    const D d;
    const VertexBatch& b = a.packed->batches[static_cast<size_t>(number)];
    if (b.spring_start < 0) return;
    const V zero = hn::Zero(d), inverse_h2 = hn::Set(d, 1.0F / (a.h * a.h));
    for (size_t lane = 0; lane < static_cast<size_t>(b.count); lane += hn::Lanes(d)) {
        const uint16_t* self = b.self.data() + lane;
        const V4 point = Gather(reinterpret_cast<const char*>(a.x + b.base), self);
        const V3 x = {point.x, point.y, point.z};
        const M free = hn::Gt(point.w, zero);
        const V inertia = hn::Div(inverse_h2, hn::IfThenElse(free, point.w, hn::Set(d, 1.0F)));
        Systems s = {{zero, zero, zero}, inertia, zero, zero, inertia, zero, inertia, inertia};
        float* sum = nullptr;
        V3 before = {zero, zero, zero};
        if (a.packed->spring_sum_start >= 0) {
            const int64_t row = b.spring_start / (kSpringRows * kLanes);
            sum = a.lanes + a.packed->spring_sum_start + row * 3 * kLanes + lane;
            before = {hn::Load(d, sum), hn::Load(d, sum + kLanes), hn::Load(d, sum + 2 * kLanes)};
            s.gradient = Scale(inertia, before);
        }
        AddSprings(a, b, lane, x, s);
        V3 step = Descend(s);
        const M sane = hn::And(free, FiniteLanes(Dot(step, step)));
        step = {hn::IfThenElseZero(sane, step.x), hn::IfThenElseZero(sane, step.y),
                hn::IfThenElseZero(sane, step.z)};
        if (sum != nullptr) {
            hn::Store(hn::Add(before.x, step.x), d, sum);
            hn::Store(hn::Add(before.y, step.y), d, sum + kLanes);
            hn::Store(hn::Add(before.z, step.z), d, sum + 2 * kLanes);
        }
        const V3 moved = Add(x, step);
        Scatter({moved.x, moved.y, moved.z, point.w}, reinterpret_cast<char*>(a.x + b.base), self,
                b.count - static_cast<int>(lane));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();
#endif  // include guard
