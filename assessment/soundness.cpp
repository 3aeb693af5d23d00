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

constexpr double kLargestM = 10;           ///< No point of a field or hand lies farther off [m].
constexpr float kLargestForceN = 1e6F;     ///< Far beyond what any solver step gives [N].
constexpr double kMostDroppedShare = 0.5;  ///< With more lost, nothing is left to judge.

std::string number(double value) { return sim::rounded_text(value, 6); }

bool within(double value, double low, double high) { return value >= low && value <= high; }

template <class List>
bool all_within(const List& list, double limit) {
    return std::all_of(std::begin(list), std::end(list),
                       [&](double x) { return std::isfinite(x) && std::abs(x) <= limit; });
}

bool whole_time(const Recording& r) {
    return r.end.reason != sim::EndReason::kInterrupted &&
           r.end.reason != sim::EndReason::kRunning && r.end.dropped == 0;
}

std::string head_problem(const Recording& r) {
    const sim::RecordingHeader& head = r.header;
    if (!within(head.frame_s, 1e-5, 0.1))
        return "frame_s is " + number(head.frame_s) + ", expected 0.00001 to 0.1";
    if (!within(head.sample_s, 1e-3, 1))
        return "sample_s is " + number(head.sample_s) + ", expected 0.001 to 1";
    if (head.tools.empty() || head.tools.size() > sim::kMaxTools)
        return "it has " + std::to_string(head.tools.size()) + " tools, expected 1 to " +
               std::to_string(sim::kMaxTools);
    if (!within(r.end.duration_s, 0, kLongestRecordingS))
        return "duration_s is " + number(r.end.duration_s) + ", expected 0 to " +
               number(kLongestRecordingS);
    const auto frames = static_cast<double>(r.inputs.size());
    if (r.end.dropped < 0 || static_cast<double>(r.end.dropped) > kMostDroppedShare * frames)
        return std::to_string(r.end.dropped) + " entries are lost, of " +
               std::to_string(r.inputs.size()) + " inputs";
    // Times are sums of frames: what rounding gives grows with their number.
    const double recorded_s = frames * head.frame_s;
    if (whole_time(r) && std::abs(recorded_s - r.end.duration_s) > head.frame_s + 1e-6 * frames)
        return "its inputs last " + number(recorded_s) + " s, its end says " +
               number(r.end.duration_s) + " s";
    return {};
}

std::string line_problem(const std::vector<sim::Vec3>& line, const char* name) {
    if (line.size() < 3)
        return std::string(name) + " has " + std::to_string(line.size()) +
               " points, expected 3 or more";
    for (const sim::Vec3& point : line)
        if (!all_within(std::array{point[0], point[1], point[2]}, kLargestM))
            return std::string(name) + " has a point that lies nowhere";
    return {};
}

std::string field_problem(const sim::FieldGeometry& field) {
    for (const auto& [line, name] : {std::pair{&field.planned_contour, "planned_contour_m"},
                                     std::pair{&field.placode_edge, "placode_edge_m"},
                                     {&field.skin_edge, "skin_edge_m"}})
        if (std::string problem = line_problem(*line, name); !problem.empty()) return problem;
    if (!within(field.target_depth_m, 0, kLargestM))
        return "target_depth_m is " + number(field.target_depth_m);
    if (!within(field.placode_volume_m3, 1e-15, 1))
        return "placode_volume_m3 is " + number(field.placode_volume_m3);
    return {};
}

bool hand_is_somewhere(const sim::ToolInput& tool) {
    return all_within(tool.position_m, kLargestM) && all_within(tool.orientation, 2) &&
           all_within(std::array{tool.jaw_rad}, 10);
}

