// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Construct validity and test-retest. Learning curves and raters: study_learning.cpp.
#include "reports/study_analysis.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "assessment/rank_tests.h"
#include "assessment/reliability.h"
#include "assessment/statistics.h"
#include "reports/analysis_parts.h"
#include "reports/csv_table.h"
#include "reports/export.h"

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

/// Means of each person in each level: repeats of one person are not independent.
std::vector<std::vector<double>> person_means(const Form& attempts, const Field& field,
                                              const Levels& levels) {
    std::map<std::pair<size_t, std::string>, std::vector<double>> values;
    for (const Row& row : attempts.rows) {
        if (!row.counts) continue;
        const auto level = levels.level_of(row);
        const auto value = value_of(row, field.id);
        if (level && value) values[{*level, row.participant}].push_back(*value);
    }
    std::vector<std::vector<double>> means(levels.names.size());
    for (const auto& [key, list] : values) means[key.first].push_back(*assessment::mean_of(list));
    return means;
}

struct Comparison {
    const Field* field = nullptr;
    std::vector<std::vector<double>> values;
    double p = 1, effect = 0;
    std::optional<assessment::Interval> interval;
    std::string test;
};

/// Two levels: exact where small; more: Kruskal and Wallis.
std::optional<Comparison> compare(const Field& field, std::vector<std::vector<double>> values,
                                  const Levels& levels) {
    for (const auto& group : values)
        if (group.size() < kLeastPeople) return std::nullopt;
    Comparison found;
    found.field = &field;
    std::vector<double> all;
    for (const auto& group : values) all.insert(all.end(), group.begin(), group.end());
    if (*std::min_element(all.begin(), all.end()) == *std::max_element(all.begin(), all.end()))
        return std::nullopt;  // Nobody differs: there is nothing to compare.
    if (values.size() == 2) {
        const MannWhitney test = assessment::mann_whitney(values[1], values[0]);
        found.p = test.p_exact.value_or(test.p_asymptotic_cc);
        found.test = test.p_exact ? "exact Mann-Whitney" : "Mann-Whitney";
        found.effect = test.hedges_g;
        if (std::isfinite(test.hedges_g_ci95.low) && std::isfinite(test.hedges_g_ci95.high))
            found.interval = test.hedges_g_ci95;
    } else {
        std::vector<assessment::NamedGroup> groups;
        for (size_t i = 0; i < values.size(); ++i) groups.push_back({levels.names[i], values[i]});
        const auto test = assessment::kruskal_wallis(groups);
        found.p = test.p;
        found.effect = test.epsilon2;
        found.test = "Kruskal-Wallis";
    }
    if (!std::isfinite(found.effect)) return std::nullopt;
    found.values = std::move(values);
    return found;
}

std::string group_text(const std::vector<double>& values) {
    const auto mean = assessment::mean_of(values), sd = assessment::sample_sd(values);
    return rounded(*mean) + (sd ? " (" + rounded(*sd) + ")" : "") + ", n " +
           std::to_string(values.size());
}

Figure effects_figure(const std::vector<Comparison>& list, const std::vector<double>& holm,
                      const Levels& levels, const ChartStyle& style) {
    std::vector<ForestRow> rows;
    double low = -1, high = 1;
    for (size_t i = 0; i < list.size(); ++i) {
        ForestRow row;
        row.label = metric_label(*list[i].field);
        row.estimate = list[i].effect;
        row.no_interval = !list[i].interval;
        if (list[i].interval) row.low = list[i].interval->low, row.high = list[i].interval->high;
        row.note = "p " + p_words(list[i].p) + ", Holm " + p_words(holm[i]);
        low = std::min({low, row.estimate, row.low});
        high = std::max({high, row.estimate, row.high});
        rows.push_back(row);
    }
    // A wild interval of a small sample must not squeeze all others.
    low = std::max(low, -6.0), high = std::min(high, 6.0);
    for (ForestRow& row : rows)
        row.low = std::clamp(row.low, low, high), row.high = std::clamp(row.high, low, high),
        row.estimate = std::clamp(row.estimate, low, high);
    return forest_figure("construct_validity", levels.label + ": effect on the metrics",
                         levels.names.size() == 2
                             ? "Hedges' g (right: " + levels.names[1] + " is higher)"
                             : "epsilon squared",
                         rows, levels.names.size() == 2 ? low : 0, high, style);
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
        for (const auto& group : person_means(*attempts, *points, *levels))
            if (group.size() < kLeastPeople) return;
        list.push_back({id, field.label});
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
    std::vector<Comparison> list;
    for (const Field* field : metric_fields(*attempts))
        if (auto found = compare(*field, person_means(*attempts, *field, *levels), *levels))
            list.push_back(std::move(*found));
    if (list.empty()) {
        analysis.problem = "No metric has values of at least two people in every level of \"" +
                           levels->label + "\" that differ.";
        return analysis;
    }
    std::vector<double> p;
    for (const Comparison& each : list) p.push_back(each.p);
    const auto holm = assessment::holm_adjusted(p);
    const bool two = levels->names.size() == 2;
    analysis.method =
        "Levels: " + levels->label +
        ". Means of each person over the attempts, then compared between levels: mean (SD), n. " +
        (two ? "Hedges' g with its 95 % interval by the noncentral t distribution, positive where "
               "\"" +
                   levels->names[1] + "\" is higher; Mann-Whitney, exact up to 60 people."
             : std::string("Kruskal-Wallis, tie-corrected, with epsilon squared.")) +
        " p adjusted by Holm over " + std::to_string(list.size()) + " metrics.";
    analysis.head = {"metric"};
    for (const std::string& name : levels->names) analysis.head.push_back(name);
    analysis.head.insert(
        analysis.head.end(),
        two ? std::initializer_list<std::string>{"g", "95 % interval", "p", "p (Holm)"}
            : std::initializer_list<std::string>{"epsilon2", "p", "p (Holm)"});
    for (size_t i = 0; i < list.size(); ++i) {
        std::vector<AnalysisCell> row{{metric_label(*list[i].field), {}}};
        for (const auto& group : list[i].values)
            row.push_back({group_text(group), assessment::mean_of(group)});
        row.push_back({rounded(list[i].effect), list[i].effect});
        if (two) row.push_back({interval_words(list[i].interval), {}});
        row.push_back({p_words(list[i].p), list[i].p});
        row.push_back({p_words(holm[i]), holm[i]});
        analysis.rows.push_back(std::move(row));
    }
    analysis.figures.push_back(effects_figure(list, holm, *levels, style));
    std::vector<StripGroup> strips;
    const auto points = person_means(*attempts, *attempts->field("points"), *levels);
    for (size_t i = 0; i < levels->names.size(); ++i)
        strips.push_back({levels->names[i], points[i]});
    analysis.figures.push_back(strip_figure("construct_points", "Score by level",
                                            "score [points], mean of each person", strips, style));
    return analysis;
}

