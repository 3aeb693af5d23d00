// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/needle_motion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/turn.h"
#include "sim/suture/needle_hold.h"

namespace placode::sim {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat36 = Eigen::Matrix<double, 3, 6>;

constexpr double kMostTurnRad = 0.1;  // of the needle in one Newton step
constexpr double kMostWay = 0.2;      // the same, in radii of its circle
// A bond at its bound is a spring in the first step and none in the next: three do. Where a step
// goes back on the last one, friction holds on the other side of its bound, and Newton's steps
// would go to and fro for ever and drive the needle: from there on the secant of the bonds is
// taken, which only ever lowers the energy.
constexpr int kMostSteps = 4, kMostSecantSteps = 12;
constexpr double kEnough = 1e-7;  // radians, or radii: less than a nanometre
// Of a needle that lies: places along the arc, how far a surface is looked for, and what holds it,
// in its own inertia over a substep. The drag lets it creep down a wall by 6 um a second.
constexpr int kSupportPlaces = kMostSupports / 2;
constexpr double kSupportSearchM = 2e-3, kSupportDeepestM = 0.3e-3;
constexpr double kSupportHold = 0.5, kSupportDrag = 100;

/// How a place of the body moves with (offset of the centre of mass, turn).
Mat36 motion_of(const Vec3& from_centre) noexcept {
    Mat36 j;
    j.leftCols<3>().setIdentity();
    const Vec3& r = from_centre;
    j.rightCols<3>() << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
    return j;
}

}  // namespace

double kinetic_energy(const Needle& needle, const SutureState& state) noexcept {
    const Vec3 w_N = state.needle.q.conjugate() * state.w;
    return 0.5 * needle.mass_kg() * state.v.squaredNorm() +
           0.5 * w_N.dot(needle.inertia_kg_m2().cwiseProduct(w_N));
}

void begin_needle(const Suture& /*suture*/, SutureState& state, SutureScratch& scratch,
                  const Pose& X_WH) noexcept {
    scratch.start = state.needle;
    state.hold.hand = X_WH;
    state.hold.hand.q.coeffs() *= 1 / std::sqrt(X_WH.q.squaredNorm());
}

void move_second_hand(SutureState& state, SutureScratch& scratch, const Pose& X_WH) noexcept {
    NeedleHold& hold = state.second.hold;
    scratch.second_before = hold.hand;
    hold.hand = X_WH;
    hold.hand.q.coeffs() *= 1 / std::sqrt(X_WH.q.squaredNorm());
}

void find_supports(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                   SutureScratch& scratch) noexcept {
    scratch.support_count = 0;
    const bool held = state.hold.held != 0 || state.second.hold.held != 0;
    if (held || state.passage_count > 0) return;
    const Needle& needle = suture.needle();
    const double wire = needle.spec().wire_radius_m, floor = suture.spec().floor_m;
    const auto add = [&](const Vec3& at_N, const Vec3& n, double offset) {
        scratch.supports[as_index(scratch.support_count++)] = {at_N, n, offset};
    };
    for (int i = 0; i < kSupportPlaces; ++i) {
        const Vec3 at_N = needle.at(needle.arc_m() * i / (kSupportPlaces - 1)).place_m;
        const Vec3 p = state.needle * at_N;
        if (p.z() < floor + kSupportSearchM) add(at_N, Vec3::UnitZ(), floor + wire);
        const SurfacePlane plane = nearest_surface(tissue, p, kSupportSearchM);
        if (plane.found) add(at_N, plane.n, plane.n.dot(p) - plane.gap_m + wire);
    }
}

