// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/resection_operator.h"

#include <algorithm>
#include <cmath>

#include "haptics/operators/jaw_habits.h"

namespace placode::haptics {

namespace {

constexpr double kResectionHoverM = 0.005;  // of free motion over the tissue
constexpr double kRiseMS = 0.012;           // out of the tissue
constexpr double kEnterMS = 0.008;          // into it
constexpr double kAdvanceMS = 0.010;        // between snips
constexpr double kPressM = 0.0002, kResectionDeepestM = 0.0014;
constexpr double kChangeS = 2.0;  // another instrument through the port
constexpr double kPullM = 0.007;  // how far a piece is lifted before it must be free
constexpr double kPullMS = 0.004;
constexpr double kCarryMS = 0.025;  // out through the port
constexpr double kCarryS = 3;
constexpr double kSlackN = 0.004;      // of traction: what is held hangs on nothing
constexpr double kAboutRestM = 0.003;  // where the outline is gone over again
constexpr int kGrasps = 6;
constexpr size_t kNormalSpan = 4;
constexpr double kGiveUpS = 240;

}  // namespace

ResectionOperator::ResectionOperator(OperatorLevel level, uint64_t seed,
                                     const ResectionTools& tools,
                                     std::span<const sim::ToolSpec> specs,
                                     std::span<const Vec3> homes)
    : level_(level),
      profile_(operator_profile(level)),
      tools_(tools),
      scissors_pivot_(specs[static_cast<size_t>(tools.scissors)].pivot_m),
      grasper_pivot_(specs[static_cast<size_t>(tools.grasper)].pivot_m),
      scissors_(profile_, seed + 1, homes[static_cast<size_t>(tools.scissors)]),
      grasper_(profile_, seed + 2, homes[static_cast<size_t>(tools.grasper)]) {
    if (tools.needle < 0) return;
    ring_ =
        std::make_unique<OperatorModel>(profile_, seed, homes[static_cast<size_t>(tools.needle)]);
    right_ = Right::kRing;
}

void ResectionOperator::see(const Perception& seen) {
    if (ring_ && right_ == Right::kRing) {
        const auto needle = static_cast<size_t>(tools_.needle);
        Perception own = seen;
        own.in_contact = seen.touches[needle];
        own.placode_gap_m[0] = seen.placode_gap_m[needle];
        ring_->see(own, needle < seen.tools.size() ? seen.tools[needle] : sim::ToolFeedback{});
    }
    const size_t n = seen.outline.size();
    if (line_.size() != n) {
        line_.resize(n);
        normal_.resize(n);
        cut_.resize(n);
        tries_.assign(n, 0);
    }
    std::copy(seen.outline.begin(), seen.outline.end(), line_.begin());
    std::copy_n(seen.outline_normal.begin(), std::min(n, seen.outline_normal.size()),
                normal_.begin());
    std::copy_n(seen.outline_cut.begin(), std::min(n, seen.outline_cut.size()), cut_.begin());
    // Closing jaws press the tissue in: a hand that went after it would only press more.
    if (!holds_ && left_ != Left::kClose) {
        place_ = seen.grasp_place_m;
        placed_ = n > 0;
    }
    const auto grasper = static_cast<size_t>(tools_.grasper);
    holds_ = seen.holds[grasper];
    touches_ = seen.touches[grasper];
    piece_free_ = seen.piece_free;
    pieces_out_ = seen.pieces_out;
    marked_left_ = seen.marked_left;
    marked_held_ = seen.marked_held;
    pull_n_ = seen.pull_n[grasper];
    placode_gap_m_ = seen.placode_gap_m[static_cast<size_t>(tools_.scissors)];
}

void ResectionOperator::go(Right next) noexcept {
    right_ = next;
    right_s_ = 0;
}
void ResectionOperator::go(Left next) noexcept {
    left_ = next;
    left_s_ = 0;
}

bool ResectionOperator::open_at(size_t i) const noexcept {
    // Parted all along and yet not free: only what is near the rest is gone over again.
    const bool parted = trust_cut_ ? cut_[i] != 0 : (line_[i] - place_).norm() > kAboutRestM;
    return !parted && tries_[i] < jaw_habits(level_).passes;
}

/// Worth another grasp.
bool ResectionOperator::unfinished() const noexcept {
    return placed_ && marked_left_ > jaw_habits(level_).leaves && grasps_ < kGrasps;
}

/// Takes hold of what is left and goes round it once more.
void ResectionOperator::grasp_again() noexcept {
    std::fill(tries_.begin(), tries_.end(), uint8_t{0});
    if (std::find(cut_.begin(), cut_.end(), 0) == cut_.end()) trust_cut_ = false;
    cutting_done_ = false;
    passes_ = 0;
    ++grasps_;
    grasper_.reach(hold_place(kResectionHoverM), Vec3::UnitZ());
    go(Left::kReach);
}

/// The next piece of outline that still holds, the least tried first.
bool ResectionOperator::next_run() noexcept {
    const size_t n = line_.size();
    if (n == 0) return false;
    uint8_t least = 255;
    for (size_t i = 0; i < n; ++i) {
        if (open_at(i)) least = std::min(least, tries_[i]);
    }
    if (least == 255) return false;
    // From where the blades are, onwards.
    for (size_t k = 0; k < n; ++k) {
        const size_t i = (at_ + k) % n;
        if (!open_at(i) || tries_[i] > least) continue;
        at_ = i;
        return true;
    }
    return false;
}

/// Looks at the outline where the blades shall cut next: place, direction, normal.
void ResectionOperator::aim() noexcept {
    const size_t n = line_.size();
    point_ = line_[at_];
    up_.setZero();
    for (size_t k = 0; k < 2 * kNormalSpan + 1; ++k) {
        const Vec3& m = normal_[(at_ + n + k - kNormalSpan) % n];
        if (m.allFinite()) up_ += m;
    }
    up_ = up_.norm() > 0.1 ? Vec3(up_.normalized()) : Vec3(Vec3::UnitZ());
    along_ = line_[(at_ + kNormalSpan) % n] - line_[(at_ + n - kNormalSpan) % n];
    along_ -= along_.dot(up_) * up_;
    along_ = along_.norm() > 0 ? Vec3(along_.normalized()) : Vec3(Vec3::UnitX());
    beside_ = along_.cross(up_);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : line_) middle += p / static_cast<double>(n);
    if (beside_.dot(middle - point_) > 0) beside_ = -beside_;
}

