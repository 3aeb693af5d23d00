// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/rod/rod_step.h"

#include <algorithm>
#include <cmath>

#include "sim/core/aligned_vector.h"
#include "sim/core/as_index.h"
#include "sim/rod/rod_lanes-inl.h"

namespace placode::sim {

struct RodScratch::Lists {
    AlignedVector<Pivot<TwoDoubles>> fronts;  ///< Two for every segment: its node, its frame.
    std::array<Pivot<double>, 6> middle{};
    std::vector<Vec3> dx, dq;         ///< Of one Newton step.
    std::vector<Vec3> moved, turned;  ///< Since the substep began.
    std::vector<Vec3> was_x;          ///< When it began.
    std::vector<Quat> was_q;
    std::vector<Vec3> gamma, omega;  ///< (S) Strain in world and, at nodes, bend when it began.
};

RodScratch::RodScratch(const Rod& rod) : lists_(std::make_unique<Lists>()) {
    const auto n = as_index(rod.segments());
    lists_->fronts.resize(n + 2);
    for (auto* list : {&lists_->dx, &lists_->moved, &lists_->omega, &lists_->was_x})
        list->assign(n + 1, Vec3::Zero());
    lists_->was_q.assign(n, Quat::Identity());
    for (auto* list : {&lists_->dq, &lists_->turned, &lists_->gamma}) list->assign(n, Vec3::Zero());
}
RodScratch::~RodScratch() = default;
RodScratch::RodScratch(RodScratch&&) noexcept = default;
RodScratch& RodScratch::operator=(RodScratch&&) noexcept = default;

namespace {

constexpr double kMostTurnRad = 0.5;   ///< Of a segment in one Newton step.
constexpr double kMostGuessRad = 0.1;  ///< Of a segment in the start guess.

/// Small turn that takes `from` to `to`.
Vec3 turn_between(const Quat& from, const Quat& to) {
    Quat d = to * from.conjugate();
    if (d.w() < 0) d.coeffs() = -d.coeffs();
    // The update takes (1, turn / 2), normalised.
    return 2 / std::max(d.w(), 1e-3) * d.vec();
}

}  // namespace

class RodStepper {
 public:
    RodStepper(const Rod& rod, RodState& state, const RodDrive& drive, RodScratch& scratch)
        : rod_(rod),
          state_(state),
          drive_(drive),
          s_(*scratch.lists_),
          segments_(as_index(rod.segments())),
          lanes_((segments_ - 1) / 2),
          per_h_(1 / drive.h_s),
          retard_(rod.spec().retardation_s / drive.h_s),
          drag_(1 + rod.spec().drag_per_s * drive.h_s) {}

    RodReport run() {
        RodReport report;
        start();
        for (int i = 0; i < drive_.iterations; ++i) {
            if (i == 0)
                solve<true>();
            else
                solve<false>();
            report.not_finite = !apply(report);
            ++report.iterations;
            if (report.not_finite || report.largest_turn_rad < drive_.turn_rad) break;
        }
        finish(report.not_finite);
        return report;
    }

 private:
    /// The start guess: everything goes on as it goes. From the old places instead, a turning
    /// thread would be stretched by one Newton step and braked by that: 3 % of its spin in a second
    /// at 2 rad/s became 96 %.
    void start() {
        std::copy(state_.x.begin(), state_.x.end(), s_.was_x.begin());
        std::copy(state_.q.begin(), state_.q.end(), s_.was_q.begin());
        // Where a thread whips round, that guess would be worse than none.
        double fastest = 0;
        for (const Vec3& w : state_.w) fastest = std::max(fastest, w.squaredNorm());
        const double most = kMostGuessRad * per_h_;
        const double ahead =
            fastest > most * most ? kMostGuessRad / std::sqrt(fastest) : drive_.h_s;
        for (size_t i = 0; i <= segments_; ++i) {
            s_.moved[i] = ahead * state_.v[i];
            state_.x[i] += s_.moved[i];
        }
        for (size_t j = 0; j < segments_; ++j) {
            s_.turned[j] = ahead * state_.w[j];
            turn_by(state_.q[j], s_.turned[j]);
        }
    }

    static void turn_by(Quat& q, const Vec3& by) {
        q = Quat(1, 0.5 * by.x(), 0.5 * by.y(), 0.5 * by.z()) * q;
        q.coeffs() *= 1 / std::sqrt(q.squaredNorm());
    }

