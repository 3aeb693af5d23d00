// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A recording simulated again, frame by frame, with moments to go back to.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "curriculum/attempt_runner.h"
#include "curriculum/practice_guide.h"
#include "curriculum/stage_start.h"
#include "sim/step/step.h"

namespace placode::curriculum {

/// Saved states along the way, in bounded memory: when it is full every second one goes, and new
/// ones come half as often.
class KeyFrames {
 public:
    static constexpr double kEveryS = 5;  ///< To begin with [s of simulated time].

    explicit KeyFrames(size_t most_bytes) : most_bytes_(most_bytes) {}
    /// Keeps this moment when it is due.
    /// @return whether it was kept.
    bool offer(const sim::Scene& scene, const sim::State& state);
    /// The last moment at or before `time_s`; null = none.
    [[nodiscard]] const std::vector<uint8_t>* before(double time_s) const;
    [[nodiscard]] size_t bytes() const;
    [[nodiscard]] size_t count() const { return kept_.size(); }

 private:
    struct Kept {
        double time_s = 0;
        std::vector<uint8_t> state;
    };
    size_t most_bytes_;
    double every_s_ = kEveryS;
    std::vector<Kept> kept_;  // rising
};

/// How a replay comes to the state that an attempt from a stage began with.
struct GivenPart {
    /// That state, where it is known here (save_state()); null: it is simulated. One that does not
    /// have the recorded hash is not used.
    const std::vector<uint8_t>* state = nullptr;
    /// Told how far it is simulated; may throw, which ends the replay's making.
    GivenTold told;
};

class Replay {
 public:
    /// @param key_frame_bytes memory for moments to go back to; 0 = back means from the beginning.
    /// An attempt from a stage begins with simulating what was given (`given`).
    /// @throws DefinitionError when the recording's task cannot be built any more.
    Replay(const sim::Recording& recording, int threads, size_t key_frame_bytes = 0,
           const GivenPart& given = {});
    /// By this task instead of the one that the recording carries. Does not follow practice():
    /// whoever asks so has an AttemptFrames. What was given is left to step_given(): until then
    /// state() is the settled one.
    Replay(const sim::Recording& recording, Task task, int threads);

    /// One frame of what was given before an attempt from a stage, where it is not simulated yet.
    /// False when nothing of it is left: state() is then the one that the attempt began with.
    bool step_given();
    /// One frame, compared with the recorded hash where there is one. False when there is nothing
    /// more to simulate: the recording is over, or differs.
    bool step();
    /// Goes back to the last kept moment at or before `time_s`, or to the beginning.
    void back_to(double time_s);
    [[nodiscard]] const sim::Scene& scene() const { return *scene_; }
    [[nodiscard]] const sim::State& state() const { return *state_; }
    /// Of the last frame.
    [[nodiscard]] const sim::StepReport& report() const { return report_; }
    /// For closing the attempt, which changes it: after that the replay is over.
    [[nodiscard]] sim::State& last_state() { return *state_; }
    /// Where the steps of a practice task stand, as the person saw them; count == 0: it has none.
    [[nodiscard]] const sim::PracticeGoal& practice() const { return practice_.goal(); }
    /// How far it is the same; complete when step() was false.
    [[nodiscard]] ReplayResult result() const;

 private:
    Replay(const sim::Recording& recording, std::optional<Task> task, int threads,
           size_t key_frame_bytes, const GivenPart& given);

    void build(const GivenPart& given);
    void begin_at_stage(const Task& task, const GivenPart& given);
    void stand_at_stage(const Task& task);
    [[nodiscard]] bool take_given_state(const GivenPart& given);
    void tune();
    bool compare();
    void follow_practice(std::span<const sim::ToolInput> hands);

    const sim::Recording& recording_;
    std::optional<Task> task_;  // instead of the recording's
    int threads_;
    std::shared_ptr<sim::Scene> scene_;
    std::unique_ptr<sim::State> state_;
    KeyFrames keys_;
    std::optional<GivenFrames> given_left_;
    std::vector<uint8_t> start_;  // of an attempt from a stage: the state that it began with
    PracticeGuide practice_;
    std::vector<std::pair<double, PracticeGuide>> practice_kept_;  // beside the key frames
    int64_t frames_per_sample_ = 10;
    std::vector<sim::Event> hashes_, tunings_;
    size_t next_hash_ = 0, next_tuning_ = 0, compared_ = 0;
    double frame_s_ = 0;
    sim::StepReport report_;
    ReplayResult result_;
    bool differs_ = false;
};

}  // namespace placode::curriculum
