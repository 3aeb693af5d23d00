// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which pass mark judged the attempts of a figure.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "db/store.h"

namespace placode::reports {

/// By task: the mark that judged all of its attempts that count. Absent where several did, and
/// where the mark is not known.
struct PassMarks {
    std::map<std::string, double> of_task;

    [[nodiscard]] std::optional<double> of(const std::string& task) const {
        const auto found = of_task.find(task);
        return found == of_task.end() ? std::nullopt : std::optional(found->second);
    }
};

/// What of an attempt decides about its mark.
struct JudgedAttempt {
    std::string task_id;
    int task_version = 0;
    std::string started_utc;
};

/// @param attempts that count, in any order. Throws StoreError.
[[nodiscard]] PassMarks pass_marks_of(db::Store& store, const std::vector<JudgedAttempt>& attempts);

}  // namespace placode::reports
