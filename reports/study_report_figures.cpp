// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of a study: what everybody answered, scales, comparison of groups, learning.

#include <algorithm>
#include <map>
#include <optional>

#include "reports/analysis_parts.h"
#include "reports/export.h"
#include "reports/report.h"
#include "reports/staged_folder.h"
#include "reports/study_report_parts.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

/// Items of one form whose scales have the same width and words, in runs.
std::vector<std::vector<LikertBar>> likert_groups(const FormNumbers& form) {
    std::vector<std::vector<LikertBar>> groups;
    for (const ItemNumbers& item : form.items) {
        LikertBar bar;
        bar.id = item.field->id;
        bar.label = item.field->label;
        bar.scale_min = item.summary.scale_min;
        bar.counts = item.summary.counts;
        bar.low = item.field->codes.front().label;
        bar.high = item.field->codes.back().label;
        bar.missing = item.summary.missing;
        bar.mean = item.summary.mean;
        bar.sd = item.summary.sd;
        const bool fits = !groups.empty() && groups.back().back().low == bar.low &&
                          groups.back().back().high == bar.high &&
                          groups.back().back().counts.size() == bar.counts.size();
        if (!fits) groups.emplace_back();
        groups.back().push_back(bar);
    }
    return groups;
}

void add_form_figures(std::vector<Figure>& figures, const FormNumbers& form,
                      const ChartStyle& style) {
    int part = 0;
    const auto groups = likert_groups(form);
    for (const auto& bars : groups) {
        std::string id = "likert_" + form.form->name;
        if (groups.size() > 1) id += "_" + std::to_string(++part);
        std::string title = form.form->title;
        if (!bars.front().low.empty())
            title += ": " + bars.front().low + " to " + bars.front().high;
        figures.push_back(likert_figure(id, title, bars, style));
    }
    std::vector<StripGroup> scores;
    const size_t first = figures.size() - groups.size();
    for (const NumberNumbers& each : form.numbers) {
        if (each.values.empty()) continue;
        if (each.field->derived) {
            scores.push_back({each.field->label, each.values});
            continue;
        }
        figures.push_back(strip_figure(
            "strip_" + form.form->name + "_" + each.field->id, each.field->label,
            each.field->label + (each.field->unit.empty() ? "" : " [" + each.field->unit + "]"),
            {{each.field->label, each.values}}, style));
    }
    if (!scores.empty())
        figures.push_back(strip_figure("scales_" + form.form->name,
                                       form.form->title + ": scale scores", "score", scores,
                                       style));
    for (size_t i = first; i < figures.size(); ++i) figures[i].group = form.form->name;
}

std::optional<Figure> comparison_figure(const StudyNumbers& numbers, const ChartStyle& style) {
    if (!numbers.comparison) return std::nullopt;
    const GroupComparison& comparison = *numbers.comparison;
    std::vector<ForestRow> rows;
    for (const auto& each : comparison.rows)
        rows.push_back(
            {item_label(*each.field), each.delta.delta, each.delta.ci95.low, each.delta.ci95.high,
             "p " + p_words(each.p) + ", Holm " + p_words(each.p_holm), each.delta.separated});
    return forest_figure(
        "forest_" + comparison.form->name,
        comparison.by->label + " " + comparison.group1 + " (n = " + std::to_string(comparison.n1) +
            ") against " + comparison.group2 + " (n = " + std::to_string(comparison.n2) + ")",
        "Cliff's delta (right: " + comparison.group1 + " answered higher)", rows, -1, 1, style);
}

/// One of every task: attempts at another one are no repeats.
void add_performance_figures(std::vector<Figure>& figures, const StudyReport& report,
                             const ChartStyle& style) {
    const Form* form = report.data.form("attempts");
    if (form == nullptr) return;
    const RowsByTask tasks = counted_by_task(*form);
    for (const auto& [task, rows] : tasks) {
        std::map<std::string, LearningLine> lines;
        for (const Row* row : rows) {
            const auto points = row->values.find("points"), verdict = row->values.find("verdict");
            if (points == row->values.end() || verdict == row->values.end()) continue;
            if (verdict->second == "Not attempted") continue;
            LearningLine& line = lines[row->participant];
            line.label = row->participant;
            line.points.push_back(curriculum::answer_number(points->second).value_or(0));
            line.failed.push_back(verdict->second != "Passed");
        }
        std::vector<LearningLine> list;
        list.reserve(lines.size());
        for (auto& [code, line] : lines) list.push_back(std::move(line));
        if (list.empty()) continue;
        figures.push_back(learning_figure(
            "learning_attempts" + task_behind(tasks, task),
            task_before(tasks, task) + "Scores and CUSUM over attempts", list,
            report.pass_mark(task), assessment::cusum_limits(0.05, 0.10, 0.05, 0.20), style));
    }
}

}  // namespace

std::vector<Figure> study_figures(const StudyReport& report, const StudyNumbers& numbers,
                                  const ChartStyle& style) {
    std::vector<Figure> figures{flow_figure("flow", "Participants", flow_numbers(report), style)};
    for (const FormNumbers& form : numbers.forms) add_form_figures(figures, form, style);
    if (auto figure = comparison_figure(numbers, style)) figures.push_back(std::move(*figure));
    add_performance_figures(figures, report, style);
    return figures;
}

std::vector<std::string> write_study_figures(const StudyReport& report, const std::string& folder,
                                             const ExportPace& pace) {
    std::vector<std::string> paths;
    const StudyNumbers numbers = study_numbers(report.data, report.instruments);
    write_staged(folder, [&](const std::string& staged) {
        for (const Figure& figure : study_figures(report, numbers)) {
            pace.next({figure.title});
            save_figure(figure, staged, report.data.demonstration);
            for (const char* ending : {".svg", ".png", ".csv"})
                paths.push_back(folder + "/" + file_name(figure.id) + ending);
        }
        save_private_file(staged + "/numbers.csv", study_numbers_csv(numbers));
    });
    paths.push_back(folder + "/numbers.csv");
    return paths;
}

}  // namespace placode::reports
