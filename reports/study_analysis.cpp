// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Test-retest, and the files of an analysis. Construct validity: construct_validity.cpp; learning
// curves, raters and shared parts: study_learning.cpp.
#include "reports/study_analysis.h"

#include <cmath>
#include <map>
#include <set>

#include "assessment/reliability.h"
#include "assessment/statistics.h"
#include "reports/analysis_parts.h"
#include "reports/csv_table.h"
#include "reports/export.h"
#include "reports/staged_folder.h"
#include "sim/core/counted.h"

namespace placode::reports {
namespace {

/// Participant to (first, second) of one metric in `rows`, the attempts at one task.
std::vector<std::vector<double>> pairs_of(const StudyReport& report,
                                          const std::vector<const Row*>& rows, const Field& field,
                                          bool by_visit) {
    std::map<int64_t, int> visit;
    for (const db::StepRecord& step : report.steps)
        if (step.attempt_id > 0) visit[step.attempt_id] = step.visit;
    std::map<std::string, std::vector<double>> first, second, all;
    for (const Row* row : rows) {
        const auto value = value_of(*row, field.id);
        if (!value) continue;
        all[row->participant].push_back(*value);
        const int when = visit.contains(row->attempt_id) ? visit[row->attempt_id] : 1;
        if (when == 1) first[row->participant].push_back(*value);
        if (when == 2) second[row->participant].push_back(*value);
    }
    std::vector<std::vector<double>> pairs;
    if (by_visit) {
        for (const auto& [code, values] : first)
            if (const auto other = second.find(code); other != second.end())
                pairs.push_back(
                    {*assessment::mean_of(values), *assessment::mean_of(other->second)});
    } else {
        for (const auto& [code, values] : all)
            if (values.size() >= 2) pairs.push_back({values[values.size() - 2], values.back()});
    }
    return pairs;
}

/// One metric of a task with both values of everybody.
struct Retest {
    std::string label;
    assessment::Icc icc;
    std::vector<double> first, second;
};

/// The metrics that at least three people have twice at one task, and in which people differ.
std::vector<Retest> retests_of(const StudyReport& report, bool by_visit) {
    std::vector<Retest> lines;
    const Form* attempts = report.data.form("attempts");
    if (attempts == nullptr) return lines;
    const RowsByTask tasks = counted_by_task(*attempts);
    for (const auto& [task, rows] : tasks) {
        for (const Field* field : metric_fields(*attempts)) {
            const auto pairs = pairs_of(report, rows, *field, by_visit);
            if (pairs.size() < 3) continue;
            Retest line{task_before(tasks, task) + metric_label(*field), {}, {}, {}};
            for (const auto& pair : pairs)
                line.first.push_back(pair[0]), line.second.push_back(pair[1]);
            const auto spread = assessment::sample_sd(line.first);
            if (!spread || *spread == 0) continue;
            const auto icc = icc_of(pairs);
            if (!icc) continue;
            line.icc = *icc;
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

}  // namespace

std::string versions_caution(const Form& attempts) {
    std::string text;
    for (const auto& [task, rows] : counted_by_task(attempts)) {
        std::set<std::string> versions, rubrics;
        for (const Row* row : rows) {
            const auto told = [row](const char* id) {
                const auto found = row->values.find(id);
                return found == row->values.end() ? std::string() : found->second;
            };
            versions.insert(told("task_version"));
            rubrics.insert(told("rubric_id") + " " + told("rubric_version"));
        }
        if (versions.size() < 2 && rubrics.size() < 2) continue;
        text += (text.empty() ? "Caution: the attempts at " : " The attempts at ") + task +
                " are of " + sim::counted(versions.size(), "version") + " of the task and " +
                sim::counted(rubrics.size(), "version") +
                " of its rubric; differences between them may be those of the rules.";
    }
    return text;
}

Analysis test_retest(const StudyReport& report, const ChartStyle& style) {
    Analysis analysis;
    analysis.id = "test_retest";
    analysis.title = "Test-retest reliability";
    bool by_visit = false;
    for (const db::StepRecord& step : report.steps)
        by_visit = by_visit || (step.visit == 2 && step.attempt_id > 0 && !step.superseded());
    const std::vector<Retest> lines = retests_of(report, by_visit);
    if (lines.empty()) {
        analysis.problem =
            "At least three people with two attempts each at the same task are needed.";
        return analysis;
    }
    analysis.caution = versions_caution(*report.data.form("attempts"));
    analysis.method =
        std::string(by_visit ? "Means of the first against those of the second visit, task by task."
                             : "The last two attempts of everybody at a task, because there is one "
                               "visit.") +
        " ICC(2,1), absolute agreement, single measure, with its 95 % interval (Shrout & Fleiss); "
        "SEM: standard error of measurement; MDC95 = 1.96 sqrt(2) SEM: what a single person must "
        "change by to have changed.";
    analysis.head = {"metric", "n", "first", "second", "ICC(2,1)", "95 % interval", "SEM", "MDC95"};
    std::vector<ForestRow> forest;
    for (const Retest& line : lines) {
        const double sem = line.icc.sem_agreement, mdc = 1.96 * std::sqrt(2.0) * sem;
        const auto& form = line.icc.icc2;
        analysis.rows.push_back({{line.label, {}},
                                 {std::to_string(line.icc.subjects), line.icc.subjects},
                                 {group_text(line.first), assessment::mean_of(line.first)},
                                 {group_text(line.second), assessment::mean_of(line.second)},
                                 {rounded(form.icc), form.icc},
                                 {interval_words(form.ci95), {}},
                                 {rounded(sem), sem},
                                 {rounded(mdc), mdc}});
        forest.push_back({line.label, form.icc, form.ci95.low, form.ci95.high,
                          "n " + std::to_string(line.icc.subjects),
                          !std::isfinite(form.ci95.low) || !std::isfinite(form.ci95.high)});
    }
    analysis.figures.push_back(forest_figure("test_retest", "Test-retest: ICC(2,1)",
                                             "ICC(2,1), absolute agreement", forest, -1, 1, style));
    return analysis;
}

std::string analysis_csv(const Analysis& analysis) {
    std::string text = csv_line(analysis.head);
    for (const auto& row : analysis.rows) {
        std::vector<std::string> cells;
        for (const AnalysisCell& cell : row)
            cells.push_back(cell.value && cell.text.find(',') == std::string::npos
                                ? whole(*cell.value)
                                : harmless(cell.text));
        text += csv_line(cells);
    }
    return text;
}

std::vector<std::string> write_analysis(const Analysis& analysis, const std::string& folder,
                                        bool demonstration) {
    const std::string table = "/" + analysis.id + "_table.csv";
    std::vector<std::string> paths{folder + table};
    write_staged(folder, [&](const std::string& staged) {
        save_private_file(staged + table, analysis_csv(analysis));
        for (const Figure& figure : analysis.figures) {
            save_figure(figure, staged, demonstration);
            for (const char* ending : {".svg", ".png", ".csv"})
                paths.push_back(folder + "/" + file_name(figure.id) + ending);
        }
    });
    return paths;
}

}  // namespace placode::reports
