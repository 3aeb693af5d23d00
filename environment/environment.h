// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A task as an environment for programs: reset, step with actions, observation, reward, save and
// restore. The same frames, recording and score as for a person's attempt; no clock, no thread but
// the workers of the physics.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "curriculum/operator_sight.h"
#include "environment/environment_error.h"
#include "environment/episode_book.h"
#include "environment/field_cache.h"
#include "environment/hands.h"
#include "environment/judge.h"
#include "environment/observation.h"

namespace placode::environment {

struct EnvironmentOptions {
    int threads = 1;  ///< Of the physics; the result is the same with any number.
    ActionUnits units = ActionUnits::kNormalised;
    double speed_m_s = 0.03;    ///< Of a tip when a normalised action says 1.
    double time_limit_s = 0;    ///< Ends earlier than the task would; 0 = as the task says.
    double start_spread_m = 0;  ///< Tips start up to so far from home, by seed.
    /// The score is asked for so often [s of simulated time]; 0 = at the end only.
    double judge_every_s = 0.5;
    double approach_weight = 0.2;  ///< Of the way to the present goal, in the dense reward.
    bool sparse = false;           ///< The reward is the score at the end, and nothing before.
    /// Seeds share so many fields: seed s gets field 1 + s % fields. 0 = a field for every seed.
    uint64_t fields = 0;
    bool record = false;             ///< Keep what a recording needs.
    std::string scene_changes_json;  ///< Merged into the task's scene; empty = none.
};

struct StepOutcome {
    double reward = 0;
    double score_part = 0;     ///< Change of the points since they were last asked for, over 100.
    double approach_part = 0;  ///< Weighted change of the way to the goal.
    sim::EndReason end = sim::EndReason::kRunning;
    bool success = false;  ///< It is over, and a person would have passed.
    int frames = 0;        ///< Simulated: fewer than asked for when the attempt ended.
};

/// An attempt as it stands now, but for field and tissue. Copied as a whole, so that a saved moment
/// forgets nothing of it.
struct Episode {
    uint64_t seed = 0;
    std::optional<curriculum::AttemptFrames> frames;  ///< Nothing before the first reset.
    std::optional<Hands> hands;
    std::array<sim::ToolInput, sim::kMaxTools> inputs{};
    std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
    EpisodeBook book;
    Judgement judged;
    sim::EndReason end = sim::EndReason::kRunning;
    double potential_m = 0;  ///< Minus the mean way to the goals, at the last step.
    double paid_points = 0;  ///< Of the score, so far rewarded.
    int64_t reached = 0;     ///< Goals.
};

/// A moment of an attempt. For any environment of the same task, in this program.
struct SavedMoment {
    [[nodiscard]] size_t bytes() const;

    std::shared_ptr<const Field> field;
    std::vector<uint8_t> state;
    Episode episode;
};

/// One thread at a time. Functions throw EnvironmentError, and what loading and building throw
/// (DefinitionError, MeshError).
class Environment {
 public:
    /// @param task id of a shipped task, or a JSON file.
    Environment(std::shared_ptr<FieldCache> fields, const std::string& task,
                const EnvironmentOptions& options);
    ~Environment();
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

    void reset(uint64_t seed);
    /// `frames` frames of 1 ms with one action: kActionSize numbers per tool (hands.h).
    /// @param finish the attempt is declared done after these frames.
    StepOutcome step(std::span<const double> actions, int frames, bool finish = false);

    [[nodiscard]] const std::vector<std::string>& observation_names() const { return names_; }
    /// As many numbers as there are names.
    void observe(std::span<double> out);
    /// What a person sees and feels now. Spans live until the next call of anything.
    [[nodiscard]] haptics::Perception look();

    /// A moment costs the state (some MB) and the recording so far.
    void save(SavedMoment& into) const;
    void restore(const SavedMoment& saved);

    [[nodiscard]] bool began() const { return state_ != nullptr; }
    [[nodiscard]] bool ended() const { return episode_.end != sim::EndReason::kRunning; }
    [[nodiscard]] const curriculum::Task& task() const { return task_; }
    [[nodiscard]] const EnvironmentOptions& options() const { return options_; }
    [[nodiscard]] size_t tools() const { return task_.scene.tools.size(); }
    [[nodiscard]] uint64_t seed() const { return episode_.seed; }
    /// The field that this seed gets.
    [[nodiscard]] uint64_t field_seed(uint64_t seed) const;
    // After reset().
    [[nodiscard]] const Field& field() const;
    [[nodiscard]] const sim::State& state() const;
    [[nodiscard]] const Hands& hands() const { return *episode_.hands; }
    /// Counts resets and restored moments: what was seen before does not lead to what is seen now.
    [[nodiscard]] uint32_t jumps() const { return jumps_; }
    [[nodiscard]] std::span<const sim::ToolFeedback> feedback() const;
    [[nodiscard]] const curriculum::AttemptFrames& frames() const { return *episode_.frames; }
    [[nodiscard]] std::span<const sim::Event> events() const;
    /// Of every frame so far, where the option record keeps them.
    [[nodiscard]] const std::vector<sim::Input>& inputs() const {
        return episode_.book.recording().inputs;
    }
    /// The last time that the score was asked for; at the end that of the attempt. Before it with
    /// the metrics that the rubric looks at only.
    [[nodiscard]] const Judgement& judged() const { return episode_.judged; }
    /// The score now, with every metric. Rewards go on from judged().
    [[nodiscard]] Judgement judge_in_full();
    /// The whole attempt, when it is over. Throws when it is not or no inputs were kept.
    [[nodiscard]] const sim::Recording& recording() const;

 private:
    void need_begun() const;
    void check(std::span<const double> actions, int frames) const;
    void enter(const std::shared_ptr<const Field>& field);
    void finish_attempt();
    void judge_now();
    void look_for_goals();
    [[nodiscard]] std::array<sim::Pose, sim::kMaxTools> poses() const;
    [[nodiscard]] double approach();

    std::shared_ptr<FieldCache> fields_;
    EnvironmentOptions options_;
    curriculum::Task task_;
    std::vector<std::string> names_;
    std::shared_ptr<const Field> field_;
    std::unique_ptr<sim::State> state_;
    std::unique_ptr<curriculum::OperatorSight> sight_;
    int64_t looked_ = -1;  // frame of the last look
    uint32_t jumps_ = 0;
    Episode episode_;
    ToolGoals goals_;
};

}  // namespace placode::environment
