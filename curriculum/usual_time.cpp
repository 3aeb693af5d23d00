// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/usual_time.h"

namespace placode::curriculum {

double usual_time_s(const Task& task) {
    constexpr double kStepS = 10;
    for (const assessment::RubricItem& item : task.rubric.items)
        if (item.metric == "task_time_s" && !item.below && item.threshold > 0)
            return item.threshold;
    if (!task.steps.empty()) return kStepS * static_cast<double>(task.steps.size());
    return task.time_limit_s / 2;
}

}  // namespace placode::curriculum
