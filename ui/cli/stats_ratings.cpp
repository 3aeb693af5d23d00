// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of ratings: Likert items, internal consistency, agreement, content validity.

#include <algorithm>
#include <cmath>

#include "assessment/bootstrap.h"
#include "assessment/content_validity.h"
#include "assessment/correlation.h"
#include "assessment/statistics.h"
#include "ui/cli/stats_table.h"

namespace placode::cli {
namespace {

constexpr double kWidestGuess = 100;  ///< Larger answers need --scale.

Json likert_item(const std::vector<double>& answers, int missing, const Scale& scale) {
    std::vector<std::optional<int>> values;
    for (const double answer : answers) values.emplace_back(static_cast<int>(answer));
    const auto s = assessment::summarise_likert(values, scale.low, scale.high);
    Json item{{"n", s.n}, {"missing", missing}};
    if (s.n == 0) return item;
    item["mean"] = *s.mean;
    item["sd_sample"] = s.sd ? Json(*s.sd) : Json();
    item["sd_population"] = *s.sd_population;
    item["median"] = *s.median;
    item["q1_type7"] = *s.lower_quartile;
    item["q3_type7"] = *s.upper_quartile;
    item["iqr_type7"] = *s.upper_quartile - *s.lower_quartile;
    item["q1_type6"] = *s.lower_quartile_type6;
    item["q3_type6"] = *s.upper_quartile_type6;
    item["iqr_type6"] = *s.upper_quartile_type6 - *s.lower_quartile_type6;
    item["mad_raw"] = *s.mad;
    item["top2_count"] = s.top2;
    item["top2_percent"] = *s.top2_percent;
    Json counts = Json::object();
    for (int value = scale.low; value <= scale.high; ++value)
        counts[std::to_string(value)] = s.counts[static_cast<size_t>(value - scale.low)];
    item["counts"] = counts;
    return item;
}

/// What the items say together, over complete cases with reverse-keyed items turned round on the
/// scale that is reported.
void add_scale(Json& json, const StatsTable& table, const StatsOptions& options,
               const Scale& scale) {
    CompleteCases cases;
    try {
        cases = complete_cases(table, options, scale);
    } catch (const InputError&) {
        if (!options.reverse.empty()) throw;
        return;  // No row is complete: the items stand alone.
    }
    const size_t n = cases.scores.size(), k = cases.items.size();
    if (n < 2) return;
    json["reverse_keyed"] = options.reverse;
    json["complete_cases"] = n;
    std::vector<std::vector<double>> items(k);
    std::vector<double> means;
    for (const auto& row : cases.scores) {
        for (size_t i = 0; i < k; ++i) items[i].push_back(row[i]);
        means.push_back(*assessment::mean_of(row));
    }
    Json matrix = Json::object();
    for (size_t i = 0; i < k; ++i) {
        const auto ranks = assessment::mid_ranks(items[i]);
        Json line = Json::array();
        for (size_t j = 0; j < k; ++j)
            line.push_back(assessment::pearson(ranks, assessment::mid_ranks(items[j])));
        matrix[cases.items[i]] = line;
    }
    json["spearman_matrix"] = matrix;
    const double sd = *assessment::sample_sd(means);
    json["scale_mean"] = {{"mean", *assessment::mean_of(means)}, {"sd", sd}, {"sem", Json()}};
    CompleteCases varying = cases;
    leave_out_constant(varying);
    if (n > 2 && varying.items.size() > 1) {
        const double alpha = assessment::cronbach_alpha(varying.scores).raw;
        if (alpha <= 1) json["scale_mean"]["sem"] = sd * std::sqrt(1 - alpha);
    }
    const assessment::Friedman f = assessment::friedman(cases.scores);
    json["friedman"] = {
        {"chisq", f.chi_square}, {"df", f.df}, {"p", f.p}, {"kendall_W", f.kendall_w}};
}

Json likert(const StatsTable& table, const StatsOptions& options) {
    // Either one column an item, or long rows with the columns item and response.
    std::vector<std::string> names;
    std::map<std::string, std::vector<double>> answers;
    std::map<std::string, int> missing;
    const bool is_long = table.has("item") && table.has("response");
    const auto take = [&](const std::string& name, std::optional<double> answer) {
        if (!answers.contains(name)) names.push_back(name);
        auto& list = answers[name];
        if (answer)
            list.push_back(*answer);
        else
            ++missing[name];
    };
    for (size_t row = 0; row < table.rows.size(); ++row) {
        if (is_long) {
            take(table.rows[row][table.column("item")],
                 table.number(row, table.column("response")));
            continue;
        }
        for (size_t column = 0; column < table.header.size(); ++column)
            take(table.header[column], table.number(row, column));
    }
    Scale scale{1, 5};
    if (!options.scale.empty()) {
        scale = scale_of(table, options);
    } else {
        for (const auto& [name, list] : answers) {
            for (const double answer : list)
                if (answer <= kWidestGuess)
                    scale.high = std::max(scale.high, static_cast<int>(std::ceil(answer)));
        }
    }
    Json items = Json::object();
    for (const std::string& name : names) {
        for (const double answer : answers[name]) {
            if (answer >= scale.low && answer <= scale.high && answer == std::floor(answer))
                continue;
            throw InputError(table.path + ": item " + name + ": " + shortest(answer) +
                             " is not on the scale " + std::to_string(scale.low) + " to " +
                             std::to_string(scale.high) + "; give the scale, e.g. --scale 1:7");
        }
        items[name] = likert_item(answers[name], missing[name], scale);
    }
    Json json{{"scale", {scale.low, scale.high}},
              {"sd", "sample (n-1) and population"},
              {"missing_rule", "left out item by item"},
              {"items", items}};
    if (!is_long && names.size() > 1) add_scale(json, table, options, scale);
    return json;
}

Json alpha(const StatsTable& table, const StatsOptions& options) {
    CompleteCases cases = complete_cases(table, options);
    leave_out_constant(cases);
    const assessment::Alpha a = assessment::cronbach_alpha(cases.scores);
    Json dropped = Json::object(), item_total = Json::object();
    for (size_t i = 0; i < cases.items.size(); ++i) {
        if (!a.alpha_if_dropped.empty()) dropped[cases.items[i]] = a.alpha_if_dropped[i];
        item_total[cases.items[i]] = a.corrected_item_total_r[i];
    }
    return {{"n", a.n},
            {"k", a.k},
            {"missing", cases.missing},
            {"missing_rule", "complete cases"},
            {"left_out_constant", cases.constant},
            {"raw", a.raw},
            {"standardized", a.standardized},
            {"G6", a.g6 ? Json(*a.g6) : Json()},
            {"mean_interitem_r", a.mean_interitem_r},
            {"ase", a.ase},
            {"feldt_ci95", interval(a.feldt_ci95)},
            {"duhachek_ci95", interval(a.duhachek_ci95)},
            {"alpha_if_dropped", dropped},
            {"corrected_item_total_r", item_total}};
}

Json omega(const StatsTable& table, const StatsOptions& options) {
    CompleteCases cases = complete_cases(table, options);
    leave_out_constant(cases);
    const assessment::Omega o = assessment::mcdonald_omega(cases.scores);
    Json loadings = Json::object(), theta = Json::object();
    // Maximum likelihood divides by n, as lavaan does.
    const double n = static_cast<double>(cases.scores.size()), scale = (n - 1) / n;
    for (size_t i = 0; i < cases.items.size(); ++i) {
        loadings[cases.items[i]] = o.loadings[i] * std::sqrt(scale);
        theta[cases.items[i]] = o.theta[i] * scale;
    }
    return {{"n", cases.scores.size()},
            {"missing", cases.missing},
            {"missing_rule", "complete cases"},
            {"left_out_constant", cases.constant},
            {"value", o.total_ml},
            {"method", "one factor, maximum likelihood on covariances"},
            {"converged", o.converged},
            {"omega_total_cfa", {{"value", o.total_ml}, {"loadings", loadings}, {"theta", theta}}},
            {"omega_total_minres", {{"value", o.total_minres}}}};
}

Json icc_form(const assessment::IccForm& form) {
    return {{"icc", form.icc}, {"F", form.f},         {"df1", form.df1},     {"df2", form.df2},
            {"p", form.p},     {"lo", form.ci95.low}, {"hi", form.ci95.high}};
}

Json icc(const StatsTable& table, const StatsOptions& options) {
    const CompleteCases cases = complete_cases(table, options);
    const assessment::Icc r = assessment::intraclass_correlation(cases.scores);
    return {{"n", r.subjects},
            {"raters", r.raters},
            {"missing", cases.missing},
            {"missing_rule", "complete cases"},
            {"ci", "95 %, F distribution; ICC2 by Satterthwaite"},
            {"results",
             {{"ICC1", icc_form(r.icc1)},
              {"ICC1k", icc_form(r.icc1k)},
              {"ICC2", icc_form(r.icc2)},
              {"ICC2k", icc_form(r.icc2k)},
              {"ICC3", icc_form(r.icc3)},
              {"ICC3k", icc_form(r.icc3k)}}},
            {"by_label",
             {{"ICC1", r.icc1.icc},
              {"ICC2", r.icc2.icc},
              {"ICC3", r.icc3.icc},
              {"ICC1k", r.icc1k.icc},
              {"ICC2k", r.icc2k.icc},
              {"ICC3k", r.icc3k.icc}}},
            {"anova",
             {{"MSR", r.ms_rows},
              {"MSC", r.ms_columns},
              {"MSE", r.ms_error},
              {"icc21", r.icc2.icc},
              {"icc2k", r.icc2k.icc},
              {"icc31", r.icc3.icc},
              {"icc3k", r.icc3k.icc},
              {"SEM_agreement", r.sem_agreement},
              {"SEM_consistency", r.sem_consistency}}}};
}

Json content(const StatsTable& table, const StatsOptions&) {
    const size_t item_column = table.column("item");
    std::vector<std::string> names;
    std::vector<std::vector<int>> ratings;
    int missing = 0;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        names.push_back(table.rows[row][item_column]);
        ratings.emplace_back();
        for (size_t column = 0; column < table.header.size(); ++column) {
            if (column == item_column) continue;
            const auto value = table.number(row, column);
            if (!value)
                ++missing;
            else
                ratings.back().push_back(static_cast<int>(*value));
        }
    }
    const assessment::ContentValidity v = assessment::content_validity(names, ratings);
    Json items = Json::array();
    for (const auto& item : v.items) {
        const assessment::CriticalCvr critical = assessment::critical_cvr(item.experts);
        const auto as_number = [](const std::string& text) {
            return Json::accept(text) ? Json::parse(text) : Json(text);
        };
        items.push_back({{"item", as_number(item.item)},
                         {"experts", item.experts},
                         {"agree", item.agree},
                         {"i_cvi", item.i_cvi},
                         {"pc", item.pc},
                         {"modified_kappa", item.modified_kappa},
                         {"n_essential_as_4", item.essential},
                         {"cvr_lawshe", item.cvr_lawshe},
                         {"n_critical", critical.n_critical},
                         {"cvr_critical", critical.cvr_critical}});
    }
    Json lawshe = Json::object();
    for (int experts = 5; experts <= 40; ++experts) {
        const assessment::CriticalCvr c = assessment::critical_cvr(experts);
        lawshe[std::to_string(experts)] = {{"n_critical", c.n_critical},
                                           {"cvr_critical", c.cvr_critical},
                                           {"one_tailed_p", c.one_tailed_p}};
    }
    return {{"lawshe_exact_binomial_critical_alpha0.05_one_tailed", lawshe},
            {"N_experts", v.n_experts},
            {"n", v.items.size()},
            {"missing", missing},
            {"missing_rule", "left out item by item"},
            {"items", items},
            {"s_cvi_ave", v.s_cvi_ave},
            {"s_cvi_ua", v.s_cvi_ua},
            {"mean_cvr", v.mean_cvr},
            {"relevant_rule",
             "rating>=3 on 1..4; essential=4 used for CVR; critical CVR by the exact one-tailed "
             "binomial at .05"}};
}

}  // namespace

std::map<std::string, StatsFunction> rating_statistics() {
    return {{"likert", likert}, {"alpha", alpha}, {"omega", omega},
            {"icc", icc},       {"cvi", content}, {"cvr", content}};
}

}  // namespace placode::cli
