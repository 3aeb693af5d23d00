// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Follows the steps of a practice task while it is done: which step, where its targets lie on the
// moving tissue, what was achieved. Physics thread; allocates in the constructor only. Private to
// curriculum.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "assessment/practice.h"
#include "curriculum/patch_watch.h"
#include "curriculum/task.h"
#include "curriculum/wash_watch.h"
#include "sim/step/step.h"

namespace placode::curriculum {

class PracticeGuide {
 public:
    PracticeGuide() = default;  ///< Without steps it has nothing to do.
    /// `settled` is the state in which the targets are looked for. Keeps a reference to the scene.
    PracticeGuide(const std::vector<TaskStep>& steps, const sim::Scene& scene,
                  const sim::State& settled);

    /// A copy goes on in another scene that was built from the same task.
    void look_into(const sim::Scene& scene) noexcept { scene_ = &scene; }

    /// The steps before this one were given; `state` is the one that the attempt begins with.
    /// Targets stay those of the settled state. @pre nothing was seen yet.
    void begin_at(int step, const sim::State& state) noexcept;

    [[nodiscard]] bool done() const noexcept { return tracker_ && tracker_->done(); }
    /// count == 0: the task has no steps.
    [[nodiscard]] const sim::PracticeGoal& goal() const noexcept { return goal_; }
    /// One sample later: the events it brought, valid until the next call.
    [[nodiscard]] std::span<const sim::Event> see(const sim::State& state,
                                                  std::span<const sim::ToolInput> inputs,
                                                  const sim::Sample& sample) noexcept;
    /// The end of the attempt: what was going on is written down.
    [[nodiscard]] std::span<const sim::Event> end(double time_s) noexcept;

 private:
    void look(const sim::State& state) noexcept;
    void look_at_handling(const sim::State& state, assessment::NeedleSight& needle) const noexcept;
    void look_at_needle(const sim::State& state, assessment::NeedleSight& needle) const noexcept;

    std::optional<assessment::PracticeTracker> tracker_;
    std::vector<std::array<sim::ContourAnchor, 2>> targets_;  // of every step
    std::vector<int> target_count_;
    std::vector<std::array<sim::Vec3, 2>> mark_m_;  // the same at rest
    double needle_arc_m_ = 1;
    const sim::Scene* scene_ = nullptr;
    PatchWatch patch_;
    WashWatch wash_;
    std::vector<int> station_;  // of a slit, between the marks of every step; -1 = none
    sim::PracticeGoal goal_;
};

}  // namespace placode::curriculum
