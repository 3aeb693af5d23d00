// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The scripted suture in skin that gives way: freed from the fascia, its edges slide before the
// point, swing back when the jaws let go, and follow every pull.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/operators/suture_operator.h"

namespace placode::haptics {
namespace {

constexpr double kNearMarkM = 1e-3;                 // of the point: it aims no more
constexpr double kTurnRadS = 0.5;                   // of a needle that is turned about its point
constexpr double kAlongPerS = 8, kAlongM_s = 3e-3;  // how it levels the point with a mark
constexpr double kGiveM_Ns = 0.1, kMostGiveM_s = 5e-3, kEasyN = 6e-3, kEaseS = 1.5;
constexpr double kSlackM_s = 0.015, kSlackN = 0.02;  // of thread that is taut no more

}  // namespace

/// The planned circle, turned about the middle between the marks: an edge that is held lies higher
/// or lower than the other, and the circle shall pass through both marks.
void SutureOperator::tilt(const Plane& p, const Vec3& in_m) noexcept {
    const Vec3 way = out_mark_m_ - in_m;
    const double tilt_rad = std::atan2(way.dot(p.up), way.dot(p.right));
    const Vec3 middle = 0.5 * (in_m + out_mark_m_);
    const double over = (centre_ - middle).dot(p.up);
    centre_ += over * ((std::cos(tilt_rad) - 1) * p.up - std::sin(tilt_rad) * p.right);
    entry_rad_ += tilt_rad;
}

/// Skin that slides before the point takes its mark along.
void SutureOperator::follow_entry(const Plane& p, double dt_s) noexcept {
    if (seen_.practice.targets < 2) return;
    Vec3 slid = seen_.practice.target_m[0] - in_mark_m_;
    slid.z() = 0;
    centre_ += slid;
    in_mark_m_ = seen_.practice.target_m[0];
    look_at_point(p, in_mark_m_, dt_s);
}

/// Along the shaft, until the point that it sees is level with a mark: the shaft turns about its
/// port as the driver swings round.
void SutureOperator::look_at_point(const Plane& p, const Vec3& mark, double dt_s) noexcept {
    const Vec3 point = seen_.X_WN * Vec3(radius_m_, 0, 0);
    const double most = kAlongM_s * dt_s;
    centre_ += std::clamp((mark - point).dot(p.shaft) * kAlongPerS * dt_s, -most, most) * p.shaft;
}

/// The point came out of one wall of a slit and is to go into the other.
bool SutureOperator::between_walls() const noexcept {
    return seen_.exits > exits_ && seen_.practice.step.kind == sim::PracticeKind::kNeedleOut;
}

/// Turns the needle about its point until its circle passes through the second mark, wherever that
/// lies now.
void SutureOperator::aim_at_exit(const Plane& p, double dt_s) noexcept {
    if (seen_.practice.targets < 2) return;
    out_mark_m_ = seen_.practice.target_m[1];
    const Vec3 point =
        centre_ + radius_m_ * (std::cos(point_rad_) * p.right + std::sin(point_rad_) * p.up);
    const double right = (out_mark_m_ - point).dot(p.right), up = (out_mark_m_ - point).dot(p.up);
    const double path = std::hypot(right, up);
    if (path < kNearMarkM || right <= 0) return;
    const double half = std::min(0.5 * path, 0.95 * radius_m_);
    const double over = std::sqrt(radius_m_ * radius_m_ - half * half) / path;
    const double c_right = 0.5 * right - over * up, c_up = 0.5 * up + over * right;
    const double wanted = std::atan2(-c_up, -c_right);
    const double turn = std::remainder(wanted - point_rad_, 2 * std::numbers::pi),
                 most = kTurnRadS * dt_s;
    point_rad_ += std::clamp(turn, -most, most);
    centre_ = point - radius_m_ * (std::cos(point_rad_) * p.right + std::sin(point_rad_) * p.up);
    look_at_point(p, out_mark_m_, dt_s);
}

/// False while the other hand does not hold the edge that comes next.
bool SutureOperator::follow_edges(const Plane& p, double dt_s) noexcept {
    if (seen_.bites == bites_) follow_entry(p, dt_s);
    if (!between_walls() || out_rad_ != 0) return true;
    if (waits_) {
        stage_s_ -= dt_s;
        return false;
    }
    aim_at_exit(p, dt_s);
    return true;
}

/// Off the edge and into its wall.
bool SutureOperator::slid_off() const noexcept {
    return habits_.edges_slide && seen_.exits > exits_ &&
           seen_.practice.step.kind == sim::PracticeKind::kNeedleIn;
}

SutureOperator::Edge SutureOperator::edge_wanted() const noexcept {
    if (stage_ >= Stage::kLeave) return Edge::kNone;
    return stage_ >= Stage::kDrive && seen_.exits > exits_ ? Edge::kExit : Edge::kEntry;
}

/// Opens the jaws; where skin gives way, once they no longer pull it aside: it would swing back and
/// take the needle along.
void SutureOperator::loosen() noexcept { stage(habits_.edges_slide ? Stage::kEase : Stage::kOpen); }

void SutureOperator::ease(double dt_s) noexcept {
    const Vec3& force_n = seen_.tools[tool_].force_n;
    static_cast<void>(hand_.glide(hand_.tip_m() + kGiveM_Ns * dt_s * force_n, kMostGiveM_s, dt_s));
    if (force_n.norm() < kEasyN || stage_s_ > kEaseS) stage(Stage::kOpen);
}

/// Aside, along the shaft, as far as the skin pulls it there.
void SutureOperator::give_way(const Plane& p, double dt_s) noexcept {
    centre_ += kGiveM_Ns * dt_s * seen_.tools[tool_].force_n.dot(p.shaft) * p.shaft;
}

/// Back towards the wound until the thread is slack: a hand that moves the skin would pull it
/// harder. True when it is.
bool SutureOperator::slackened(const Plane& p, double dt_s) noexcept {
    if (seen_.tools[tool_].force_n.norm() <= kSlackN) return true;
    static_cast<void>(hand_.glide(hand_.tip_m() + kSlackM_s * dt_s * p.shaft, 0.05, dt_s));
    return false;
}

}  // namespace placode::haptics
