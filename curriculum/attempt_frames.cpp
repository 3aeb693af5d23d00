// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_frames.h"

#include <algorithm>
#include <cmath>

#include "curriculum/attempt_sample.h"
#include "curriculum/preset.h"
#include "sim/cutting/attempt_progress.h"
#include "sim/fluid/irrigation.h"
#include "sim/ledger/damage.h"
#include "sim/ledger/ledger.h"
#include "sim/step/patch_when_let_go.h"
#include "sim/step/slit_when_let_go.h"
#include "sim/step/undermining_when_let_go.h"

namespace placode::curriculum {

namespace {

using sim::EventKind;

constexpr double kCutFraction = 0.995, kLiftedM = 0.001, kLiftedS = 1.0;

void write_event(AttemptBook& book, double time_s, EventKind kind, uint64_t hash = 0) noexcept {
    sim::Event event;
    event.time_s = time_s;
    event.kind = kind;
    event.hash = hash;
    book.write(event);
}

/// What is measured once, on the last state: each event to `use`, in the order of a recording.
template <class Use>
void measure_last(const sim::Scene& scene, const sim::State& state, const Use& use) {
    for (const sim::Event& event : sim::reached_events(scene, state)) use(event);
    for (const sim::Event& event : sim::slit_when_let_go(scene, state)) use(event);
    for (const sim::Event& event : sim::patch_when_let_go(scene, state)) use(event);
    for (const sim::Event& event : sim::irrigation_events(scene, state)) use(event);
    for (const sim::Event& event : sim::undermining_when_let_go(scene, state)) use(event);
}

}  // namespace

AttemptFrames::AttemptFrames(const Task& task, const std::vector<TaskStep>& steps,
                             const sim::Scene& scene, const sim::State& settled,
                             double time_limit_s)
    : scene_(&scene),
      time_limit_s_(time_limit_s),
      frame_s_(task.scene.solver.frame_s),
      finish_when_cut_(task.finish_when_cut),
      preset_(!preset_of(task).empty()),
      frames_per_sample_(std::max<int64_t>(1, std::llround(0.01 / frame_s_))),
      warnings_(scene),
      practice_(steps, scene, settled),
      used_substeps_(settled.substeps) {}

void AttemptFrames::begin_at(int step, const sim::State& state) noexcept {
    practice_.begin_at(step, state);
    used_substeps_ = state.substeps;
}

void AttemptFrames::begin(AttemptBook& book) const noexcept {
    if (!preset_) return;
    sim::Event event;
    event.kind = EventKind::kTuned;
    event.element = static_cast<int32_t>(sim::TuneParameter::kPreset);
    book.write(event);
}

sim::StepReport AttemptFrames::simulate(sim::State& state, std::span<const sim::ToolInput> inputs,
                                        std::span<sim::ToolFeedback> feedback,
                                        AttemptBook& book) noexcept {
    sim::Input input;
    input.frame = state.frame;
    input.substeps = used_substeps_ = state.substeps;
    input.tool_count = static_cast<int32_t>(inputs.size());
    for (size_t i = 0; i < inputs.size(); ++i) input.tools[i] = inputs[i];
    book.write(input);
    return sim::step(*scene_, state, inputs, feedback);
}

void AttemptFrames::look(const sim::State& state, const sim::StepReport& report,
                         std::span<const sim::ToolInput> inputs, AttemptBook& book) noexcept {
    sample_flags_ |= report.flags;
    for (int i = 0; i < state.event_count; ++i) book.write(state.events[static_cast<size_t>(i)]);
    cut_fraction_ = sim::ring_share(state);
    const bool sampled = state.frame % frames_per_sample_ == 0;
    warnings_.look(state, inputs, sampled);
    for (const sim::Event& event : warnings_.events()) book.write(event);
    if (sampled) sample(state, inputs, book);
}

/// The sample, and what was done of a practice task by then.
void AttemptFrames::sample(const sim::State& state, std::span<const sim::ToolInput> inputs,
                           AttemptBook& book) noexcept {
    sim::Sample sample = sample_of(*scene_, state, inputs);
    sample.cut_fraction = static_cast<float>(cut_fraction_);
    sample.step_flags = sample_flags_;
    sample_flags_ = 0;
    book.write(sample);
    for (const sim::Event& event : practice_.see(state, inputs, sample)) {
        book.write(event);
        warnings_.hear(event);
    }
}

sim::EndReason AttemptFrames::ended(const sim::State& state, std::span<const sim::ToolInput> inputs,
                                    bool finished) noexcept {
    bool lifted = true;
    for (size_t i = 0; i < scene_->tools.size(); ++i) {
        if (scene_->tools[i].kind == sim::ToolKind::kScope) continue;
        lifted = lifted && inputs[i].pedals == 0 && state.tools[i].tip_gap_m > kLiftedM;
    }
    const bool cut = finish_when_cut_ && cut_fraction_ >= kCutFraction;
    lifted_s_ = cut && lifted ? lifted_s_ + frame_s_ : 0;
    if (cut && !lifted) warnings_.ring_closed(state.time_s);
    // A moment to see the last step ticked off.
    practised_s_ = practice_.done() ? practised_s_ + frame_s_ : 0;
    if (finished || lifted_s_ >= kLiftedS || practised_s_ >= kLiftedS)
        return sim::EndReason::kFinished;
    if (state.time_s >= time_limit_s_ - frame_s_ / 2) return sim::EndReason::kTimeLimit;
    return sim::EndReason::kRunning;
}

void AttemptFrames::close(sim::State& state, AttemptBook& book) noexcept {
    for (const sim::Event& event : practice_.end(state.time_s)) book.write(event);
    for (const sim::Event& event : warnings_.end(state.time_s)) book.write(event);
    try {
        measure_last(*scene_, state, [&book](const sim::Event& event) { book.write(event); });
        for (const sim::Event& event : sim::closing_events(*scene_, state)) book.write(event);
    } catch (const std::exception&) {
        // Without memory for it gaps or thermal spread are not known; the attempt is.
    }
}

sim::RecordingEnd AttemptFrames::seal(sim::State& state, sim::EndReason reason,
                                      AttemptBook& book) const noexcept {
    if (reason == sim::EndReason::kFinished) write_event(book, state.time_s, EventKind::kFinished);
    // Substeps may have been chosen for a frame that never came; the hash covers their number.
    state.substeps = used_substeps_;
    sim::RecordingEnd end;
    end.final_hash = sim::state_hash(state);
    end.reason = reason;
    end.duration_s = state.time_s;
    write_event(book, state.time_s, EventKind::kStateHash, end.final_hash);
    return end;
}

std::vector<sim::Event> AttemptFrames::entries_if_closed(const sim::State& state) const {
    std::vector<sim::Event> all;
    const auto add = [&all](const auto& events) {
        all.insert(all.end(), events.begin(), events.end());
    };
    PracticeGuide practice = practice_;
    LiveWarnings warnings = warnings_;
    add(practice.end(state.time_s));
    add(warnings.end(state.time_s));
    measure_last(*scene_, state, [&all](const sim::Event& event) { all.push_back(event); });
    add(sim::open_spells(*scene_, state));
    add(sim::spread_events(*scene_, state));
    return all;
}

}  // namespace placode::curriculum
