// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/practice.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "assessment/statistics.h"

namespace placode::assessment {

using sim::PracticeKind;

sim::Vec2 practice_target(const sim::PracticeStep& step, const sim::FieldGeometry& geometry,
                          bool second) {
    if (step.placed) return step.place_m[second ? 1 : 0];
    const auto& line = geometry.planned_contour;
    // +x is up and +y is left in the picture, so the clock runs from +x towards -y.
    const double angle = -2 * std::numbers::pi * (second ? step.hour_left : step.hour) / 12;
    const sim::Vec2 offset(std::cos(angle), std::sin(angle));
    if (line.empty()) return 0.008 * offset;
    sim::Vec2 centre = sim::Vec2::Zero(), best = line[0].head<2>();
    for (const sim::Vec3& p : line) centre += p.head<2>() / static_cast<double>(line.size());
    double along = -2;
    for (const sim::Vec3& p : line) {
        const double here = (p.head<2>() - centre).normalized().dot(offset);
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

void PracticeTracker::begin_at(int step) noexcept {
    first_ = index_ = std::clamp(step, 0, count());
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
        emit(sim::EventKind::kPracticeSteps, count() - first_, 0, -1, sim::Vec3::Zero());
        started_ = true;
        began_s_ = now_s_;
    }
    // A single bite says all of itself with its distances from the marks.
    if (bites_ > 1 && step().kind == PracticeKind::kNeedleIn && marked_ != index_ && !done())
        tell_marks(sight.needle);
    if (!done() && sight.needle.handled) watch_handling(sight);
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

namespace {

/// How far from the line each stretch of it was followed [m]; nothing where it was not.
///
/// Of a stretch counts its worst pass. A pass ends wherever the tip crosses into the next stretch,
/// so a wobble across one border makes any number of them: neither a mean over passes nor one over
/// the passes of a stretch would keep a fault, and the best one would let a good second lap wipe
/// out a bad first. Whoever goes back to mend a stretch loses nothing by it: that it was followed
/// at all, which earns the points, is said by its best pass.
std::vector<double> worst_passes(const sim::Recording& recording) {
    std::array<std::optional<double>, sim::kTraceBins> worst{};
    for (const sim::Event& e : recording.events) {
        if (e.kind != sim::EventKind::kTraced) continue;
        // What says another stretch than there are is a fault of the last one, and not forgotten.
        const double bin = std::clamp(static_cast<double>(e.value), 0.0, sim::kTraceBins - 1.0);
        auto& here = worst[std::isfinite(bin) ? static_cast<size_t>(bin) : 0];
        here = std::max(here.value_or(0), static_cast<double>(e.value2));
    }
    std::vector<double> passes;
    for (const auto& each : worst)
        if (each) passes.push_back(*each);
    return passes;
}

}  // namespace

std::vector<const sim::Event*> first_touches(const sim::Recording& recording) {
    std::map<float, const sim::Event*> first;
    for (const sim::Event& e : recording.events)
        if (e.kind == sim::EventKind::kTargetTouched) first.emplace(e.value, &e);
    std::vector<const sim::Event*> touches;
    touches.reserve(first.size());
    for (const auto& [step, event] : first) touches.push_back(event);
    return touches;
}

void add_practice_metrics(const sim::Recording& recording, std::vector<Metric>& out) {
    int steps = 0, done = 0, misses = 0;
    bool aims = false, traces = false, pulls = false;
    std::vector<double> errors;
    std::array<bool, sim::kTraceBins> traced{};
    double held = 0;
    std::optional<double> loosest_n;
    for (const sim::Event& e : recording.events) {
        if (e.kind == sim::EventKind::kPracticeSteps) steps = static_cast<int>(e.value);
        if (e.kind == sim::EventKind::kStepDone) ++done;
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
            const auto bin = static_cast<size_t>(std::max(0.0F, e.value));
            if (bin < traced.size() && e.value2 <= kTracedWithinM) traced[bin] = true;
        }
    }
    if (steps == 0) return;
    for (const sim::Event* touch : first_touches(recording)) errors.push_back(touch->value2);
    aims = misses > 0 || !errors.empty();
    out.push_back({"steps_done_percent", 100.0 * done / steps});
    if (aims) out.push_back({"target_misses", static_cast<double>(misses)});
    if (!errors.empty()) out.push_back({"target_error_mm", *mean_of(errors) * 1e3});
    if (traces) {
        std::vector<double> offsets = worst_passes(recording);
        std::sort(offsets.begin(), offsets.end());
        const auto covered = std::count(traced.begin(), traced.end(), true);
        out.push_back(
            {"trace_coverage_percent", 100.0 * static_cast<double>(covered) / sim::kTraceBins});
        out.push_back({"trace_error_mm", *mean_of(offsets) * 1e3});
        out.push_back({"trace_error_p95_mm", quantile(offsets, 0.95) * 1e3});
    }
    if (pulls) out.push_back({"traction_held_s", held});
    if (loosest_n) out.push_back({"draw_pull_least_mn", 1e3 * *loosest_n});
}

}  // namespace placode::assessment
