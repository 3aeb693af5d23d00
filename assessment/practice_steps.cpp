// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// When a step of practice counts as done: what each kind of step looks at, what it writes down as
// events, and how far it has come.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "assessment/closure.h"
#include "assessment/practice.h"

namespace placode::assessment {

using sim::PracticeKind;

namespace {

constexpr double kNearSurfaceM = 0.001;  // a tip this near follows the line
constexpr double kNotThisLineM = 0.003;  // further off it is on its way to the line,
constexpr double kStrayedS = 0.3;        // unless it stays there for longer than this
constexpr double kGoneM = 1e-4;          // more than a hand trembles: so far it went, and not stood
constexpr double kStandsM = 1e-9;        // weighs as much of a way, where there is no other
constexpr int kBinsEnough = 69;          // of 72: the last ones meet the first
constexpr double kTakenWithin = 0.15;    // of the needle's arc
constexpr double kLaidFromM = 0.003;     // over the field: a needle let go lower is laid down
constexpr double kEasedShare = 0.5;      // of a pull that is enough: below it the hand gave way
constexpr double kTractionReachM = 0.005;
constexpr double kLaidShare = 0.95;  // of the placode's edge: a patch that overlaps so much is laid
constexpr double kFlatShare = 0.02;  // of a patch: less than that in folds is flat
constexpr double kAlongShaft =
    0.85;  // share of a motion that makes it one of depth: within 32 degrees

sim::Vec3 tip(const sim::ToolSample& tool) { return {tool.tip_m[0], tool.tip_m[1], tool.tip_m[2]}; }
sim::Quat turn(const sim::ToolSample& tool) {
    const auto& q = tool.orientation;
    return {q[0], q[1], q[2], q[3]};
}

}  // namespace

bool PracticeTracker::did(const PracticeSight& sight) noexcept {
    if (step().kind == PracticeKind::kTraction) return did_traction(sight);
    const int index = tool_of(step().hand, sight);
    if (index < 0) return true;  // no such instrument here: nothing to wait for
    const auto i = static_cast<size_t>(index);
    const sim::ToolSample& tool = sight.sample.tools[i];
    if (!sight.engaged[i] || index != last_tool_) {
        has_last_ = false;
        last_tool_ = index;
    }
    bool done = false;
    switch (step().kind) {
        case PracticeKind::kTouch:
        case PracticeKind::kCut:
        case PracticeKind::kCoag:
            done = did_touch(sight, index);
            break;
        case PracticeKind::kGrasp:
            done = did_grasp(sight, index);
            break;
        case PracticeKind::kNeedleIn:
        case PracticeKind::kNeedleOut:
        case PracticeKind::kNeedleTake:
        case PracticeKind::kNeedleThrough:
            done = did_bite(sight, index);
            break;
        case PracticeKind::kNeedleShow:
        case PracticeKind::kNeedleLay:
            done = did_handle(sight, index);
            break;
        case PracticeKind::kThreadDraw:
            // Not the driver's force, which may press the edges together beside the thread.
            done = did_draw(sight.slit_gap_m, sight.thread_pull_n);
            break;
        case PracticeKind::kPatchTake:
        case PracticeKind::kPatchLay:
        case PracticeKind::kPatchSpread:
            done = did_patch(sight.patch, i);
            break;
        case PracticeKind::kWash:
        case PracticeKind::kSuck:
            done = did_wash(sight.wash);
            break;
        case PracticeKind::kUndermine:
            done = did_undermine(sight.undermine, i);
            break;
        case PracticeKind::kRelease:
            done = !sight.holds[i];
            break;
        case PracticeKind::kTrace:
            done = did_trace(tool, index, now_s_);
            break;
        case PracticeKind::kWithdraw:
            progress_ = std::clamp(tool.tip_gap_m / step().distance_m, 0.0, 1.0);
            done = tool.tip_gap_m >= step().distance_m;
            break;
        default:
            done = did_motion(tool);
            break;
    }
    last_ = tool;
    has_last_ = sight.engaged[i];
    return done;
}

/// Jaws that close on tissue at the target.
bool PracticeTracker::did_grasp(const PracticeSight& sight, int index) noexcept {
    const auto i = static_cast<size_t>(index);
    const sim::ToolSample& tool = sight.sample.tools[i];
    const bool near = !sight.targets.empty() &&
                      (tip(tool) - sight.targets[0]).head<2>().norm() < step().tolerance_m;
    bool done = false;
    if (sight.holds[i] && !open_) {  // one grasp is one event, at the target or beside it
        const double path =
            sight.targets.empty() ? 0 : (tip(tool) - sight.targets[0]).head<2>().norm();
        emit(near ? sim::EventKind::kTargetTouched : sim::EventKind::kTargetMissed, index_, path,
             index, tip(tool));
        done = near;
    }
    open_ = sight.holds[i];
    progress_ = done ? 1 : 0;
    return done;
}

bool PracticeTracker::did_motion(const sim::ToolSample& tool) noexcept {
    if (!has_last_) return false;
    const sim::Vec3 offset = tip(tool) - tip(last_);
    const sim::Vec3 shaft = turn(tool) * sim::Vec3::UnitZ();
    double whole = step().distance_m;
    if (step().kind == PracticeKind::kMove) {
        amount_ += (offset - offset.dot(shaft) * shaft).norm();
    } else if (step().kind == PracticeKind::kDepth) {
        // What goes mostly sideways is not pushed, though a part of it lies along the shaft.
        const double along = std::abs(offset.dot(shaft));
        if (along >= kAlongShaft * offset.norm()) amount_ += along;
    } else {
        // Twist about the shaft between the samples.
        const sim::Quat change = turn(last_).conjugate() * turn(tool);
        const double angle = 2 * std::atan2(change.z(), change.w());
        amount_ += std::abs(std::remainder(angle, 2 * std::numbers::pi));
        whole = step().turn_rad;
    }
    progress_ = std::clamp(amount_ / whole, 0.0, 1.0);
    return amount_ >= whole;
}

bool PracticeTracker::did_touch(const PracticeSight& sight, int index) noexcept {
    if (sight.targets.empty()) return true;
    const sim::ToolSample& tool = sight.sample.tools[static_cast<size_t>(index)];
    const double path = (tip(tool) - sight.targets[0]).head<2>().norm();
    const bool near = path <= step().tolerance_m;
    const bool touches = tool.in_contact != 0;
    // A touch counts when it begins; what slides onto the target afterwards has missed it.
    if (touches && !touched_)
        emit(near ? sim::EventKind::kTargetTouched : sim::EventKind::kTargetMissed, index_, path,
             index, tip(tool));
    touched_ = touches;
    const uint8_t pedal = step().kind == PracticeKind::kCut    ? sim::kPedalCut
                          : step().kind == PracticeKind::kCoag ? sim::kPedalCoag
                                                               : uint8_t{0};
    const bool doing = touches && near && (pedal == 0 || tool.pedals == pedal);
    // Energy counts in bursts: a practised foot taps.
    held_s_ = doing ? held_s_ + dt_ : pedal != 0 ? held_s_ : 0;
    progress_ = step().hold_s > 0 ? std::clamp(held_s_ / step().hold_s, 0.0, 1.0) : 0;
    return doing && held_s_ >= step().hold_s;
}

/// A pass is weighed by the way that the tip goes, along the line or across it: with time for a
/// weight, standing still on the line would thin out the wobble before it.
void PracticeTracker::weigh_offset(const sim::Vec2& at, double offset_m) noexcept {
    const double way = bin_weight_ > 0 ? (at - bin_from_).norm() : 0;
    const bool went = way >= kGoneM;
    const double weight = kStandsM + (went ? way : 0);
    bin_offset_ += weight * (went ? (bin_from_offset_ + offset_m) / 2 : offset_m);
    if (went || bin_weight_ == 0) {
        bin_from_ = at;
        bin_from_offset_ = offset_m;
    }
    bin_weight_ += weight;
}

void PracticeTracker::close_bin(int tool, double) noexcept {
    if (bin_ < 0 || bin_weight_ == 0) return;
    const double mean = bin_offset_ / bin_weight_;
    emit(sim::EventKind::kTraced, bin_, mean, tool, sim::Vec3::Zero());
    if (mean <= step().tolerance_m && traced_[static_cast<size_t>(bin_)] == 0) {
        traced_[static_cast<size_t>(bin_)] = 1;
        ++bins_done_;
    }
    bin_ = -1;
}

bool PracticeTracker::did_trace(const sim::ToolSample& tool, int index, double time_s) noexcept {
    if (contour_.empty()) return true;
    const ClosedContour::Foot foot = contour_[0].nearest(tip(tool).head<2>());
    const bool near = tool.tip_gap_m < kNearSurfaceM;
    const bool far = std::abs(foot.offset) >= kNotThisLineM;
    const bool strayed = held_s_ > kStrayedS;
    held_s_ = near && far ? held_s_ + dt_ : 0;
    const bool strays = held_s_ > kStrayedS;
    const bool follows = near && (!far || strays);
    const int bin =
        !follows ? -1
                 : std::clamp(static_cast<int>(sim::kTraceBins * foot.arc / contour_[0].length()),
                              0, sim::kTraceBins - 1);
    // One pass is near the line or far from it: else time near it would thin out the fault.
    if (bin != bin_ || strays != strayed) {
        close_bin(index, time_s);
        bin_ = bin;
        bin_weight_ = 0;
        bin_offset_ = 0;
    }
    if (bin >= 0) weigh_offset(tip(tool).head<2>(), std::abs(foot.offset));
    progress_ = static_cast<double>(bins_done_) / kBinsEnough;
    return bins_done_ >= kBinsEnough;
}

void PracticeTracker::close_traction(double) noexcept {
    if (held_s_ > 0) emit(sim::EventKind::kTractionHeld, held_s_, peak_n_, -1, sim::Vec3::Zero());
    held_s_ = peak_n_ = 0;
}

/// Both hands hold tissue near their places and pull within the band, without a break. Tissue that
/// was held before the step began does not count: it has to be let go first.
bool PracticeTracker::did_traction(const PracticeSight& sight) noexcept {
    const int right = tool_of(sim::Hand::kRight, sight), left = tool_of(sim::Hand::kLeft, sight);
    if (right < 0 || left < 0 || sight.targets.size() < 2) return true;
    const auto r = static_cast<size_t>(right), l = static_cast<size_t>(left);
    if (!sight.holds[r] && !sight.holds[l]) open_ = true;
    bool good = open_ && sight.holds[r] && sight.holds[l];
    for (const auto& [i, target] : {std::pair{r, sight.targets[0]}, {l, sight.targets[1]}}) {
        const double pull = sight.pull_n[i];
        good = good && pull >= step().low_n && pull <= step().high_n &&
               (tip(sight.sample.tools[i]) - target).head<2>().norm() < kTractionReachM;
        if (good) peak_n_ = std::max(peak_n_, pull);
    }
    if (good) {
        held_s_ += dt_;
    } else {
        close_traction(now_s_);
    }
    progress_ = std::clamp(held_s_ / std::max(step().hold_s, dt_), 0.0, 1.0);
    if (held_s_ < step().hold_s) return false;
    close_traction(now_s_);
    return true;
}

/// Where the needle goes in and comes out; a needle that was drawn back may go in once more.
bool PracticeTracker::did_bite(const PracticeSight& sight, int tool) noexcept {
    const NeedleSight& now = sight.needle;
    if (now.handled && step().kind == PracticeKind::kNeedleTake) return did_take(now, tool);
    const bool in = now.entered > needle_.entered && !now.entry_in_slit;
    const bool out = now.left > needle_.left && !now.exit_in_slit;
    const bool taken = now.taken > needle_.taken;
    needle_ = now;
    const auto away = [&](const sim::Vec3& place, size_t mark) {
        return (place - now.mark_m[mark]).norm();
    };
    const PracticeKind kind = step().kind;
    const bool bites = kind == PracticeKind::kNeedleIn || kind == PracticeKind::kNeedleOut;
    if (in && bites)
        emit(sim::EventKind::kBiteEntry, index_, away(now.entry_m, 0), tool, now.entry_m);
    if (out && kind == PracticeKind::kNeedleOut)
        emit(sim::EventKind::kBiteExit, index_, away(now.exit_m, 1), tool, now.exit_m);
    if (bites) through_before_ = now.through;
    if (kind == PracticeKind::kNeedleIn) return in;
    if (kind == PracticeKind::kNeedleOut) return out;
    // Pushed all the way through without being taken again: nothing is left to take.
    const bool through = now.through > through_before_ && !now.in_tissue;
    const bool there =
        step().take_share == 0 || std::abs(now.held_share - step().take_share) <= kTakenWithin;
    return through || (kind == PracticeKind::kNeedleTake && taken && there);
}

/// By this hand, whether another one holds it as well or not.
bool PracticeTracker::did_take(const NeedleSight& needle, int tool) noexcept {
    const auto i = static_cast<size_t>(tool);
    const double wanted = step().take_share, off = std::abs(needle.share[i] - wanted);
    if (!needle.held[i] || (wanted > 0 && off > kTakenWithin)) return false;
    if (wanted > 0) emit(sim::EventKind::kNeedlePlaced, index_, off, tool, needle.point_m);
    return true;
}

/// A needle that falls: let go in the open, and not to lie at its mark.
void PracticeTracker::watch_handling(const PracticeSight& sight) noexcept {
    const NeedleSight& now = sight.needle;
    const bool let_go = carried_ && now.free() && !now.in_tissue;
    carried_ = !now.free();
    if (!let_go) return;
    const bool lays = step().kind == PracticeKind::kNeedleLay && !sight.targets.empty() &&
                      now.lowest_m <= kLaidFromM &&
                      (now.middle_m - sight.targets[0]).head<2>().norm() <= step().tolerance_m;
    if (!lays) emit(sim::EventKind::kNeedleDropped, index_, now.lowest_m, -1, now.middle_m);
}

/// Held with its point at the mark; let go, lying at it.
bool PracticeTracker::did_handle(const PracticeSight& sight, int tool) noexcept {
    if (sight.targets.empty()) return true;
    const NeedleSight& now = sight.needle;
    const bool shows = step().kind == PracticeKind::kNeedleShow;
    const double away = shows ? (now.point_m - sight.targets[0]).norm()
                              : (now.middle_m - sight.targets[0]).head<2>().norm();
    const bool ready =
        shows ? now.held[static_cast<size_t>(tool)] : now.free() && now.lowest_m <= kLaidFromM;
    held_s_ = ready && away <= step().tolerance_m ? held_s_ + dt_ : 0;
    progress_ = std::clamp(held_s_ / std::max(step().hold_s, dt_), 0.0, 1.0);
    if (held_s_ <= 0 || held_s_ < step().hold_s) return false;
    emit(shows ? sim::EventKind::kNeedleShown : sim::EventKind::kNeedleLaid, index_, away, tool,
         shows ? now.point_m : now.middle_m);
    return true;
}

/// Whoever has held enough for a while and eases off has drawn as much as they wanted to.
bool PracticeTracker::eased_off(double slit_gap_m, double pull_n) noexcept {
    const double enough_n = step().enough_n;
    if (enough_n <= 0) return false;
    const bool shut = slit_gap_m <= std::max(step().tolerance_m, kShutM);
    if (shut) peak_n_ = std::max(peak_n_, pull_n);
    enough_s_ = shut && pull_n >= enough_n ? enough_s_ + dt_ : 0;
    open_ = open_ || enough_s_ >= step().hold_s;
    return open_ && pull_n < kEasedShare * enough_n;
}

/// Taken; laid, whether it is still held or not; and lying so, flat, when nobody holds it.
bool PracticeTracker::did_patch(const PatchSight* patch, size_t tool) noexcept {
    if (patch == nullptr) return true;  // nothing to lay
    if (step().kind == PracticeKind::kPatchTake) {
        progress_ = patch->held[tool] ? 1 : 0;
        return patch->held[tool];
    }
    const double laid = std::clamp(patch->overlapped / kLaidShare, 0.0, 1.0);
    if (step().kind == PracticeKind::kPatchLay) {
        progress_ = laid;
        return laid >= 1;
    }
    const bool lies = laid >= 1 && patch->folded <= kFlatShare && patch->free();
    held_s_ = lies ? held_s_ + dt_ : 0;
    progress_ = 0.5 * (laid + std::clamp(1 - patch->folded / 0.2, 0.0, 1.0));
    return lies && held_s_ >= step().hold_s;
}

/// All debris loosened; nothing afloat and the field dry.
bool PracticeTracker::did_wash(const WashSight* wash) noexcept {
    if (wash == nullptr) return true;  // nothing to wash
    if (step().kind == PracticeKind::kWash) {
        progress_ = wash->debris > 0 ? 1 - wash->stuck / wash->debris : 1;
        return wash->stuck == 0;
    }
    const bool dry = wash->standing_m3 <= kDryM3 && wash->loose == 0;
    held_s_ = dry ? held_s_ + dt_ : 0;
    progress_ = std::clamp(kDryM3 / std::max(kDryM3, wash->standing_m3), 0.0, 1.0);
    if (wash->loose > 0) progress_ = std::min(progress_, 0.9);
    return dry && held_s_ >= step().hold_s;
}

/// Enough of the skin on the far side of the wound is free.
bool PracticeTracker::did_undermine(const UndermineSight* undermine, size_t tool) noexcept {
    if (undermine == nullptr) return true;  // nothing to undermine
    progress_ = std::clamp(undermine->freed[tool] / kEnoughUndermined, 0.0, 1.0);
    return progress_ >= 1;
}

/// Shut for a while, under as much pull as the step wants: edges that only swing together come
/// apart again, and thread gives a little when it is let go.
bool PracticeTracker::did_draw(double slit_gap_m, double pull_n) noexcept {
    if (slit_gap_m < 0) return true;  // nothing to shut
    amount_ = std::max(amount_, slit_gap_m);
    const bool shut = slit_gap_m <= step().tolerance_m, taut = pull_n >= step().low_n;
    held_s_ = shut && taut ? held_s_ + dt_ : 0;
    const double path = amount_ - step().tolerance_m, half = step().low_n > 0 ? 0.5 : 1;
    progress_ = !shut  ? half * std::clamp((amount_ - slit_gap_m) / path, 0.0, 1.0)
                : taut ? 1
                       : half + half * pull_n / step().low_n;
    const bool eased = eased_off(slit_gap_m, pull_n);
    return (shut && taut && held_s_ >= step().hold_s) || eased;
}

}  // namespace placode::assessment
