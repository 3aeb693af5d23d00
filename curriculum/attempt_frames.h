// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The frames of an attempt: inputs in, physics, and what of it goes into the recording. Knows no
// device, no thread and no clock, so that a person's attempt (attempt_loop.h) and a program's
// (environment/environment.h) are simulated and recorded alike.

#include <memory>
#include <span>
#include <vector>

#include "curriculum/attempt_runner.h"
#include "curriculum/live_warnings.h"
#include "curriculum/practice_guide.h"
#include "sim/step/recording.h"
#include "sim/step/step.h"

namespace placode::curriculum {

/// Where the recording of an attempt goes, entry by entry. Called within frames: must not throw.
class AttemptBook {
 public:
    virtual ~AttemptBook() = default;
    virtual void write(const sim::Input& input) noexcept = 0;
    virtual void write(const sim::Sample& sample) noexcept = 0;
    virtual void write(const sim::Event& event) noexcept = 0;
};

/// What a recording of this attempt begins with.
[[nodiscard]] sim::RecordingHeader recording_header(const Task& task, uint64_t seed,
                                                    const AttemptOptions& options,
                                                    const sim::Scene& scene);

/// What an attempt carries from frame to frame beside sim::State. A copy of both goes on alike.
/// One thread; within a frame it neither locks, allocates nor throws.
class AttemptFrames {
 public:
    /// `settled` is the state that the attempt begins with, or its given part; `scene` must outlive
    /// this.
    AttemptFrames(const Task& task, const std::vector<TaskStep>& steps, const sim::Scene& scene,
                  const sim::State& settled, double time_limit_s);

    /// The attempt begins with `state` and this step, what came before was given.
    void begin_at(int step, const sim::State& state) noexcept;
    /// Before the first frame.
    void begin(AttemptBook& book) const noexcept;
    /// One frame: writes its input and simulates it.
    sim::StepReport simulate(sim::State& state, std::span<const sim::ToolInput> inputs,
                             std::span<sim::ToolFeedback> feedback, AttemptBook& book) noexcept;
    /// What the frame brought: events, a sample every 10 ms, steps done.
    void look(const sim::State& state, const sim::StepReport& report,
              std::span<const sim::ToolInput> inputs, AttemptBook& book) noexcept;
    /// Whether the attempt ends by itself after this frame: what was to be done is done, or time is
    /// up. `finished`: the operator says so.
    [[nodiscard]] sim::EndReason ended(const sim::State& state,
                                       std::span<const sim::ToolInput> inputs,
                                       bool finished) noexcept;
    /// The last entries of the ledger, after the last frame. Allocates.
    void close(sim::State& state, AttemptBook& book) noexcept;
    /// What a recording ends with: the last hash, for which `state` takes the substeps of its last
    /// frame.
    [[nodiscard]] sim::RecordingEnd seal(sim::State& state, sim::EndReason reason,
                                         AttemptBook& book) const noexcept;
    /// What close() would write if the attempt ended now, but for sums of over-stretch that are
    /// still open (the ledger has those of whole seconds). Changes nothing. Allocates.
    [[nodiscard]] std::vector<sim::Event> entries_if_closed(const sim::State& state) const;

    [[nodiscard]] const sim::PracticeGoal& goal() const noexcept { return practice_.goal(); }
    [[nodiscard]] const LiveWarnings& warnings() const noexcept { return warnings_; }
    [[nodiscard]] double cut_fraction() const noexcept { return cut_fraction_; }
    [[nodiscard]] double time_limit_s() const noexcept { return time_limit_s_; }

 private:
    void sample(const sim::State& state, std::span<const sim::ToolInput> inputs,
                AttemptBook& book) noexcept;

    const sim::Scene* scene_;
    double time_limit_s_, frame_s_;
    bool finish_when_cut_, preset_;
    int64_t frames_per_sample_;
    LiveWarnings warnings_;
    PracticeGuide practice_;
    uint32_t sample_flags_ = 0;
    int used_substeps_ = 0;  // of the last frame
    double cut_fraction_ = 0, lifted_s_ = 0, practised_s_ = 0;
};

}  // namespace placode::curriculum
