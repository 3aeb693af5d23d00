// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/rod/rod_step.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/turn.h"
#include "sim/rod/rod_equations-inl.h"

namespace placode::sim {

struct RodScratch::Lists : RodLists {};

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

}  // namespace

class RodStepper {
 public:
    RodStepper(const Rod& rod, RodState& state, const RodDrive& drive, RodScratch& scratch)
        : state_(state),
          drive_(drive),
          s_(*scratch.lists_),
          equations_(rod, state, drive, *scratch.lists_),
          segments_(as_index(rod.segments())),
          lanes_((segments_ - 1) / 2),
          per_h_(1 / drive.h_s) {}

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

    template <bool kFirst>
    void solve() {
        Gathered<TwoDoubles> both;
        equations_.add_clamps<kFirst>(both);
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

    /// Node `near`, its segment, and the bend to the next segment; then both are eliminated.
    template <bool kFirst, class T>
    void advance(const Place<T>& at, bool has_next, Gathered<T>& g, Pivot<T>* out) {
        Gathered<T> next;
        M3<T> xx;  // near with far
        M3<T> qx;  // the frame with far
        equations_.add_node(at.near, g.px, g.bx);
        equations_.add_segment<kFirst>(at, g, next, xx, qx);
        if (!drive_.contact.empty()) equations_.add_contact(at, g, next, xx);
        M3<T> qq{};
        if (has_next) equations_.add_bend<kFirst>(at, g, next, qq);
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
        equations_.add_node(node, g.px, g.bx);
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

    RodState& state_;
    const RodDrive& drive_;
    RodLists& s_;
    RodEquations equations_;
    size_t segments_, lanes_;  ///< Steps that the two fronts make side by side.
    double per_h_;
    M3<double> from_the_back_{};  ///< Coupling that the back front has left, see solve().
};

RodReport step_rod(const Rod& rod, RodState& state, const RodDrive& drive,
                   RodScratch& scratch) noexcept {
    return RodStepper(rod, state, drive, scratch).run();
}

}  // namespace placode::sim