std::string input_problem(const Recording& r) {
    const auto tools = static_cast<int32_t>(r.header.tools.size());
    int64_t before = -1;
    for (const sim::Input& input : r.inputs) {
        // An hour has millions of them: words are made for the one that is wrong.
        const auto wrong = [&](const std::string& what) {
            return "the input of frame " + std::to_string(input.frame) + " " + what;
        };
        if (input.frame <= before || (r.end.dropped == 0 && input.frame != before + 1))
            return wrong("follows that of frame " + std::to_string(before));
        before = input.frame;
        if (input.tool_count != tools)
            return wrong("is of " + std::to_string(input.tool_count) + " tools, expected " +
                         std::to_string(tools));
        if (input.substeps < 1 || input.substeps > 1000)
            return wrong("has " + std::to_string(input.substeps) + " substeps");
        const std::span hands(input.tools, r.header.tools.size());
        if (!std::all_of(hands.begin(), hands.end(), hand_is_somewhere))
            return wrong("has a hand that lies nowhere");
    }
    return {};
}

std::string sample_values(const sim::Sample& sample, size_t tools) {
    for (const sim::ToolSample& tool : std::span(sample.tools, tools)) {
        if (!all_within(tool.tip_m, kLargestM)) return "has a tip that lies nowhere";
        if (!all_within(tool.orientation, 2)) return "has a tool that points nowhere";
        if (!all_within(tool.force_n, kLargestForceN)) return "has a force that is no number";
        if (!all_within(std::array{tool.jaw_rad, tool.power_w}, 1e6))
            return "has a jaw or a power that is no number";
        if (!std::isfinite(tool.tip_gap_m)) return "has a distance that is no number";
    }
    if (!within(sample.placode_peak_c, -50, 5000) || !(sample.placode_peak_cem43_min >= 0) ||
        !(sample.placode_burned_m3 >= 0) || !std::isfinite(sample.placode_burned_m3))
        return "has a temperature, dose or volume that cannot be";
    if (!within(sample.cut_fraction, 0, 1 + 1e-6)) return "has a share that was cut beyond 0 to 1";
    return {};
}

std::string sample_problem(const Recording& r) {
    double before_s = 0;
    size_t at = 0;
    for (const sim::Sample& sample : r.samples) {
        const auto name = [&] { return "sample " + std::to_string(at); };
        if (!std::isfinite(sample.time_s) || !(sample.time_s > before_s))
            return name() + " is at " + number(sample.time_s) + " s, the one before it at " +
                   number(before_s) + " s";
        before_s = sample.time_s;
        if (const std::string bad = sample_values(sample, r.header.tools.size()); !bad.empty())
            return name() + " " + bad;
        ++at;
    }
    const double step_s = r.header.sample_s, end_s = r.end.duration_s;
    if (before_s > end_s + step_s)
        return "its samples go on to " + number(before_s) + " s, its end says " + number(end_s) +
               " s";
    const auto expected = static_cast<int64_t>(std::floor(end_s / step_s));
    const auto found = static_cast<int64_t>(r.samples.size());
    if (whole_time(r) && (found < expected - 1 || found > expected + 1))
        return std::to_string(found) + " samples for " + number(end_s) + " s, expected " +
               std::to_string(expected);
    return {};
}

std::string event_problem(const Recording& r) {
    const sim::Event* last_hash = nullptr;
    for (size_t i = 0; i < r.events.size(); ++i) {
        const sim::Event& event = r.events[i];
        const auto name = [&] { return "event " + std::to_string(i); };
        if (!within(event.time_s, 0, r.end.duration_s + 1))
            return name() + " is at " + number(event.time_s) + " s of " + number(r.end.duration_s) +
                   " s";
        if (!std::isfinite(event.value) || !std::isfinite(event.value2) ||
            !all_within(event.rest_position_m, kLargestM))
            return name() + " has a value that is no number";
        if (event.kind == sim::EventKind::kStateHash) last_hash = &event;
    }
    // The attempt's last event is the hash that the end repeats.
    if (whole_time(r) && last_hash != nullptr && last_hash->hash != r.end.final_hash)
        return "final_hash is not the hash of its last state";
    return {};
}

}  // namespace

std::string unsound(const Recording& recording) {
    for (const auto& problem :
         {head_problem, +[](const Recording& r) { return field_problem(r.header.geometry); },
          input_problem, sample_problem, event_problem})
        if (std::string found = problem(recording); !found.empty()) return found;
    return {};
}

}  // namespace placode::assessment
