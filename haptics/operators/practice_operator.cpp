// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/practice_operator.h"

#include <algorithm>
#include <cmath>

#include "haptics/operators/jaw_habits.h"

namespace placode::haptics {

namespace {

using sim::PracticeKind;

constexpr double kHoverM = 0.005, kDeepestM = 0.0025, kSwayM = 0.006, kScopeSwayM = 0.003;
constexpr double kStepPatienceS = 30, kDoPatienceS = 6, kTurnRadS = 2;

PracticeHabits intermediate() {
    PracticeHabits h;
    h.aim_error_m = 4e-4;
    h.press_m = 5e-4;
    h.early_pedal_s = 1.15;
    h.late_pedal_s = 0.8;
    h.trace_m_s = 0.005;
    h.trace_wander_m = 3e-4;
    h.pull = 0.55;
    h.pull_m_s = 0.002;
    return h;
}

PracticeHabits novice() {
    PracticeHabits h;
    h.aim_error_m = 1.3e-3;
    h.press_m = 1.6e-3;
    h.feels = false;
    h.early_pedal_s = 1.4;
    h.late_pedal_s = 1.2;
    h.trace_m_s = 0.004;
    h.trace_wander_m = 9e-4;
    h.trace_inward_m = 5e-4;
    h.pull = 2.5;
    h.pull_m_s = 0.006;
    return h;
}

}  // namespace

const PracticeHabits& practice_habits(OperatorLevel level) noexcept {
    static const std::array habits{PracticeHabits{}, intermediate(), novice()};
    return habits[static_cast<size_t>(level)];
}

PracticeOperator::PracticeOperator(OperatorLevel level, uint64_t seed,
                                   std::span<const sim::ToolSpec> tools,
                                   std::span<const Vec3> homes)
    : level_(level),
      profile_(operator_profile(level)),
      habits_(practice_habits(level)),
      tools_(tools.begin(), tools.end()) {
    for (size_t i = 0; i < tools_.size(); ++i)
        workers_.push_back({.motion = HandMotion(profile_, seed + i, homes[i])});
}

void PracticeOperator::see(const Perception& seen) {
    goal_ = seen.practice;
    contour_.assign(seen.contour.begin(), seen.contour.end());
    normal_.assign(seen.contour_normal.begin(), seen.contour_normal.end());
    normal_.resize(contour_.size(), Vec3::UnitZ());
    for (size_t i = 0; i < workers_.size(); ++i) {
        workers_[i].touches = seen.touches[i];
        workers_[i].holds = seen.holds[i];
        workers_[i].pull_n = seen.pull_n[i];
    }
}

void PracticeOperator::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
}

int PracticeOperator::tool_of(sim::Hand hand) const noexcept {
    for (size_t i = 0; i < tools_.size(); ++i)
        if (tools_[i].hand == hand) return static_cast<int>(i);
    return -1;
}

bool PracticeOperator::aims() const noexcept {
    return sim::targets_of(goal_.step.kind) > 0 || goal_.step.kind == PracticeKind::kTrace;
}

void PracticeOperator::aim() noexcept {
    for (int t = 0; t < busy_; ++t) {
        Worker& w = workers_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])];
        for (int k = 0; k < 2; ++k)
            w.error[k] =
                habits_.aim_error_m / (1 << std::min(tries_, 4)) * w.motion.random().normal();
        w.gone_m = 0;
    }
}

void PracticeOperator::begin_step() noexcept {
    step_ = goal_.index;
    step_s_ = 0;
    tries_ = 0;
    arc_m_ = 0;
    busy_ = 0;
    // Who just held something goes on holding it; who just worked with energy lets go late.
    late_s_ = habits_.late_pedal_s;
    const sim::PracticeStep& step = goal_.step;
    const int right = tool_of(step.kind == PracticeKind::kTraction ? sim::Hand::kRight : step.hand);
    if (right >= 0) at_work_[static_cast<size_t>(busy_++)] = right;
    if (step.kind == PracticeKind::kTraction && tool_of(sim::Hand::kLeft) >= 0)
        at_work_[static_cast<size_t>(busy_++)] = tool_of(sim::Hand::kLeft);
    stage(Stage::kRise);
}

