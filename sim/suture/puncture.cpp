// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/puncture.h"

#include <algorithm>
#include <cmath>

#include "sim/suture/needle_in_tissue.h"

namespace placode::sim {
namespace {

constexpr double kSpacingM = 0.3e-3;     // of passages inside one tet
constexpr double kNearestM = 0.1e-3;     // a face so close to the last passage gets none
constexpr double kDrawnBackM = 0.05e-3;  // the point lets the channel close behind it
constexpr double kLookBackM = 0.5e-3;    // a hand at 0.5 m/s goes a quarter of it in a substep
constexpr int kMostFaces = 64;           // crossed in one substep

}  // namespace

void NeedleInTissue::meet() noexcept {
    NeedlePoint& point = state_.point;
    const SurfaceHit hit = hit_ahead();
    if (hit.at.tet < 0) return;
    point.mode = PointMode::kPresses;
    point.at = hit.at;
    point.tissue = hit.tissue;
    point.hold_n_m = hold_at(point.at);
    state_.work.made += energy();
}

void NeedleInTissue::move_point() noexcept {
    NeedlePoint& point = state_.point;
    if (point.mode == PointMode::kFree) return;
    const double u = pushed(), force = point.hold_n_m * u;
    const SutureStrength& strength = suture_.strength(point.tissue);
    const double cutting = strength.cutting_share * strength.puncture_n;
    report_.point_force_n =
        std::max(0.0, point.mode == PointMode::kInside ? std::min(force, cutting) : force);
    switch (point.mode) {
        case PointMode::kPresses:
            if (u <= 0)
                lift_off();
            else if (force >= strength.puncture_n)
                enter(cutting);
            else
                slide();
            break;
        case PointMode::kInside:
            if (force > cutting)
                cut(cutting, energy());
            else if (u < -kDrawnBackM)
                draw_back();
            break;
        case PointMode::kAtFarSide:
            if (force >= strength.puncture_n) {
                leave();
            } else if (u < -kDrawnBackM) {
                point.mode = PointMode::kInside;
                draw_back();
            }
            break;
        case PointMode::kFree:
            break;
    }
}

SurfaceHit NeedleInTissue::hit_ahead() const noexcept {
    const Vec3 tip = needle_.to_W(suture_.needle().tip_m());
    return meet_surface(tissue_, tip - kLookBackM * forward_, kLookBackM * forward_);
}

void NeedleInTissue::slide() noexcept {
    NeedlePoint& point = state_.point;
    const Vec3 off = needle_.to_N(place_of(tissue_, point.at)) - suture_.needle().tip_m();
    const double beside = std::sqrt(off.x() * off.x() + off.z() * off.z());
    if (beside <= suture_.spec().point_friction * off.y()) return;
    const double before = energy();
    const SurfaceHit hit = hit_ahead();
    if (hit.at.tet < 0) {
        lift_off();
        state_.work.friction += before;
        return;
    }
    point.at = hit.at;
    point.tissue = hit.tissue;
    point.hold_n_m = hold_at(point.at);
    state_.work.friction += before - energy();
}

void NeedleInTissue::enter(double cutting_n) noexcept {
    NeedlePoint& point = state_.point;
    const double before = energy();
    ++state_.channels;
    add_passage(PassageKind::kEntry);
    tell_of(SutureEventKind::kEntered, point.at, state_.channels, report_.point_force_n);
    point.mode = PointMode::kInside;
    point.since_passage_m = 0;
    cut(cutting_n, before);
}

void NeedleInTissue::cut(double cutting_n, double before_j) noexcept {
    NeedlePoint& point = state_.point;
    // Twice: where it comes to, the tissue may answer otherwise.
    for (int turn = 0; turn < 2 && point.mode == PointMode::kInside; ++turn) {
        const double path = pushed() - cutting_n / point.hold_n_m;
        if (path > 0) go(path);
        point.hold_n_m = hold_at(point.at);
    }
    state_.work.puncture += before_j - energy();
}

double NeedleInTissue::advance_m() const noexcept {
    const Vec3 lever =
        needle_.to_W(suture_.needle().tip_m()) - needle_.to_W(suture_.needle().centre_m());
    return h_s_ * std::max(0.0, forward_.dot(state_.v + state_.w.cross(lever)));
}

void NeedleInTissue::go(double path_m) noexcept {
    NeedlePoint& point = state_.point;
    for (int faces = 0; faces < kMostFaces && path_m > 0;) {
        const bool full = state_.passage_count == kMostPassages;
        const double due = full ? path_m : std::max(0.0, kSpacingM - point.since_passage_m);
        double step = std::min(path_m, due);
        TissueWalk walk = walk_to_face(tissue_, point.at, step * forward_);
        if (walk.end == WalkEnd::kLost) {
            // Soft tissue that is drawn along goes flat. A point that stood still in it would
            // drag it until it tears; so it goes on with the needle, by the shape at rest.
            path_m = step = std::min(step, advance_m());
            walk = walk_at_rest(tissue_, point.at, step * forward_);
        }
        point.at = walk.at;
        point.since_passage_m += walk.share * step;
        path_m -= walk.share * step;
        if (walk.end == WalkEnd::kArrived) {
            if (step >= due) add_passage(PassageKind::kInner);
            continue;
        }
        if (walk.end == WalkEnd::kAtSurface) {
            point.mode = PointMode::kAtFarSide;
            return;
        }
        ++faces;
        const TissuePoint next = across_face(tissue_, point.at, walk.face);
        const Tissue beyond = tissue_at(next.tet);
        if (point.since_passage_m >= kNearestM || beyond != point.tissue)
            add_passage(PassageKind::kInner);
        point.at = next;
        point.tissue = beyond;
    }
}

void NeedleInTissue::leave() noexcept {
    NeedlePoint& point = state_.point;
    const double before = energy();
    add_passage(PassageKind::kExit);
    tell_of(SutureEventKind::kLeft, point.at, state_.channels, report_.point_force_n);
    point.mode = PointMode::kFree;
    state_.work.puncture += before;
}

void NeedleInTissue::draw_back() noexcept {
    NeedlePoint& point = state_.point;
    const double before = energy();
    double path = -pushed();
    for (int faces = 0; faces < kMostFaces && path > 0; ++faces) {
        const TissueWalk walk = walk_to_face(tissue_, point.at, -path * forward_);
        if (walk.end == WalkEnd::kLost) break;
        point.at = walk.at;
        point.since_passage_m = std::max(0.0, point.since_passage_m - walk.share * path);
        path -= walk.share * path;
        if (walk.end == WalkEnd::kAtSurface) {  // out of the tissue
            point.mode = PointMode::kFree;
            state_.work.puncture += before;
            return;
        }
        if (walk.end != WalkEnd::kAtFace) break;
        point.at = across_face(tissue_, point.at, walk.face);
        point.tissue = tissue_at(point.at.tet);
    }
    point.hold_n_m = hold_at(point.at);
    state_.work.puncture += before - energy();
}

void begin_point(const Suture& suture, SutureState& state, const SuturedTissue& tissue, double h_s,
                 SutureReport& report) noexcept {
    NeedleInTissue needle(suture, state, tissue, h_s, report);
    needle.drop_lost();
    if (state.point.mode == PointMode::kFree) needle.meet();
}

void finish_point(const Suture& suture, SutureState& state, const SuturedTissue& tissue, double h_s,
                  SutureReport& report) noexcept {
    NeedleInTissue needle(suture, state, tissue, h_s, report);
    needle.slip_in_walls();
    needle.move_point();
    needle.leave_passages();
}

}  // namespace placode::sim
