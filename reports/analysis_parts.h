// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the analyses share. Private to reports.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/rank_tests.h"
#include "assessment/reliability.h"
#include "reports/dataset.h"

namespace placode::reports {

/// The score and every metric: the fields of attempts that measure performance.
[[nodiscard]] std::vector<const Field*> metric_fields(const Form& attempts);
[[nodiscard]] std::string metric_label(const Field& field);  ///< With its unit.
[[nodiscard]] std::optional<double> value_of(const Row& row, const std::string& field);
/// Rows that count, by task: attempts at different tasks are no repeats of each other.
using RowsByTask = std::map<std::string, std::vector<const Row*>>;
/// @pre `attempts` outlives the result.
[[nodiscard]] RowsByTask counted_by_task(const Form& attempts);
/// Where attempts at one task that count are of several versions of it or of its rubric: says so.
[[nodiscard]] std::string versions_caution(const Form& attempts);
/// "ring: " before what is said of one of several tasks; nothing where there is only one.
[[nodiscard]] std::string task_before(const RowsByTask& all, const std::string& task);
/// "_ring" behind the name of a figure of one of several tasks.
[[nodiscard]] std::string task_behind(const RowsByTask& all, const std::string& task);
/// Nothing where the scores do not vary.
[[nodiscard]] std::optional<assessment::Icc> icc_of(const assessment::Scores& scores);
/// Three significant digits, '.' decimals.
[[nodiscard]] std::string rounded(double value);
[[nodiscard]] std::string whole(double value);
/// "0.52 (0.1), n 12": mean and standard deviation.
[[nodiscard]] std::string group_text(const std::vector<double>& values);
[[nodiscard]] std::string p_words(double p);  ///< "0.012", "< 0.001"
/// "the exact Mann-Whitney test", or what else stands behind `all` values of p.
[[nodiscard]] std::string mann_whitney_words(size_t exact, size_t all);
[[nodiscard]] std::string interval_words(const std::optional<assessment::Interval>& interval);

}  // namespace placode::reports
