// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The two elements of a rod, and 3x3 algebra, for a number that is one double or two side by side.
// `near` and `far` are ends of an element as seen by whoever walks along the rod; walking backwards
// turns the sign of d3 and of rest angles, and nothing else.

#include "sim/rod/rod.h"

namespace placode::sim {

/// Two doubles: the fronts that start at the two ends of a rod.
using TwoDoubles = double __attribute__((vector_size(16)));

template <class T>
struct V3 {
    T x, y, z;
    friend V3 operator+(const V3& a, const V3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend V3 operator-(const V3& a, const V3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend V3 operator*(const T& s, const V3& a) { return {s * a.x, s * a.y, s * a.z}; }
    void operator+=(const V3& b) { *this = *this + b; }
    void operator-=(const V3& b) { *this = *this - b; }
};
template <class T>
[[nodiscard]] inline T dot(const V3<T>& a, const V3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
[[nodiscard]] inline V3<T> cross(const V3<T>& a, const V3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
struct Q4 {
    T w;
    V3<T> v;
};
template <class T>
[[nodiscard]] inline V3<T> rotated(const Q4<T>& q, const V3<T>& u) {
    const V3<T> c = cross(q.v, u);
    return u + (q.w + q.w) * c + (T{} + 2.0) * cross(q.v, c);
}
/// conj(a) b.
template <class T>
[[nodiscard]] inline Q4<T> between(const Q4<T>& a, const Q4<T>& b) {
    return {a.w * b.w + dot(a.v, b.v), a.w * b.v - b.w * a.v - cross(a.v, b.v)};
}
template <class T>
[[nodiscard]] inline V3<T> third_axis(const Q4<T>& q) {
    const T two = T{} + 2.0;
    return {two * (q.v.x * q.v.z + q.w * q.v.y), two * (q.v.y * q.v.z - q.w * q.v.x),
            1.0 - two * (q.v.x * q.v.x + q.v.y * q.v.y)};
}

/// Symmetric.
template <class T>
struct S3 {
    T xx, xy, xz, yy, yz, zz;
    void operator+=(const S3& o) {
        xx += o.xx;
        xy += o.xy;
        xz += o.xz;
        yy += o.yy;
        yz += o.yz;
        zz += o.zz;
    }
    void add_diagonal(const T& s) {
        xx += s;
        yy += s;
        zz += s;
    }
};
/// a I + b u u^T.
template <class T>
[[nodiscard]] inline S3<T> diagonal_and_square(const T& a, const T& b, const V3<T>& u) {
    const V3<T> bu = b * u;
    return {a + bu.x * u.x, bu.x * u.y, bu.x * u.z, a + bu.y * u.y, bu.y * u.z, a + bu.z * u.z};
}

/// Stretch and shear of one segment.
template <class T>
struct SegmentStrain {
    V3<T> t;      ///< (x_far - x_near) / l
    V3<T> gamma;  ///< t - d3, in world.
    V3<T> force;  ///< Derivative of the energy by x_far; by x_near it is the opposite [N].
    T tension;    ///< Along d3 [N].
};
template <class T>
[[nodiscard]] inline SegmentStrain<T> segment_strain(const V3<T>& near, const V3<T>& far,
                                                     const V3<T>& d3, const T& per_length,
                                                     const RodStiffness& k) {
    SegmentStrain<T> s;
    s.t = per_length * (far - near);
    s.gamma = s.t - d3;
    const T axial = dot(d3, s.gamma);
    s.force = (T{} + k.shear_n) * s.gamma + ((k.stretch_n - k.shear_n) * axial) * d3;
    s.tension = k.stretch_n * axial;
    return s;
}

/// Bend and twist from one frame to the next.
template <class T>
struct BendStrain {
    V3<T> omega;   ///< In either frame [rad].
    V3<T> moment;  ///< Derivative of the energy by a turn of the far frame, in world [N m].
};
/// From p = conj(q_near) q_far, omega = 4 v / (1 + w). A turn D of the far frame against the near
/// one (in its axes) changes p by D p / 2, so
///   d omega = 2 / (1 + w) (w D + D x v) + 2 v (D . v) / (1 + w)^2.
/// `was` is omega when the substep began, `retard` the retardation time over the substep: damping.
template <class T>
[[nodiscard]] inline V3<T> bend_omega(const Q4<T>& p) {
    return (4.0 / (1.0 + p.w)) * p.v;
}
template <class T>
[[nodiscard]] inline BendStrain<T> bend_strain(const Q4<T>& near, const Q4<T>& far,
                                               const V3<T>& rest, const V3<T>& was, double retard,
                                               const T& per_length, const RodStiffness& k) {
    const Q4<T> p = between(near, far);
    const T r = 1.0 / (1.0 + p.w);
    BendStrain<T> s;
    s.omega = (4.0 * r) * p.v;
    const V3<T> strain = s.omega - rest + (T{} + retard) * (s.omega - was);
    const T bend = k.bend_n_m2 * per_length, twist = k.twist_n_m2 * per_length;
    const V3<T> m{bend * strain.x, bend * strain.y, twist * strain.z};
    const T two_r = r + r;
    const V3<T> in_frame = two_r * (p.w * m + cross(p.v, m)) + (two_r * r * dot(p.v, m)) * p.v;
    s.moment = rotated(near, in_frame);
    return s;
}

}  // namespace placode::sim
