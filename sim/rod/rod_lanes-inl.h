// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reading and writing a rod's lists from one front or from both at once, one front a lane.

#include "sim/rod/rod_elimination-inl.h"

namespace placode::sim {

/// Where one step of a front stands: the only difference between the two directions.
template <class T>
struct Place {
    static constexpr size_t kLanes = sizeof(T) / sizeof(double);
    std::array<size_t, kLanes> near, far, segment, next_segment;
    T along;  ///< 1 forwards, -1 backwards.
};

inline Place<double> forwards(size_t k) { return {{k}, {k + 1}, {k}, {k + 1}, 1.0}; }
inline Place<TwoDoubles> from_both_ends(size_t k, size_t segments) {
    return {{k, segments - k},
            {k + 1, segments - k - 1},
            {k, segments - k - 1},
            {k + 1, segments - k - 2},
            TwoDoubles{1.0, -1.0}};
}

inline double load(const double* at, const std::array<size_t, 1>& i) { return at[i[0]]; }
inline TwoDoubles load(const double* at, const std::array<size_t, 2>& i) {
    return TwoDoubles{at[i[0]], at[i[1]]};
}
inline V3<double> load(const Vec3* at, const std::array<size_t, 1>& i) {
    const Vec3& a = at[i[0]];
    return {a.x(), a.y(), a.z()};
}
inline V3<TwoDoubles> load(const Vec3* at, const std::array<size_t, 2>& i) {
    const Vec3 &a = at[i[0]], &b = at[i[1]];
    return {TwoDoubles{a.x(), b.x()}, TwoDoubles{a.y(), b.y()}, TwoDoubles{a.z(), b.z()}};
}
inline Q4<double> load(const Quat* at, const std::array<size_t, 1>& i) {
    const Quat& a = at[i[0]];
    return {a.w(), {a.x(), a.y(), a.z()}};
}
inline Q4<TwoDoubles> load(const Quat* at, const std::array<size_t, 2>& i) {
    const Quat &a = at[i[0]], &b = at[i[1]];
    return {TwoDoubles{a.w(), b.w()},
            {TwoDoubles{a.x(), b.x()}, TwoDoubles{a.y(), b.y()}, TwoDoubles{a.z(), b.z()}}};
}
inline void store(Vec3* at, const std::array<size_t, 1>& i, const V3<double>& a) {
    at[i[0]] = Vec3(a.x, a.y, a.z);
}
inline void store(Vec3* at, const std::array<size_t, 2>& i, const V3<TwoDoubles>& a) {
    at[i[0]] = Vec3(a.x[0], a.y[0], a.z[0]);
    at[i[1]] = Vec3(a.x[1], a.y[1], a.z[1]);
}
inline double lane(const double& value, size_t) { return value; }
inline void set_lane(double& value, size_t, double to) { value = to; }
inline void set_lane(TwoDoubles& value, size_t i, double to) { value[i] = to; }
inline double lane(const TwoDoubles& value, size_t i) { return value[i]; }

template <class T>
inline void set_lane(V3<T>& v, size_t i, const Vec3& to) {
    set_lane(v.x, i, to.x());
    set_lane(v.y, i, to.y());
    set_lane(v.z, i, to.z());
}
template <class T>
Vec3 lane(const V3<T>& v, size_t i) {
    return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
}
template <class T>
inline void set_lane(S3<T>& s, size_t i, const std::array<double, 6>& to) {
    set_lane(s.xx, i, to[0]);
    set_lane(s.xy, i, to[1]);
    set_lane(s.xz, i, to[2]);
    set_lane(s.yy, i, to[3]);
    set_lane(s.yz, i, to[4]);
    set_lane(s.zz, i, to[5]);
}

/// What has been gathered for the next node and the next frame of a front.
template <class T>
struct Gathered {
    S3<T> px{}, pq{};
    V3<T> bx{}, bq{};
    M3<T> xq{};  ///< Node (rows) with frame (columns).
};

}  // namespace placode::sim
