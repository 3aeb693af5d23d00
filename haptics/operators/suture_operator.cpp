// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/suture_operator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace placode::haptics {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kOverMarkM = 0.008;    // of the circle's centre over where it shall be
constexpr double kBeforeM = 0.0025;     // of the point, before it meets the tissue
constexpr double kClearM = 0.007;       // back along the shaft, off the wire
constexpr double kTakeM = 0.0013;       // behind the point, where it is taken again
constexpr double kPastM = 0.0025;       // of its end past its exit: it was torn out
constexpr double kFalseM = 0.002;       // way in, before a false start is drawn back
constexpr double kHeldShare = 1.0 / 3;  // of the jaws behind their tips
constexpr double kOpenRad = 0.5, kJawRadS = 1.5, kPatienceS = 20;
constexpr double kStrainS = 0.5;      // without getting on, before it lets go
constexpr double kAskewM = 1e-3;      // between the jaws and where they would be on the circle
constexpr double kMostAskewM = 2e-3;  // where edges slide
constexpr int kMostMisses = 4;        // of the jaws, before it gives up
constexpr int kMostRetries = 2;       // of a bite that does not come out
constexpr double kDrawM_s = 0.015;    // of slack thread
constexpr double kTautN = 0.02;       // from here on the thread pulls
constexpr double kContentS = 0.4;     // of a pull, before it eases off

}  // namespace

const SutureHabits& suture_habits(OperatorLevel level) noexcept {
    static const std::array habits{SutureHabits{},
                                   SutureHabits{5e-3, 4e-4, 0.06, 0, 2.6e-3, 2e-3, 0.25, 0.09},
                                   SutureHabits{9e-3, 9e-4, 0.15, 1, 2.6e-3, 4e-3, 0.28}};
    return habits[static_cast<size_t>(level)];
}

SutureOperator::SutureOperator(OperatorLevel level, uint64_t seed, size_t tool,
                               const sim::ToolSpec& spec, const Vec3& home_m)
    : SutureOperator(level, suture_habits(level), seed, tool, spec, home_m) {}

SutureOperator::SutureOperator(OperatorLevel level, const SutureHabits& habits, uint64_t seed,
                               size_t tool, const sim::ToolSpec& spec, const Vec3& home_m)
    : habits_(habits),
      profile_(operator_profile(level)),
      hand_(profile_, seed, home_m),
      tool_(tool),
      spec_(spec),
      held_rad_(kPi * habits.held_share),
      take_m_(kTakeM) {}

void SutureOperator::see(const Perception& seen) { seen_ = seen; }

void SutureOperator::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = strained_s_ = content_s_ = 0;
}

bool SutureOperator::too_hard() const noexcept {
    return seen_.tools[tool_].force_n.norm() > habits_.most_pull_n;
}

/// Off the needle and once more; who misses too often gives up.
void SutureOperator::try_again() noexcept {
    stage(++misses_ < kMostMisses ? Stage::kOpen : Stage::kDone);
}

SutureOperator::Plane SutureOperator::plane() const noexcept {
    Plane p;
    p.shaft = (hand_.tip_m() - spec_.pivot_m).normalized();
    p.up = (Vec3::UnitZ() - Vec3::UnitZ().dot(p.shaft) * p.shaft).normalized();
    p.right = p.up.cross(p.shaft);
    return p;
}

/// The circle through both marks, in the plane of the needle.
void SutureOperator::plan() noexcept {
    const Vec3 in = seen_.practice.target_m[0], out = seen_.practice.target_m[1];
    radius_m_ = seen_.needle_arc_m / kPi;
    in_mark_m_ = in;
    out_mark_m_ = out;
    const double half = std::min(0.5 * (out - in).norm(), 0.95 * radius_m_);
    const Plane p = plane();
    centre_ = 0.5 * (in + out) + std::sqrt(radius_m_ * radius_m_ - half * half) * p.up;
    for (int k = 0; k < 3; ++k) centre_[k] += habits_.aim_error_m * hand_.random().normal();
    entry_rad_ = kPi + std::acos(half / radius_m_);
    if (habits_.edges_slide) tilt(p, in);
    point_rad_ = entry_rad_ - kBeforeM / radius_m_;
}

