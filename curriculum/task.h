// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A task: what to do, in which scene, with which tools, and how it is judged. Data, not code.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assessment/scoring.h"
#include "curriculum/definitions.h"
#include "sim/anatomy/operative_field.h"
#include "sim/core/practice.h"

namespace placode::curriculum {

/// Text in several languages; `en` is always there.
struct LocalText {
    std::string en, pl;
    [[nodiscard]] const std::string& in(const std::string& language) const {
        return language == "pl" && !pl.empty() ? pl : en;
    }
};

/// A step of a practice task: what to do, how the device at hand does it, when it counts as done.
struct TaskStep {
    sim::PracticeStep goal;
    LocalText text;
    std::map<std::string, LocalText> hints;  ///< By device: "mouse", "keyboard", ...
    std::vector<std::string> devices;        ///< Only with these; empty = with all.
};

/// A place in a task to begin at in practice: what comes before it is given.
struct TaskStage {
    int before_step = 1;  ///< Index of the step that the trainee does first.
    LocalText title;      ///< "Bite 2"
};

struct Task {
    std::string id;
    int version = 1;
    LocalText title, goal;
    std::vector<LocalText> instructions;  ///< Step by step.
    std::string scene_id;
    sim::OperativeFieldSpec scene;  ///< Resolved.
    double settle_s = 0.3;
    double time_limit_s = 0;        ///< 0 = none: a person ends it, at the latest after kLongestS.
    bool finish_when_cut = true;    ///< Ends by itself when the ring is complete.
    std::vector<TaskStep> steps;    ///< Done in this order; the attempt ends with the last.
    std::vector<TaskStage> stages;  ///< Rising; stage k of an attempt is stages[k - 1].
    assessment::Rubric rubric;
    std::string
        json;  ///< Resolved text, for the recording: load_task_text(json) gives the same task.
};

/// No attempt lasts longer, whatever its task says: somebody has left.
inline constexpr double kLongestS = 3600;
/// When an attempt ends by itself [s]: by the task, or earlier where `asked_s` > 0 asks for it.
[[nodiscard]] double limit_of(const Task& task, double asked_s) noexcept;

/// Stage `stage` >= 1 of a task. Throws DefinitionError, which says what there is.
[[nodiscard]] const TaskStage& stage_of(const Task& task, int stage);

/// The steps that this device can do; scripts can do all. "script:expert" is the device "script".
[[nodiscard]] std::vector<TaskStep> steps_for(const Task& task, const std::string& device);

/// Whether steps with a patch are among those of a task.
[[nodiscard]] bool lays_patch(const Task& task) noexcept;

/// By id of a shipped task, or by path of a JSON file. Throws DefinitionError.
[[nodiscard]] Task load_task(const std::string& id_or_file);
/// Its title alone, without building the scene. Throws DefinitionError.
[[nodiscard]] LocalText load_task_title(const std::string& id_or_file);
/// The rubric alone, as the store keeps it.
[[nodiscard]] std::string rubric_text(const Task& task);
[[nodiscard]] assessment::Rubric load_rubric_text(const std::string& json,
                                                  const std::string& origin);
/// From the text that a recording carries. `origin` is used in messages.
[[nodiscard]] Task load_task_text(const std::string& json, const std::string& origin);

}  // namespace placode::curriculum
