// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/recorded_frames.h"

#include <chrono>
#include <stdexcept>

#include "curriculum/replay.h"
#include "curriculum/task.h"

namespace placode::bench {
namespace {

using Clock = std::chrono::steady_clock;

std::string name_of(const sim::PracticeGoal& goal, const std::vector<curriculum::TaskStep>& steps) {
    const auto at = static_cast<size_t>(goal.index);
    if (goal.count == 0) return "attempt";
    return at < steps.size() ? steps[at].text.en : "after the last step";
}

}  // namespace

std::vector<FrameParts> measure_recording(const sim::Recording& recording, int threads) {
    const curriculum::Task task =
        curriculum::load_task_text(recording.header.task_json, "recording");
    const std::vector<curriculum::TaskStep> steps =
        curriculum::steps_for(task, recording.header.device);
    curriculum::Replay replay(recording, threads);
    std::vector<FrameParts> all;
    while (true) {
        const std::string name = name_of(replay.practice(), steps);
        const auto start = Clock::now();
        if (!replay.step()) break;
        const std::chrono::duration<double, std::micro> spent = Clock::now() - start;
        if (all.empty() || all.back().case_name != name) {
            all.emplace_back();
            all.back().case_name = name;
            all.back().threads = threads;
            all.back().substeps = replay.state().substeps;
        }
        add_frame(all.back(), replay.report(), replay.state(), 0, spent.count());
    }
    if (!replay.result().identical) throw std::runtime_error(replay.result().message);
    for (FrameParts& costs : all) close_frames(costs);
    return all;
}

}  // namespace placode::bench