/// Taken anew a needle does not lie quite square to the shaft: what has to go to the mark is its
/// point, which keeps its distance from the plane while it is turned.
void SutureOperator::look_along(const Plane& p) noexcept {
    const Vec3 point = seen_.X_WN * Vec3(radius_m_, 0, 0);
    centre_ -= (point - centre_).dot(p.shaft) * p.shaft;
}

Vec3 SutureOperator::jaws_at(const Plane& p, const Vec3& centre, double angle) const noexcept {
    return centre + radius_m_ * (std::cos(angle) * p.right + std::sin(angle) * p.up) +
           kHeldShare * spec_.tip_length_m * p.shaft;
}

Vec3 SutureOperator::hold_at(const Plane& p, const Vec3& centre, double angle) noexcept {
    across_ = side_ * (std::sin(angle) * p.right - std::cos(angle) * p.up);
    return jaws_at(p, centre, angle);
}

void SutureOperator::drive(const Plane& p, double dt_s) noexcept {
    if (habits_.edges_slide && !follow_edges(p, dt_s)) return;
    const double path = habits_.speed_m_s * dt_s;
    // Straight ahead, as the point goes, instead of round.
    const Vec3 ahead = -std::sin(point_rad_) * p.right + std::cos(point_rad_) * p.up;
    centre_ += habits_.push * path * ahead;
    point_rad_ += (1 - habits_.push) * path / radius_m_;
    static_cast<void>(hand_.glide(hold_at(p, centre_, point_rad_ - held_rad_), 0.05, dt_s));
    const bool wrong = starts_ < habits_.false_starts && seen_.bites > bites_ &&
                       point_rad_ > entry_rad_ + kFalseM / radius_m_;
    if (wrong) {
        ++starts_;
        stage(Stage::kDrawBack);
        return;
    }
    if (slid_off() && retries_ < kMostRetries) {
        ++retries_;
        stage(Stage::kDrawBack);
        return;
    }
    // A point that comes out within a slit goes on into its other wall.
    const bool came_out =
        seen_.exits > exits_ && seen_.practice.step.kind != sim::PracticeKind::kNeedleOut;
    if (came_out && out_rad_ == 0) out_rad_ = point_rad_;
    const bool out = out_rad_ > 0 && point_rad_ > out_rad_ + habits_.out_m / radius_m_;
    // The jaws must not be pushed into the tissue.
    const bool low = point_rad_ - held_rad_ > entry_rad_ - 0.15;
    // As far round as it goes and still inside, or up through a slit: back, and in once more.
    if (low && out_rad_ == 0 && retries_ < kMostRetries) {
        ++retries_;
        stage(Stage::kDrawBack);
    } else if (out || low) {
        loosen();
    }
}

/// Behind the point, or where it is held to bite; from behind the wire.
void SutureOperator::take_again(const Plane& p, double dt_s) noexcept {
    const double s = take_m_ / radius_m_;
    const Vec3 radial = seen_.X_WN.q * Vec3(std::cos(s), std::sin(s), 0);
    const Vec3 back = seen_.X_WN.q * Vec3(-std::sin(s), std::cos(s), 0);
    const Vec3 wire = seen_.X_WN.p + radius_m_ * radial;
    side_ = 1;
    across_ = back;
    goal_ = wire + kHeldShare * spec_.tip_length_m * p.shaft;
    if (stage_ == Stage::kCome && too_hard()) {  // on tissue, not on the wire
        try_again();
        return;
    }
    const double still = stage_ == Stage::kSwing ? kClearM : 0;
    const bool there = hand_.glide(goal_ - still * p.shaft, 0.02, dt_s);
    if (!there) return;
    if (stage_ == Stage::kCome)
        stage(Stage::kClose);
    else if (stage_s_ > 1.2)  // the handle has been turned
        stage(Stage::kCome);
}

