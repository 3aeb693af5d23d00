// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/step_watch.h"

#include <algorithm>
#include <numbers>

namespace placode::view {

using namespace sim;
namespace {

constexpr double kSomeProgress = 0.02;  // of a step; less is a hand that trembles
constexpr double kLostMm = 1.5;         // farther away it was never meant to touch
constexpr double kLongestPictureS = 5;  // between two of them; more is a jump in time

}  // namespace

void StepWatch::look(const PracticeGoal& goal, double clock_s, bool waits, bool present) {
    const double passed_s = begun_ ? clock_s - last_s_ : 0;
    last_s_ = clock_s;
    begun_ = true;
    const bool first = goal.index != step_;
    // A hand that comes back somewhere else goes on with its step.
    fresh_ = first || !anchored_;
    anchored_ = first ? present : anchored_ || present;
    const bool moved_on = goal.progress > progress_ + kSomeProgress;
    // What was held and let go again starts from its beginning.
    if (first || moved_on || goal.progress < progress_) progress_ = goal.progress;
    if (first || moved_on || passed_s < 0) {
        idle_s_ = 0;
    } else if (!waits) {
        idle_s_ += std::min(passed_s, kLongestPictureS);
    }
    if (fresh_) side = 1;
    step_ = goal.index;
}

StepAmount step_amount(const PracticeGoal& goal) {
    const PracticeStep& step = goal.step;
    const double share = std::clamp(goal.progress, 0.0, 1.0);
    switch (step.kind) {
        case PracticeKind::kMove:
        case PracticeKind::kDepth:
            return {1000 * share * step.distance_m, 1000 * step.distance_m, 0, " mm"};
        case PracticeKind::kWithdraw:
            return {1000 * share * step.distance_m, 1000 * step.distance_m, 1, " mm"};
        case PracticeKind::kTurn: {
            const double whole = step.turn_rad * 180 / std::numbers::pi;
            return {share * whole, whole, 0, "\xC2\xB0"};
        }
        case PracticeKind::kTrace:
            return {100 * share, 100, 0, " %"};
        case PracticeKind::kPatchLay:
        case PracticeKind::kWash:
        case PracticeKind::kSuck:
        case PracticeKind::kUndermine:
            return {100 * share, 100, 0, " %"};
        case PracticeKind::kTouch:
        case PracticeKind::kCut:
        case PracticeKind::kCoag:
        case PracticeKind::kTraction:
        case PracticeKind::kNeedleShow:
            if (step.hold_s <= 0) return {};
            return {share * step.hold_s, step.hold_s, 1, " s"};
        default:
            return {};
    }
}

bool contact_lost(const PracticeStep& step, uint8_t pedals, bool touches, double gap_mm) noexcept {
    const uint8_t wanted = step.kind == PracticeKind::kCut    ? kPedalCut
                           : step.kind == PracticeKind::kCoag ? kPedalCoag
                                                              : uint8_t{0};
    return wanted != 0 && pedals == wanted && !touches && gap_mm < kLostMm;
}

}  // namespace placode::view
