// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Positions in and out of vector registers: 16-byte loads and a 4x4 transposition, which is faster
// than gather instructions. Included once for every instruction set.

#if defined(PLACODE_SIM_GATHER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLACODE_SIM_GATHER_INL
#undef PLACODE_SIM_GATHER_INL
#else
#define PLACODE_SIM_GATHER_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "sim/solver/kernel_layout.h"

HWY_BEFORE_NAMESPACE();
namespace placode::sim {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// As many lanes as the machine has, at most one batch.
using D = HWY_CAPPED(float, 16);
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct V3 {
    V x, y, z;
};
struct V4 {
    V x, y, z, w;
};

HWY_INLINE V3 Sub(const V3& a, const V3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE V3 Add(const V3& a, const V3& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE V3 Scale(V s, const V3& a) {
    return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
HWY_INLINE V3 MulAdd(V s, const V3& a, const V3& b) {
    return {hn::MulAdd(s, a.x, b.x), hn::MulAdd(s, a.y, b.y), hn::MulAdd(s, a.z, b.z)};
}
HWY_INLINE V3 NegMulAdd(V s, const V3& a, const V3& b) {
    return {hn::NegMulAdd(s, a.x, b.x), hn::NegMulAdd(s, a.y, b.y), hn::NegMulAdd(s, a.z, b.z)};
}
HWY_INLINE V Dot(const V3& a, const V3& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE V3 Cross(const V3& a, const V3& b) {
    return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
            hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}
HWY_INLINE V3 Select(M m, const V3& yes, const V3& no) {
    return {hn::IfThenElse(m, yes.x, no.x), hn::IfThenElse(m, yes.y, no.y),
            hn::IfThenElse(m, yes.z, no.z)};
}

/// x + low += step without loss (Knuth's two-sum): x takes what a float has room for.
HWY_INLINE void Carry(V& x, V& low, V step) {
    const V add = hn::Add(low, step), sum = hn::Add(x, add);
    const V added = hn::Sub(sum, x);
    low = hn::Add(hn::Sub(x, hn::Sub(sum, added)), hn::Sub(add, added));
    x = sum;
}

HWY_INLINE M FiniteLanes(V a) {
    return hn::Le(hn::Abs(a), hn::Set(D(), std::numeric_limits<float>::max()));
}

#if HWY_TARGET == HWY_SCALAR
template <class Index>
HWY_INLINE V4 Gather(const char* base, const Index* index) {
    const D d;
    const float* p = reinterpret_cast<const float*>(base + size_t{*index} * 8);
    return {hn::Set(d, p[0]), hn::Set(d, p[1]), hn::Set(d, p[2]), hn::Set(d, p[3])};
}

HWY_INLINE void Scatter(const V4& p, char* base, const uint16_t* index, int) {
    float* out = reinterpret_cast<float*>(base + size_t{*index} * 8);
    out[0] = hn::GetLane(p.x);
    out[1] = hn::GetLane(p.y);
    out[2] = hn::GetLane(p.z);
    out[3] = hn::GetLane(p.w);
}
#else
template <class Index>
HWY_INLINE hn::Vec<hn::FixedTag<float, 4> > LoadPoint(const char* base, const Index* index) {
    const hn::FixedTag<float, 4> d4;
    return hn::Load(d4, reinterpret_cast<const float*>(base + size_t{*index} * 8));
}

/// Points of lanes k, k + 4, k + 8, ... in consecutive 128-bit blocks.
template <class Tag, class Index>
HWY_INLINE hn::Vec<Tag> LoadRow(Tag, const char* base, const Index* index) {
#if HWY_MAX_BYTES >= 32
    constexpr size_t kN = hn::MaxLanes(Tag());
    if constexpr (kN == 16) {
        const hn::FixedTag<float, 8> d8;
        const auto low = hn::Combine(d8, LoadPoint(base, index + 4), LoadPoint(base, index));
        const auto high = hn::Combine(d8, LoadPoint(base, index + 12), LoadPoint(base, index + 8));
        return hn::Combine(Tag(), high, low);
    } else if constexpr (kN == 8) {
        return hn::Combine(Tag(), LoadPoint(base, index + 4), LoadPoint(base, index));
    } else {
        return LoadPoint(base, index);
    }
#else
    return LoadPoint(base, index);
#endif
}

/// x, y, z, w of one point per lane. index[lane] = byte offset / 8 from base.
template <class Index>
HWY_INLINE V4 Gather(const char* base, const Index* index) {
    const D d;
    const hn::Repartition<double, D> dd;
    const V r0 = LoadRow(d, base, index), r1 = LoadRow(d, base, index + 1);
    const V r2 = LoadRow(d, base, index + 2), r3 = LoadRow(d, base, index + 3);
    const auto xy01 = hn::BitCast(dd, hn::InterleaveLower(d, r0, r1));
    const auto xy23 = hn::BitCast(dd, hn::InterleaveLower(d, r2, r3));
    const auto zw01 = hn::BitCast(dd, hn::InterleaveUpper(d, r0, r1));
    const auto zw23 = hn::BitCast(dd, hn::InterleaveUpper(d, r2, r3));
    return {hn::BitCast(d, hn::InterleaveLower(dd, xy01, xy23)),
            hn::BitCast(d, hn::InterleaveUpper(dd, xy01, xy23)),
            hn::BitCast(d, hn::InterleaveLower(dd, zw01, zw23)),
            hn::BitCast(d, hn::InterleaveUpper(dd, zw01, zw23))};
}

HWY_INLINE void StorePoint(hn::Vec<hn::FixedTag<float, 4> > p, char* base, const uint16_t* index) {
    const hn::FixedTag<float, 4> d4;
    hn::Store(p, d4, reinterpret_cast<float*>(base + size_t{*index} * 8));
}

/// The inverse of LoadRow.
template <class Tag>
HWY_INLINE void StoreRow(Tag, hn::Vec<Tag> row, char* base, const uint16_t* index) {
#if HWY_MAX_BYTES >= 32
    constexpr size_t kN = hn::MaxLanes(Tag());
    const hn::FixedTag<float, 4> d4;
    if constexpr (kN == 16) {
        const hn::FixedTag<float, 8> d8;
        const auto low = hn::LowerHalf(d8, row), high = hn::UpperHalf(d8, row);
        StorePoint(hn::LowerHalf(d4, low), base, index);
        StorePoint(hn::UpperHalf(d4, low), base, index + 4);
        StorePoint(hn::LowerHalf(d4, high), base, index + 8);
        StorePoint(hn::UpperHalf(d4, high), base, index + 12);
    } else if constexpr (kN == 8) {
        StorePoint(hn::LowerHalf(d4, row), base, index);
        StorePoint(hn::UpperHalf(d4, row), base, index + 4);
    } else {
        StorePoint(row, base, index);
    }
#else
    StorePoint(row, base, index);
#endif
}

/// The first `count` lanes back to their points.
HWY_INLINE void Scatter(const V4& p, char* base, const uint16_t* index, int count) {
    const D d;
    if (HWY_LIKELY(count >= static_cast<int>(hn::Lanes(d)))) {
        const hn::Repartition<double, D> dd;
        const auto xy01 = hn::BitCast(dd, hn::InterleaveLower(d, p.x, p.y));
        const auto xy23 = hn::BitCast(dd, hn::InterleaveUpper(d, p.x, p.y));
        const auto zw01 = hn::BitCast(dd, hn::InterleaveLower(d, p.z, p.w));
        const auto zw23 = hn::BitCast(dd, hn::InterleaveUpper(d, p.z, p.w));
        StoreRow(d, hn::BitCast(d, hn::InterleaveLower(dd, xy01, zw01)), base, index);
        StoreRow(d, hn::BitCast(d, hn::InterleaveUpper(dd, xy01, zw01)), base, index + 1);
        StoreRow(d, hn::BitCast(d, hn::InterleaveLower(dd, xy23, zw23)), base, index + 2);
        StoreRow(d, hn::BitCast(d, hn::InterleaveUpper(dd, xy23, zw23)), base, index + 3);
        return;
    }
    alignas(64) float out[4 * kLanes];
    hn::StoreInterleaved4(p.x, p.y, p.z, p.w, d, out);
    const hn::FixedTag<float, 4> d4;
    for (int lane = 0; lane < count; ++lane) {
        StorePoint(hn::Load(d4, out + 4 * lane), base, index + lane);
    }
}

#endif  // HWY_SCALAR

template <class Index>
HWY_INLINE V3 Gather3(const char* base, const Index* index) {
    const V4 p = Gather(base, index);
    return {p.x, p.y, p.z};
}

}  // namespace HWY_NAMESPACE
}  // namespace placode::sim
HWY_AFTER_NAMESPACE();
#endif  // include guard
