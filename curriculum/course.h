// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A course: tasks in order, what opens each of them, and what is next.

#include <map>
#include <string>
#include <vector>

#include "curriculum/task.h"

namespace placode::curriculum {

struct CourseStage {
    std::string task_id;
    std::vector<std::string> requires_tasks;  ///< Task ids that must be mastered first.
    double benchmark_points = 70;             ///< Score that counts.
    int consecutive = 2;  ///< This many times in a row, without a critical error.
};

struct Course {
    std::string id;
    int version = 1;
    LocalText title, description;
    std::vector<CourseStage> stages;
};

/// The outcome of one attempt, as far as a course cares. Oldest first in lists.
struct AttemptOutcome {
    std::string task_id;
    double points = 0;
    bool critical = false;
    bool interrupted = false;  ///< Does not count.
};

enum class StageStatus : uint8_t { kLocked, kOpen, kMastered };

struct StageProgress {
    StageStatus status = StageStatus::kLocked;
    int streak = 0;  ///< Benchmarks met in a row, up to now.
    int attempts = 0;
    double best_points = 0;
    std::vector<std::string> missing;  ///< Task ids that still lock it.
};

struct CourseProgress {
    std::vector<StageProgress> stages;
    int next_stage = -1;  ///< First open, not mastered stage; -1 = all mastered.
};

[[nodiscard]] Course load_course(const std::string& id_or_file);
[[nodiscard]] CourseProgress course_progress(const Course& course,
                                             const std::vector<AttemptOutcome>& outcomes);

}  // namespace placode::curriculum
