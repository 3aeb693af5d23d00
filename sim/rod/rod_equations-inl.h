// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The equations of one Newton step, block by block as the elimination asks for them: what node,
// segment, bend, clamp and contact add. For one front (double) or two side by side (TwoDoubles).
// Internal to the rod.

#include <algorithm>
#include <vector>

#include "sim/core/aligned_vector.h"
#include "sim/core/as_index.h"
#include "sim/rod/rod_lanes-inl.h"
#include "sim/rod/rod_step.h"

namespace placode::sim {

/// Memory of the step.
struct RodLists {
    AlignedVector<Pivot<TwoDoubles>> fronts;  ///< Two for every segment: its node, its frame.
    std::array<Pivot<double>, 6> middle{};
    std::vector<Vec3> dx, dq;         ///< Of one Newton step.
    std::vector<Vec3> moved, turned;  ///< Since the substep began.
    std::vector<Vec3> was_x;          ///< When it began.
    std::vector<Quat> was_q;
    std::vector<Vec3> gamma, omega;  ///< (S) Strain in world and, at nodes, bend when it began.
};

/// Of one substep; what it refers to outlives it.
class RodEquations {
 public:
    RodEquations(const Rod& rod, const RodState& state, const RodDrive& drive, RodLists& lists)
        : rod_(rod),
          state_(state),
          drive_(drive),
          s_(lists),
          segments_(as_index(rod.segments())),
          per_h_(1 / drive.h_s),
          retard_(rod.spec().retardation_s / drive.h_s),
          drag_(1 + rod.spec().drag_per_s * drive.h_s) {}

    /// Half a segment between the clamp and the first (last) frame.
    template <bool kFirst>
    void add_clamps(Gathered<TwoDoubles>& both) {
        const RodStiffness& k = rod_.spec().stiffness;
        for (size_t end = 0; end < 2; ++end) {
            if (state_.end_held[end] == 0) continue;
            const Quat& c = state_.end_frame[end];
            const size_t segment = end == 0 ? 0 : segments_ - 1;
            const size_t node = end == 0 ? 0 : segments_;
            const Q4<double> clamp{c.w(), {c.x(), c.y(), c.z()}};
            const Q4<double> frame = load(state_.q.data(), std::array<size_t, 1>{segment});
            const double per_length = 1 / rod_.bend_length_m()[node];
            if constexpr (kFirst) {
                const auto o = bend_omega(
                    between(clamp, load(s_.was_q.data(), std::array<size_t, 1>{segment})));
                s_.omega[node] = Vec3(o.x, o.y, o.z);
            }
            const auto was = load(s_.omega.data(), std::array<size_t, 1>{node});
            const auto bend = bend_strain(clamp, frame, {0, 0, 0}, was, retard_, per_length, k);
            const auto axis = third_axis(frame);
            const double damped = (1 + retard_) * per_length;
            const S3<double> stiff = diagonal_and_square(
                damped * k.bend_n_m2, damped * (k.twist_n_m2 - k.bend_n_m2), axis);
            set_lane(both.pq, end, {stiff.xx, stiff.xy, stiff.xz, stiff.yy, stiff.yz, stiff.zz});
            set_lane(both.bq, end, -Vec3(bend.moment.x, bend.moment.y, bend.moment.z));
        }
    }

    /// Inertia, gravity and outer force of a node.
    template <class T, class Index>
    void add_node(const Index& node, S3<T>& p, V3<T>& b) const {
        const T m = load(rod_.mass_kg().data(), node);
        const T inertia = m * per_h_;
        p.add_diagonal(inertia * (per_h_ * drag_));
        const Vec3& g = drive_.gravity_m_s2;
        const T zero{};
        b += inertia * load(state_.v.data(), node) +
             m * V3<T>{zero + g.x(), zero + g.y(), zero + g.z()};
        b -= (inertia * (per_h_ * drag_)) * load(s_.moved.data(), node);
        if (!drive_.force_n.empty()) b += load(drive_.force_n.data(), node);
    }

