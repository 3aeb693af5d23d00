// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Proof that a recording is complete: its inputs alone give every state hash again.
#include "curriculum/replay.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "curriculum/attempt_sample.h"
#include "sim/anatomy/operative_field.h"
#include "sim/core/number_text.h"
#include "sim/step/live_tuning.h"
#include "sim/world/saved_state.h"

namespace placode::curriculum {

namespace {

std::string seconds(double value) { return sim::fixed_text(value, 3); }

std::string hex(uint64_t value) {
    char text[17];
    const auto end = std::to_chars(text, text + sizeof text, value, 16);
    const std::string digits(text, end.ptr);
    return std::string(16 - digits.size(), '0') + digits;
}

/// A hand with force holds its tools as its device does, not as the task says.
void restore_grips(const sim::RecordingHeader& header, std::vector<sim::ToolSpec>& tools) {
    for (size_t i = 0; i < std::min(tools.size(), header.tools.size()); ++i)
        tools[i].hand_n_m = header.tools[i].hand_n_m;
}

}  // namespace

bool KeyFrames::offer(const sim::Scene& scene, const sim::State& state) {
    if (most_bytes_ == 0) return false;
    const double last_s = kept_.empty() ? 0 : kept_.back().time_s;
    if (state.time_s < last_s + every_s_) return false;
    kept_.push_back({state.time_s, sim::save_state(scene, state)});
    while (kept_.size() > 1 && bytes() > most_bytes_) {
        // The second, the fourth, ... go; with them the last where their number is even.
        std::vector<Kept> rest;
        for (size_t i = 0; i < kept_.size(); i += 2) rest.push_back(std::move(kept_[i]));
        kept_ = std::move(rest);
        every_s_ *= 2;
    }
    return true;
}

const std::vector<uint8_t>* KeyFrames::before(double time_s) const {
    const auto after = std::upper_bound(kept_.begin(), kept_.end(), time_s,
                                        [](double t, const Kept& kept) { return t < kept.time_s; });
    return after == kept_.begin() ? nullptr : &std::prev(after)->state;
}

size_t KeyFrames::bytes() const {
    size_t sum = 0;
    for (const Kept& kept : kept_) sum += kept.state.size();
    return sum;
}

Replay::Replay(const sim::Recording& recording, int threads, size_t key_frame_bytes,
               const GivenPart& given)
    : Replay(recording, std::nullopt, threads, key_frame_bytes, given) {}

Replay::Replay(const sim::Recording& recording, Task task, int threads)
    : Replay(recording, std::optional(std::move(task)), threads, 0, {}) {}

Replay::Replay(const sim::Recording& recording, std::optional<Task> task, int threads,
               size_t key_frame_bytes, const GivenPart& given)
    : recording_(recording), task_(std::move(task)), threads_(threads), keys_(key_frame_bytes) {
    for (const sim::Event& event : recording.events) {
        if (event.kind == sim::EventKind::kStateHash) hashes_.push_back(event);
        if (event.kind == sim::EventKind::kTuned) tunings_.push_back(event);
    }
    build(given);
}

void Replay::build(const GivenPart& given) {
    Task task = task_ ? *task_ : load_task_text(recording_.header.task_json, "recording");
    task.scene.seed = recording_.header.seed;
    // What was given was a script's, which holds its tools as the task says.
    const bool at_stage = recording_.header.stage > 0;
    if (!at_stage) restore_grips(recording_.header, task.scene.tools);
    frame_s_ = task.scene.solver.frame_s;
    // This scene is ours alone: tunings of the attempt are done again.
    given_left_.reset();
    scene_ = std::const_pointer_cast<sim::Scene>(sim::build_operative_field(task.scene));
    state_ = std::make_unique<sim::State>(*scene_, threads_);
    sim::settle(*scene_, *state_, task.settle_s);
    if (!task_)
        practice_ = PracticeGuide(steps_for(task, recording_.header.device), *scene_, *state_);
    if (at_stage) begin_at_stage(task, given);
    frames_per_sample_ =
        std::max<int64_t>(1, std::llround(sim::RecordingHeader{}.sample_s / frame_s_));
    next_hash_ = next_tuning_ = 0;
}

/// A known state is taken where it is the recorded one: it is read as of this scene only, and may
/// be of any other.
bool Replay::take_given_state(const GivenPart& given) {
    if (given.state == nullptr) return false;
    try {
        sim::State known(*scene_, threads_);
        sim::load_state(*scene_, known, *given.state);
        if (sim::whole_hash(known) != recording_.header.given_hash) return false;
    } catch (const sim::StateError&) {
        return false;
    }
    start_ = *given.state;
    return true;
}

/// From the settled state to the one that the attempt began with.
void Replay::begin_at_stage(const Task& task, const GivenPart& given) {
    const auto stage = static_cast<size_t>(recording_.header.stage);
    const double longest_s = limit_of(task, 0) + kLongestWayBackS;
    if (stage > task.stages.size() ||
        static_cast<double>(recording_.given.size()) * frame_s_ > longest_s) {
        result_.first_difference_s = 0;
        result_.message =
            "replay: the task has no stage " + std::to_string(stage) + " that begins like this";
        differs_ = true;
        return;
    }
    if (!start_.empty() || take_given_state(given)) {
        sim::load_state(*scene_, *state_, start_);
    } else if (task_) {
        given_left_.emplace(*scene_, *state_, recording_.given);
        return;
    } else {
        simulate_given(*scene_, *state_, recording_.given, given.told);
        start_ = sim::save_state(*scene_, *state_);
    }
    stand_at_stage(task);
}

bool Replay::step_given() {
    if (!given_left_) return false;
    if (given_left_->step()) return true;
    given_left_.reset();
    start_ = sim::save_state(*scene_, *state_);
    stand_at_stage(*task_);
    return false;
}

/// What was given is done: whether it is what was recorded.
void Replay::stand_at_stage(const Task& task) {
    const auto stage = static_cast<size_t>(recording_.header.stage);
    if (sim::whole_hash(*state_) != recording_.header.given_hash) {
        result_.first_difference_s = 0;
        result_.message = "replay: what was given before stage " + std::to_string(stage) +
                          " ends in another state";
        differs_ = true;
    }
    restore_grips(recording_.header, scene_->tools);
    practice_.begin_at(task.stages[stage - 1].before_step, *state_);
}

/// What was tuned before the present frame.
void Replay::tune() {
    for (; next_tuning_ < tunings_.size() &&
           tunings_[next_tuning_].hash <= static_cast<uint64_t>(state_->frame);
         ++next_tuning_)
        static_cast<void>(sim::tune_live(*scene_, *state_, tunings_[next_tuning_]));
}

/// What is due. False at a difference.
bool Replay::compare() {
    for (; next_hash_ < hashes_.size(); ++next_hash_) {
        const sim::Event& recorded = hashes_[next_hash_];
        if (recorded.time_s > state_->time_s + frame_s_ / 2) return true;
        const uint64_t hash = sim::state_hash(*state_);
        ++compared_;
        if (hash == recorded.hash) continue;
        result_.first_difference_s = recorded.time_s;
        result_.message = "replay: differs from " + seconds(recorded.time_s) +
                          " s on: state hash " + hex(hash) + ", recorded " + hex(recorded.hash);
        return false;
    }
    return true;
}

bool Replay::step() {
    while (step_given()) {
    }
    const auto at = static_cast<size_t>(state_->frame);
    if (differs_ || at >= recording_.inputs.size()) return false;
    const sim::Input& input = recording_.inputs[at];
    const size_t tools = scene_->tools.size();
    if (input.frame != state_->frame || input.tool_count != static_cast<int32_t>(tools)) {
        result_.first_difference_s = state_->time_s;
        result_.message = "replay: the input of frame " + std::to_string(state_->frame) +
                          " is missing (found frame " + std::to_string(input.frame) + " with " +
                          std::to_string(input.tool_count) + " tools)";
        differs_ = true;
        return false;
    }
    tune();
    state_->substeps = input.substeps;
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
    report_ = sim::step(*scene_, *state_, {input.tools, tools}, {feedback.data(), tools});
    result_.frames = std::max(result_.frames, state_->frame);
    follow_practice({input.tools, tools});
    differs_ = !compare();
    if (!differs_ && keys_.offer(*scene_, *state_) && practice_.goal().count > 0)
        practice_kept_.emplace_back(state_->time_s, practice_);
    return !differs_;
}

void Replay::follow_practice(std::span<const sim::ToolInput> hands) {
    if (practice_.goal().count == 0 || state_->frame % frames_per_sample_ != 0) return;
    (void)practice_.see(*state_, hands, sample_of(*scene_, *state_, hands));
}

void Replay::back_to(double time_s) {
    const std::vector<uint8_t>* kept = keys_.before(time_s);
    // A scene that was tuned cannot be untuned: it is built again.
    if (kept == nullptr || next_tuning_ > 0) build({});
    if (kept == nullptr) return;
    sim::load_state(*scene_, *state_, *kept);
    // The scene as it was tuned then; what that changed in the state is saved with it.
    if (next_tuning_ < tunings_.size()) {
        tune();
        sim::load_state(*scene_, *state_, *kept);
    }
    for (const auto& [at_s, guide] : practice_kept_)
        if (at_s == state_->time_s) practice_ = guide;
    practice_.look_into(*scene_);  // The kept one knew the scene before it was built again.
    next_hash_ = 0;
    while (next_hash_ < hashes_.size() &&
           hashes_[next_hash_].time_s <= state_->time_s + frame_s_ / 2)
        ++next_hash_;
}

ReplayResult Replay::result() const {
    ReplayResult result = result_;
    if (differs_) return result;
    const bool ended = recording_.end.reason != sim::EndReason::kRunning &&
                       recording_.end.reason != sim::EndReason::kInterrupted;
    const uint64_t hash = sim::state_hash(*state_);
    if (ended && hash != recording_.end.final_hash) {
        result.first_difference_s = state_->time_s;
        result.message = "replay: differs at the end: state hash " + hex(hash) + ", recorded " +
                         hex(recording_.end.final_hash);
    } else if (next_hash_ != hashes_.size()) {
        result.first_difference_s = state_->time_s;
        result.message = "replay: the inputs end at " + seconds(state_->time_s) +
                         " s, before the last recorded state hash";
    } else if (compared_ == 0 && !ended) {
        result.message = "replay: nothing to compare, the recording holds no state hash";
    } else {
        result.identical = true;
        result.message = "replay: identical";
    }
    return result;
}

ReplayResult replay(const sim::Recording& recording, int threads,
                    const std::function<void(const sim::Scene&, const sim::State&)>& on_frame) {
    Replay replay(recording, threads);
    while (replay.step()) {
        if (on_frame) on_frame(replay.scene(), replay.state());
    }
    return replay.result();
}

}  // namespace placode::curriculum
