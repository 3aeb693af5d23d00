// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The people of a cohort by tasks: read from the store, as a picture of the scores of one task, and
// as a table for other programs.

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "assessment/cohort.h"
#include "ui/shell/app_context.h"

class QWidget;

namespace placode::ui {

struct CohortPerson {
    int64_t id = 0;
    QString name;
    std::map<std::string, assessment::CohortCell> tasks;
    std::map<std::string, double> first_points;
    std::string last_utc;
};

/// Who has attempts that count and an account that is open, by name, and the ids of their tasks,
/// sorted.
struct CohortPeople {
    std::vector<CohortPerson> people;
    std::vector<std::string> tasks;
};
[[nodiscard]] CohortPeople read_cohort_people(db::Store& store);

/// "stuck", "passing", ...
[[nodiscard]] QString standing_words(assessment::Standing standing);
/// Stuck or regressed.
[[nodiscard]] bool needs_help(assessment::Standing standing);

/// First, last and best score of everybody at `task`.
[[nodiscard]] QWidget* make_scores_picture(const AppContext& context,
                                           const std::vector<CohortPerson>& people,
                                           const std::string& task);

/// A line for every person and task.
[[nodiscard]] std::string cohort_csv(const std::vector<CohortPerson>& people);

}  // namespace placode::ui