    /// Stretch, shear, their damping, and the spin of a segment.
    template <bool kFirst, class T>
    void add_segment(const Place<T>& at, Gathered<T>& g, Gathered<T>& next, M3<T>& xx, M3<T>& qx) {
        const RodStiffness& k = rod_.spec().stiffness;
        const T length = load(rod_.length_m().data(), at.segment);
        const T per_length = 1.0 / length;
        const V3<T> axis = third_axis(load(state_.q.data(), at.segment));
        const V3<T> d3 = at.along * axis;
        auto s = segment_strain(load(state_.x.data(), at.near), load(state_.x.data(), at.far), d3,
                                per_length, k);
        // Damping: the rate of the strain as the segment sees it.
        V3<T> was;
        if constexpr (kFirst) {
            was = per_length * (load(s_.was_x.data(), at.far) - load(s_.was_x.data(), at.near)) -
                  at.along * third_axis(load(s_.was_q.data(), at.segment));
            store(s_.gamma.data(), at.segment, at.along * was);
        } else {
            was = at.along * load(s_.gamma.data(), at.segment);
        }
        const V3<T> carried = was + cross(load(s_.turned.data(), at.segment), was);
        const V3<T> e = (T{} + retard_) * (s.gamma - carried);
        s.force += (T{} + k.shear_n) * e + ((k.stretch_n - k.shear_n) * dot(d3, e)) * d3;
        // Under tension T a turn costs energy although no strain changes with it. Exactly, to
        // second order: shear (GA - T) |dt - dtheta x t|^2 / 2 and T |dt across|^2 / 2. Compression
        // is left out: it would make the matrix indefinite, and forces hold it anyway. The tension
        // is that of the substep's beginning: the start guess stretches what turns, and as stiff as
        // that would be, nothing could change the way it goes.
        const T zero{};
        T tension = kFirst ? T(k.stretch_n * dot(d3, was)) : s.tension;
        tension = tension > zero ? tension : zero;
        const T most = zero + 0.9 * k.shear_n;
        tension = tension < most ? tension : most;
        const T damped = zero + (1 + retard_);
        const T shear = damped * (k.shear_n - tension);
        const T along = damped * k.stretch_n - shear;
        const V3<T>& t = s.t;
        const T t2 = dot(t, t), per_t2 = 1.0 / t2;
        const S3<T> places = diagonal_and_square((shear + tension) * per_length,
                                                 (along - tension) * per_length * per_t2, t);
        g.px += places;
        next.px += places;
        xx = full(places, T{} - 1.0);
        g.bx += s.force;
        next.bx -= s.force;
        // far with frame: shear [t]x; near: the opposite.
        const T sx = shear * t.x, sy = shear * t.y, sz = shear * t.z;
        g.xq.row[0] += V3<T>{zero, sz, -sy};
        g.xq.row[1] += V3<T>{-sz, zero, sx};
        g.xq.row[2] += V3<T>{sy, -sx, zero};
        qx = {{V3<T>{zero, sz, -sy}, V3<T>{-sz, zero, sx}, V3<T>{sy, -sx, zero}}};
        g.bq -= length * cross(s.force, t);
        const T stiff = length * shear;
        g.pq += diagonal_and_square(stiff * t2, -stiff, t);
        // Spin.
        const T inertia = load(rod_.inertia_kg_m2().data(), at.segment) * per_h_;
        const T held = inertia * (per_h_ * drag_);
        g.pq += diagonal_and_square(held, held, axis);
        V3<T> spin = inertia * load(state_.w.data(), at.segment);
        spin -= held * load(s_.turned.data(), at.segment);
        g.bq += spin + dot(axis, spin) * axis;
    }

