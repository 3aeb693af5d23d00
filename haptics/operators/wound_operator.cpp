// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/wound_operator.h"

#include <algorithm>

namespace placode::haptics {
namespace {

constexpr double kBesideM = 0.0028;  // of the place where the edge is held, along the wound
constexpr double kInwardM = 0.0010;  // of the mark, towards the wound
// Raised, the first edge lies across the needle's way, and the bite reaches as deep as in the
// other.
constexpr double kRaiseEntryM = 0.0009, kRaiseExitM = 0.0003;
constexpr double kWoundHeldShare = 0.62;  // of a needle of 20 mm, from its point
// Both edges hold it then: in one of freed skin it falls over.
constexpr double kWoundTailM = 6.5e-3;
constexpr double kWoundMostN = 0.32;
constexpr double kWoundContentN = 0.15;  // of the intermediate: the edges meet

/// How a level sews skin that gives way.
SutureHabits wound_habits(OperatorLevel level) {
    SutureHabits habits = suture_habits(level);
    habits.edges_slide = true;
    habits.held_share = kWoundHeldShare;
    habits.tail_m = kWoundTailM;
    habits.most_pull_n = kWoundMostN;
    if (habits.content_n > 0) habits.content_n = kWoundContentN;
    return habits;
}

bool is_sewing(const sim::PracticeGoal& goal) noexcept {
    return goal.index < goal.count && goal.step.kind >= sim::PracticeKind::kNeedleIn &&
           goal.step.kind <= sim::PracticeKind::kThreadDraw;
}

}  // namespace

WoundOperator::WoundOperator(OperatorLevel level, uint64_t seed, const WoundTools& tools,
                             std::span<const sim::ToolSpec> specs, std::span<const Vec3> homes)
    : tools_(tools),
      holds_edge_(level != OperatorLevel::kNovice),
      undermine_(level, seed, tools.graspers, specs, homes),
      suture_(level, wound_habits(level), seed + 2, tools.driver, specs[tools.driver],
              homes[tools.driver]),
      holder_(operator_profile(level), seed + 3, homes[tools.graspers[1]]) {}

void WoundOperator::see(const Perception& seen) {
    goal_ = seen.practice;
    undermine_.see(seen);
    suture_.see(seen);
    holder_.see(seen.holds[tools_.graspers[1]]);
}

/// On the side where the point passes, beside it.
void WoundOperator::hold_edge() noexcept {
    const SutureOperator::Edge edge = suture_.edge_wanted();
    const bool seen = goal_.targets == 2;
    if (seen) {
        const Vec3 across = (goal_.target_m[1] - goal_.target_m[0]).normalized();
        const Vec3 along = across.cross(Vec3::UnitZ()).normalized();
        const bool entry = edge == SutureOperator::Edge::kEntry;
        const Vec3 mark = goal_.target_m[entry ? 0 : 1];
        holder_.want(edge != SutureOperator::Edge::kNone,
                     mark + kBesideM * along + (entry ? kInwardM : -kInwardM) * across, along,
                     entry ? kRaiseEntryM : kRaiseExitM);
    } else if (edge == SutureOperator::Edge::kNone) {
        holder_.want(false, Vec3::Zero(), Vec3::UnitX(), 0);
    }
    suture_.wait(!holder_.ready());
}

bool WoundOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    switch (stage_) {
        case Stage::kUndermine:
            if (is_sewing(goal_)) stage_ = Stage::kSew;  // nothing to undermine
            if (undermine_.act(dt_s, hands)) {
                if (!is_sewing(goal_)) return true;  // gave up
                stage_ = Stage::kChange;
            }
            return false;
        case Stage::kChange:
            if (undermine_.go_home(dt_s, hands)) stage_ = Stage::kSew;
            return false;
        case Stage::kSew:
            break;
    }
    if (holds_edge_) hold_edge();
    const bool done = suture_.act(dt_s, hands);
    hands[tools_.graspers[1]] = holder_.act(time_s_, dt_s);
    return done;
}

}  // namespace placode::haptics
