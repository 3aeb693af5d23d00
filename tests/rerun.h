// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A whole attempt of a scripted operator, to be simulated again frame by frame.

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "sim/anatomy/operative_field.h"
#include "sim/step/step.h"
#include "tests/attempt_fixture.h"

namespace placode::test {

/// A recorded attempt to be simulated again, frame by frame.
class Rerun {
 public:
    /// @param end_s  The attempt ends then [simulated s]; 0 = as the task says.
    explicit Rerun(const std::string& id, double end_s = 0) {
        curriculum::Task task = curriculum::load_task(id);
        if (end_s > 0) task.time_limit_s = end_s;
        recording_ = scripted_attempt(task, "expert");
        task.scene.seed = recording_.header.seed;
        settle_s_ = task.settle_s;
        scene = sim::build_operative_field(task.scene);
    }
    [[nodiscard]] std::unique_ptr<sim::State> start() const {
        auto state = std::make_unique<sim::State>(*scene, 1);
        sim::settle(*scene, *state, settle_s_);
        return state;
    }
    [[nodiscard]] int64_t frames() const { return std::ssize(recording_.inputs); }
    void step(sim::State& state) const {
        const sim::Input& input = recording_.inputs.at(static_cast<size_t>(state.frame));
        state.substeps = input.substeps;
        std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
        const size_t tools = scene->tools.size();
        (void)sim::step(*scene, state, {input.tools, tools}, {feedback.data(), tools});
    }
    void step_to(sim::State& state, int64_t frame) const {
        while (state.frame < std::min(frame, frames())) step(state);
    }
    std::shared_ptr<const sim::Scene> scene;

 private:
    sim::Recording recording_;
    double settle_s_ = 0;
};

}  // namespace placode::test
