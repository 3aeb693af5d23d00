// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/stage_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <span>
#include <string>

#include "curriculum/attempt_frames.h"
#include "curriculum/operator_sight.h"
#include "curriculum/stage_way_back.h"
#include "haptics/catalogue/open_device.h"
#include "haptics/servo.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/begin_here.h"
#include "sim/step/step.h"
#include "sim/world/saved_state.h"

namespace placode::curriculum {
namespace {

constexpr int64_t kToldEvery = 32;      // frames
constexpr double kWayBackShare = 0.04;  // of the bar, for what comes behind the last step
constexpr const char* kExpert = "script:expert";

/// The inputs alone. What an attempt writes beside them is the expert's, and nobody's here.
class GivenBook final : public AttemptBook {
 public:
    void write(const sim::Input& input) noexcept override {
        try {
            inputs.push_back(input);
        } catch (const std::bad_alloc&) {
            lost = true;
        }
    }
    void write(const sim::Sample&) noexcept override {}
    void write(const sim::Event&) noexcept override {}
    std::vector<sim::Input> inputs;
    bool lost = false;
};

std::unique_ptr<haptics::Servo> open_expert(const Task& task) {
    haptics::DeviceConfig config;
    config.name = kExpert;
    config.seed = kStageSeed;
    config.tools = task.scene.tools;
    config.frame_s = task.scene.solver.frame_s;
    config.practice = true;  // only steps have stages
    config.patch = lays_patch(task);
    return std::make_unique<haptics::Servo>(haptics::open_device(config), task.scene.tools,
                                            haptics::default_trocars(task.scene.tools, kExpert),
                                            haptics::CouplingSettings{});
}

/// The expert at work, one frame after another.
class ExpertAtWork {
 public:
    ExpertAtWork(const Task& task, int stage, int threads, const StageWatch& watch)
        : task_(task),
          before_step_(stage_of(task, stage).before_step),
          watch_(watch),
          scene_(sim::build_operative_field(task.scene)),
          state_(*scene_, std::max(1, threads)),
          servo_(open_expert(task)),
          sight_(*scene_),
          frames_(task, task.steps, *scene_, settled(), limit_of(task, 0)),
          frame_s_(task.scene.solver.frame_s) {}

    /// False: it was stopped.
    bool work() {
        while (frames_.goal().index < before_step_) {
            perceive();
            const auto t_ns = std::llround(static_cast<double>(state_.frame) * frame_s_ * 1e9);
            servo_->tick(t_ns, hands(), {feedback_.data(), tools()});
            if (!frame()) return false;
            if (frames_.ended(state_, hands(), servo_->finish_requested()) !=
                sim::EndReason::kRunning)
                break;
        }
        if (frames_.goal().index >= before_step_) return true;
        throw StageError("stage: the scripted expert came to step " +
                         std::to_string(frames_.goal().index + 1) + " of " +
                         std::to_string(frames_.goal().count) + " in " + task_.id +
                         " and no further; begin at the beginning");
    }

    /// Hands let go and go home; tissue comes to rest. False: it was stopped.
    bool go_back() {
        StageWayBack way(*scene_, state_, home_, inputs_);
        while (way.next(state_, hands(), frame_s_))
            if (!frame()) return false;
        return true;
    }

    [[nodiscard]] std::shared_ptr<const StageStart> result(int stage) {
        if (book_.lost) throw std::bad_alloc();
        auto start = std::make_shared<StageStart>();
        sim::begin_here(*scene_, state_);
        start->stage = stage;
        start->given = std::move(book_.inputs);
        start->state = sim::save_state(*scene_, state_);
        start->hash = sim::whole_hash(state_);
        return start;
    }

 private:
    [[nodiscard]] const sim::State& settled() {
        sim::settle(*scene_, state_, task_.settle_s);
        return state_;
    }
    [[nodiscard]] size_t tools() const { return scene_->tools.size(); }
    [[nodiscard]] std::span<sim::ToolInput> hands() { return {inputs_.data(), tools()}; }

    /// As in an attempt: what a person sees on the screen, as often as it is refreshed.
    void perceive() {
        const auto frames_per_look = std::max<int64_t>(1, std::llround(0.016 / frame_s_));
        if (state_.frame % frames_per_look == 0) sight_.look(state_);
        haptics::Perception seen = sight_.seen(state_);
        seen.tools = {feedback_.data(), tools()};
        seen.cut_fraction = static_cast<float>(frames_.cut_fraction());
        seen.practice = frames_.goal();
        servo_->devices().perceive(seen);
    }

    bool frame() {
        if (state_.frame == 0) home_ = inputs_;
        const sim::StepReport report =
            frames_.simulate(state_, hands(), {feedback_.data(), tools()}, book_);
        frames_.look(state_, report, hands(), book_);
        return state_.frame % kToldEvery != 0 || !watch_ || watch_(share(), *scene_, state_);
    }

    [[nodiscard]] double share() const {
        const sim::PracticeGoal& goal = frames_.goal();
        if (goal.index >= before_step_) return 1 - kWayBackShare / 2;
        return (1 - kWayBackShare) * (goal.index + std::clamp(goal.progress, 0.0, 1.0)) /
               before_step_;
    }

    const Task& task_;
    int before_step_;
    const StageWatch& watch_;
    std::shared_ptr<const sim::Scene> scene_;
    sim::State state_;
    std::unique_ptr<haptics::Servo> servo_;
    OperatorSight sight_;
    AttemptFrames frames_;
    double frame_s_;
    std::array<sim::ToolInput, sim::kMaxTools> inputs_{}, home_{};
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback_{};
    GivenBook book_;
};

}  // namespace

std::shared_ptr<const StageStart> make_stage_start(const Task& task, uint64_t seed, int stage,
                                                   int threads, const StageWatch& watch) {
    Task own = task;
    own.scene.seed = seed;
    ExpertAtWork expert(own, stage, threads, watch);
    if (!expert.work() || !expert.go_back()) return nullptr;
    return expert.result(stage);
}

bool GivenFrames::step() {
    if (next_ == given_.size()) {
        sim::begin_here(scene_, state_);
        return false;
    }
    const sim::Input& input = given_[next_++];
    const size_t tools = scene_.tools.size();
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
    state_.substeps = input.substeps;
    (void)sim::step(scene_, state_, {input.tools, tools}, {feedback.data(), tools});
    return true;
}

void simulate_given(const sim::Scene& scene, sim::State& state, std::span<const sim::Input> given,
                    const GivenTold& told) {
    GivenFrames frames(scene, state, given);
    for (size_t i = 0; frames.step(); ++i)
        if (told && i % static_cast<size_t>(kToldEvery) == 0)
            told(static_cast<double>(i) / static_cast<double>(given.size()), scene, state);
}

}  // namespace placode::curriculum
