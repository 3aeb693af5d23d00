// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/frame_parts.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include "curriculum/attempt_recorder.h"
#include "db/recording_file.h"
#include "haptics/trocar.h"
#include "sim/step/step.h"

namespace placode::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr WorkCase kCases[] = {{"hands off", Work::kAway},
                               {"needle presses", Work::kPress},
                               {"needle drags", Work::kDrag},
                               {"needle cuts", Work::kCut}};

/// The first instrument of every port but the scope's works at the planned contour, its shaft
/// through its trocar.
void move_hands(const sim::Scene& scene, const std::vector<sim::Vec3>& contour, Work work,
                int frame, std::vector<sim::ToolInput>& inputs) {
    for (size_t i = 0; i < inputs.size(); ++i) {
        const sim::ToolSpec& tool = scene.tools[i];
        const bool scope = tool.kind == sim::ToolKind::kScope;
        // 3 mm/s along the contour where the hand moves.
        const bool moves = work == Work::kDrag || work == Work::kCut;
        double path = moves ? 3e-6 * frame : 0;
        size_t n = 0;
        sim::Vec3 target = contour.front();
        for (; n + 1 < contour.size(); ++n) {
            const double length = (contour[n + 1] - contour[n]).norm();
            if (path < length) {
                target = contour[n] + path / length * (contour[n + 1] - contour[n]);
                break;
            }
            path -= length;
        }
        const double down = std::min(0.0003, 2e-5 * frame - 0.0005);
        target.z() -= work == Work::kAway ? -0.010 : down;
        if (scope) target = sim::Vec3(0, 0, 0.030);
        const sim::Vec3 along = (target - tool.pivot_m).normalized();
        inputs[i].set_pose({target, sim::Quat::FromTwoVectors(sim::Vec3::UnitZ(), along)});
        const uint32_t before = (1U << i) - 1;
        inputs[i].engaged = (haptics::others_in_port(scene.tools, i) & before) != 0 ? 0 : 1;
        inputs[i].pedals = work == Work::kCut && !scope ? sim::kPedalCut : 0;
    }
}

}  // namespace

std::span<const WorkCase> work_cases() noexcept { return kCases; }

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<size_t>(std::ceil(share * last))];
}

double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double v : values) total += v;
    return total;
}

double other_share(const FrameParts& costs) {
    const double all = sum(costs.us[kParts]);
    return all > 0 ? 1 - sum(costs.us[0]) / all : 0;
}

double other_of_frame(const FrameParts& costs, double frame_s) {
    return 1e-6 * (sum(costs.us[kParts]) - sum(costs.us[0])) / (costs.frames * frame_s);
}

void add_frame(FrameParts& costs, const sim::StepReport& report, const sim::State& state,
               double recording_us, double frame_us) {
    ++costs.frames;
    costs.contacts += report.contacts;
    costs.awake += state.sleep.enabled()
                       ? 1 - static_cast<double>(state.sleep.asleep_count) / state.sleep.blocks()
                       : 1;
    for (size_t p = 0; p + 1 < kParts; ++p)
        costs.us[p].push_back(1e-3 * static_cast<double>(report.cost_ns[p]));
    costs.us[kParts - 1].push_back(recording_us);
    costs.us[kParts].push_back(frame_us);
}

void close_frames(FrameParts& costs) {
    costs.contacts /= costs.frames;
    costs.awake /= costs.frames;
}

FrameParts measure_hands(const sim::Scene& scene, sim::State& state, const std::string& name,
                         const FrameRange& range, const Hands& hands) {
    FrameParts costs;
    costs.case_name = name;
    costs.threads = state.workers->threads();
    costs.substeps = state.substeps;
    std::vector<sim::ToolInput> inputs(scene.tools.size());
    std::vector<sim::ToolFeedback> feedback(inputs.size());
    const auto path =
        std::filesystem::temp_directory_path() /
        ("placode-bench-" + std::to_string(Clock::now().time_since_epoch().count()) + ".placode");
    sim::RecordingHeader header;
    header.task_id = "bench";
    header.tools = scene.tools;
    header.geometry = scene.geometry;
    curriculum::AttemptRecorder recorder(db::create_recording_file(path.string()), header);
    recorder.start();
    int64_t dropped = 0;
    for (int frame = range.first; frame < range.end; ++frame) {
        hands(frame, inputs);
        const auto start = Clock::now();
        const sim::StepReport report = sim::step(scene, state, inputs, feedback);
        const auto stepped = Clock::now();
        sim::Input input;
        input.frame = state.frame;
        input.substeps = state.substeps;
        input.tool_count = static_cast<int32_t>(inputs.size());
        std::copy(inputs.begin(), inputs.end(), input.tools);
        dropped += !recorder.put(input);
        for (int e = 0; e < state.event_count; ++e) {
            dropped += !recorder.put(state.events[static_cast<size_t>(e)]);
        }
        const auto end = Clock::now();
        if (frame < range.counted) continue;
        const auto us = [](auto d) { return std::chrono::duration<double, std::micro>(d).count(); };
        add_frame(costs, report, state, us(end - stepped), us(end - start));
    }
    recorder.finish({sim::EndReason::kFinished, state.time_s, 0, dropped});
    std::error_code ignored;
    for (const char* tail : {"", "-wal", "-shm"}) {
        std::filesystem::remove(path.string() + tail, ignored);
    }
    close_frames(costs);
    return costs;
}

FrameParts measure_frames(const sim::Scene& scene, const WorkCase& what, int threads, int frames) {
    sim::State state(scene, threads);
    sim::settle(scene, state, 0.3);
    std::vector<sim::Vec3> contour(scene.contour_anchors.size());
    sim::deformed_contour(scene, state, contour);
    constexpr int kWarmUp = 100;
    return measure_hands(scene, state, what.name, {0, kWarmUp, frames + kWarmUp},
                         [&](int frame, std::vector<sim::ToolInput>& inputs) {
                             move_hands(scene, contour, what.work, frame, inputs);
                         });
}

}  // namespace placode::bench
