// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/practice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "assessment/closure.h"
#include "assessment/statistics.h"

namespace placode::assessment {

namespace {

using sim::PracticeKind;

constexpr double kNearSurfaceM = 0.001;  // a tip this near follows the line
constexpr double kNotThisLineM = 0.003;  // further off it does not follow this line at all
constexpr int kBinsEnough = 69;          // of 72: the last ones meet the first
constexpr double kTakenWithin = 0.15;    // of the needle's arc
constexpr double kEasedShare = 0.5;      // of a pull that is enough: below it the hand gave way
constexpr double kTractionReachM = 0.005;
constexpr double kAlongShaft =
    0.85;  // share of a motion that makes it one of depth: within 32 degrees

sim::Vec3 tip(const sim::ToolSample& tool) { return {tool.tip_m[0], tool.tip_m[1], tool.tip_m[2]}; }
sim::Quat turn(const sim::ToolSample& tool) {
    const auto& q = tool.orientation;
    return {q[0], q[1], q[2], q[3]};
}

}  // namespace

sim::Vec2 practice_target(const sim::PracticeStep& step, const sim::FieldGeometry& geometry,
                          bool second) {
    if (step.placed) return step.place_m[second ? 1 : 0];
    const auto& line = geometry.planned_contour;
    // +x is up and +y is left in the picture, so the clock runs from +x towards -y.
    const double angle = -2 * std::numbers::pi * (second ? step.hour_left : step.hour) / 12;
    const sim::Vec2 way(std::cos(angle), std::sin(angle));
    if (line.empty()) return 0.008 * way;
    sim::Vec2 centre = sim::Vec2::Zero(), best = line[0].head<2>();
    for (const sim::Vec3& p : line) centre += p.head<2>() / static_cast<double>(line.size());
    double along = -2;
    for (const sim::Vec3& p : line) {
        const double here = (p.head<2>() - centre).normalized().dot(way);
        if (here <= along) continue;
        along = here;
        best = p.head<2>();
    }
    return best + step.outward_m * (best - centre).normalized();
}

PracticeTracker::PracticeTracker(std::span<const sim::PracticeStep> steps,
                                 std::span<const sim::ToolSpec> tools,
                                 const sim::FieldGeometry& geometry)
    : steps_(steps.begin(), steps.end()), tools_(tools.begin(), tools.end()) {
    assert(steps.size() <= sim::kMaxPracticeSteps);
    if (geometry.planned_contour.size() >= 3) contour_.emplace_back(geometry.planned_contour);
    for (const sim::PracticeStep& each : steps_)
        bites_ += each.kind == PracticeKind::kNeedleIn ? 1 : 0;
}

int PracticeTracker::bite() const noexcept {
    int begun = 0;
    for (int i = 0; i <= std::min(index_, count() - 1); ++i)
        begun += steps_[static_cast<size_t>(i)].kind == PracticeKind::kNeedleIn ? 1 : 0;
    return std::max(0, begun - 1);
}

const sim::PracticeStep& PracticeTracker::step() const noexcept {
    static const sim::PracticeStep none;
    return done() ? none : steps_[static_cast<size_t>(index_)];
}

void PracticeTracker::emit(sim::EventKind kind, double value, double value2, int tool,
                           const sim::Vec3& at) noexcept {
    if (event_count_ == events_.size()) return;
    sim::Event event;
    event.time_s = now_s_;
    event.kind = kind;
    event.tool = static_cast<int8_t>(tool);
    event.value = static_cast<float>(value);
    event.value2 = static_cast<float>(value2);
    for (int k = 0; k < 3; ++k)
        event.rest_position_m[static_cast<size_t>(k)] = static_cast<float>(at[k]);
    events_[event_count_++] = event;
}

void PracticeTracker::advance(double time_s) noexcept {
    if (step().kind == PracticeKind::kThreadDraw && step().enough_n > 0)
        emit(sim::EventKind::kThreadDrawn, index_, peak_n_, -1, sim::Vec3::Zero());
    emit(sim::EventKind::kStepDone, index_, time_s - began_s_, -1, sim::Vec3::Zero());
    ++index_;
    began_s_ = time_s;
    progress_ = amount_ = held_s_ = enough_s_ = peak_n_ = 0;
    has_last_ = open_ = false;
    touched_ = true;  // a touch that goes on from the step before is none of this one
    traced_.fill(0);
    bin_ = -1;
    bins_done_ = 0;
}

/// What the bites of a row are measured by: the line between their marks, and their pitch.
void PracticeTracker::tell_marks(const NeedleSight& needle) noexcept {
    marked_ = index_;
    for (size_t mark = 0; mark < needle.mark_m.size(); ++mark) {
        emit(sim::EventKind::kBiteMark, index_, static_cast<double>(mark), -1, needle.mark_m[mark]);
        if (event_count_ > 0) events_[event_count_ - 1].element = bite();
    }
}

/// The instrument of this hand that is in the field; instruments that share a port take turns.
int PracticeTracker::tool_of(sim::Hand hand, const PracticeSight& sight) const noexcept {
    int found = -1;
    for (size_t i = 0; i < tools_.size() && i < sim::kMaxTools; ++i) {
        if (tools_[i].hand != hand) continue;
        if (found < 0 || (sight.engaged[i] && !sight.engaged[static_cast<size_t>(found)]))
            found = static_cast<int>(i);
    }
    return found;
}

std::span<const sim::Event> PracticeTracker::see(const PracticeSight& sight) noexcept {
    event_count_ = 0;
    now_s_ = sight.sample.time_s;
    if (!started_) {
        emit(sim::EventKind::kPracticeSteps, count(), 0, -1, sim::Vec3::Zero());
        started_ = true;
        began_s_ = now_s_;
    }
    // A single bite says all of itself with its distances from the marks.
    if (bites_ > 1 && step().kind == PracticeKind::kNeedleIn && marked_ != index_ && !done())
        tell_marks(sight.needle);
    if (!done() && did(sight)) advance(now_s_);
    return {events_.data(), event_count_};
}

std::span<const sim::Event> PracticeTracker::end(double time_s) noexcept {
    event_count_ = 0;
    now_s_ = time_s;
    if (!done() && step().kind == PracticeKind::kTrace) close_bin(last_tool_, time_s);
    if (!done() && step().kind == PracticeKind::kTraction) close_traction(time_s);
    return {events_.data(), event_count_};
}

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
        case PracticeKind::kGrasp: {
            const bool near = !sight.targets.empty() &&
                              (tip(tool) - sight.targets[0]).head<2>().norm() < step().tolerance_m;
            if (sight.holds[i] && !open_) {  // one grasp is one event, at the target or beside it
                const double way =
                    sight.targets.empty() ? 0 : (tip(tool) - sight.targets[0]).head<2>().norm();
                emit(near ? sim::EventKind::kTargetTouched : sim::EventKind::kTargetMissed, index_,
                     way, index, tip(tool));
                done = near;
            }
            open_ = sight.holds[i];
            progress_ = done ? 1 : 0;
            break;
        }
        case PracticeKind::kNeedleIn:
        case PracticeKind::kNeedleOut:
        case PracticeKind::kNeedleTake:
        case PracticeKind::kNeedleThrough:
            done = did_bite(sight, index);
            break;
        case PracticeKind::kThreadDraw:
            done = did_draw(sight.slit_gap_m, std::hypot(static_cast<double>(tool.force_n[0]),
                                                         static_cast<double>(tool.force_n[1]),
                                                         static_cast<double>(tool.force_n[2])));
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

bool PracticeTracker::did_motion(const sim::ToolSample& tool) noexcept {
    if (!has_last_) return false;
    const sim::Vec3 way = tip(tool) - tip(last_);
    const sim::Vec3 shaft = turn(tool) * sim::Vec3::UnitZ();
    double whole = step().distance_m;
    if (step().kind == PracticeKind::kMove) {
        amount_ += (way - way.dot(shaft) * shaft).norm();
    } else if (step().kind == PracticeKind::kDepth) {
        // What goes mostly sideways is not pushed, though a part of it lies along the shaft.
        const double along = std::abs(way.dot(shaft));
        if (along >= kAlongShaft * way.norm()) amount_ += along;
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
    const double way = (tip(tool) - sight.targets[0]).head<2>().norm();
    const bool near = way <= step().tolerance_m;
    const bool touches = tool.in_contact != 0;
    // A touch counts when it begins; what slides onto the target afterwards has missed it.
    if (touches && !touched_)
        emit(near ? sim::EventKind::kTargetTouched : sim::EventKind::kTargetMissed, index_, way,
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

void PracticeTracker::close_bin(int tool, double) noexcept {
    if (bin_ < 0 || bin_samples_ == 0) return;
    const double mean = bin_offset_ / bin_samples_;
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
    const bool follows = tool.tip_gap_m < kNearSurfaceM && std::abs(foot.offset) < kNotThisLineM;
    const int bin =
        !follows ? -1
                 : std::clamp(static_cast<int>(sim::kTraceBins * foot.arc / contour_[0].length()),
                              0, sim::kTraceBins - 1);
    if (bin != bin_) {
        close_bin(index, time_s);
        bin_ = bin;
        bin_samples_ = 0;
        bin_offset_ = 0;
    }
    if (bin >= 0) {
        ++bin_samples_;
        bin_offset_ += std::abs(foot.offset);
    }
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

/// Shut for a while, under as much pull as the step wants: edges that only swing together come
/// apart again, and thread gives a little when it is let go.
bool PracticeTracker::did_draw(double slit_gap_m, double pull_n) noexcept {
    if (slit_gap_m < 0) return true;  // nothing to shut
    amount_ = std::max(amount_, slit_gap_m);
    const bool shut = slit_gap_m <= step().tolerance_m, taut = pull_n >= step().low_n;
    held_s_ = shut && taut ? held_s_ + dt_ : 0;
    const double way = amount_ - step().tolerance_m, half = step().low_n > 0 ? 0.5 : 1;
    progress_ = !shut  ? half * std::clamp((amount_ - slit_gap_m) / way, 0.0, 1.0)
                : taut ? 1
                       : half + half * pull_n / step().low_n;
    const bool eased = eased_off(slit_gap_m, pull_n);
    return (shut && taut && held_s_ >= step().hold_s) || eased;
}

void add_practice_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    int steps = 0, done = 0, misses = 0;
    bool aims = false, traces = false, pulls = false;
    std::vector<double> errors, offsets;
    std::array<bool, sim::kTraceBins> traced{};
    double held = 0;
    std::optional<double> loosest_n;
    for (const sim::Event& e : recording.events) {
        if (e.kind == sim::EventKind::kPracticeSteps) steps = static_cast<int>(e.value);
        if (e.kind == sim::EventKind::kStepDone) ++done;
        if (e.kind == sim::EventKind::kTargetTouched) errors.push_back(e.value2);
        if (e.kind == sim::EventKind::kTargetMissed) ++misses;
        if (e.kind == sim::EventKind::kTractionHeld) {
            held += e.value;
            pulls = true;
        }
        if (e.kind == sim::EventKind::kThreadDrawn) {
            const auto pull_n = static_cast<double>(e.value2);
            loosest_n = std::min(loosest_n.value_or(pull_n), pull_n);
        }
        if (e.kind == sim::EventKind::kTraced) {
            traces = true;
            offsets.push_back(e.value2);
            const auto bin = static_cast<size_t>(std::max(0.0F, e.value));
            if (bin < traced.size() && e.value2 <= kTracedWithinM) traced[bin] = true;
        }
    }
    if (steps == 0) return;
    aims = misses > 0 || !errors.empty();
    out.push_back({"steps_done_percent", 100.0 * done / steps});
    if (aims) out.push_back({"target_misses", static_cast<double>(misses)});
    if (!errors.empty()) {
        double mean = 0;
        for (const double e : errors) mean += e / static_cast<double>(errors.size());
        out.push_back({"target_error_mm", mean * 1e3});
    }
    if (traces) {
        std::sort(offsets.begin(), offsets.end());
        double mean = 0;
        for (const double o : offsets) mean += o / static_cast<double>(offsets.size());
        const auto covered = std::count(traced.begin(), traced.end(), true);
        out.push_back(
            {"trace_coverage_percent", 100.0 * static_cast<double>(covered) / sim::kTraceBins});
        out.push_back({"trace_error_mm", mean * 1e3});
        out.push_back({"trace_error_p95_mm", quantile(offsets, 0.95) * 1e3});
    }
    if (pulls) out.push_back({"traction_held_s", held});
    if (loosest_n) out.push_back({"draw_pull_least_mn", 1e3 * *loosest_n});
}

}  // namespace placode::assessment