    /// Bend and twist between a segment and the next one.
    template <bool kFirst, class T>
    void add_bend(const Place<T>& at, Gathered<T>& g, Gathered<T>& next, M3<T>& qq) {
        const RodStiffness& k = rod_.spec().stiffness;
        const Q4<T> near = load(state_.q.data(), at.segment);
        const Q4<T> far = load(state_.q.data(), at.next_segment);
        const T per_length = 1.0 / load(rod_.bend_length_m().data(), at.far);
        V3<T> was;
        if constexpr (kFirst) {
            was = bend_omega(
                between(load(s_.was_q.data(), at.segment), load(s_.was_q.data(), at.next_segment)));
            store(s_.omega.data(), at.far, at.along * was);
        } else {
            was = at.along * load(s_.omega.data(), at.far);
        }
        const auto bend = bend_strain(near, far, at.along * load(rod_.rest_omega().data(), at.far),
                                      was, retard_, per_length, k);
        g.bq += bend.moment;
        next.bq -= bend.moment;
        const V3<T> middle = (T{} + 0.5) * (third_axis(near) + third_axis(far));
        const T damped = (1 + retard_) * per_length;
        const S3<T> stiff = diagonal_and_square(damped * k.bend_n_m2,
                                                damped * (k.twist_n_m2 - k.bend_n_m2), middle);
        g.pq += stiff;
        next.pq += stiff;
        qq = full(stiff, T{} - 1.0);
    }

    /// One number of each lane's contact, as the walker's near or far end.
    template <class T, class Number>
    T gathered(const Place<T>& at, Number&& number) const {
        if constexpr (Place<T>::kLanes == 1)
            return number(drive_.contact[at.segment[0]], true);
        else
            return T{number(drive_.contact[at.segment[0]], true),
                     number(drive_.contact[at.segment[1]], false)};
    }

    /// Forces and stiffness of contact, carried along by what the segment moved.
    template <class T>
    void add_contact(const Place<T>& at, Gathered<T>& g, Gathered<T>& next, M3<T>& xx) const {
        const auto matrix = [&](auto&& side) {
            std::array<T, 6> m;
            for (size_t e = 0; e < 6; ++e)
                m[e] = gathered(at,
                                [&](const SegmentContact& c, bool fwd) { return side(c, fwd)[e]; });
            return S3<T>{m[0], m[1], m[2], m[3], m[4], m[5]};
        };
        const auto force = [&](auto&& side) {
            std::array<T, 3> f;
            for (size_t e = 0; e < 3; ++e)
                f[e] = gathered(at,
                                [&](const SegmentContact& c, bool fwd) { return side(c, fwd)[e]; });
            return V3<T>{f[0], f[1], f[2]};
        };
        using C = SegmentContact;
        const S3<T> near = matrix([](const C& c, bool fwd) { return fwd ? c.aa : c.bb; });
        const S3<T> far = matrix([](const C& c, bool fwd) { return fwd ? c.bb : c.aa; });
        const M3<T> off = full(matrix([](const C& c, bool) { return c.ab; }), T{} + 1.0);
        V3<T> on_near = force([](const C& c, bool fwd) { return fwd ? c.a : c.b; });
        V3<T> on_far = force([](const C& c, bool fwd) { return fwd ? c.b : c.a; });
        g.px += near;
        next.px += far;
        for (size_t r = 0; r < 3; ++r) xx.row[r] += off.row[r];
        const V3<T> a = load(s_.moved.data(), at.near), b = load(s_.moved.data(), at.far);
        on_near -= times(full(near, T{} + 1.0), a) + times(off, b);
        on_far -= times(full(far, T{} + 1.0), b) + times(off, a);
        g.bx += on_near;
        next.bx += on_far;
    }

 private:
    const Rod& rod_;
    const RodState& state_;
    const RodDrive& drive_;
    RodLists& s_;
    size_t segments_;
    double per_h_, retard_, drag_;
};

}  // namespace placode::sim
