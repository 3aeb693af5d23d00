// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A CSV table for the statistics, and what its commands share.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/rank_tests.h"
#include "assessment/reliability.h"
#include "ui/cli/cli.h"

namespace placode::cli {

/// Cells as text, rectangular; an empty cell, "NA" or "NaN" is missing.
struct StatsTable {
    std::string path;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
    std::vector<int> lines;  ///< Of the file, for each row.

    /// Throws InputError naming file, column and what there is.
    [[nodiscard]] size_t column(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// "FILE: line 3, column NAME", for messages.
    [[nodiscard]] std::string place(size_t row, size_t column) const;
    /// nullopt when missing. Throws InputError naming line, column and what was found.
    [[nodiscard]] std::optional<double> number(size_t row, size_t column) const;
    /// Throws InputError where a number is missing.
    [[nodiscard]] double needed(size_t row, size_t column) const;
};

/// As assessment::read_csv() reads it; in a table of one column an empty line above the last value
/// is a missing value. Throws InputError for an unreadable file, no
/// header or a row of another length.
[[nodiscard]] StatsTable read_stats_table(const std::string& path);

/// Options of `placodectl stats NAME FILE`.
struct StatsOptions {
    std::string name, file;
    std::string reverse;  ///< Items, comma between.
    std::string scale, groups, positive, value, by, statistic = "mean";
    double p0 = 0.05, p1 = 0.10, alpha = 0.05, beta = 0.20, success_at = 65;
    double adequate = 0.10, inadequate = 0.30, h = 2;
    int64_t resamples = 20000;
    uint64_t seed = 1;
    int digits = 0;  ///< Of the differences (wilcoxon); 0: exact.
};

/// Lowest and highest value of the scale: --scale, else the least and largest answer.
struct Scale {
    int low = 1, high = 5;
};
[[nodiscard]] Scale scale_of(const StatsTable& table, const StatsOptions& options);

/// Complete cases of the table's items (all columns), reverse-keyed ones turned round.
struct CompleteCases {
    std::vector<std::string> items;
    assessment::Scores scores;
    int missing = 0;                    ///< Rows left out.
    std::vector<std::string> constant;  ///< Items left out by leave_out_constant().
};
/// @param scale  That reverse-keyed items are turned round on; none: scale_of().
[[nodiscard]] CompleteCases complete_cases(const StatsTable& table, const StatsOptions& options,
                                           const std::optional<Scale>& scale = {});
/// Takes out the items that everybody answered alike, as psych::alpha does.
void leave_out_constant(CompleteCases& cases);

/// Values by group, groups in order of name. Counts rows without value or group in `missing`.
[[nodiscard]] std::vector<assessment::NamedGroup> groups_of(const StatsTable& table,
                                                            const StatsOptions& options,
                                                            int& missing);

[[nodiscard]] Json interval(const assessment::Interval& interval);

using StatsFunction = Json (*)(const StatsTable&, const StatsOptions&);
/// The statistics by name, one map a file.
[[nodiscard]] std::map<std::string, StatsFunction> rating_statistics();
[[nodiscard]] std::map<std::string, StatsFunction> group_statistics();
[[nodiscard]] std::map<std::string, StatsFunction> learning_statistics();

}  // namespace placode::cli
