// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/soundness.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "sim/core/number_text.h"

namespace placode::assessment {
namespace {

using sim::Recording;
using sim::Said;
using Problem = std::optional<Said>;

constexpr double kLargestM = 10;        ///< No point of a field or hand lies farther off [m].
constexpr float kLargestForceN = 1e6F;  ///< Far beyond what any solver step gives [N].

std::string number(double value) { return sim::rounded_text(value, 6); }

template <class List>
int64_t count(const List& list) {
    return static_cast<int64_t>(list.size());
}

bool within(double value, double low, double high) { return value >= low && value <= high; }

template <class List>
bool all_within(const List& list, double limit) {
    return std::all_of(std::begin(list), std::end(list),
                       [&](double x) { return std::isfinite(x) && std::abs(x) <= limit; });
}

bool whole_time(const Recording& r) {
    return r.end.reason != sim::EndReason::kInterrupted && r.end.reason != sim::EndReason::kRunning;
}

Problem head_problem(const Recording& r) {
    const sim::RecordingHeader& head = r.header;
    if (!within(head.frame_s, 1e-5, 0.1))
        return Said::that("frame_s is %1, expected 0.00001 to 0.1").with(number(head.frame_s));
    if (!within(head.sample_s, 1e-3, 1))
        return Said::that("sample_s is %1, expected 0.001 to 1").with(number(head.sample_s));
    if (head.tools.empty() || head.tools.size() > sim::kMaxTools)
        return Said::that("it has %1 tools, expected 1 to %2")
            .with(count(head.tools))
            .with(sim::kMaxTools);
    if (!within(r.end.duration_s, 0, kLongestRecordingS))
        return Said::that("duration_s is %1, expected 0 to %2")
            .with(number(r.end.duration_s))
            .with(number(kLongestRecordingS));
    const auto frames = static_cast<double>(r.inputs.size());
    // One lost event may be the harm. The rings hold 16 s (curriculum/attempt_recorder.cpp): a disk
    // that is slow loses nothing, and a fast run waits for it.
    if (r.end.dropped != 0)
        return Said::that("%1 entries are lost, of %2 inputs")
            .with(r.end.dropped)
            .with(count(r.inputs));
    // Times are sums of frames: what rounding gives grows with their number.
    const double recorded_s = frames * head.frame_s;
    if (whole_time(r) && std::abs(recorded_s - r.end.duration_s) > head.frame_s + 1e-6 * frames)
        return Said::that("its inputs last %1 s, its end says %2 s")
            .with(number(recorded_s))
            .with(number(r.end.duration_s));
    return {};
}

Problem line_problem(const std::vector<sim::Vec3>& line, const char* name) {
    if (line.size() < 3)
        return Said::that("%1 has %2 points, expected 3 or more").with(name).with(count(line));
    for (const sim::Vec3& point : line)
        if (!all_within(std::array{point[0], point[1], point[2]}, kLargestM))
            return Said::that("%1 has a point that lies nowhere").with(name);
    return {};
}

Problem field_problem(const sim::FieldGeometry& field) {
    for (const auto& [line, name] : {std::pair{&field.planned_contour, "planned_contour_m"},
                                     std::pair{&field.placode_edge, "placode_edge_m"},
                                     {&field.skin_edge, "skin_edge_m"}})
        if (Problem problem = line_problem(*line, name)) return problem;
    if (!within(field.target_depth_m, 0, kLargestM))
        return Said::that("target_depth_m is %1").with(number(field.target_depth_m));
    if (!within(field.placode_volume_m3, 1e-15, 1))
        return Said::that("placode_volume_m3 is %1").with(number(field.placode_volume_m3));
    return {};
}

bool hand_is_somewhere(const sim::ToolInput& tool) {
    return all_within(tool.position_m, kLargestM) && all_within(tool.orientation, 2) &&
           all_within(std::array{tool.jaw_rad}, 10);
}

Problem input_problem(const Recording& r, const std::vector<sim::Input>& inputs) {
    const auto tools = static_cast<int32_t>(r.header.tools.size());
    int64_t before = -1;
    for (const sim::Input& input : inputs) {
        if (input.frame != before + 1)
            return Said::that("the input of frame %1 follows that of frame %2")
                .with(input.frame)
                .with(before);
        before = input.frame;
        if (input.tool_count != tools)
            return Said::that("the input of frame %1 is of %2 tools, expected %3")
                .with(input.frame)
                .with(input.tool_count)
                .with(tools);
        if (input.substeps < 1 || input.substeps > 1000)
            return Said::that("the input of frame %1 has %2 substeps")
                .with(input.frame)
                .with(input.substeps);
        const std::span hands(input.tools, r.header.tools.size());
        if (!std::all_of(hands.begin(), hands.end(), hand_is_somewhere))
            return Said::that("the input of frame %1 has a hand that lies nowhere")
                .with(input.frame);
    }
    return {};
}

/// What was given is told in the head, whole, and made of hands like all others.
Problem given_problem(const Recording& r) {
    const sim::RecordingHeader& head = r.header;
    if (head.stage < 0 || head.stage > sim::kMostStages)
        return Said::that("stage is %1, expected 0 to %2").with(head.stage).with(sim::kMostStages);
    const bool told = head.stage > 0;
    if (told != !r.given.empty() || count(r.given) != head.given_frames)
        return Said::that("%1 inputs were given, its head says %2")
            .with(count(r.given))
            .with(head.given_frames);
    if (static_cast<double>(r.given.size()) * head.frame_s > kLongestRecordingS)
        return Said::that("%1 inputs were given, more than %2 s")
            .with(count(r.given))
            .with(number(kLongestRecordingS));
    return input_problem(r, r.given);
}

Problem sample_values(const sim::Sample& sample, size_t tools) {
    for (const sim::ToolSample& tool : std::span(sample.tools, tools)) {
        if (!all_within(tool.tip_m, kLargestM))
            return Said::that("sample %1 has a tip that lies nowhere");
        if (!all_within(tool.orientation, 2))
            return Said::that("sample %1 has a tool that points nowhere");
        if (!all_within(tool.force_n, kLargestForceN))
            return Said::that("sample %1 has a force that is no number");
        if (!all_within(std::array{tool.jaw_rad, tool.power_w}, 1e6))
            return Said::that("sample %1 has a jaw or a power that is no number");
        if (!std::isfinite(tool.tip_gap_m))
            return Said::that("sample %1 has a distance that is no number");
    }
    if (!within(sample.placode_peak_c, -50, 5000) || !(sample.placode_peak_cem43_min >= 0) ||
        !(sample.placode_burned_m3 >= 0) || !std::isfinite(sample.placode_burned_m3))
        return Said::that("sample %1 has a temperature, dose or volume that cannot be");
    if (!within(sample.cut_fraction, 0, 1 + 1e-6))
        return Said::that("sample %1 has a share that was cut beyond 0 to 1");
    return {};
}

Problem sample_problem(const Recording& r) {
    double before_s = 0;
    int64_t at = 0;
    for (const sim::Sample& sample : r.samples) {
        if (!std::isfinite(sample.time_s) || !(sample.time_s > before_s))
            return Said::that("sample %1 is at %2 s, the one before it at %3 s")
                .with(at)
                .with(number(sample.time_s))
                .with(number(before_s));
        before_s = sample.time_s;
        if (const Problem bad = sample_values(sample, r.header.tools.size())) return bad->with(at);
        ++at;
    }
    const double step_s = r.header.sample_s, end_s = r.end.duration_s;
    if (before_s > end_s + step_s)
        return Said::that("its samples go on to %1 s, its end says %2 s")
            .with(number(before_s))
            .with(number(end_s));
    const auto expected = static_cast<int64_t>(std::floor(end_s / step_s));
    const auto found = static_cast<int64_t>(r.samples.size());
    if (whole_time(r) && (found < expected - 1 || found > expected + 1))
        return Said::that("%1 samples for %2 s, expected %3")
            .with(found)
            .with(number(end_s))
            .with(expected);
    return {};
}

/// Seconds, forces, areas, volumes, gaps: nothing that harms can be less than none of it.
bool is_an_amount(sim::EventKind kind) {
    using enum sim::EventKind;
    switch (kind) {
        case kEnergyOff:
        case kEnergyInAir:
        case kDwell:
        case kVaporised:
        case kTorn:
        case kPlacodeContact:
        case kPlacodeEnergised:
        case kPlacodeOverheated:
        case kPlacodeBurned:
        case kOverForce:
        case kOverStretch:
        case kTetherBroken:
        case kGrasped:
        case kReleased:
        case kSlipped:
        case kCrushed:
        case kOverTraction:
        case kSnipped:
        case kPlacodeCut:
        case kPieceFree:
        case kPieceOut:
        case kCrumb:
        case kBuried:
        case kPaused:
        case kMachineSpeed:
        case kSlowSpell:
        case kNoRoomToCut:
        case kTractionHeld:
        case kThreadDrawn:
        case kStretchSum:
        case kTakenOut:
        case kMarkedLost:
        case kRingGap:
        case kSlitGap:
        case kWatertight:
        case kPatchEdge:
        case kPatchFold:
        case kSlitPressed:
        case kSlitOpened:
        case kThreadCut:
        case kThreadToreOut:
        case kNeedleGrip:
        case kNeedleHandedOver:
        case kNeedleSwung:
        case kNeedlePlaced:
        case kBiteEntry:
        case kBiteExit:
        case kIrrigated:
        case kUndermined:
            return true;
        default:
            return false;
    }
}

/// Its second value is a depth below the surface at rest, of a place that may lie above it; or the
/// side of a line from a slit.
bool has_a_sign(const sim::Event& event) {
    return event.kind == sim::EventKind::kVaporised || event.kind == sim::EventKind::kSnipped ||
           (event.kind == sim::EventKind::kUndermined && event.element >= 0);
}

/// A list after the last frame says in its head how long it is; who takes out what is bad says so.
Problem list_problem(const Recording& r, sim::EventKind kind) {
    int64_t heads = 0, entries = 0;
    double told = 0;
    for (const sim::Event& event : r.events) {
        if (event.kind != kind) continue;
        if (event.element >= 0) {
            ++entries;
        } else {
            ++heads;
            told = static_cast<double>(event.value);
        }
    }
    if (heads + entries == 0 || (heads == 1 && static_cast<double>(entries) == told)) return {};
    return Said::that("it has %1 entries of \"%2\", and %3 are told")
        .with(entries)
        .with(std::string(event_name(kind)))
        .with(heads == 1 ? number(told) : std::string("-"));
}

Problem event_problem(const Recording& r) {
    const sim::Event* last_hash = nullptr;
    for (size_t i = 0; i < r.events.size(); ++i) {
        const sim::Event& event = r.events[i];
        const auto at = static_cast<int64_t>(i);
        if (!within(event.time_s, 0, r.end.duration_s + 1))
            return Said::that("event %1 is at %2 s of %3 s")
                .with(at)
                .with(number(event.time_s))
                .with(number(r.end.duration_s));
        if (!std::isfinite(event.value) || !std::isfinite(event.value2) ||
            !all_within(event.rest_position_m, kLargestM))
            return Said::that("event %1 has a value that is no number").with(at);
        const float least = has_a_sign(event) ? event.value : std::min(event.value, event.value2);
        if (is_an_amount(event.kind) && least < 0)
            return Said::that("event %1 (%2) has the value %3, expected 0 or more")
                .with(at)
                .with(std::string(event_name(event.kind)))
                .with(number(least));
        if (event.kind == sim::EventKind::kStateHash) last_hash = &event;
    }
    for (const auto kind :
         {sim::EventKind::kThermalSpread, sim::EventKind::kRingGap, sim::EventKind::kSlitGap,
          sim::EventKind::kSlitOpened, sim::EventKind::kPatchEdge})
        if (Problem problem = list_problem(r, kind)) return problem;
    // The attempt's last event is the hash that the end repeats.
    if (whole_time(r) && last_hash != nullptr && last_hash->hash != r.end.final_hash)
        return Said::that("final_hash is not the hash of its last state");
    return {};
}

}  // namespace

std::optional<Said> unsound(const Recording& recording) {
    for (const auto& problem :
         {head_problem, +[](const Recording& r) { return field_problem(r.header.geometry); },
          given_problem, +[](const Recording& r) { return input_problem(r, r.inputs); },
          sample_problem, event_problem})
        if (Problem found = problem(recording)) return found;
    return {};
}

}  // namespace placode::assessment
