// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pass marks that were set for tasks, and the rubric as it stood at a given time.

#include <optional>
#include <string>
#include <vector>

#include "assessment/standard_setting.h"
#include "curriculum/standard.h"
#include "curriculum/task.h"
#include "db/store.h"

namespace placode::db {

struct StandardRecord {
    curriculum::PassStandard standard;
    std::string reason, set_by, set_utc;
};

/// The standard of a task that was set last at or before `at_utc` (empty: the newest).
[[nodiscard]] std::optional<StandardRecord> standard_at(Store& store, const std::string& task_id,
                                                        const std::string& at_utc = {});

/// Keeps it as the task's next version (`version` is set here), with audit. Returns the version.
/// Throws kRefused without a reason from version 2 on.
int set_standard(Store& store, curriculum::PassStandard standard, const std::string& reason);

/// The task's rubric, with the pass mark that held at that time: an attempt is judged by the
/// standard of its day, also when it is scored again.
[[nodiscard]] assessment::Rubric rubric_at(Store& store, const curriculum::Task& task,
                                           const std::string& at_utc = {});

/// Others are judged by a standard, as by norms: throws StoreError kRefused where one of the last
/// `last` attempts of these people that count was never simulated again, or where they are not all
/// of one version of the task and its rubric. Demonstrations are in no standard, but where all
/// accounts are there to demonstrate; there they need not be proved.
/// @param people of both groups: what is compared with each other.
void need_fit_to_judge(Store& store, const std::string& task_id, const std::vector<int64_t>& people,
                       int last);

/// Of each of these people the mean of the attempts that need_fit_to_judge() asks for; who has none
/// is left out. Throws as need_fit_to_judge().
[[nodiscard]] std::vector<double> person_means(Store& store, const std::string& task_id,
                                               const std::vector<int64_t>& people, int last);

/// The standard that these two groups give, not kept yet. Throws std::invalid_argument when they
/// give none.
[[nodiscard]] curriculum::PassStandard standard_of_groups(const std::string& task_id,
                                                          const std::vector<double>& novices,
                                                          const std::vector<double>& experts,
                                                          int last);

/// The standard that these judges give: the weighted share is the mark. Not kept yet.
[[nodiscard]] curriculum::PassStandard standard_of_judges(const std::string& task_id,
                                                          const assessment::Angoff& judges);

}  // namespace placode::db