    template <bool kFirst>
    void solve() {
        Gathered<TwoDoubles> both;
        add_clamps<kFirst>(both);
        for (size_t k = 0; k < lanes_; ++k) {
            const auto at = from_both_ends(k, segments_);
            advance<kFirst>(at, true, both, &s_.fronts[2 * k]);
        }
        Gathered<double> front = lane_of(both, 0);
        const Gathered<double> back = lane_of(both, 1);
        size_t used = 0;
        for (size_t k = lanes_; k < segments_ - lanes_; ++k, used += 2) {
            const bool last = k + 1 == segments_ - lanes_;
            if (last) {
                front.pq += back.pq;
                front.bq += back.bq;
                from_the_back_ = back.xq;
            } else {
                from_the_back_ = {};
            }
            advance<kFirst>(forwards(k), !last, front, &s_.middle[used]);
        }
        from_the_back_ = {};
        front.px += back.px;
        front.bx += back.bx;
        last_node(front, s_.middle[used]);
        go_back(used);
    }

    static Gathered<double> lane_of(const Gathered<TwoDoubles>& g, size_t i) {
        const auto s = [i](const S3<TwoDoubles>& m) {
            return S3<double>{m.xx[i], m.xy[i], m.xz[i], m.yy[i], m.yz[i], m.zz[i]};
        };
        const auto v = [i](const V3<TwoDoubles>& a) { return V3<double>{a.x[i], a.y[i], a.z[i]}; };
        return {
            s(g.px), s(g.pq), v(g.bx), v(g.bq), {{v(g.xq.row[0]), v(g.xq.row[1]), v(g.xq.row[2])}}};
    }

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

    /// Node `near`, its segment, and the bend to the next segment; then both are eliminated.
    template <bool kFirst, class T>
    void advance(const Place<T>& at, bool has_next, Gathered<T>& g, Pivot<T>* out) {
        Gathered<T> next;
        M3<T> xx;  // near with far
        M3<T> qx;  // the frame with far
        add_node(at.near, g.px, g.bx);
        add_segment<kFirst>(at, g, next, xx, qx);
        if (!drive_.contact.empty()) add_contact(at, g, next, xx);
        M3<T> qq{};
        if (has_next) add_bend<kFirst>(at, g, next, qq);
        // The back front's coupling of this frame with the far node, where the fronts meet.
        if constexpr (std::is_same_v<T, double>) {
            const M3<double> t = transposed(from_the_back_);
            for (size_t r = 0; r < 3; ++r) qx.row[r] += t.row[r];
        }
        hold(state_.node_held, at.near, g.px, g.bx, g.xq, xx, g.bq, next.bx,
             [&](size_t i) { return Vec3(state_.node_target[i] - state_.x[i]); });
        eliminate(g.px, g.bx, g.xq, xx, out[0], {g.pq, g.bq, next.px, next.bx, qx});
        hold(state_.frame_held, at.segment, g.pq, g.bq, qx, qq, next.bx, next.bq,
             [&](size_t i) { return turn_between(state_.q[i], state_.frame_target[i]); });
        eliminate(g.pq, g.bq, qx, qq, out[1], {next.px, next.bx, next.pq, next.bq, next.xq});
        g = next;
    }

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

    /// A block with a given value is cut off from the others, which get that value's share.
    template <class T, class Value>
    void hold(const std::vector<uint8_t>& held, const auto& at, S3<T>& p, V3<T>& b, M3<T>& u,
              M3<T>& v, V3<T>& b_next, V3<T>& b_after, Value&& value_of) const {
        for (size_t i = 0; i < Place<T>::kLanes; ++i) {
            if (held[at[i]] == 0) continue;
            const Vec3 value = value_of(at[i]);
            Vec3 next = lane(b_next, i), after = lane(b_after, i);
            for (size_t r = 0; r < 3; ++r) {
                next -= value[static_cast<Eigen::Index>(r)] * lane(u.row[r], i);
                after -= value[static_cast<Eigen::Index>(r)] * lane(v.row[r], i);
                set_lane(u.row[r], i, Vec3::Zero());
                set_lane(v.row[r], i, Vec3::Zero());
            }
            set_lane(b_next, i, next);
            set_lane(b_after, i, after);
            set_lane(p, i, {1, 0, 0, 1, 0, 1});
            set_lane(b, i, value);
        }
    }