/// Counts a try for all that the blades have covered.
void ResectionOperator::count_try() noexcept {
    const double covered_m = jaw_habits(level_).snip_step_m;
    for (size_t i = 0; i < line_.size(); ++i) {
        if ((line_[i] - point_).norm() < covered_m && tries_[i] < 255) ++tries_[i];
    }
}

Vec3 ResectionOperator::tip_goal(double above_m) const noexcept {
    return point_ + above_m * up_ + out_m_ * beside_;
}

Vec3 ResectionOperator::hold_place(double above_m) const noexcept {
    return place_ + place_error_ + above_m * place_normal_;
}

void ResectionOperator::right(double dt_s, std::span<HandAction> hands) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    if (right_ == Right::kRing) {
        const OperatorAction a = ring_->act(dt_s);
        HandAction& hand = hands[static_cast<size_t>(tools_.needle)];
        hand.tip_m = a.tip_m;
        hand.pedals = a.pedals;
        hand.engaged = true;
        if (a.finish) go(Right::kChange);
        return;
    }
    switch (right_) {
        case Right::kChange:
            if (right_s_ > kChangeS) go(Right::kWait);
            return;  // the port is empty
        case Right::kWait:
            if (!wanted_ || cutting_done_) break;
            if (!next_run()) {
                cutting_done_ = true;
                break;
            }
            aim();
            scissors_.reach(tip_goal(kResectionHoverM), up_);
            go(Right::kReach);
            break;
        case Right::kReach:
            static_cast<void>(scissors_.jaw(habit.blade_rad, 2.0, dt_s));
            if (!scissors_.reached(tip_goal(kResectionHoverM), dt_s)) break;
            out_m_ = habit.outward_m + habit.wander_m * scissors_.random().normal();
            go(Right::kEnter);
            break;
        case Right::kEnter:
            aim();
            if (!scissors_.glide(tip_goal(-habit.depth_m), kEnterMS, dt_s)) break;
            if (placode_gap_m_ < habit.clear_m) {
                count_try();  // not here: the placode would come between the blades
                go(Right::kOpen);
            } else {
                go(Right::kSnip);
            }
            break;
        case Right::kSnip:
            if (scissors_.jaw(0, habit.snip_rad_s, dt_s) && right_s_ > 0.05) {
                count_try();
                go(Right::kOpen);
            }
            break;
        case Right::kOpen:
            // Out of the slit before the blades open: open blades inside would cut at random.
            static_cast<void>(scissors_.glide(tip_goal(0.0008), kRiseMS, dt_s));
            if (right_s_ < 0.12) break;
            if (!scissors_.jaw(habit.blade_rad, 3.0, dt_s)) break;
            go(Right::kAdvance);
            break;
        case Right::kAdvance: {
            const size_t n = line_.size();
            double way = 0;
            size_t steps = 0;
            while (steps < n && way < habit.snip_step_m) {
                way += (line_[(at_ + steps + 1) % n] - line_[(at_ + steps) % n]).norm();
                ++steps;
            }
            const size_t next = (at_ + steps) % n;
            if (piece_free_ || !open_at(next) || !wanted_) {
                go(Right::kRise);
                break;
            }
            at_ = next;
            aim();
            out_m_ = habit.outward_m + habit.wander_m * scissors_.random().normal();
            go(Right::kEnter);
            break;
        }
        case Right::kRise:
            if (scissors_.glide(tip_goal(kResectionHoverM), kRiseMS, dt_s)) {
                if (piece_free_) cutting_done_ = true;
                go(Right::kWait);
                if (!next_run()) cutting_done_ = true;
                if (cutting_done_) {
                    scissors_.reach(scissors_.home_m(), Vec3::UnitZ());
                    go(Right::kAway);
                }
            }
            break;
        case Right::kAway:
            static_cast<void>(scissors_.jaw(0, 2.0, dt_s));
            if (scissors_.reached(scissors_.home_m(), dt_s)) go(Right::kWait);
            break;
        case Right::kRing:
            break;
    }
    HandAction& hand = hands[static_cast<size_t>(tools_.scissors)];
    hand = scissors_.action(time_s_);
    // Blades in the plane of cut and shaft.
    const Vec3 shaft = (hand.tip_m - scissors_pivot_).normalized();
    hand.opening = along_ - along_.dot(shaft) * shaft;
}

