// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The numbers of a study's report, computed by assessment/ from the data set and from nothing else,
// so that the exported CSV gives the same.

#include <optional>
#include <string>
#include <vector>

#include "assessment/intervals.h"
#include "assessment/reliability.h"
#include "assessment/statistics.h"
#include "reports/dataset.h"

namespace placode::reports {

/// One Likert item.
struct ItemNumbers {
    const Field* field = nullptr;
    assessment::LikertSummary summary;
    std::optional<assessment::Interval> mean_ci95;  ///< Student.
    assessment::Interval top2_ci95;                 ///< Wilson, shares 0..1.
    int not_applicable = 0;
};

/// A number or a scale score.
struct NumberNumbers {
    const Field* field = nullptr;
    std::vector<double> values;
    int missing = 0;
    std::optional<double> mean, sd;
    std::optional<assessment::Interval> mean_ci95;
};

/// A choice: how many took what.
struct ChoiceNumbers {
    const Field* field = nullptr;
    int n = 0, missing = 0;
    std::vector<int> counts;  ///< In the order of the codes.
};

struct AlphaNumbers {
    const Field* scale = nullptr;
    int complete = 0, left_out = 0;
    std::optional<assessment::Alpha> alpha;
    std::string problem;  ///< Why there is none.
};

struct FormNumbers {
    const Form* form = nullptr;
    std::vector<ItemNumbers> items;
    std::vector<NumberNumbers> numbers;
    std::vector<ChoiceNumbers> choices;
    std::vector<AlphaNumbers> alphas;
};

/// Items of one form between two groups of participants.
struct GroupComparison {
    const Form* form = nullptr;
    const Field* by = nullptr;
    std::string group1, group2;
    int n1 = 0, n2 = 0;
    struct Row {
        const Field* field = nullptr;
        assessment::CliffsDelta delta;
        double p = 1, p_holm = 1;
        bool exact = true;  ///< p is of the permutation distribution, else of the normal one.
    };
    std::vector<Row> rows;
    [[nodiscard]] size_t exact_rows() const;
    double least_p = 1;  ///< No p can be smaller with these group sizes: 2 / C(n1 + n2, n1).
};

struct StudyNumbers {
    std::vector<FormNumbers> forms;
    std::optional<GroupComparison> comparison;
    /// What the sample cannot carry, in plain words.
    std::vector<std::string> cautions;
};

/// @pre `data` outlives the result. Uses participants whose data are used, first answers of each.
[[nodiscard]] StudyNumbers study_numbers(const Dataset& data,
                                         const std::vector<curriculum::Questionnaire>& instruments);

/// "form,field,statistic,value": every number above, for scripts/study_report.R and whoever checks.
[[nodiscard]] std::string study_numbers_csv(const StudyNumbers& numbers);

}  // namespace placode::reports
