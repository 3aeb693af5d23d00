// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of standards and learning: contrasting groups, Angoff, CUSUM, learning curves.

#include <algorithm>
#include <numeric>

#include "assessment/learning_curve.h"
#include "assessment/standard_setting.h"
#include "ui/cli/stats_table.h"

namespace placode::cli {
namespace {

Json contrasting(const StatsTable& table, const StatsOptions& options) {
    int missing = 0;
    const auto groups = groups_of(table, options, missing);
    const size_t comma = options.groups.find(',');
    if (comma == std::string::npos)
        throw InputError(
            "contrasting-groups: say which group is which with --groups NOVICES,EXPERTS");
    const auto values = [&](const std::string& name) {
        for (const auto& group : groups) {
            if (group.name == name) return group.values;
        }
        throw InputError(table.path + ": there is no group \"" + name + "\"");
    };
    const std::string novices = options.groups.substr(0, comma),
                      experts = options.groups.substr(comma + 1);
    const assessment::ContrastingGroups r =
        assessment::contrasting_groups(values(novices), values(experts));
    const auto scores = values(novices);
    const double limit = r.mean_expert - 2 * r.sd_expert;
    const auto passing =
        std::count_if(scores.begin(), scores.end(), [&](double score) { return score >= limit; });
    return {{"novices_pass_expert_mean_minus_2sd", static_cast<double>(passing) / r.n_novice},
            {"novice_group", novices},
            {"expert_group", experts},
            {"n", {r.n_novice, r.n_expert}},
            {"missing", missing},
            {"missing_rule", "rows left out"},
            {"mean", {r.mean_novice, r.mean_expert}},
            {"sd", {r.sd_novice, r.sd_expert}},
            {"roots", r.roots},
            {"cut_score", r.cut_score},
            {"theoretical_false_positive", r.theoretical_false_positive},
            {"theoretical_false_negative", r.theoretical_false_negative},
            {"observed_false_positive", r.observed_false_positive},
            {"observed_false_negative", r.observed_false_negative},
            {"auc", r.auc},
            {"mannwhitney_p_cc", r.mannwhitney_p_cc},
            {"cohens_d", r.cohens_d},
            {"pbp_benchmark_expert_mean", r.mean_expert},
            {"expert_mean_minus_1sd", r.mean_expert - r.sd_expert},
            {"expert_mean_minus_2sd", r.mean_expert - 2 * r.sd_expert}};
}

Json angoff(const StatsTable& table, const StatsOptions&) {
    // One row a judge, one column an item; a leading column "judge" is a name.
    const size_t first = table.header[0] == "judge" ? 1 : 0;
    std::vector<std::vector<double>> probability;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        probability.emplace_back();
        for (size_t column = first; column < table.header.size(); ++column)
            probability.back().push_back(table.needed(row, column));
    }
    const assessment::Angoff r = assessment::angoff(probability);
    return {{"n", r.judges},
            {"items", r.items},
            {"missing", 0},
            {"judge_totals", r.judge_totals},
            {"cut_score_items", r.cut_score_items},
            {"cut_percent", r.cut_percent},
            {"sd_judges", r.sd_judges},
            {"se_cut", r.se_cut}};
}

/// Scores of each subject in order of the trials.
struct Series {
    std::vector<std::pair<std::string, std::vector<double>>> subjects;
    int missing = 0;
};
Series series_of(const StatsTable& table, const StatsOptions& options) {
    const size_t score = table.column(options.value.empty() ? "score" : options.value);
    const bool named = table.has("subject"), ordered = table.has("trial");
    std::vector<std::string> names;
    std::map<std::string, std::vector<std::pair<double, double>>> points;
    Series series;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const auto value = table.number(row, score);
        if (!value) {
            ++series.missing;
            continue;
        }
        const std::string name = named ? table.rows[row][table.column("subject")] : "all";
        if (!points.contains(name)) names.push_back(name);
        points[name].push_back(
            {ordered ? table.needed(row, table.column("trial")) : static_cast<double>(row),
             *value});
    }
    for (const std::string& name : names) {
        auto& list = points[name];
        std::stable_sort(list.begin(), list.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        series.subjects.push_back({name, {}});
        for (const auto& [trial, value] : list) series.subjects.back().second.push_back(value);
    }
    return series;
}

std::vector<bool> failures(const std::vector<double>& scores, double success_at) {
    std::vector<bool> failed;
    for (const double score : scores) failed.push_back(score < success_at);
    return failed;
}

Json cusum(const StatsTable& table, const StatsOptions& options) {
    const Series series = series_of(table, options);
    const assessment::CusumLimits l =
        assessment::cusum_limits(options.p0, options.p1, options.alpha, options.beta);
    Json subjects = Json::object();
    for (const auto& [name, scores] : series.subjects) {
        const assessment::Cusum c = assessment::cusum(failures(scores, options.success_at), l);
        subjects[name] = {{"n", scores.size()},
                          {"failures", c.failures},
                          {"cusum_final", c.path.back()},
                          {"cusum_max", *std::max_element(c.path.begin(), c.path.end())},
                          {"cusum_min", *std::min_element(c.path.begin(), c.path.end())},
                          {"first_above_h1", c.first_above_h1 ? Json(c.first_above_h1) : Json()},
                          {"first_below_h0", c.first_below_h0 ? Json(c.first_below_h0) : Json()},
                          {"path", c.path}};
        Json at = Json::array();
        for (const size_t trial : {10, 50, 100})
            at.push_back(trial <= c.path.size() ? Json(c.path[trial - 1]) : Json());
        subjects[name]["cusum_at_10_50_100"] = at;
    }
    return {{"n", series.subjects.size()},
            {"missing", series.missing},
            {"missing_rule", "rows left out"},
            {"success_rule", "score >= " + shortest(options.success_at)},
            {"cusum_parameters",
             {{"p0", l.p0},
              {"p1", l.p1},
              {"alpha", l.alpha},
              {"beta", l.beta},
              {"P", l.p},
              {"Q", l.q},
              {"s", l.s},
              {"h0_lower", l.h0_lower},
              {"h1_upper", l.h1_upper}}},
            {"subjects", subjects}};
}

Json lc_cusum(const StatsTable& table, const StatsOptions& options) {
    const Series series = series_of(table, options);
    Json subjects = Json::object(), parameters;
    for (const auto& [name, scores] : series.subjects) {
        const assessment::LcCusum c = assessment::lc_cusum(
            failures(scores, options.success_at), options.adequate, options.inadequate, options.h);
        parameters = {{"p_adequate", options.adequate},
                      {"p_inadequate", options.inadequate},
                      {"h", options.h},
                      {"w_failure", c.w_failure},
                      {"w_success", c.w_success}};
        subjects[name] = {{"n", scores.size()},
                          {"lc_final", c.path.back()},
                          {"lc_max", *std::max_element(c.path.begin(), c.path.end())},
                          {"lc_first_reach_h", c.first_reach_h ? Json(c.first_reach_h) : Json()},
                          {"path", c.path}};
    }
    return {{"n", series.subjects.size()},
            {"missing", series.missing},
            {"missing_rule", "rows left out"},
            {"success_rule", "score >= " + shortest(options.success_at)},
            {"lc_cusum", parameters},
            {"subjects", subjects}};
}

Json curve_of(const std::vector<double>& scores) {
    const assessment::LearningCurve c = assessment::learning_curve(scores);
    Json json{{"n", c.n}, {"exp_fit", Json()}, {"power_loglog", Json()}};
    if (c.exponential) {
        const auto& e = *c.exponential;
        json["exp_fit"] = {{"asymptote", e.asymptote},
                           {"gain", e.gain},
                           {"tau_trials", e.tau_trials},
                           {"rss", e.rss},
                           {"r2", e.r2},
                           {"se", {{"a", e.se_asymptote}, {"b", e.se_gain}, {"c", e.se_tau}}},
                           {"trial_to_95pct_of_gain", e.trial_to_95pct_of_gain},
                           {"aic", e.aic},
                           {"converged", e.converged}};
    }
    if (c.power)
        json["power_loglog"] = {{"log_a", c.power->log_a},
                                {"b", c.power->b},
                                {"r2", c.power->r2},
                                {"n_positive", c.power->n_positive}};
    json["mean_first10"] = c.mean_first10;
    json["mean_last10"] = c.mean_last10;
    if (scores.size() >= 50)
        json["moving_avg10_at_50"] =
            std::accumulate(scores.begin() + 40, scores.begin() + 50, 0.0) / 10;
    json["last10_slope_ci95"] =
        c.last10_slope_ci95 ? Json::array({c.last10_slope_ci95->low, c.last10_slope_ci95->high})
                            : Json();
    json["plateau"] = c.plateau;
    return json;
}

Json learning(const StatsTable& table, const StatsOptions& options) {
    const Series series = series_of(table, options);
    Json subjects = Json::object();
    for (const auto& [name, scores] : series.subjects) subjects[name] = curve_of(scores);
    return {{"n", series.subjects.size()},
            {"missing", series.missing},
            {"missing_rule", "rows left out"},
            {"subjects", subjects}};
}

}  // namespace

std::map<std::string, StatsFunction> learning_statistics() {
    return {{"contrasting-groups", contrasting},
            {"angoff", angoff},
            {"cusum", cusum},
            {"lc-cusum", lc_cusum},
            {"learning-curve", learning}};
}

}  // namespace placode::cli