namespace {

/// Participant to (first, second) of one metric.
std::vector<std::vector<double>> pairs_of(const StudyReport& report, const Form& attempts,
                                          const Field& field, bool by_visit) {
    std::map<int64_t, int> visit;
    for (const db::StepRecord& step : report.steps)
        if (step.attempt_id > 0) visit[step.attempt_id] = step.visit;
    std::map<std::string, std::vector<double>> first, second, all;
    for (const Row& row : attempts.rows) {
        const auto value = value_of(row, field.id);
        if (!value || !row.counts) continue;
        all[row.participant].push_back(*value);
        const int when = visit.contains(row.attempt_id) ? visit[row.attempt_id] : 1;
        if (when == 1) first[row.participant].push_back(*value);
        if (when == 2) second[row.participant].push_back(*value);
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

}  // namespace

Analysis test_retest(const StudyReport& report, const ChartStyle& style) {
    Analysis analysis;
    analysis.id = "test_retest";
    analysis.title = "Test-retest reliability";
    const Form* attempts = report.data.form("attempts");
    bool by_visit = false;
    for (const db::StepRecord& step : report.steps)
        by_visit = by_visit || (step.visit == 2 && step.attempt_id > 0 && !step.superseded());
    struct Line {
        const Field* field;
        assessment::Icc icc;
        std::vector<double> first, second;
    };
    std::vector<Line> lines;
    if (attempts != nullptr) {
        for (const Field* field : metric_fields(*attempts)) {
            const auto pairs = pairs_of(report, *attempts, *field, by_visit);
            if (pairs.size() < 3) continue;
            Line line{field, {}, {}, {}};
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
    if (lines.empty()) {
        analysis.problem = "At least three people with two attempts each are needed.";
        return analysis;
    }
    analysis.method =
        std::string(by_visit ? "Means of the first against those of the second visit."
                             : "The last two attempts of everybody, because there is one visit.") +
        " ICC(2,1), absolute agreement, single measure, with its 95 % interval (Shrout & Fleiss); "
        "SEM: standard error of measurement; MDC95 = 1.96 sqrt(2) SEM: what a single person must "
        "change by to have changed.";
    analysis.head = {"metric", "n", "first", "second", "ICC(2,1)", "95 % interval", "SEM", "MDC95"};
    std::vector<ForestRow> forest;
    for (const Line& line : lines) {
        const double sem = line.icc.sem_agreement, mdc = 1.96 * std::sqrt(2.0) * sem;
        const auto& form = line.icc.icc2;
        analysis.rows.push_back({{metric_label(*line.field), {}},
                                 {std::to_string(line.icc.subjects), line.icc.subjects},
                                 {group_text(line.first), assessment::mean_of(line.first)},
                                 {group_text(line.second), assessment::mean_of(line.second)},
                                 {rounded(form.icc), form.icc},
                                 {interval_words(form.ci95), {}},
                                 {rounded(sem), sem},
                                 {rounded(mdc), mdc}});
        forest.push_back({metric_label(*line.field), std::clamp(form.icc, -1.0, 1.0),
                          std::clamp(form.ci95.low, -1.0, 1.0),
                          std::clamp(form.ci95.high, -1.0, 1.0),
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
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw ReportError("write " + analysis.title + " to " + folder +
                          ": cannot be made a folder");
    std::vector<std::string> paths{folder + "/" + analysis.id + "_table.csv"};
    save_file(paths.front(), analysis_csv(analysis));
    for (const Figure& figure : analysis.figures) {
        save_figure(figure, folder, demonstration);
        for (const char* ending : {".svg", ".png", ".csv"})
            paths.push_back(folder + "/" + file_name(figure.id) + ending);
    }
    return paths;
}

}  // namespace placode::reports