    void last_node(Gathered<double>& g, Pivot<double>& out) {
        const std::array<size_t, 1> node{segments_ - lanes_};
        add_node(node, g.px, g.bx);
        M3<double> none{};
        V3<double> nothing{};
        hold(state_.node_held, node, g.px, g.bx, none, none, nothing, nothing,
             [&](size_t i) { return Vec3(state_.node_target[i] - state_.x[i]); });
        factor(g.px, out);
        out.u = out.v = {};
        out.y = forward(out, g.bx);
    }

    void go_back(size_t used) {
        V3<double> node = solved(s_.middle[used], V3<double>{}, V3<double>{});
        V3<double> frame{};
        store(s_.dx.data(), std::array<size_t, 1>{segments_ - lanes_}, node);
        const V3<double> back_node = node;
        V3<double> back_frame{};
        for (size_t k = segments_ - lanes_; k-- > lanes_;) {
            used -= 2;
            const auto at = forwards(k);
            frame = solved(s_.middle[used + 1], node, frame);
            node = solved(s_.middle[used], frame, node);
            store(s_.dq.data(), at.segment, frame);
            store(s_.dx.data(), at.near, node);
            if (k + 1 == segments_ - lanes_) back_frame = frame;
        }
        const auto two = [](const V3<double>& a, const V3<double>& b) {
            return V3<TwoDoubles>{TwoDoubles{a.x, b.x}, TwoDoubles{a.y, b.y}, TwoDoubles{a.z, b.z}};
        };
        V3<TwoDoubles> nodes = two(node, back_node), frames = two(frame, back_frame);
        for (size_t k = lanes_; k-- > 0;) {
            const auto at = from_both_ends(k, segments_);
            frames = solved(s_.fronts[2 * k + 1], nodes, frames);
            nodes = solved(s_.fronts[2 * k], frames, nodes);
            store(s_.dq.data(), at.segment, frames);
            store(s_.dx.data(), at.near, nodes);
        }
    }

    /// Adds the Newton step; false if it is not finite.
    bool apply(RodReport& report) {
        double turn = 0, sum = 0;
        for (const Vec3& d : s_.dx) sum += d.squaredNorm();
        for (const Vec3& d : s_.dq) {
            sum += d.squaredNorm();
            turn = std::max(turn, d.squaredNorm());
        }
        if (!std::isfinite(sum)) return false;
        // Far from the solution a whole Newton step overshoots: turns are linearised.
        const double share =
            turn > kMostTurnRad * kMostTurnRad ? kMostTurnRad / std::sqrt(turn) : 1;
        for (size_t i = 0; i <= segments_; ++i) {
            const Vec3 d = share * s_.dx[i];
            state_.x[i] += d;
            s_.moved[i] += d;
        }
        for (size_t j = 0; j < segments_; ++j) {
            const Vec3 d = share * s_.dq[j];
            turn_by(state_.q[j], d);
            s_.turned[j] += d;
        }
        report.largest_turn_rad = std::sqrt(turn);
        return true;
    }

    void finish(bool stop) {
        if (stop) {
            std::copy(s_.was_x.begin(), s_.was_x.end(), state_.x.begin());
            std::copy(s_.was_q.begin(), s_.was_q.end(), state_.q.begin());
            std::fill(state_.v.begin(), state_.v.end(), Vec3::Zero());
            std::fill(state_.w.begin(), state_.w.end(), Vec3::Zero());
            return;
        }
        for (size_t i = 0; i <= segments_; ++i) {
            state_.v[i] = per_h_ * s_.moved[i];
            if (state_.node_held[i] != 0) state_.x[i] = state_.node_target[i];
        }
        for (size_t j = 0; j < segments_; ++j) {
            state_.w[j] = per_h_ * s_.turned[j];
            if (state_.frame_held[j] != 0) state_.q[j] = state_.frame_target[j];
        }
    }

    const Rod& rod_;
    RodState& state_;
    const RodDrive& drive_;
    RodScratch::Lists& s_;
    size_t segments_, lanes_;  ///< Steps that the two fronts make side by side.
    double per_h_, retard_, drag_;
    M3<double> from_the_back_{};  ///< Coupling that the back front has left, see solve().
};

RodReport step_rod(const Rod& rod, RodState& state, const RodDrive& drive,
                   RodScratch& scratch) noexcept {
    return RodStepper(rod, state, drive, scratch).run();
}

}  // namespace placode::sim