/// Above a target (or the start of the line), at the height of the hand.
Vec3 PracticeOperator::place(const Worker& worker, int target) const noexcept {
    Vec3 at = goal_.target_m[static_cast<size_t>(target)];
    Vec3 up = Vec3::UnitZ();
    if (goal_.step.kind == PracticeKind::kTrace && !contour_.empty()) {
        at = contour_[0];
        up = normal_[0];
    }
    return at + worker.error + worker.height_m * up;
}

/// To and fro, along or across the shaft, or turning: free exercises.
void PracticeOperator::wander_about(Worker& w, size_t tool, double dt_s) noexcept {
    const Vec3 shaft = (w.motion.tip_m() - tools_[tool].pivot_m).normalized();
    const Vec3 across = shaft.cross(Vec3::UnitZ()).normalized();
    const bool scope = tools_[tool].kind == sim::ToolKind::kScope;
    if (goal_.step.kind == PracticeKind::kTurn) {
        w.turned_rad += kTurnRadS * dt_s;
        w.opening = std::cos(w.turned_rad) * across + std::sin(w.turned_rad) * shaft.cross(across);
        return;
    }
    const double sway = scope ? kScopeSwayM : kSwayM;
    const Vec3 out = goal_.step.kind == PracticeKind::kDepth ? Vec3(-shaft) : across;
    const Vec3 goal = w.forth ? Vec3(w.anchor + sway * out) : w.anchor;
    if (w.motion.glide(goal, profile_.free_speed_m_s, dt_s)) w.forth = !w.forth;
}

void PracticeOperator::rise(double dt_s) noexcept {
    bool up = true;
    const bool stay = goal_.step.kind == PracticeKind::kRelease;  // opens where it is
    for (size_t i = 0; i < workers_.size(); ++i) {
        Worker& w = workers_[i];
        if (tools_[i].kind == sim::ToolKind::kScope || stay) continue;
        late_s_ -= dt_s;
        if (late_s_ <= 0) w.pedals = 0;
        if (w.pedals != 0) {
            up = false;
            continue;
        }
        if (w.holds) {  // let go first
            static_cast<void>(w.motion.jaw(jaw_habits(level_).open_rad, 2.0, dt_s));
            up = false;
            continue;
        }
        if (w.height_m >= kHoverM) continue;
        w.height_m += 0.012 * dt_s;
        static_cast<void>(w.motion.glide(w.motion.tip_m() + Vec3(0, 0, 0.012 * dt_s), 0.02, dt_s));
        up = false;
    }
    if (!up) return;
    if (!aims()) {
        for (int t = 0; t < busy_; ++t) {
            Worker& w = workers_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])];
            w.anchor = w.motion.tip_m();
        }
        stage(Stage::kDo);
        return;
    }
    aim();
    for (int t = 0; t < busy_; ++t) {
        Worker& w = workers_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])];
        w.height_m = kHoverM;
        w.motion.reach(place(w, t), Vec3::UnitZ());
    }
    stage(Stage::kGo);
}

void PracticeOperator::go(double dt_s) noexcept {
    bool there = true;
    for (int t = 0; t < busy_; ++t) {
        Worker& w = workers_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])];
        if (tools_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])].kind ==
            sim::ToolKind::kGrasper)
            static_cast<void>(w.motion.jaw(jaw_habits(level_).open_rad, 1.5, dt_s));
        there = w.motion.reached(place(w, t), dt_s) && there;
    }
    if (there) stage(Stage::kDown);
}

void PracticeOperator::down(double dt_s) noexcept {
    bool touched = true;
    const bool energy =
        goal_.step.kind == PracticeKind::kCut || goal_.step.kind == PracticeKind::kCoag;
    for (int t = 0; t < busy_; ++t) {
        Worker& w = workers_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])];
        if (energy && w.height_m < habits_.early_pedal_s * profile_.descend_m_s)
            w.pedals = goal_.step.kind == PracticeKind::kCut ? sim::kPedalCut : sim::kPedalCoag;
        if (w.touches || w.height_m < -kDeepestM) {
            w.gone_m = w.height_m;  // where it touched
            w.anchor = w.motion.tip_m();
            continue;
        }
        w.height_m -= profile_.descend_m_s * dt_s;
        static_cast<void>(w.motion.glide(place(w, t), 0.02, dt_s));
        touched = false;
    }
    if (touched) stage(Stage::kDo);
}

