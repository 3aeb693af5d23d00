// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How an attempt begins at a stage of its task: the scripted expert does what comes before it, by
// the same frames as in any attempt. What it did is kept as inputs, from which every replay comes
// to the same state, and for the program that is running as that state.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "curriculum/task.h"
#include "sim/step/recording.h"
#include "sim/world/state.h"

namespace placode::curriculum {

/// The scripted expert of every stage has this seed: a stage is the same for everybody.
inline constexpr uint64_t kStageSeed = 1;

/// Hands that have reached a stage are back within this time [s].
inline constexpr double kLongestWayBackS = 60;

/// What comes before a stage, done. Never changes.
struct StageStart {
    int stage = 0;
    std::vector<sim::Input> given;  ///< Of every frame before it.
    std::vector<uint8_t> state;     ///< save_state() behind them and begin_here().
    uint64_t hash = 0;              ///< whole_hash() of that state.
};

/// The expert does not come as far as the stage: its scene or tissue was changed too much.
class StageError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// Told the share that is done, 0..1, and what there is to see, every few frames; false stops.
using StageWatch = std::function<bool(double share, const sim::Scene&, const sim::State&)>;

/// Simulates the scripted expert up to stage `stage` of the task, takes its instruments back to
/// where they began and waits until the tissue is calm (3 s at most). A needle in jaws stays in
/// them. About as long as a person's attempt takes, or half of it.
/// @param seed of the anatomy. @return null: it was stopped. Throws DefinitionError for a stage
/// that the task does not have, StageError, and what building a scene throws.
[[nodiscard]] std::shared_ptr<const StageStart> make_stage_start(const Task& task, uint64_t seed,
                                                                 int stage, int threads,
                                                                 const StageWatch& watch = {});

/// Told the share that is simulated, 0..1, and what there is to see.
using GivenTold = std::function<void(double share, const sim::Scene&, const sim::State&)>;

/// What was given, frame by frame, for whoever may stop at any of them: from the settled state of
/// the task's own beginning to the one behind these inputs and begin_here(). All three outlive it.
/// @pre the scene is as the task has it, also in the grip of its hands.
class GivenFrames {
 public:
    GivenFrames(const sim::Scene& scene, sim::State& state, std::span<const sim::Input> given)
        : scene_(scene), state_(state), given_(given) {}
    /// One frame. False where none was left: then begin_here() is done, and this is not called
    /// again.
    bool step();

 private:
    const sim::Scene& scene_;
    sim::State& state_;
    std::span<const sim::Input> given_;
    size_t next_ = 0;
};

/// All of them: from the settled state of the task's own beginning to the one behind these inputs
/// and begin_here(). @param told every few frames, with the share that is done; may throw.
/// @pre the scene is as the task has it, also in the grip of its hands.
void simulate_given(const sim::Scene& scene, sim::State& state, std::span<const sim::Input> given,
                    const GivenTold& told = {});

}  // namespace placode::curriculum
