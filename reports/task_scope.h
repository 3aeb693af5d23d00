// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What of an attempt belongs to its task: where nothing is to be cut, nobody reads of a ring. Pages
// and reports ask here; exports keep every metric.

#include <string>
#include <string_view>
#include <vector>

#include "curriculum/task.h"
#include "sim/step/recording.h"

namespace placode::reports {

struct TaskScope {
    bool ring = true;                 ///< The incision around the placode is judged.
    bool line = true;                 ///< The planned line means something: to cut on or to follow.
    bool energy = true;               ///< An instrument conducts.
    bool resection = true;            ///< Tissue is to be freed and taken out.
    bool jaws = true;                 ///< An instrument holds tissue.
    bool scissors = true;             ///< An instrument snips.
    bool placode = true;              ///< The field has one.
    bool hands = true;                ///< More than one instrument is held.
    double force_limit_n = 0;         ///< Of the scene: what counts as too much; 0 = not known.
    std::vector<std::string> scored;  ///< Metrics that the rubric looks at; empty = not known.

    /// Inspect, incise, release .. are parts of the task.
    [[nodiscard]] bool phases() const noexcept { return ring || resection; }
};

/// From instruments, rubric and steps of the task.
[[nodiscard]] TaskScope scope_of(const curriculum::Task& task);
/// From the task that the recording keeps, and from its anatomy. Of a task that this build cannot
/// read any more: from the instruments.
[[nodiscard]] TaskScope scope_of(const sim::RecordingHeader& header);
/// From instruments and scored metrics alone.
[[nodiscard]] TaskScope scope_of(const std::vector<sim::ToolSpec>& tools,
                                 const std::vector<std::string>& scored);

/// True for what the score looks at, and for what the task has.
[[nodiscard]] bool belongs(const TaskScope& scope, std::string_view metric);
/// It is counted from the scene's limit of force on.
[[nodiscard]] bool about_force_limit(std::string_view metric) noexcept;

}  // namespace placode::reports
