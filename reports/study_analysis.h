// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The four questions that a validation study asks of performance: do levels differ (construct
// validity), does a repeat give the same (test-retest), who has learned (learning curves, CUSUM),
// do raters agree. Each is a table, a figure and a sentence on the method, for window, command line
// and paper alike.

#include <optional>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "reports/study_report.h"

namespace placode::reports {

struct AnalysisCell {
    std::string text;             ///< As printed.
    std::optional<double> value;  ///< The whole number behind it.
};

struct Analysis {
    std::string id, title;
    std::string method;   ///< How the numbers were made, in a few sentences.
    std::string caution;  ///< What the attempts do not have in common; empty = nothing.
    std::string problem;  ///< Why there is no table; empty = there is one.
    std::vector<std::string> head;
    std::vector<std::vector<AnalysisCell>> rows;
    std::vector<Figure> figures;
};

/// "form.field" of a grouping, and its words.
struct Grouping {
    std::string id, label;
};
/// Choices with at least two levels of two people each, the device of the attempts among them.
[[nodiscard]] std::vector<Grouping> possible_groupings(const Dataset& data);

/// @param by a Grouping's id; empty = the first possible one.
[[nodiscard]] Analysis construct_validity(const StudyReport& report, const std::string& by,
                                          const ChartStyle& style = {});
/// First against second visit; with one visit the last two attempts of everybody.
[[nodiscard]] Analysis test_retest(const StudyReport& report, const ChartStyle& style = {});
[[nodiscard]] Analysis learning_curves(const StudyReport& report, const ChartStyle& style = {});
/// Of the study's attempts. @param ratings all of that form.
[[nodiscard]] Analysis rater_agreement(const StudyReport& report,
                                       const std::vector<db::RatingRecord>& ratings,
                                       const curriculum::Questionnaire& form,
                                       const ChartStyle& style = {});

/// The table as CSV, the numbers whole.
[[nodiscard]] std::string analysis_csv(const Analysis& analysis);
/// ID_table.csv and every figure into the folder: all of them, or it is as it was. Returns the
/// paths. Throws ReportError.
std::vector<std::string> write_analysis(const Analysis& analysis, const std::string& folder,
                                        bool demonstration);

}  // namespace placode::reports
