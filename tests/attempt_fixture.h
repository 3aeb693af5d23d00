// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What tests of whole attempts share.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "curriculum/attempt_runner.h"
#include "curriculum/task.h"
#include "sim/step/recording.h"
#include "sim/step/step.h"

namespace placode::test {

/// Keeps what it gets. One writer (the recorder thread), read after wait().
class MemorySink final : public sim::RecordingSink {
 public:
    explicit MemorySink(std::shared_ptr<sim::Recording> to) : to_(std::move(to)) {}
    void begin(const sim::RecordingHeader& header) override { to_->header = header; }
    void give(std::span<const sim::Input> given) override {
        to_->given.assign(given.begin(), given.end());
    }
    void append(std::span<const sim::Input> inputs, std::span<const sim::Sample> samples,
                std::span<const sim::Event> events) override {
        to_->inputs.insert(to_->inputs.end(), inputs.begin(), inputs.end());
        to_->samples.insert(to_->samples.end(), samples.begin(), samples.end());
        to_->events.insert(to_->events.end(), events.begin(), events.end());
    }
    void finish(const sim::RecordingEnd& end) override { to_->end = end; }

 private:
    std::shared_ptr<sim::Recording> to_;
};

/// One frame with recorded hands.
inline void step_with(const sim::Scene& scene, sim::State& state, const sim::Input& input) {
    state.substeps = input.substeps;
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
    const size_t tools = scene.tools.size();
    (void)sim::step(scene, state, {input.tools, tools}, {feedback.data(), tools});
}

/// The task with other numbers in its scene: {"edge_ring_m", "0.0012"}, ...
inline curriculum::Task changed_task(
    const std::string& id, std::initializer_list<std::pair<const char*, const char*>> numbers) {
    std::string json = curriculum::load_task(id).json;
    for (const auto& [key, value] : numbers) {
        std::string name = key;  // in steps: g++ 12 warns wrongly (-Wrestrict) about the sum
        name.insert(0, 1, '"').append("\":");
        const size_t found = json.find(name);
        EXPECT_NE(found, std::string::npos) << key;
        const size_t at = found + name.size();
        json.replace(at, json.find_first_of(",}", at) - at, value);
    }
    return curriculum::load_task_text(json, id);
}

/// A task on some hundred large tets that hardly settle: for what no mesh decides.
inline curriculum::Task tiny_task(const std::string& id) {
    return changed_task(id, {{"edge_ring_m", "0.0012"},
                             {"edge_placode_m", "0.0016"},
                             {"edge_outer_m", "0.003"},
                             {"settle_s", "0.02"}});
}

/// The running suture on a field that a test can afford.
inline curriculum::Task coarse_suture_run() {
    return changed_task(
        "suture_run",
        {{"edge_ring_m", "0.0009"}, {"edge_placode_m", "0.0009"}, {"edge_outer_m", "0.0012"}});
}

/// A scripted operator ("expert", ...), headless, as fast as one thread can.
inline curriculum::AttemptOptions scripted(const std::string& level) {
    curriculum::AttemptOptions options;
    options.device = "script:" + level;
    options.fast = true;
    options.threads = 1;
    return options;
}

inline sim::Recording recorded(const curriculum::Task& task, uint64_t seed,
                               const curriculum::AttemptOptions& options) {
    const auto recording = std::make_shared<sim::Recording>();
    curriculum::AttemptRunner runner(task, seed, options, std::make_unique<MemorySink>(recording));
    runner.start();
    runner.wait();
    return std::move(*recording);
}

/// One whole attempt.
inline sim::Recording scripted_attempt(const curriculum::Task& task, const std::string& level) {
    return recorded(task, 1, scripted(level));
}

/// The first seconds of one, with the task's steps; 0 = all of it.
inline sim::Recording scripted_seconds(const curriculum::Task& task, double seconds,
                                       const std::string& level = "expert", uint64_t seed = 3) {
    curriculum::AttemptOptions options = scripted(level);
    options.duration_s = seconds;
    options.steps = task.steps;
    return recorded(task, seed, options);
}
inline sim::Recording scripted_seconds(const std::string& task, double seconds,
                                       const std::string& level = "expert", uint64_t seed = 3) {
    return scripted_seconds(curriculum::load_task(task), seconds, level, seed);
}

}  // namespace placode::test
