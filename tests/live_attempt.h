// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An attempt of a scripted operator on the test's own thread, with its state in the test's hands:
// what AttemptRunner does in lock step, frame by frame. Whoever looks into frames needs no second
// simulation of a recording for it.

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "curriculum/attempt_frames.h"
#include "curriculum/operator_sight.h"
#include "haptics/catalogue/open_device.h"
#include "haptics/servo.h"
#include "sim/anatomy/operative_field.h"
#include "tests/attempt_fixture.h"

namespace placode::test {

class LiveAttempt final : private curriculum::AttemptBook {
 public:
    /// @param level  "expert", ...
    /// @param end_s  The attempt ends then [simulated s]; 0 = as the task says.
    explicit LiveAttempt(curriculum::Task task, const std::string& level = "expert",
                         double end_s = 0, uint64_t seed = 1)
        : options_(scripted(level)) {
        if (end_s > 0) task.time_limit_s = end_s;
        task.scene.seed = seed;
        options_.steps = curriculum::steps_for(task, options_.device);
        scene_ = sim::build_operative_field(task.scene);
        state_ = std::make_unique<sim::State>(*scene_, 1);
        sim::settle(*scene_, *state_, task.settle_s);
        servo_ = open_servo(task, seed);
        sight_ = std::make_unique<curriculum::OperatorSight>(*scene_);
        frames_ = std::make_unique<curriculum::AttemptFrames>(
            task, options_.steps, *scene_, *state_, curriculum::limit_of(task, 0));
        recording_.header = curriculum::recording_header(task, seed, options_, *scene_);
        frames_->begin(*this);
    }
    explicit LiveAttempt(const std::string& task, double end_s = 0)
        : LiveAttempt(curriculum::load_task(task), "expert", end_s) {}

    [[nodiscard]] const sim::Scene& scene() const { return *scene_; }
    [[nodiscard]] sim::State& state() { return *state_; }
    [[nodiscard]] bool over() const { return reason_ != sim::EndReason::kRunning; }
    /// Of the last frame.
    [[nodiscard]] const sim::Input& input() const { return recording_.inputs.back(); }
    /// So far.
    [[nodiscard]] const std::vector<sim::Event>& events() const { return recording_.events; }

    /// One frame: both parts below.
    void step() {
        look();
        simulate();
    }
    void step_to(int64_t frame) {
        while (!over() && state_->frame < frame) step();
    }
    /// The operator looks and moves its hands. Makes room for what the frame will record.
    void look() {
        make_room();
        if (state_->frame % kFramesPerLook == 0) sight_->look(*state_);
        haptics::Perception seen = sight_->seen(*state_);
        seen.tools = feedback();
        seen.cut_fraction = static_cast<float>(frames_->cut_fraction());
        seen.practice = frames_->goal();
        servo_->devices().perceive(seen);
        servo_->tick(state_->frame * 1000000, {inputs_.data(), scene_->tools.size()}, feedback());
    }
    /// The frame itself: neither allocates nor locks.
    void simulate() noexcept {
        const sim::StepReport report = frames_->simulate(*state_, hands(), feedback(), *this);
        frames_->look(*state_, report, hands(), *this);
        reason_ = frames_->ended(*state_, hands(), servo_->finish_requested());
    }

    /// The attempt as it was recorded; after that it is over.
    [[nodiscard]] sim::Recording recording() {
        make_room();
        frames_->close(*state_, *this);
        recording_.end = frames_->seal(*state_, reason_, *this);
        return std::move(recording_);
    }

 private:
    static constexpr int64_t kFramesPerLook = 16;  // as in AttemptLoop, with frames of 1 ms
    static constexpr size_t kRoom = 4096;          // more entries than a frame can bring

    [[nodiscard]] std::unique_ptr<haptics::Servo> open_servo(const curriculum::Task& task,
                                                             uint64_t seed) const {
        haptics::DeviceConfig config;
        config.name = options_.device;
        config.seed = seed;
        config.tools = task.scene.tools;
        config.frame_s = task.scene.solver.frame_s;
        config.practice = !task.steps.empty();
        return std::make_unique<haptics::Servo>(
            haptics::open_device(config), task.scene.tools,
            haptics::default_trocars(task.scene.tools, options_.device, config.station),
            haptics::station_limits(config.station));
    }
    [[nodiscard]] std::span<const sim::ToolInput> hands() const {
        return {inputs_.data(), scene_->tools.size()};
    }
    [[nodiscard]] std::span<sim::ToolFeedback> feedback() {
        return {feedback_.data(), scene_->tools.size()};
    }
    template <class Entry>
    static void make_room_in(std::vector<Entry>& entries) {
        if (entries.capacity() < entries.size() + kRoom)
            entries.reserve(2 * (entries.size() + kRoom));
    }
    void make_room() {
        make_room_in(recording_.inputs);
        make_room_in(recording_.samples);
        make_room_in(recording_.events);
    }
    void write(const sim::Input& input) noexcept override { recording_.inputs.push_back(input); }
    void write(const sim::Sample& sample) noexcept override {
        recording_.samples.push_back(sample);
    }
    void write(const sim::Event& event) noexcept override { recording_.events.push_back(event); }

    curriculum::AttemptOptions options_;
    std::shared_ptr<const sim::Scene> scene_;
    std::unique_ptr<sim::State> state_;
    std::unique_ptr<haptics::Servo> servo_;
    std::unique_ptr<curriculum::OperatorSight> sight_;
    std::unique_ptr<curriculum::AttemptFrames> frames_;
    sim::Recording recording_;
    std::array<sim::ToolInput, sim::kMaxTools> inputs_{};
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback_{};
    sim::EndReason reason_ = sim::EndReason::kRunning;
};

}  // namespace placode::test
