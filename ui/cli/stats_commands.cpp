// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl stats NAME FILE.csv: the statistics of a study, one JSON answer each.

#include <memory>
#include <stdexcept>

#include "ui/cli/stats_table.h"
#include "ui/finite_range.h"
#include "ui/seed_range.h"
#include "ui/usage_message.h"

namespace placode::cli {
namespace {

std::map<std::string, StatsFunction> all_statistics() {
    auto all = rating_statistics();
    all.merge(group_statistics());
    all.merge(learning_statistics());
    return all;
}

/// One line a value, nested keys joined by dots.
void flatten(const Json& json, const std::string& prefix, std::string& text) {
    if (json.is_object()) {
        for (const auto& [key, value] : json.items())
            flatten(value, prefix.empty() ? key : prefix + "." + key, text);
    } else if (json.is_array() && !json.empty() && json[0].is_object()) {
        for (size_t i = 0; i < json.size(); ++i)
            flatten(json[i], prefix + "." + std::to_string(i + 1), text);
    } else {
        text += prefix + "  " + (json.is_string() ? json.get<std::string>() : json.dump()) + "\n";
    }
}

int run_stats(const Context& context, const StatsOptions& options) {
    const auto all = all_statistics();
    const auto found = all.find(options.name);
    if (found == all.end()) {
        std::vector<std::string> names;
        names.reserve(all.size());
        for (const auto& [name, function] : all) names.push_back(name);
        throw InputError("stats: unknown statistic \"" + options.name + "\"; expected one of: " +
                         ui::list_of(names) + sim::did_you_mean(options.name, names));
    }
    const StatsTable table = read_stats_table(options.file);
    Json json;
    try {
        json = found->second(table, options);
    } catch (const std::invalid_argument& error) {
        throw InputError(table.path + ": " + error.what());
    }
    std::string text;
    flatten(json, "", text);
    print(context, json, text);
    return 0;
}

}  // namespace

void add_stats_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<StatsOptions>();
    CLI::App* stats = app.add_subcommand(
        "stats", "A statistic of a CSV table; every answer says n and what was missing");
    stats
        ->add_option(
            "name", options->name,
            "likert alpha omega icc cvi cvr mann-whitney kruskal wilcoxon spearman roc bootstrap "
            "contrasting-groups angoff cusum lc-cusum learning-curve")
        ->required();
    stats->add_option("file", options->file, "CSV with a header")->required();
    stats->add_option("--reverse", options->reverse, "Reverse-keyed items, comma between");
    stats->add_option("--scale", options->scale, "LOW:HIGH of the items, e.g. 1:6");
    stats->add_option("--groups", options->groups,
                      "The two groups, FIRST,SECOND (contrasting-groups: NOVICES,EXPERTS)");
    stats->add_option("--positive", options->positive,
                      "Value of the first column that counts as positive (roc)");
    stats->add_option("--value", options->value, "Column with the values");
    stats->add_option("--by", options->by, "Column with the groups");
    stats->add_option("--statistic", options->statistic, "mean or median (bootstrap)");
    stats->add_option("--resamples", options->resamples, "Monte-Carlo resamples (bootstrap)");
    stats->add_option("--seed", options->seed, "Seed of the resampling (bootstrap)")
        ->transform(ui::seed_range());
    stats->add_option("--digits", options->digits,
                      "Significant digits of the differences before ties are counted (wilcoxon; "
                      "default: exact, as R)");
    stats->add_option("--p0", options->p0, "Acceptable failure rate (cusum)");
    stats->add_option("--p1", options->p1, "Unacceptable failure rate (cusum)");
    stats->add_option("--alpha", options->alpha, "Type I error (cusum)");
    stats->add_option("--beta", options->beta, "Type II error (cusum)");
    stats
        ->add_option("--success-at", options->success_at,
                     "Least score that is a success (cusum, lc-cusum)")
        ->check(ui::finite_range(-1e9, 1e9));
    stats->add_option("--adequate", options->adequate, "Adequate failure rate (lc-cusum)");
    stats->add_option("--inadequate", options->inadequate, "Inadequate failure rate (lc-cusum)");
    stats->add_option("--limit", options->h, "Limit h that signals competence (lc-cusum)")
        ->check(ui::finite_range(0.0, 1e9));
    stats->callback([&context, options] {
        context.run = [&context, options] { return run_stats(context, *options); };
    });
}

}  // namespace placode::cli