namespace {

/// The thread at the swage, slid to where friction holds it: what it gives by sliding is in its
/// stiffness.
void add_thread(const Vec3& swage, const Vec3& centre, ThreadLine& line, Vec6& gradient,
                Mat6& hessian) noexcept {
    line.place_front(swage);
    line.slide();
    const LineSegment& last = line.segment(line.nodes() - 2);
    const Mat36 j = motion_of(swage - centre);
    const Mat3 across = Mat3::Identity() - last.along * last.along.transpose();
    const double pull = line.pull_n(last);
    gradient += j.transpose() * (pull * last.along);
    hessian += j.transpose() *
               (line.front_stiffness() * last.along * last.along.transpose() +
                pull / last.path_m * across) *
               j;
}

/// What a needle lies on pushes it out and lets it neither slide nor bounce.
void add_supports(const PosedNeedle& posed, const Vec3& centre, const SutureScratch& scratch,
                  double inertia_n_m, Vec6& gradient, Mat6& hessian) noexcept {
    for (int i = 0; i < scratch.support_count; ++i) {
        const NeedleSupport& s = scratch.supports[as_index(i)];
        const Vec3 p = posed.to_W(s.at_N);
        const double gap = std::max(s.n.dot(p) - s.offset_m, -kSupportDeepestM);
        if (gap >= 0) continue;
        const Mat36 j = motion_of(p - centre);
        const double hold = kSupportHold * inertia_n_m, drag = kSupportDrag * inertia_n_m;
        const Vec3 offset = p - scratch.start * s.at_N;
        gradient += j.transpose() * (hold * gap * s.n + drag * offset);
        hessian += j.transpose() * (hold * s.n * s.n.transpose() + drag * Mat3::Identity()) * j;
    }
}

void add_hold(const JawSpec& jaws, const NeedleHold& hold, const Pose& X_WN, const Vec3& centre,
              Vec6& gradient, Mat6& hessian) noexcept {
    const HoldError e(hold, X_WN);
    const Mat36 j = motion_of(e.grip - centre);
    gradient += jaws.pull_n_m * (j.transpose() * e.offset);
    hessian += jaws.pull_n_m * (j.transpose() * j);
    gradient.tail<3>() += jaws.turn_n_m_rad * e.turn;
    hessian.bottomRightCorner<3, 3>().diagonal().array() += jaws.turn_n_m_rad;
}

/// One step, with the slope of what bonds do or with their secant.
/// @param step what it did: offset of the centre of mass, turn.
/// @return how far it went, in radii and radians, or -1 where it is not finite.
double newton_step(const Suture& suture, SutureState& state, SutureScratch& scratch, double h_s,
                   bool slope, Vec6& step) noexcept {
    const Needle& needle = suture.needle();
    const SutureSpec& spec = suture.spec();
    const Vec3 centre = state.needle * needle.centre_m();
    const Mat3 r = state.needle.q.toRotationMatrix();
    Mat6 hessian = Mat6::Zero();
    Vec6 gradient = Vec6::Zero();
    // Inertia: from where it would have gone.
    const double per_h = 1 / h_s, held = per_h * per_h * (1 + spec.drag_per_s * h_s);
    const Vec3 offset = centre - scratch.start * needle.centre_m();
    const Vec3 turned = turn_between(scratch.start.q, state.needle.q);
    const double m = needle.mass_kg();
    const Mat3 inertia = r * needle.inertia_kg_m2().asDiagonal() * r.transpose();
    gradient.head<3>() = m * (held * offset - per_h * state.v - spec.gravity_m_s2);
    gradient.tail<3>() = inertia * (held * turned - per_h * state.w);
    hessian.topLeftCorner<3, 3>().diagonal().setConstant(m * held);
    hessian.bottomRightCorner<3, 3>() = held * inertia;
    for (const NeedleHold* hold : {&state.hold, &state.second.hold})
        if (hold->held != 0) add_hold(spec.jaws, *hold, state.needle, centre, gradient, hessian);
    const PosedNeedle posed(needle, state.needle);
    for (int n = 0; n < scratch.bond_count; ++n) {
        const Vec3& p = scratch.places[as_index(n)];
        const BondForce f = force_of(posed, scratch.bonds[as_index(n)], p, slope);
        const Mat36 j = motion_of(p - centre);
        gradient -= j.transpose() * f.gradient;
        hessian += j.transpose() * f.stiffness * j;
    }
    if (scratch.thread.active() && state.thread.ends[1].mode == ThreadEndMode::kSwage)
        add_thread(swage_m(suture, state), centre, scratch.thread, gradient, hessian);
    add_supports(posed, centre, scratch, m * per_h * per_h, gradient, hessian);
    step = -hessian.llt().solve(gradient);
    const double far = step.head<3>().norm() / needle.radius_m(), turn = step.tail<3>().norm();
    const double over = std::max(far / kMostWay, turn / kMostTurnRad);
    if (!std::isfinite(over)) return -1;
    if (over > 1) step /= over;
    turn_by(state.needle.q, step.tail<3>());
    state.needle.p = centre + step.head<3>() - state.needle.q * needle.centre_m();
    return std::max(far, turn);
}

/// False where a step turns back: compared in metres of the circle.
bool goes_on(const Needle& needle, const Vec6& last, const Vec6& step) noexcept {
    const double r = needle.radius_m();
    return last.head<3>().dot(step.head<3>()) + r * r * last.tail<3>().dot(step.tail<3>()) >= 0;
}

}  // namespace

void solve_needle(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                  SutureScratch& scratch, double h_s) noexcept {
    for (int n = 0; n < scratch.bond_count; ++n)
        scratch.places[as_index(n)] = place_of(tissue.state, scratch.bonds[as_index(n)]);
    Vec6 last = Vec6::Zero();
    bool slope = true;
    for (int i = 0; i < (slope ? kMostSteps : kMostSecantSteps); ++i) {
        Vec6 step;
        const double gone = newton_step(suture, state, scratch, h_s, slope, step);
        if (!(gone > kEnough)) break;
        slope = slope && goes_on(suture.needle(), last, step);
        last = step;
    }
    if (state.thread.ends[1].mode != ThreadEndMode::kSwage) return;
    scratch.thread.place_front(swage_m(suture, state));
    scratch.thread.slide();
}

void finish_needle(const Suture& suture, SutureState& state, const SutureScratch& scratch,
                   const Pose& X_WH_before, double h_s, SutureReport& report) noexcept {
    const Needle& needle = suture.needle();
    const bool finite = state.needle.p.allFinite() && state.needle.q.coeffs().allFinite();
    if (!finite) {
        report.not_finite = true;
        state.needle = scratch.start;
        state.v = state.w = Vec3::Zero();
    } else {
        state.v = (state.needle * needle.centre_m() - scratch.start * needle.centre_m()) / h_s;
        state.w = turn_between(scratch.start.q, state.needle.q) / h_s;
    }
    const double force_n = suture.spec().jaws.force_n;
    const auto& firm = state.second.firm;
    Jaws{suture, state, state.hold, firm[0] * force_n, 0, report}.finish(X_WH_before);
    Jaws{suture, state, state.second.hold, firm[1] * force_n, 1, report}.finish(
        scratch.second_before);
}

}  // namespace placode::sim