/// Tissue yields, and with it the target that is seen: a hand that keeps its height above it goes
/// down with it until something tears. Who feels stays where he met it, and goes on only when he
/// has lost it.
void PracticeOperator::press(Worker& w, double press_m, double dt_s) noexcept {
    constexpr double kPressMS = 0.002, kLostM = 1e-3;
    const bool feels = habits_.feels && goal_.step.kind != PracticeKind::kTouch;
    const double deepest = w.gone_m - press_m - (feels && !w.touches ? kLostM : 0);
    if (!feels || w.height_m > deepest)
        w.height_m = std::max(w.height_m - kPressMS * dt_s, deepest);
    const Vec3 goal =
        feels ? Vec3(w.anchor + (w.height_m - w.gone_m) * Vec3::UnitZ()) : place(w, 0);
    static_cast<void>(w.motion.glide(goal, 0.02, dt_s));
}

void PracticeOperator::do_touch(Worker& w, double dt_s) noexcept {
    press(w, habits_.press_m, dt_s);
    if (goal_.step.kind != PracticeKind::kTouch)
        w.pedals = goal_.step.kind == PracticeKind::kCut ? sim::kPedalCut : sim::kPedalCoag;
    const double patience = 1.0 + 1.5 * goal_.step.hold_s;
    if (stage_s_ > patience) stage(Stage::kAgain);  // not the place: once more
}

void PracticeOperator::do_grasp(Worker& w, double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    press(w, 2e-4, dt_s);
    static_cast<void>(w.motion.jaw(habit.squeezed_rad(), habit.close_rad_s, dt_s));
    if (stage_s_ > 2.5) stage(Stage::kAgain);
}

/// Along the planned line at its height: down when it has lost touch, up when it presses.
void PracticeOperator::do_trace(Worker& w, double dt_s) noexcept {
    if (contour_.size() < 3) return;
    double length = 0;
    std::vector<double>::size_type i = 0;
    arc_m_ += habits_.trace_m_s * dt_s;
    double left = arc_m_;
    // The way from point to point, around and around.
    for (;; i = (i + 1) % contour_.size()) {
        length = (contour_[(i + 1) % contour_.size()] - contour_[i]).norm();
        if (left <= length || length <= 0) break;
        left -= length;
    }
    const Vec3 a = contour_[i], b = contour_[(i + 1) % contour_.size()];
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : contour_) centre += p / static_cast<double>(contour_.size());
    const Vec3 out = (a - centre).normalized();
    wander_ += -wander_ * dt_s / profile_.wander_s + habits_.trace_wander_m *
                                                         std::sqrt(2 * dt_s / profile_.wander_s) *
                                                         w.motion.random().normal();
    w.height_m = std::clamp(w.height_m + (w.touches ? 4e-4 : -8e-4) * dt_s, -1.5e-3, 2e-3);
    const Vec3 goal = a + (left / std::max(length, 1e-9)) * (b - a) +
                      (wander_ - habits_.trace_inward_m) * out +
                      (w.height_m - habits_.press_m * 0.5) * normal_[i];
    static_cast<void>(w.motion.glide(goal, 0.03, dt_s));
}

/// Both jaws close, then the hands part until the pull is what this hand thinks is right.
void PracticeOperator::do_traction(double dt_s) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    const sim::PracticeStep& step = goal_.step;
    const double wanted = step.low_n + habits_.pull * (step.high_n - step.low_n);
    bool both = true;
    for (int t = 0; t < busy_; ++t) {
        Worker& w = workers_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])];
        static_cast<void>(w.motion.jaw(habit.squeezed_rad(), habit.close_rad_s, dt_s));
        both = both && w.holds;
    }
    if (!both && stage_s_ > 3) stage(Stage::kAgain);
    for (int t = 0; t < busy_ && both; ++t) {
        Worker& w = workers_[static_cast<size_t>(at_work_[static_cast<size_t>(t)])];
        const Vec3 apart =
            goal_.target_m[static_cast<size_t>(t)] - goal_.target_m[static_cast<size_t>(1 - t)];
        const Vec3 offset = (apart.normalized() + 0.5 * Vec3::UnitZ()).normalized();
        // Slower as it comes near: an overshoot is what tears.
        const double lack = std::clamp((wanted - w.pull_n) / wanted, -1.0, 1.0);
        const double step_m = habits_.pull_m_s * lack * dt_s;
        w.gone_m += step_m;
        static_cast<void>(w.motion.glide(w.motion.tip_m() + step_m * offset, 0.05, dt_s));
    }
    if (stage_s_ > kDoPatienceS + 2 * step.hold_s) stage(Stage::kAgain);
}

