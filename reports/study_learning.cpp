// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Learning curves with CUSUM, agreement of raters, and the parts that all analyses share.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "assessment/learning_curve.h"
#include "assessment/rating_block.h"
#include "assessment/standard_setting.h"
#include "assessment/statistics.h"
#include "reports/analysis_parts.h"
#include "reports/study_analysis.h"
#include "reports/text.h"

namespace placode::reports {

std::vector<const Field*> metric_fields(const Form& attempts) {
    std::vector<const Field*> fields;
    for (const Field& field : attempts.fields) {
        const bool told = field.id == "attempt_id" || field.id.ends_with("_version");
        if (field.kind == FieldKind::kDecimal && !told) fields.push_back(&field);
    }
    return fields;
}

std::string metric_label(const Field& field) {
    return field.label + (field.unit.empty() ? "" : " [" + field.unit + "]");
}

std::optional<double> value_of(const Row& row, const std::string& field) {
    const auto found = row.values.find(field);
    return found == row.values.end() ? std::nullopt : curriculum::answer_number(found->second);
}

RowsByTask counted_by_task(const Form& attempts) {
    RowsByTask tasks;
    for (const Row& row : attempts.rows) {
        if (!row.counts) continue;
        const auto task = row.values.find("task_id");
        tasks[task == row.values.end() ? std::string() : task->second].push_back(&row);
    }
    return tasks;
}

std::string task_before(const RowsByTask& all, const std::string& task) {
    return all.size() > 1 ? task + ": " : std::string();
}

std::string task_behind(const RowsByTask& all, const std::string& task) {
    return all.size() > 1 ? "_" + task : std::string();
}

std::optional<assessment::Icc> icc_of(const assessment::Scores& scores) {
    try {
        const auto icc = assessment::intraclass_correlation(scores);
        return std::isfinite(icc.icc2.icc) ? std::optional(icc) : std::nullopt;
    } catch (const std::invalid_argument&) {
        return std::nullopt;  // Nothing varies: there is nothing to agree on.
    }
}

std::string whole(double value) { return shortest_text(value); }

std::string rounded(double value) {
    if (!std::isfinite(value)) return "-";
    const double size = std::abs(value);
    const int decimals = size >= 100 ? 0 : size >= 10 ? 1 : 2;
    return number(value, decimals).toStdString();
}

std::string group_text(const std::vector<double>& values) {
    const auto mean = assessment::mean_of(values), sd = assessment::sample_sd(values);
    return rounded(*mean) + (sd ? " (" + rounded(*sd) + ")" : "") + ", n " +
           std::to_string(values.size());
}

std::string p_words(double p) { return p < 0.001 ? "< 0.001" : number(p, 3).toStdString(); }

std::string interval_words(const std::optional<assessment::Interval>& interval) {
    if (!interval || !std::isfinite(interval->low) || !std::isfinite(interval->high)) return "-";
    return rounded(interval->low) + " to " + rounded(interval->high);
}

namespace {

struct Learner {
    std::vector<double> points;
    std::vector<bool> failed;
};

std::map<std::string, Learner> learners_of(const std::vector<const Row*>& rows) {
    std::map<std::string, Learner> learners;
    for (const Row* row : rows) {
        const auto points = value_of(*row, "points");
        const auto verdict = row->values.find("verdict");
        if (!points || verdict == row->values.end()) continue;
        Learner& learner = learners[row->participant];
        learner.points.push_back(*points);
        learner.failed.push_back(verdict->second != "Passed");
    }
    return learners;
}

std::string cusum_words(const assessment::Cusum& cusum) {
    if (cusum.first_below_h0 > 0 &&
        (cusum.first_above_h1 == 0 || cusum.first_below_h0 < cusum.first_above_h1))
        return "acceptable from attempt " + std::to_string(cusum.first_below_h0);
    if (cusum.first_above_h1 > 0)
        return "unacceptable from attempt " + std::to_string(cusum.first_above_h1);
    return "undecided";
}

/// Whether the plateau is reached, or why that cannot be said.
std::string plateau_words(const assessment::LearningCurve& curve, bool fitted, size_t attempts) {
    if (attempts < assessment::kCurveFrom) return "too few attempts";
    if (curve.constant) return "all scores are equal";
    if (!fitted) return "no curve fits";
    return curve.plateau ? "yes" : "no";
}

/// A row for everybody who made attempts at one task. Returns the lines of its figure.
/// @param before of the names, where there are several tasks.
std::vector<LearningLine> fill_learners(const std::vector<const Row*>& rows,
                                        const std::string& before,
                                        const assessment::CusumLimits& limits, Analysis& analysis) {
    std::vector<LearningLine> lines;
    for (const auto& [code, learner] : learners_of(rows)) {
        lines.push_back({code, learner.points, learner.failed});
        const auto curve = assessment::learning_curve(learner.points);
        const auto chart = assessment::cusum(learner.failed, limits);
        const auto cell = [](double value) { return AnalysisCell{rounded(value), value}; };
        const bool fitted = learner.points.size() >= assessment::kCurveFrom && curve.exponential &&
                            curve.exponential->converged;
        const auto n = static_cast<double>(learner.points.size());
        analysis.rows.push_back(
            {{before + code, {}},
             {std::to_string(learner.points.size()), n},
             cell(learner.points.front()),
             cell(learner.points.back()),
             cell(*std::max_element(learner.points.begin(), learner.points.end())),
             {std::to_string(chart.failures), chart.failures},
             fitted ? cell(curve.exponential->asymptote) : AnalysisCell{"-", {}},
             fitted ? cell(curve.exponential->tau_trials) : AnalysisCell{"-", {}},
             {plateau_words(curve, fitted, learner.points.size()), {}},
             {cusum_words(chart), {}}});
    }
    return lines;
}

}  // namespace

Analysis learning_curves(const StudyReport& report, const ChartStyle& style) {
    Analysis analysis;
    analysis.id = "learning_curves";
    analysis.title = "Learning curves";
    const Form* attempts = report.data.form("attempts");
    const RowsByTask tasks = attempts == nullptr ? RowsByTask{} : counted_by_task(*attempts);
    if (attempts != nullptr) analysis.caution = versions_caution(*attempts);
    const auto limits = assessment::cusum_limits(0.05, 0.10, 0.05, 0.20);
    analysis.method =
        "Scores over attempts at a task; y = a - b exp(-(x - 1) / tau) by least squares from " +
        std::to_string(assessment::kCurveFrom) +
        " attempts on that are not all equal, plateau where 95 % of the gain is reached and the "
        "slope of the last 10 contains 0. CUSUM with p0 0.05, p1 0.10, alpha 0.05, beta 0.20 "
        "(limits h0 " +
        rounded(limits.h0_lower) + ", h1 " + rounded(limits.h1_upper) +
        "); an attempt that did not pass is a failure.";
    analysis.head = {"participant", "attempts", "first",           "last", "best", "failures",
                     "plateau a",   "tau",      "plateau reached", "CUSUM"};
    for (const auto& [task, rows] : tasks) {
        const std::string before = task_before(tasks, task);
        const auto lines = fill_learners(rows, before, limits, analysis);
        if (lines.empty()) continue;
        analysis.figures.push_back(learning_figure("learning_curves" + task_behind(tasks, task),
                                                   before + "Scores and CUSUM over attempts", lines,
                                                   report.pass_mark(task), limits, style));
    }
    if (analysis.rows.empty())
        analysis.problem = attempts == nullptr || attempts->rows.empty()
                               ? "There are no attempts yet."
                               : "There are attempts, but none of them counts.";
    return analysis;
}

namespace {

constexpr size_t kLeastAttempts = 3;  // Of an agreement; with fewer the report says so.

/// A scale or an item that raters judge: attempt, rater, value.
struct Judged {
    std::string label;
    assessment::RatingTable values;
};

struct Ratings {
    std::vector<Judged> judged;
    int count = 0, blinded = 0;
};

/// What the raters said of the attempts in `own`: scales first, then the items that have a scale.
Ratings ratings_of(const std::set<int64_t>& own, const std::vector<db::RatingRecord>& ratings,
                   const curriculum::Questionnaire& form) {
    Ratings found;
    auto& judged = found.judged;
    for (const auto& scale : form.scales) judged.push_back({scale.title.en, {}});
    for (const auto& item : form.items)
        if (item.kind == curriculum::ItemKind::kLikert) judged.push_back({item.text.en, {}});
    for (const db::RatingRecord& rating : ratings) {
        if (!own.contains(rating.attempt_id)) continue;
        ++found.count;
        found.blinded += rating.blinded ? 1 : 0;
        size_t at = 0;
        for (const auto& score : curriculum::scale_scores(form, rating.answers)) {
            if (score.value) judged[at].values[rating.attempt_id][rating.rater_id] = *score.value;
            ++at;
        }
        for (const auto& item : form.items) {
            if (item.kind != curriculum::ItemKind::kLikert) continue;
            const auto answer = rating.answers.find(item.id);
            const auto value = answer == rating.answers.end()
                                   ? std::nullopt
                                   : curriculum::answer_number(answer->second);
            if (value) judged[at].values[rating.attempt_id][rating.rater_id] = *value;
            ++at;
        }
    }
    return found;
}

/// A row and a mark of the figure for all that at least two raters judged completely.
std::vector<ForestRow> fill_agreement(const std::vector<Judged>& judged, Analysis& analysis) {
    std::vector<ForestRow> forest;
    for (const Judged& each : judged) {
        const auto block = assessment::complete_block(each.values, kLeastAttempts);
        if (block.scores.empty()) continue;
        const auto found = icc_of(block.scores);
        if (!found) continue;
        const assessment::Icc& icc = *found;
        const auto cell = [](double value) { return AnalysisCell{rounded(value), value}; };
        analysis.rows.push_back({{each.label, {}},
                                 {std::to_string(icc.subjects), icc.subjects},
                                 {std::to_string(icc.raters), icc.raters},
                                 cell(icc.icc2.icc),
                                 {interval_words(icc.icc2.ci95), {}},
                                 cell(icc.icc2k.icc),
                                 cell(icc.icc3.icc),
                                 cell(icc.sem_agreement)});
        const assessment::Interval& ci = icc.icc2.ci95;
        forest.push_back({each.label, icc.icc2.icc, ci.low, ci.high,
                          std::to_string(icc.raters) + " raters, n " + std::to_string(icc.subjects),
                          !std::isfinite(ci.low) || !std::isfinite(ci.high)});
    }
    return forest;
}

}  // namespace

Analysis rater_agreement(const StudyReport& report, const std::vector<db::RatingRecord>& ratings,
                         const curriculum::Questionnaire& form, const ChartStyle& style) {
    Analysis analysis;
    analysis.id = "rater_agreement";
    analysis.title = "Agreement of raters";
    std::set<int64_t> own;
    if (const Form* attempts = report.data.form("attempts"))
        for (const Row& row : attempts->rows)
            if (row.counts) own.insert(row.attempt_id);
    const Ratings found = ratings_of(own, ratings, form);
    const std::string count = std::to_string(found.count);
    analysis.method = form.title.en + ": " + count +
                      " ratings of this study's "
                      "attempts, " +
                      std::to_string(found.blinded) +
                      " of them blinded. The largest block that the same raters have judged "
                      "completely; ICC of Shrout & Fleiss with 95 % intervals: (2,1) and (2,k) "
                      "absolute agreement, (3,1) consistency; SEM in points of the scale.";
    analysis.head = {"rated",         "attempts", "raters",   "ICC(2,1)",
                     "95 % interval", "ICC(2,k)", "ICC(3,1)", "SEM"};
    const std::vector<ForestRow> forest = fill_agreement(found.judged, analysis);
    if (analysis.rows.empty())
        analysis.problem =
            "At least three attempts of this study that the same two raters have judged are "
            "needed; "
            "there are " +
            count +
            " ratings. Raters find their queue on the page "
            "Ratings.";
    else
        analysis.figures.push_back(forest_figure("rater_agreement", "Agreement of raters",
                                                 "ICC(2,1), absolute agreement", forest, -1, 1,
                                                 style));
    return analysis;
}

}  // namespace placode::reports