void SutureOperator::close(const Plane& p, double dt_s) noexcept {
    if (!hand_.jaw(0, kJawRadS, dt_s)) return;
    if (!seen_.needle_held) {
        if (stage_s_ > 0.6) try_again();  // beside it
        return;
    }
    centre_ = seen_.X_WN.p;
    const auto angle_of = [&](const Vec3& offset) {
        return std::atan2(offset.dot(p.up), offset.dot(p.right));
    };
    grip_rad_ = angle_of(goal_ - kHeldShare * spec_.tip_length_m * p.shaft - centre_);
    const double behind = angle_of(seen_.X_WN.q * Vec3::UnitX()) - grip_rad_;
    if (take_m_ > kTakeM) held_rad_ = std::remainder(behind, 2 * kPi);
    // Who took it askew cannot turn it on its circle.
    // Freed skin lets it stand a little beside the jaws' plane, on which it turns as well.
    const Vec3 beside = hand_.tip_m() - jaws_at(p, centre_, grip_rad_);
    if (habits_.edges_slide) centre_ += beside.dot(p.shaft) * p.shaft;
    const bool askew = beside.norm() > (habits_.edges_slide ? kMostAskewM : kAskewM);
    stage(askew ? Stage::kDone : Stage::kPull);
}

/// Of the needle behind its exit.
double SutureOperator::left_inside_m() const noexcept {
    const Vec3 exit = seen_.X_WN.inverse() * out_mark_m_;
    return seen_.needle_arc_m - radius_m_ * std::atan2(exit.y(), exit.x());
}

/// Round until it is through, or only its end is left for the tissue to hold. With skin between
/// the jaws as well it lets go: nobody goes on against what the hand feels.
void SutureOperator::pull(const Plane& p, double dt_s) noexcept {
    if (too_hard()) {
        strained_s_ += dt_s;
        if (strained_s_ > kStrainS) try_again();
        return;
    }
    strained_s_ = 0;
    if (habits_.edges_slide) give_way(p, dt_s);
    grip_rad_ += habits_.speed_m_s * dt_s / radius_m_;
    static_cast<void>(hand_.glide(hold_at(p, centre_, grip_rad_), 0.05, dt_s));
    const sim::PracticeStep& step = seen_.practice.step;
    const bool again = step.kind == sim::PracticeKind::kNeedleTake && step.take_share > 0;
    // Well past its exit without having come out there: it was torn out, or never went in. Behind
    // the needle's end the angle begins anew.
    const double past_m = 2 * seen_.needle_arc_m - left_inside_m();
    const bool lost = past_m > kPastM && past_m < 0.5 * seen_.needle_arc_m;
    if (seen_.drawn_through > drawn_ || lost || stage_s_ > kPatienceS) {
        stage(Stage::kLeave);
    } else if (again && take_m_ == kTakeM && left_inside_m() < habits_.tail_m) {
        take_m_ = step.take_share * seen_.needle_arc_m;
        loosen();
    }
}

/// Up, which draws the thread after it, and to the next bite if there is one.
void SutureOperator::leave(double dt_s) noexcept {
    if (!too_hard())
        static_cast<void>(hand_.glide(hand_.tip_m() + Vec3(0, 0, 0.01 * dt_s), 0.02, dt_s));
    if (stage_s_ <= 0.8) return;
    if (seen_.practice.step.kind == sim::PracticeKind::kThreadDraw)
        stage(Stage::kDraw);
    else
        next_bite();
}

/// Back along the shaft, until the task says that the slit is shut, or this hand finds it so and
/// gives way.
void SutureOperator::draw(const Plane& p, double dt_s) noexcept {
    if (seen_.practice.step.kind != sim::PracticeKind::kThreadDraw) {
        if (!habits_.edges_slide || stage_s_ > kPatienceS || slackened(p, dt_s)) next_bite();
        return;
    }
    if (too_hard()) return;
    const double pull_n = seen_.tools[tool_].force_n.norm();
    const double content_n = seen_.practice.step.enough_n > 0 ? habits_.content_n : 0;
    if (content_s_ > 0 || (content_n > 0 && pull_n >= content_n)) content_s_ += dt_s;
    double speed = pull_n > kTautN ? habits_.taut_m_s : kDrawM_s;
    if (content_s_ >= kContentS)
        speed = -habits_.taut_m_s;
    else if (content_s_ > 0)
        speed = 0;  // holds it
    static_cast<void>(hand_.glide(hand_.tip_m() - speed * dt_s * p.shaft, 0.05, dt_s));
}

