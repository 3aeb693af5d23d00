// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of groups and pairs: ranks, correlation, ROC, bootstrap.

#include <algorithm>

#include "assessment/bootstrap.h"
#include "assessment/correlation.h"
#include "assessment/roc.h"
#include "assessment/statistics.h"
#include "ui/cli/stats_table.h"

namespace placode::cli {
namespace {

Json mann_whitney(const StatsTable& table, const StatsOptions& options) {
    int missing = 0;
    auto groups = groups_of(table, options, missing);
    std::string first, second;
    if (!options.groups.empty()) {
        const size_t comma = options.groups.find(',');
        if (comma == std::string::npos)
            throw InputError("--groups: found \"" + options.groups + "\", expected FIRST,SECOND");
        first = options.groups.substr(0, comma);
        second = options.groups.substr(comma + 1);
    } else if (groups.size() == 2) {
        first = groups[0].name;
        second = groups[1].name;
    } else {
        throw InputError(table.path + ": found " + std::to_string(groups.size()) +
                         " groups; name two of them with --groups FIRST,SECOND");
    }
    const auto values = [&](const std::string& name) {
        for (const auto& group : groups) {
            if (group.name == name) return group.values;
        }
        throw InputError(table.path + ": there is no group \"" + name + "\"");
    };
    const assessment::MannWhitney r = assessment::mann_whitney(values(first), values(second));
    return {{"group1", first},
            {"group2", second},
            {"n", r.n1 + r.n2},
            {"n1", r.n1},
            {"n2", r.n2},
            {"missing", missing},
            {"missing_rule", "rows left out"},
            {"U1", r.u1},
            {"U2", r.u2},
            {"p_asymptotic_cc", r.p_asymptotic_cc},
            {"p_asymptotic_nocc", r.p_asymptotic_nocc},
            {"p_exact_permutation_with_ties_coin", optional_number(r.p_exact)},
            {"z_nocc", r.z},
            {"r_abs_z_over_sqrtN", r.r},
            {"A12", r.a12},
            {"cliffs_delta", r.cliffs_delta},
            {"rank_biserial_effectsize", r.cliffs_delta},
            {"hodges_lehmann", r.hodges_lehmann},
            {"hl_ci95", interval(r.hodges_lehmann_ci95)},
            {"hl_ci95_method",
             "inversion of the test, normal approximation with continuity correction"},
            {"cohens_d", r.cohens_d},
            {"cohens_d_ci95", interval(r.cohens_d_ci95)},
            {"hedges_g", r.hedges_g},
            {"hedges_g_ci95", interval(r.hedges_g_ci95)},
            {"d_ci95_method", "noncentral t"},
            {"glass_delta_sd_group2", r.glass_delta},
            {"welch_t", r.welch_t},
            {"welch_df", r.welch_df},
            {"welch_p", r.welch_p},
            {"mean1", r.mean1},
            {"sd1", r.sd1},
            {"mean2", r.mean2},
            {"sd2", r.sd2}};
}

Json kruskal(const StatsTable& table, const StatsOptions& options) {
    int missing = 0;
    const assessment::KruskalWallis r =
        assessment::kruskal_wallis(groups_of(table, options, missing));
    Json dunn = Json::array();
    for (const auto& pair : r.dunn) {
        dunn.push_back({{"g1", pair.group1},
                        {"g2", pair.group2},
                        {"z", pair.z},
                        {"p", pair.p},
                        {"p_holm", pair.p_holm},
                        {"p_bonferroni", pair.p_bonferroni}});
    }
    return {{"n", r.n},
            {"missing", missing},
            {"missing_rule", "rows left out"},
            {"H", r.h},
            {"df", r.df},
            {"p", r.p},
            {"epsilon2", r.epsilon2},
            {"eta2_H", r.eta2_h},
            {"dunn", dunn}};
}

/// Complete pairs of two columns.
std::pair<std::vector<double>, std::vector<double>> pairs(const StatsTable& table, size_t a,
                                                          size_t b, int& missing) {
    std::pair<std::vector<double>, std::vector<double>> result;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const auto x = table.number(row, a), y = table.number(row, b);
        if (!x || !y) {
            ++missing;
            continue;
        }
        result.first.push_back(*x);
        result.second.push_back(*y);
    }
    return result;
}

std::pair<size_t, size_t> two_columns(const StatsTable& table, const char* first,
                                      const char* second) {
    if (table.has(first) && table.has(second)) return {table.column(first), table.column(second)};
    if (table.header.size() == 2) return {0, 1};
    return {table.column(first), table.column(second)};
}

Json wilcoxon(const StatsTable& table, const StatsOptions& options) {
    int missing = 0;
    if (options.digits < 0 || options.digits > 15)
        throw InputError("--digits: found " + std::to_string(options.digits) +
                         ", expected 1 to 15, or 0 for an exact comparison");
    const auto [a, b] = two_columns(table, "before", "after");
    const auto [before, after] = pairs(table, a, b, missing);
    const assessment::WilcoxonPaired r = assessment::wilcoxon_paired(before, after, options.digits);
    return {{"V", r.v},
            {"n", r.n},
            {"n_nonzero", r.n_nonzero},
            {"missing", missing},
            {"missing_rule", "pairs left out"},
            {"ties", options.digits > 0 ? "differences rounded to " +
                                              std::to_string(options.digits) + " significant digits"
                                        : "exact comparison"},
            {"p_cc", r.p_cc},
            {"p_nocc", r.p_nocc},
            {"z_wilcoxon_zero", r.z},
            {"p_exact_wilcoxon_zero", optional_number(r.p_exact)},
            {"z_pratt", r.z_pratt},
            {"p_pratt", r.p_pratt},
            {"matched_rank_biserial", r.matched_rank_biserial},
            {"r_abs_z_over_sqrt_nonzero", r.r},
            {"cohens_dz", r.cohens_dz},
            {"paired_t", r.paired_t},
            {"paired_t_p", r.paired_t_p}};
}

Json spearman(const StatsTable& table, const StatsOptions&) {
    int missing = 0;
    const auto [a, b] = two_columns(table, "x", "y");
    const auto [x, y] = pairs(table, a, b, missing);
    const assessment::Correlation r = assessment::correlation(x, y);
    return {{"n", r.n},
            {"missing", missing},
            {"missing_rule", "pairs left out"},
            {"spearman", r.spearman},
            {"spearman_p_t_approx", r.spearman_p_t_approx},
            {"spearman_S", r.spearman_s},
            {"spearman_ci95_bonett_wright", interval(r.spearman_ci95)},
            {"kendall_tau_b", r.kendall_tau_b},
            {"kendall_p", r.kendall_p},
            {"pearson", r.pearson},
            {"pearson_p", r.pearson_p},
            {"pearson_ci95", interval(r.pearson_ci95)}};
}

Json roc(const StatsTable& table, const StatsOptions& options) {
    if (options.positive.empty())
        throw InputError("roc: say which value of column " + table.header[0] +
                         " is positive, e.g. --positive " + table.rows[0][0]);
    if (table.header.size() < 2)
        throw InputError(table.path +
                         ": expected a column with the class and at least one predictor");
    Json result{{"response", table.header[0]},
                {"positive", options.positive},
                {"ci_method", "DeLong, 95 %"}};
    std::vector<assessment::Roc> curves;
    int missing = 0;
    std::vector<size_t> complete;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        bool whole = !table.rows[row][0].empty();
        for (size_t column = 1; column < table.header.size(); ++column)
            whole = whole && table.number(row, column).has_value();
        whole ? complete.push_back(row) : static_cast<void>(++missing);
    }
    for (size_t column = 1; column < table.header.size(); ++column) {
        std::vector<double> values;
        std::vector<bool> positive;
        for (const size_t row : complete) {
            values.push_back(*table.number(row, column));
            positive.push_back(table.rows[row][0] == options.positive);
        }
        const assessment::Roc r = assessment::roc(values, positive);
        curves.push_back(r);
        result[table.header[column]] = {
            {"auc", r.auc},
            {"delong_se", r.delong_se},
            {"delong_ci95_unclipped", interval(r.delong_ci95_unclipped)},
            {"delong_ci95", interval(r.delong_ci95)},
            {"youden_threshold", r.youden_threshold},
            {"sens", r.sensitivity},
            {"spec", r.specificity}};
        result["n"] = values.size();
        result["n_positive"] = r.positives;
    }
    result["missing"] = missing;
    result["missing_rule"] = "rows left out";
    if (curves.size() == 2) {
        const assessment::RocComparison paired = assessment::compare_paired(curves[0], curves[1]);
        result["paired_delong_1_vs_2"] = {{"z", paired.z}, {"p", paired.p}};
    }
    return result;
}

