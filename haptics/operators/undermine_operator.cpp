// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/undermine_operator.h"

#include <algorithm>

namespace placode::haptics {
namespace {

using sim::PracticeKind;

constexpr double kEdgeOverM = 0.005, kEdgeIntoSkinM = 0.0005, kEdgeDownM_s = 0.005;
constexpr double kEdgeOpenRad = 0.35, kEdgeHeldRad = 0.12, kDiggerShutRad = 0.02;
constexpr double kEdgeJawRad_s = 0.8, kDiggerRad_s = 0.6;
constexpr double kDiggerShortM = 0.002, kDiggerOverM = 0.0025;  // short of the edge; above the skin
constexpr double kDiggerBackM = 0.0005;                         // before the jaws shut
constexpr double kDiggerOutM_s = 0.010;
constexpr int kEdgeTries = 3;

UndermineHabits undermine_intermediate() {
    UndermineHabits h;
    h.lift_m = 0.0024;
    h.lift_m_s = 0.005;
    h.aim_m = 2e-4;
    h.spread_rad = 0.14;
    h.raise_m = 0.0026;
    h.push_m_s = 0.009;
    h.first_m = 0.0018;
    h.step_m = 0.0022;
    h.deepest_m = 0.0068;
    return h;
}

UndermineHabits undermine_novice() {
    UndermineHabits h;
    h.lift_m = 0.0034;
    h.lift_m_s = 0.008;
    h.aim_m = 5e-4;
    h.spread_rad = 0.35;
    h.raise_m = 0.0035;
    h.push_m_s = 0.014;
    h.step_m = 0.0045;
    h.deepest_m = 0.0075;
    h.places = 2;
    h.most_places = 3;
    return h;
}

}  // namespace

const UndermineHabits& undermine_habits(OperatorLevel level) noexcept {
    static const std::array habits{UndermineHabits{}, undermine_intermediate(), undermine_novice()};
    return habits[static_cast<size_t>(level)];
}

UndermineOperator::UndermineOperator(OperatorLevel level, uint64_t seed,
                                     std::array<size_t, 2> tools,
                                     std::span<const sim::ToolSpec> specs,
                                     std::span<const Vec3> homes)
    : habits_(undermine_habits(level)),
      profile_(operator_profile(level)),
      workers_{
          Worker{tools[0], HandMotion(profile_, seed, homes[tools[0]]), specs[tools[0]].pivot_m},
          Worker{tools[1], HandMotion(profile_, seed + 1, homes[tools[1]]),
                 specs[tools[1]].pivot_m}} {}

void UndermineOperator::see(const Perception& seen) {
    goal_ = seen.practice;
    for (Worker& worker : workers_) worker.holds = seen.holds[worker.tool];
}

void UndermineOperator::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
}

Vec3 UndermineOperator::below_edge(double out_m, double up_m) const noexcept {
    const Vec3 along = Vec3::UnitZ().cross(out_);
    return edge_ + along_m_ * along + out_m * out_ + (height_m_ + up_m) * Vec3::UnitZ();
}

/// Over it, down on it, jaws shut, up with it.
void UndermineOperator::take_edge(double dt_s) noexcept {
    Worker& hand = lifter();
    const Vec3 over = edge_ + kEdgeOverM * Vec3::UnitZ();
    switch (stage_) {
        case Stage::kOver:
            static_cast<void>(hand.motion.jaw(kEdgeOpenRad, 1.5, dt_s));
            static_cast<void>(digger().motion.jaw(kDiggerShutRad, 1.5, dt_s));
            if (hand.motion.reached(over, dt_s)) stage(Stage::kDown);
            break;
        case Stage::kDown:
            if (hand.motion.glide(edge_ - kEdgeIntoSkinM * Vec3::UnitZ(), kEdgeDownM_s, dt_s))
                stage(Stage::kClose);
            break;
        case Stage::kClose:
            if (!hand.motion.jaw(kEdgeHeldRad, kEdgeJawRad_s, dt_s) || stage_s_ < 0.4) break;
            if (hand.holds) {
                stage(Stage::kLift);
            } else if (++tries_ < kEdgeTries) {
                hand.motion.reach(over);
                stage(Stage::kOver);
            } else {
                stage(Stage::kDone);
            }
            break;
        default:
            if (hand.motion.glide(edge_ + habits_.lift_m * Vec3::UnitZ(), habits_.lift_m_s, dt_s)) {
                place_ = 0;
                next_place();
            }
    }
}

/// From the middle of the edge to both sides by turns; then where skin still holds.
void UndermineOperator::next_place() noexcept {
    const bool enough = goal_.step.kind != PracticeKind::kUndermine && place_ > 0;
    if (!enough && place_ >= habits_.most_places) {
        stage(Stage::kDone);  // gives up
        return;
    }
    if (enough) {
        digger().motion.reach(digger().motion.home_m());
        stage(Stage::kRelease);
        return;
    }
    const double side = place_ % 2 == 0 ? -1 : 1;
    const Vec3 along = Vec3::UnitZ().cross(out_);
    const int places_off = 1 + place_ / 2;  // not where the other hand holds
    along_m_ = side * places_off * habits_.apart_m;
    if (place_ >= habits_.places && goal_.targets > 0)
        along_m_ = along.dot(goal_.target_m[0] - edge_);
    along_m_ += habits_.aim_m * digger().motion.random().normal();
    height_m_ = -habits_.below_m + 0.5 * habits_.aim_m * digger().motion.random().normal();
    ++place_;
    depth_m_ = habits_.first_m;
    digger().motion.reach(below_edge(-kDiggerShortM - 0.001, habits_.below_m + kDiggerOverM));
    stage(Stage::kAside);
}

