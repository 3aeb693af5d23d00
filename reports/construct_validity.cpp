// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Construct validity: do people of different levels differ in their metrics, and by how much.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "assessment/rank_tests.h"
#include "assessment/statistics.h"
#include "reports/analysis_parts.h"
#include "reports/points_figure.h"
#include "reports/study_analysis.h"

namespace placode::reports {
namespace {

using assessment::MannWhitney;

constexpr size_t kLeastPeople = 2;
constexpr size_t kMostLevels = 6;

/// Participant (or participant and level) to level, in the order of the levels.
struct Levels {
    std::string label;
    std::vector<std::string> names;
    std::map<std::string, size_t> of_participant;  ///< By a questionnaire.
    const Field* of_attempt = nullptr;             ///< By a field of the attempts themselves.

    [[nodiscard]] std::optional<size_t> level_of(const Row& attempt) const {
        if (of_attempt == nullptr) {
            const auto found = of_participant.find(attempt.participant);
            return found == of_participant.end() ? std::nullopt : std::optional(found->second);
        }
        const auto value = attempt.values.find(of_attempt->id);
        if (value == attempt.values.end()) return std::nullopt;
        const auto place = std::find(names.begin(), names.end(), value->second);
        if (place == names.end()) return std::nullopt;
        return static_cast<size_t>(place - names.begin());
    }
};

std::optional<Levels> levels_by(const Dataset& data, const std::string& id) {
    const size_t dot = id.find('.');
    const Form* form = data.form(id.substr(0, dot));
    const Field* field =
        form == nullptr || dot == std::string::npos ? nullptr : form->field(id.substr(dot + 1));
    if (field == nullptr) return std::nullopt;
    Levels levels;
    levels.label = field->label;
    if (form->id == "attempts") {
        std::set<std::string> names;
        for (const Row& row : form->rows)
            if (const auto found = row.values.find(field->id);
                row.counts && found != row.values.end())
                names.insert(found->second);
        levels.names.assign(names.begin(), names.end());
        levels.of_attempt = field;
        return levels;
    }
    std::map<int, size_t> place;
    for (const Row& row : form->rows) {
        const auto found = row.values.find(field->id);
        if (row.instance != 1 || found == row.values.end()) continue;
        const auto code = curriculum::answer_number(found->second);
        if (code) place[static_cast<int>(*code)] = 0;
    }
    for (auto& [code, at] : place) {
        at = levels.names.size();
        std::string name = std::to_string(code);
        for (const Code& each : field->codes)
            if (each.value == code && !each.label.empty()) name = each.label;
        levels.names.push_back(name);
    }
    for (const Row& row : form->rows) {
        const auto found = row.values.find(field->id);
        if (row.instance != 1 || found == row.values.end()) continue;
        if (const auto code = curriculum::answer_number(found->second))
            levels.of_participant[row.participant] = place[static_cast<int>(*code)];
    }
    return levels;
}

/// What is compared with each other: attempts at one task, but where the tasks are the levels.
RowsByTask compared_rows(const Form& attempts, const Levels& levels) {
    RowsByTask tasks = counted_by_task(attempts);
    if (levels.of_attempt == nullptr || levels.of_attempt->id != "task_id") return tasks;
    std::vector<const Row*> together;
    for (const auto& [task, rows] : tasks)
        together.insert(together.end(), rows.begin(), rows.end());
    return {{std::string(), together}};
}

/// Means of each person in each level: repeats of one person are not independent.
std::vector<std::vector<double>> person_means(const std::vector<const Row*>& rows,
                                              const Field& field, const Levels& levels) {
    std::map<std::pair<size_t, std::string>, std::vector<double>> values;
    for (const Row* row : rows) {
        const auto level = levels.level_of(*row);
        const auto value = value_of(*row, field.id);
        if (level && value) values[{*level, row->participant}].push_back(*value);
    }
    std::vector<std::vector<double>> means(levels.names.size());
    for (const auto& [key, list] : values) means[key.first].push_back(*assessment::mean_of(list));
    return means;
}

bool enough_people(const std::vector<std::vector<double>>& groups) {
    return std::all_of(groups.begin(), groups.end(),
                       [](const auto& group) { return group.size() >= kLeastPeople; });
}

struct Comparison {
    std::string label;  ///< Metric, and task where there are several.
    std::vector<std::vector<double>> values;
    double p = 1, effect = 0;
    std::optional<assessment::Interval> interval;
    bool exact = false;  ///< p is of the permutation distribution.
};

/// Two levels: exact where small; more: Kruskal and Wallis.
std::optional<Comparison> compare(const std::string& label, std::vector<std::vector<double>> values,
                                  const Levels& levels) {
    if (!enough_people(values)) return std::nullopt;
    Comparison found;
    found.label = label;
    std::vector<double> all;
    for (const auto& group : values) all.insert(all.end(), group.begin(), group.end());
    if (*std::min_element(all.begin(), all.end()) == *std::max_element(all.begin(), all.end()))
        return std::nullopt;  // Nobody differs: there is nothing to compare.
    if (values.size() == 2) {
        const MannWhitney test = assessment::mann_whitney(values[1], values[0]);
        found.p = test.p_exact.value_or(test.p_asymptotic_cc);
        found.exact = test.p_exact.has_value();
        found.effect = test.hedges_g;
        if (std::isfinite(test.hedges_g_ci95.low) && std::isfinite(test.hedges_g_ci95.high))
            found.interval = test.hedges_g_ci95;
    } else {
        std::vector<assessment::NamedGroup> groups;
        for (size_t i = 0; i < values.size(); ++i) groups.push_back({levels.names[i], values[i]});
        const auto test = assessment::kruskal_wallis(groups);
        found.p = test.p;
        found.effect = test.epsilon2;
    }
    if (!std::isfinite(found.effect)) return std::nullopt;
    found.values = std::move(values);
    return found;
}

Figure effects_figure(const std::vector<Comparison>& list, const std::vector<double>& holm,
                      const Levels& levels, const ChartStyle& style) {
    std::vector<ForestRow> rows;
    double low = -1, high = 1;
    for (size_t i = 0; i < list.size(); ++i) {
        ForestRow row;
        row.label = list[i].label;
        row.estimate = list[i].effect;
        row.no_interval = !list[i].interval;
        if (list[i].interval) row.low = list[i].interval->low, row.high = list[i].interval->high;
        row.note = "p " + p_words(list[i].p) + ", Holm " + p_words(holm[i]);
        low = std::min({low, row.estimate, row.low});
        high = std::max({high, row.estimate, row.high});
        rows.push_back(row);
    }
    // A wild interval of a small sample must not squeeze all others: the drawing cuts it off.
    low = std::max(low, -6.0), high = std::min(high, 6.0);
    return forest_figure("construct_validity", levels.label + ": effect on the metrics",
                         levels.names.size() == 2
                             ? "Hedges' g (right: " + levels.names[1] + " is higher)"
                             : "epsilon squared",
                         rows, levels.names.size() == 2 ? low : 0, high, style);
}

/// How levels were compared over these metrics.
std::string comparison_method(const Levels& levels, const std::vector<Comparison>& list) {
    const bool two = levels.names.size() == 2;
    const auto exact = static_cast<size_t>(
        std::count_if(list.begin(), list.end(), [](const Comparison& each) { return each.exact; }));
    return "Levels: " + levels.label +
           ". Means of each person over the attempts at a task, then compared between levels: mean "
           "(SD), n. " +
           (two ? "Hedges' g with its 95 % interval by the noncentral t distribution, positive "
                  "where "
                  "\"" +
                      levels.names[1] + "\" is higher; p of " +
                      mann_whitney_words(exact, list.size()) + "."
                : std::string("Kruskal-Wallis, tie-corrected, with epsilon squared.")) +
           " p adjusted by Holm over " + std::to_string(list.size()) + " metrics.";
}

/// A row a metric: the levels side by side, effect, interval and p.
void fill_table(const std::vector<Comparison>& list, const std::vector<double>& holm,
                const Levels& levels, Analysis& analysis) {
    const bool two = levels.names.size() == 2;
    analysis.head = {"metric"};
    for (const std::string& name : levels.names) analysis.head.push_back(name);
    analysis.head.insert(
        analysis.head.end(),
        two ? std::initializer_list<std::string>{"g", "95 % interval", "p", "p (Holm)"}
            : std::initializer_list<std::string>{"epsilon2", "p", "p (Holm)"});
    for (size_t i = 0; i < list.size(); ++i) {
        std::vector<AnalysisCell> row{{list[i].label, {}}};
        for (const auto& group : list[i].values)
            row.push_back({group_text(group), assessment::mean_of(group)});
        row.push_back({rounded(list[i].effect), list[i].effect});
        if (two) row.push_back({interval_words(list[i].interval), {}});
        row.push_back({p_words(list[i].p), list[i].p});
        row.push_back({p_words(holm[i]), holm[i]});
        analysis.rows.push_back(std::move(row));
    }
}

/// Scores by level, a figure a task.
void add_score_strips(const RowsByTask& tasks, const Field& field, const Levels& levels,
                      const ChartStyle& style, Analysis& analysis) {
    for (const auto& [task, rows] : tasks) {
        const auto points = person_means(rows, field, levels);
        if (!enough_people(points)) continue;
        std::vector<StripGroup> strips;
        for (size_t i = 0; i < levels.names.size(); ++i)
            strips.push_back({levels.names[i], points[i]});
        analysis.figures.push_back(points_figure("construct_points" + task_behind(tasks, task),
                                                 task_before(tasks, task) + "Score by level",
                                                 "score [points], mean of each person", strips,
                                                 style));
    }
}

}  // namespace

std::vector<Grouping> possible_groupings(const Dataset& data) {
    std::vector<Grouping> list;
    const Form* attempts = data.form("attempts");
    if (attempts == nullptr) return list;
    const auto add = [&](const Form& form, const Field& field) {
        const std::string id = form.name + "." + field.id;
        const auto levels = levels_by(data, id);
        if (!levels || levels->names.size() < 2 || levels->names.size() > kMostLevels) return;
        const Field* points = attempts->field("points");
        for (const auto& [task, rows] : compared_rows(*attempts, *levels)) {
            if (!enough_people(person_means(rows, *points, *levels))) continue;
            list.push_back({id, field.label});
            return;
        }
    };
    // Who people are before what they think.
    for (const bool opinion : {false, true})
        for (const Form& form : data.forms)
            for (const Field& field : form.fields)
                if (field.ordinal == opinion &&
                    ((field.kind == FieldKind::kCode &&
                      (is_questionnaire(form) || field.id == "arm")) ||
                     (form.id == "attempts" && (field.id == "device" || field.id == "task_id"))))
                    add(form, field);
    return list;
}

Analysis construct_validity(const StudyReport& report, const std::string& by,
                            const ChartStyle& style) {
    Analysis analysis;
    analysis.id = "construct_validity";
    analysis.title = "Construct validity";
    const auto possible = possible_groupings(report.data);
    const Form* attempts = report.data.form("attempts");
    const std::string id = !by.empty()        ? by
                           : possible.empty() ? std::string()
                                              : possible.front().id;
    const auto levels = attempts == nullptr ? std::nullopt : levels_by(report.data, id);
    if (!levels || levels->names.size() < 2) {
        analysis.problem = "There are no two levels with attempts of at least two people each.";
        return analysis;
    }
    const RowsByTask tasks = compared_rows(*attempts, *levels);
    std::vector<Comparison> list;
    for (const auto& [task, rows] : tasks)
        for (const Field* field : metric_fields(*attempts))
            if (auto found = compare(task_before(tasks, task) + metric_label(*field),
                                     person_means(rows, *field, *levels), *levels))
                list.push_back(std::move(*found));
    if (list.empty()) {
        analysis.problem = "No metric has values of at least two people in every level of \"" +
                           levels->label + "\" that differ.";
        return analysis;
    }
    std::vector<double> p;
    p.reserve(list.size());
    for (const Comparison& each : list) p.push_back(each.p);
    const auto holm = assessment::holm_adjusted(p);
    analysis.method = comparison_method(*levels, list);
    analysis.caution = versions_caution(*attempts);
    fill_table(list, holm, *levels, analysis);
    analysis.figures.push_back(effects_figure(list, holm, *levels, style));
    add_score_strips(tasks, *attempts->field("points"), *levels, style, analysis);
    return analysis;
}

}  // namespace placode::reports