double mean_of(std::span<const double> values) { return *assessment::mean_of(values); }

constexpr int64_t kMostDraws = 400'000'000;  ///< Some seconds of work.

Json bootstrap(const StatsTable& table, const StatsOptions& options) {
    const size_t column = options.value.empty() ? 0 : table.column(options.value);
    std::vector<double> values;
    int missing = 0;
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const auto value = table.number(row, column);
        value ? values.push_back(*value) : static_cast<void>(++missing);
    }
    if (options.statistic != "mean" && options.statistic != "median")
        throw InputError("--statistic: found \"" + options.statistic +
                         "\", expected mean or median");
    const auto most = kMostDraws / static_cast<int64_t>(std::max<size_t>(1, values.size()));
    if (values.size() > 7 && options.resamples > most)
        throw InputError("--resamples: found " + std::to_string(options.resamples) +
                         ", expected at most " + std::to_string(most) + " for " +
                         std::to_string(values.size()) + " values");
    const assessment::Bootstrap mean =
        assessment::bootstrap(values, mean_of, options.resamples, options.seed);
    const assessment::Bootstrap median =
        assessment::bootstrap(values, assessment::median_of, options.resamples, options.seed);
    const assessment::Bootstrap& chosen = options.statistic == "mean" ? mean : median;
    return {{"n", mean.n},
            {"missing", missing},
            {"missing_rule", "left out"},
            {"method", mean.exact ? "exact: every resample enumerated" : "Monte Carlo"},
            {mean.exact ? "enumerated" : "resamples", mean.resamples},
            {"seed", options.seed},
            {"statistic", options.statistic},
            {"estimate", chosen.estimate},
            {"ci95", interval(chosen.percentile95)},
            {"ci95_method", "percentile, type 7"},
            {"mean", mean.estimate},
            {"mean_pctl_025", mean.percentile95.low},
            {"mean_pctl_975", mean.percentile95.high},
            {"mean_boot_sd", mean.boot_sd},
            {"bca_z0_exact_strict", mean.bca_z0},
            {"bca_a", mean.bca_a},
            {"mean_bca_ci95", interval(mean.bca95)},
            {"median", median.estimate},
            {"median_pctl_025", median.percentile95.low},
            {"median_pctl_975", median.percentile95.high}};
}

}  // namespace

std::map<std::string, StatsFunction> group_statistics() {
    return {{"mann-whitney", mann_whitney}, {"kruskal", kruskal}, {"wilcoxon", wilcoxon},
            {"spearman", spearman},         {"roc", roc},         {"bootstrap", bootstrap}};
}

}  // namespace placode::cli