void ResectionOperator::carry() noexcept {
    out_before_ = pieces_out_;
    wanted_ = false;
    go(Left::kCarry);
}

void ResectionOperator::left(double dt_s, std::span<HandAction> hands) noexcept {
    const JawHabits& habit = jaw_habits(level_);
    const bool ready = right_ != Right::kRing && right_ != Right::kChange;
    switch (left_) {
        case Left::kLook:
            if (!ready || !placed_ || left_s_ < profile_.look_s) break;
            for (int k = 0; k < 2; ++k) {
                place_error_[k] = habit.aim_error_m * grasper_.random().normal();
            }
            grasper_.reach(hold_place(kResectionHoverM), Vec3::UnitZ());
            ++grasps_;
            go(Left::kReach);
            break;
        case Left::kReach:
            static_cast<void>(grasper_.jaw(habit.open_rad, 1.5, dt_s));
            height_m_ = kResectionHoverM;
            if (grasper_.reached(hold_place(kResectionHoverM), dt_s)) go(Left::kLower);
            break;
        case Left::kLower:
            height_m_ -= profile_.descend_m_s * dt_s;
            static_cast<void>(grasper_.glide(hold_place(height_m_), 0.02, dt_s));
            if (touches_ || height_m_ < -kResectionDeepestM) {
                low_m_ = std::max(height_m_ - kPressM, -kResectionDeepestM);
                go(Left::kClose);
            }
            break;
        case Left::kClose:
            height_m_ = std::max(height_m_ - 0.002 * dt_s, low_m_);
            static_cast<void>(grasper_.glide(hold_place(height_m_), 0.02, dt_s));
            if (!grasper_.jaw(habit.squeezed_rad(), habit.close_rad_s, dt_s) || left_s_ < 0.8) {
                break;
            }
            go(holds_ ? Left::kTension : Left::kOpen);
            break;
        case Left::kTension:
            height_m_ += habit.lift_m_s * dt_s;
            static_cast<void>(grasper_.glide(hold_place(height_m_), 0.03, dt_s));
            if (height_m_ < habit.tension_m) break;
            wanted_ = true;
            go(Left::kHold);
            break;
        case Left::kHold:
            if (!holds_) {
                wanted_ = false;
                go(Left::kOpen);
            } else if (cutting_done_ && right_ == Right::kWait) {
                go(Left::kLift);
            }
            break;
        case Left::kLift:
            height_m_ += kPullMS * dt_s;
            static_cast<void>(grasper_.glide(hold_place(height_m_), 0.03, dt_s));
            if (!holds_) {
                go(Left::kOpen);
            } else if (piece_free_ && height_m_ > 0.004) {
                carry();
            } else if (height_m_ > kPullM) {
                if (pull_n_ < kSlackN) {  // only part of it came along: out with that
                    carry();
                } else if (++passes_ < habit.passes) {
                    // Something still holds it: back, and along the outline again.
                    std::fill(tries_.begin(), tries_.end(), uint8_t{0});
                    cutting_done_ = false;
                    go(Left::kTension);
                    height_m_ = habit.tension_m;
                } else {
                    go(Left::kOpen);
                }
            }
            break;
        case Left::kCarry: {
            const Vec3 away = (grasper_pivot_ - grasper_.tip_m()).normalized();
            static_cast<void>(grasper_.glide(grasper_.tip_m() + 0.01 * away, kCarryMS, dt_s));
            const bool out = pieces_out_ > out_before_ && marked_held_ <= 0;
            if (out || !holds_ || left_s_ > kCarryS) go(Left::kOpen);
            break;
        }
        case Left::kOpen:
            if (!grasper_.jaw(habit.open_rad, 2.0, dt_s)) break;
            if (unfinished()) {
                grasp_again();
                break;
            }
            grasper_.reach(grasper_.home_m(), Vec3::UnitZ());
            go(Left::kBack);
            break;
        case Left::kBack:
            static_cast<void>(grasper_.jaw(0, 1.0, dt_s));
            wanted_ = false;
            if (grasper_.reached(grasper_.home_m(), dt_s) &&
                (right_ == Right::kWait || right_ == Right::kAway) && left_s_ > 2.5) {
                go(Left::kDone);
            }
            break;
        case Left::kDone:
            break;
    }
    hands[static_cast<size_t>(tools_.grasper)] = grasper_.action(time_s_);
}

bool ResectionOperator::act(double dt_s, std::span<HandAction> hands) noexcept {
    dt_s = std::clamp(dt_s, 0.0, 0.01);
    time_s_ += dt_s;
    right_s_ += dt_s;
    left_s_ += dt_s;
    right(dt_s, hands);
    left(dt_s, hands);
    if (line_.empty() && left_ == Left::kLook && left_s_ > profile_.look_s + 4 &&
        right_ != Right::kRing) {
        go(Left::kDone);  // nothing is marked
    }
    return left_ == Left::kDone || time_s_ > kGiveUpS;
}

}  // namespace placode::haptics