void PracticeOperator::do_step(double dt_s) noexcept {
    for (int t = 0; t < busy_; ++t) {
        const auto tool = static_cast<size_t>(at_work_[static_cast<size_t>(t)]);
        Worker& w = workers_[tool];
        switch (goal_.step.kind) {
            case PracticeKind::kMove:
            case PracticeKind::kDepth:
            case PracticeKind::kTurn:
                wander_about(w, tool, dt_s);
                break;
            case PracticeKind::kTouch:
            case PracticeKind::kCut:
            case PracticeKind::kCoag:
                do_touch(w, dt_s);
                break;
            case PracticeKind::kGrasp:
                do_grasp(w, dt_s);
                break;
            case PracticeKind::kRelease:
                static_cast<void>(w.motion.jaw(jaw_habits(level_).open_rad, 2.0, dt_s));
                break;
            case PracticeKind::kTrace:
                do_trace(w, dt_s);
                break;
            case PracticeKind::kTraction:
            case PracticeKind::kPatchTake:  // a patch has an operator of its own
            case PracticeKind::kPatchLay:
            case PracticeKind::kPatchSpread:
            case PracticeKind::kWash:  // and so has irrigation
            case PracticeKind::kSuck:
            case PracticeKind::kUndermine:  // and undermining
            case PracticeKind::kNeedleIn:   // and so have sutures
            case PracticeKind::kNeedleOut:
            case PracticeKind::kNeedleTake:
            case PracticeKind::kNeedleThrough:
            case PracticeKind::kThreadDraw:
            case PracticeKind::kNeedleShow:
            case PracticeKind::kNeedleLay:
                break;
            case PracticeKind::kWithdraw:
                static_cast<void>(w.motion.glide(w.motion.home_m(), 0.02, dt_s));
                break;
        }
    }
    if (goal_.step.kind == PracticeKind::kTraction) do_traction(dt_s);
}

/// All is done: lets go and rises.
void PracticeOperator::leave(double dt_s) noexcept {
    for (size_t i = 0; i < workers_.size(); ++i) {
        Worker& w = workers_[i];
        if (tools_[i].kind == sim::ToolKind::kScope) continue;
        w.pedals = 0;
        if (w.holds)
            static_cast<void>(w.motion.jaw(jaw_habits(level_).open_rad, 2.0, dt_s));
        else
            static_cast<void>(
                w.motion.glide(w.motion.tip_m() + Vec3(0, 0, 0.008 * dt_s), 0.02, dt_s));
    }
}

bool PracticeOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    stage_s_ += dt_s;
    step_s_ += dt_s;
    if (goal_.index != step_ && goal_.index < goal_.count && time_s_ > profile_.look_s)
        begin_step();
    const bool over = goal_.count > 0 && goal_.index >= goal_.count;
    if (over) leave(dt_s);
    switch (over ? Stage::kLook : stage_) {
        case Stage::kLook:
        case Stage::kGiveUp:
            break;
        case Stage::kRise:
            rise(dt_s);
            break;
        case Stage::kGo:
            go(dt_s);
            break;
        case Stage::kDown:
            down(dt_s);
            break;
        case Stage::kDo:
            do_step(dt_s);
            break;
        case Stage::kAgain:
            ++tries_;
            late_s_ = 0;
            stage(Stage::kRise);
            break;
    }
    if (step_s_ > kStepPatienceS && step_ >= 0 && !over) stage(Stage::kGiveUp);
    for (size_t i = 0; i < std::min(hands.size(), workers_.size()); ++i) {
        hands[i] = workers_[i].motion.action(time_s_);
        if (tools_[i].kind == sim::ToolKind::kScope) hands[i].tip_m = workers_[i].motion.tip_m();
        hands[i].opening = workers_[i].opening;
        hands[i].pedals = stage_ == Stage::kGiveUp ? uint8_t{0} : workers_[i].pedals;
    }
    return stage_ == Stage::kGiveUp;
}

}  // namespace placode::haptics