void SutureOperator::next_bite() noexcept {
    const bool another =
        seen_.practice.step.kind == sim::PracticeKind::kNeedleIn && seen_.needle_held;
    stage(another ? Stage::kLook : Stage::kDone);
    take_m_ = kTakeM;
    exits_ = seen_.exits;
    drawn_ = seen_.drawn_through;
    bites_ = seen_.bites;
    starts_ = misses_ = retries_ = 0;
    out_rad_ = 0;
}

/// Whether the marks of a bite are there to be seen.
bool SutureOperator::sees_marks() const noexcept { return seen_.practice.targets == 2; }

void SutureOperator::look(const Plane& p) noexcept {
    if (stage_s_ < profile_.look_s || !seen_.needle || !sees_marks()) return;
    plan();
    stage(Stage::kReach);
    hand_.reach(hold_at(p, centre_ + kOverMarkM * p.up, point_rad_ - held_rad_));
}

/// Over the mark, where it waits for the other hand.
void SutureOperator::come_over_mark(const Plane& p, double dt_s) noexcept {
    if (hand_.reached(hold_at(p, centre_ + kOverMarkM * p.up, point_rad_ - held_rad_), dt_s) &&
        stage_s_ > 1.5) {
        if (waits_) return;
        if (habits_.edges_slide && sees_marks()) plan();
        if (drawn_ > 0) look_along(p);
        stage(Stage::kLower);
    }
}

/// Out of a bite that went wrong, the way that it came; then once more.
void SutureOperator::draw_back(const Plane& p, double dt_s) noexcept {
    if (too_hard()) {
        strained_s_ += dt_s;
        if (strained_s_ > kStrainS) stage(Stage::kDone);
        return;
    }
    point_rad_ -= habits_.speed_m_s * dt_s / radius_m_;
    static_cast<void>(hand_.glide(hold_at(p, centre_, point_rad_ - held_rad_), 0.05, dt_s));
    if (point_rad_ > entry_rad_ - kBeforeM / radius_m_) return;
    bites_ = seen_.bites;
    if (habits_.edges_slide) exits_ = seen_.exits;
    if (sees_marks()) plan();
    stage(Stage::kLower);
}

void SutureOperator::go_on(const Plane& p, double dt_s) noexcept {
    switch (stage_) {
        case Stage::kLook:
            look(p);
            break;
        case Stage::kReach:
            come_over_mark(p, dt_s);
            break;
        case Stage::kLower:
            if (hand_.glide(hold_at(p, centre_, point_rad_ - held_rad_), profile_.descend_m_s,
                            dt_s))
                stage(Stage::kDrive);
            break;
        case Stage::kDrive:
            drive(p, dt_s);
            break;
        case Stage::kDrawBack:
            draw_back(p, dt_s);
            break;
        case Stage::kEase:
            ease(dt_s);
            break;
        case Stage::kOpen:
            if (hand_.jaw(kOpenRad, kJawRadS, dt_s)) {
                goal_ = hand_.tip_m() - kClearM * p.shaft;
                stage(Stage::kBack);
            }
            break;
        case Stage::kBack:
            if (hand_.glide(goal_, 0.02, dt_s)) stage(Stage::kSwing);
            break;
        case Stage::kSwing:
        case Stage::kCome:
            take_again(p, dt_s);
            break;
        case Stage::kClose:
            close(p, dt_s);
            break;
        case Stage::kPull:
            pull(p, dt_s);
            break;
        case Stage::kLeave:
            leave(dt_s);
            break;
        case Stage::kDraw:
            draw(p, dt_s);
            break;
        case Stage::kDone:
            break;
    }
}

bool SutureOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    const Plane p = plane();
    // A thread that holds the needle back is not pulled out of the tissue on the way to a mark.
    const bool held_back = (stage_ == Stage::kReach || stage_ == Stage::kLower) && too_hard();
    if (!held_back) go_on(p, dt_s);
    if (stage_s_ > kPatienceS && stage_ != Stage::kDone) stage(Stage::kDone);
    hands[tool_] = hand_.action(time_s_);
    hands[tool_].across = across_;
    return stage_ == Stage::kDone;
}

}  // namespace placode::haptics
