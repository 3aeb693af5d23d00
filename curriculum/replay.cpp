// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Proof that a recording is complete: its inputs alone give every state hash again.

#include <algorithm>
#include <array>
#include <charconv>

#include "curriculum/attempt_runner.h"
#include "sim/step/retune.h"

namespace placode::curriculum {

namespace {

std::string seconds(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 3);
    return {text, end.ptr};
}

std::string hex(uint64_t value) {
    char text[17];
    const auto end = std::to_chars(text, text + sizeof text, value, 16);
    const std::string digits(text, end.ptr);
    return std::string(16 - digits.size(), '0') + digits;
}

/// Walks through the recorded hashes beside the simulation.
class HashTrail {
 public:
    explicit HashTrail(const sim::Recording& recording) {
        for (const sim::Event& event : recording.events) {
            if (event.kind == sim::EventKind::kStateHash) hashes_.push_back(event);
        }
    }
    /// Compares what is due at `time_s`. False at a difference.
    bool compare(const sim::State& state, double frame_s, ReplayResult& result) {
        for (; next_ < hashes_.size(); ++next_) {
            const sim::Event& recorded = hashes_[next_];
            if (recorded.time_s > state.time_s + frame_s / 2) return true;
            const uint64_t hash = sim::state_hash(state);
            ++compared_;
            if (hash == recorded.hash) continue;
            result.first_difference_s = recorded.time_s;
            result.message = "replay: differs from " + seconds(recorded.time_s) +
                             " s on: state hash " + hex(hash) + ", recorded " + hex(recorded.hash);
            return false;
        }
        return true;
    }
    [[nodiscard]] size_t compared() const { return compared_; }
    [[nodiscard]] bool complete() const { return next_ == hashes_.size(); }

 private:
    std::vector<sim::Event> hashes_;
    size_t next_ = 0, compared_ = 0;
};

void conclude(const sim::Recording& recording, const sim::State& state, const HashTrail& trail,
              ReplayResult& result) {
    const bool ended = recording.end.reason != sim::EndReason::kRunning &&
                       recording.end.reason != sim::EndReason::kInterrupted;
    const uint64_t hash = sim::state_hash(state);
    if (ended && hash != recording.end.final_hash) {
        result.first_difference_s = state.time_s;
        result.message = "replay: differs at the end: state hash " + hex(hash) + ", recorded " +
                         hex(recording.end.final_hash);
    } else if (!trail.complete()) {
        result.first_difference_s = state.time_s;
        result.message = "replay: the inputs end at " + seconds(state.time_s) +
                         " s, before the last recorded state hash";
    } else if (trail.compared() == 0 && !ended) {
        result.message = "replay: nothing to compare, the recording holds no state hash";
    } else {
        result.identical = true;
        result.message = "replay: identical";
    }
}

/// A hand with force holds its tools as its device does, not as the task says.
void restore_grips(const sim::RecordingHeader& header, Task& task) {
    std::vector<sim::ToolSpec>& tools = task.scene.tools;
    for (size_t i = 0; i < std::min(tools.size(), header.tools.size()); ++i)
        tools[i].grip_n_m = header.tools[i].grip_n_m;
}

}  // namespace

ReplayResult replay(const sim::Recording& recording, int threads,
                    const std::function<void(const sim::Scene&, const sim::State&)>& on_frame) {
    Task task = load_task_text(recording.header.task_json, "recording");
    task.scene.seed = recording.header.seed;
    restore_grips(recording.header, task);
    const std::shared_ptr<const sim::Scene> scene = sim::build_operative_field(task.scene);
    // This scene is ours alone: tunings of the attempt are done again.
    const auto tunable = std::const_pointer_cast<sim::Scene>(scene);
    std::vector<sim::Event> tunings;
    for (const sim::Event& event : recording.events)
        if (event.kind == sim::EventKind::kTuned) tunings.push_back(event);
    size_t tuning = 0;
    sim::State state(*scene, threads);
    sim::settle(*scene, state, task.settle_s);

    ReplayResult result;
    HashTrail trail(recording);
    const size_t tools = scene->tools.size();
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
    for (const sim::Input& input : recording.inputs) {
        if (input.frame != state.frame || input.tool_count != static_cast<int32_t>(tools)) {
            result.first_difference_s = state.time_s;
            result.message = "replay: the input of frame " + std::to_string(state.frame) +
                             " is missing (found frame " + std::to_string(input.frame) + " with " +
                             std::to_string(input.tool_count) + " tools)";
            return result;
        }
        for (;
             tuning < tunings.size() && tunings[tuning].hash <= static_cast<uint64_t>(state.frame);
             ++tuning)
            static_cast<void>(sim::retune(*tunable, state, tunings[tuning]));
        state.substeps = input.substeps;
        (void)sim::step(*scene, state, {input.tools, tools}, {feedback.data(), tools});
        ++result.frames;
        if (!trail.compare(state, task.scene.solver.frame_s, result)) return result;
        if (on_frame) on_frame(*scene, state);
    }
    conclude(recording, state, trail, result);
    return result;
}

}  // namespace placode::curriculum
