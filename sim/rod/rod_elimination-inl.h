// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Block elimination of a band in which every block of three unknowns couples with the next two.
// The pivot is factored as L D L^T and only L^-1 is applied: the stiffness along the thread is 10^6
// times its inertia, and a pivot's inverse would lose in the next block what is left of inertia.

#include "sim/rod/rod_elements-inl.h"

namespace placode::sim {

/// Rows of a block that is not symmetric.
template <class T>
struct M3 {
    std::array<V3<T>, 3> row;
};

/// What a block leaves behind for going back: x = L^-T D^-1 (y - U x_next - V x_after_next).
template <class T>
struct Pivot {
    T l10, l20, l21, i0, i1, i2;
    M3<T> u, v;  ///< L^-1 times the couplings.
    V3<T> y;
};

template <class T>
inline void factor(const S3<T>& p, Pivot<T>& out) {
    out.i0 = 1.0 / p.xx;
    out.l10 = p.xy * out.i0;
    out.l20 = p.xz * out.i0;
    const T d1 = p.yy - out.l10 * p.xy;
    out.i1 = 1.0 / d1;
    const T e = p.yz - out.l20 * p.xy;
    out.l21 = e * out.i1;
    out.i2 = 1.0 / (p.zz - out.l20 * p.xz - out.l21 * e);
}

template <class T>
inline M3<T> forward(const Pivot<T>& p, const M3<T>& m) {
    M3<T> out;
    out.row[0] = m.row[0];
    out.row[1] = m.row[1] - p.l10 * out.row[0];
    out.row[2] = m.row[2] - p.l20 * out.row[0] - p.l21 * out.row[1];
    return out;
}
template <class T>
inline V3<T> forward(const Pivot<T>& p, const V3<T>& b) {
    const T y = b.y - p.l10 * b.x;
    return {b.x, y, b.z - p.l20 * b.x - p.l21 * y};
}

/// D^-1 m.
template <class T>
inline M3<T> scaled(const Pivot<T>& p, const M3<T>& m) {
    return {{p.i0 * m.row[0], p.i1 * m.row[1], p.i2 * m.row[2]}};
}

/// a^T b, for a b = a D^-1 a: symmetric.
template <class T>
inline S3<T> square(const M3<T>& a, const M3<T>& b) {
    S3<T> s{};
    for (size_t r = 0; r < 3; ++r) {
        const V3<T>&p = a.row[r], &q = b.row[r];
        s += S3<T>{p.x * q.x, p.x * q.y, p.x * q.z, p.y * q.y, p.y * q.z, p.z * q.z};
    }
    return s;
}
template <class T>
inline void subtract(S3<T>& from, const S3<T>& s) {
    from.xx -= s.xx;
    from.xy -= s.xy;
    from.xz -= s.xz;
    from.yy -= s.yy;
    from.yz -= s.yz;
    from.zz -= s.zz;
}
/// from -= a^T b
template <class T>
inline void subtract_product(M3<T>& from, const M3<T>& a, const M3<T>& b) {
    for (size_t r = 0; r < 3; ++r) {
        from.row[0] -= a.row[r].x * b.row[r];
        from.row[1] -= a.row[r].y * b.row[r];
        from.row[2] -= a.row[r].z * b.row[r];
    }
}
/// m^T b
template <class T>
inline V3<T> transposed_times(const M3<T>& m, const V3<T>& b) {
    return b.x * m.row[0] + b.y * m.row[1] + b.z * m.row[2];
}
template <class T>
inline V3<T> times(const M3<T>& m, const V3<T>& b) {
    return {dot(m.row[0], b), dot(m.row[1], b), dot(m.row[2], b)};
}
template <class T>
inline M3<T> transposed(const M3<T>& m) {
    return {{V3<T>{m.row[0].x, m.row[1].x, m.row[2].x}, V3<T>{m.row[0].y, m.row[1].y, m.row[2].y},
             V3<T>{m.row[0].z, m.row[1].z, m.row[2].z}}};
}
template <class T>
inline M3<T> full(const S3<T>& s, const T& factor) {
    return {{factor * V3<T>{s.xx, s.xy, s.xz}, factor * V3<T>{s.xy, s.yy, s.yz},
             factor * V3<T>{s.xz, s.yz, s.zz}}};
}

/// The two blocks after the one that is eliminated.
template <class T>
struct NextTwo {
    S3<T>& p_next;
    V3<T>& b_next;
    S3<T>& p_after;
    V3<T>& b_after;
    M3<T>& coupling;  ///< Of the next (rows) with the one after (columns).
};

/// Eliminates the block with pivot `p`, right side `b` and couplings u (to the next) and v (to the
/// one after). `held` and `to`: blocks with a given value, see below.
template <class T>
inline void eliminate(const S3<T>& p, const V3<T>& b, const M3<T>& u, const M3<T>& v, Pivot<T>& out,
                      const NextTwo<T>& next) {
    factor(p, out);
    out.u = forward(out, u);
    out.v = forward(out, v);
    out.y = forward(out, b);
    const M3<T> du = scaled(out, out.u), dv = scaled(out, out.v);
    subtract(next.p_next, square(out.u, du));
    subtract(next.p_after, square(out.v, dv));
    subtract_product(next.coupling, out.u, dv);
    next.b_next -= transposed_times(du, out.y);
    next.b_after -= transposed_times(dv, out.y);
}

template <class T>
inline V3<T> solved(const Pivot<T>& p, const V3<T>& next, const V3<T>& after) {
    const V3<T> r = p.y - times(p.u, next) - times(p.v, after);
    const T z = p.i2 * r.z;
    const T y = p.i1 * r.y - p.l21 * z;
    return {p.i0 * r.x - p.l10 * y - p.l20 * z, y, z};
}

}  // namespace placode::sim