/// In along the fascia, spread, shut, deeper; out again.
void UndermineOperator::dig(double dt_s) noexcept {
    HandMotion& hand = digger().motion;
    const Vec3 outside = below_edge(-kDiggerShortM - 0.001, habits_.below_m + kDiggerOverM);
    switch (stage_) {
        case Stage::kAside:
            static_cast<void>(hand.jaw(kDiggerShutRad, 1.5, dt_s));
            if (hand.reached(outside, dt_s)) stage(Stage::kEnter);
            break;
        case Stage::kEnter:
            if (hand.glide(below_edge(-kDiggerShortM, 0), kDiggerOutM_s, dt_s)) stage(Stage::kPush);
            break;
        case Stage::kPush:
            if (hand.glide(below_edge(depth_m_, 0), habits_.push_m_s, dt_s)) stage(Stage::kSpread);
            break;
        case Stage::kSpread: {
            const bool wide = hand.jaw(habits_.spread_rad, kDiggerRad_s, dt_s);
            if (hand.glide(below_edge(depth_m_, habits_.raise_m), habits_.raise_m_s, dt_s) && wide)
                stage(Stage::kShut);
            break;
        }
        case Stage::kShut: {
            const bool back =
                hand.glide(below_edge(depth_m_ - kDiggerBackM, 0), 2 * habits_.raise_m_s, dt_s);
            if (!hand.jaw(kDiggerShutRad, kEdgeJawRad_s, dt_s) || !back) break;
            depth_m_ += habits_.step_m;
            const bool enough = goal_.step.kind != PracticeKind::kUndermine;
            stage(depth_m_ > habits_.deepest_m || enough ? Stage::kOut : Stage::kPush);
            break;
        }
        case Stage::kOut:
            if (hand.glide(below_edge(-kDiggerShortM, 0.0005), 2 * kDiggerOutM_s, dt_s))
                stage(Stage::kAway);
            break;
        default:
            if (hand.glide(outside, 2 * kDiggerOutM_s, dt_s)) next_place();
    }
}

/// Lets the edge go; then the other side, with hands exchanged.
void UndermineOperator::release(double dt_s) noexcept {
    static_cast<void>(digger().motion.reached(digger().motion.home_m(), dt_s));
    HandMotion& hand = lifter().motion;
    // Down first: what is let go under tension slides out.
    if (!hand.glide(edge_, kEdgeDownM_s, dt_s) || !hand.jaw(kEdgeOpenRad, 1.5, dt_s) ||
        lifter().holds || stage_s_ < 1.5)
        return;
    if (goal_.index < goal_.count && goal_.step.kind == PracticeKind::kRelease && stage_s_ < 3)
        return;
    if (goal_.index >= goal_.count || goal_.step.kind != PracticeKind::kGrasp) {
        stage(Stage::kDone);
        return;
    }
    hand.reach(hand.home_m());
    lifting_ = 1 - lifting_;
    tries_ = 0;
    stage(Stage::kLook);
}

bool UndermineOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    switch (stage_) {
        case Stage::kLook:
            // The hand that let go rises first.
            static_cast<void>(digger().motion.reached(digger().motion.home_m(), dt_s));
            if (stage_s_ < profile_.look_s || goal_.targets < 1) break;
            edge_ = goal_.target_m[0];
            edge_.z() = std::max(edge_.z(), -0.0005);
            out_ = edge_ - digger().pivot;
            out_.z() = 0;
            out_.normalize();
            lifter().opening = Vec3::UnitZ().cross(out_);
            digger().opening = Vec3::UnitZ();
            for (int k = 0; k < 2; ++k)
                edge_[k] += habits_.aim_m * lifter().motion.random().normal();
            lifter().motion.reach(edge_ + kEdgeOverM * Vec3::UnitZ());
            stage(Stage::kOver);
            break;
        case Stage::kOver:
        case Stage::kDown:
        case Stage::kClose:
        case Stage::kLift:
            take_edge(dt_s);
            break;
        case Stage::kRelease:
            release(dt_s);
            break;
        case Stage::kDone:
            break;
        default:
            dig(dt_s);
    }
    for (Worker& worker : workers_) {
        hands[worker.tool] = worker.motion.action(time_s_);
        hands[worker.tool].opening = worker.opening;
    }
    return stage_ == Stage::kDone && stage_s_ > 1.5;
}

bool UndermineOperator::go_home(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    bool there = true;
    for (Worker& worker : workers_) {
        if (!going_home_) worker.motion.reach(worker.motion.home_m(), Vec3::UnitZ());
        there = worker.motion.reached(worker.motion.home_m(), dt_s) && there;
        hands[worker.tool] = worker.motion.action(time_s_);
        hands[worker.tool].opening = worker.opening;
    }
    going_home_ = true;
    return there;
}

}  // namespace placode::haptics
