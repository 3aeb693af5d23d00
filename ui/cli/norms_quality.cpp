// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/norms_quality.h"

#include <algorithm>
#include <memory>

#include "assessment/known_groups.h"
#include "assessment/statistics.h"
#include "ui/cli/norm_levels.h"

namespace placode::cli {
namespace {

Json separation_json(const assessment::Separation& found) {
    return {{"auc", found.auc},
            {"low", found.ci95.low},
            {"high", found.ci95.high},
            {"perfect", found.perfect}};
}
std::string separation_text(const assessment::Separation& found) {
    return fixed(found.auc, 3) + " (" + fixed(found.ci95.low, 3) + " to " +
           fixed(found.ci95.high, 3) + (found.perfect ? ", all apart" : "") + ")";
}

/// The score of known groups, in words and as JSON; nothing where one of them is empty.
std::string describe_score(const batches::SkillLevels& levels, Json& json) {
    const auto low = db::level_values(levels.novices, "points", true);
    const auto middle = db::level_values(levels.intermediates, "points", true);
    const auto high = db::level_values(levels.experts, "points", true);
    if (low.empty() || high.empty()) return "no novices or no experts: nothing to compare\n";
    const auto groups = assessment::known_groups(low, middle, high);
    json = {{"novices", groups.novices},
            {"intermediates", groups.intermediates},
            {"experts", groups.experts},
            {"novice_median", groups.novice_median},
            {"intermediate_median", optional_number(groups.intermediate_median)},
            {"expert_median", groups.expert_median},
            {"novices_passed", levels.novices.passed()},
            {"intermediates_passed", levels.intermediates.passed()},
            {"experts_passed", levels.experts.passed()},
            {"not_attempted", levels.not_attempted},
            {"expert_novice", separation_json(groups.expert_novice)}};
    std::string text = "score: area under the curve, experts against novices " +
                       separation_text(groups.expert_novice) + "\n";
    if (groups.between) {
        json["expert_intermediate"] = separation_json(*groups.expert_intermediate);
        json["intermediate_novice"] = separation_json(*groups.intermediate_novice);
        json["between"] = *groups.between;
        text += "experts against intermediates " + separation_text(*groups.expert_intermediate) +
                "; intermediates against novices " + separation_text(*groups.intermediate_novice) +
                "\n";
    }
    std::vector<std::vector<std::string>> rows{
        {"level", "people", "median", "least", "most", "passed"}};
    const auto add = [&](const char* name, const std::vector<double>& values,
                         const db::LevelAttempts& level) {
        if (values.empty()) return;
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        rows.push_back(
            {name, std::to_string(values.size()), fixed(assessment::median_of(values), 1),
             fixed(*least, 1), fixed(*most, 1),
             std::to_string(level.passed()) + " of " + std::to_string(level.attempts())});
    };
    add("expert", high, levels.experts);
    add("intermediate", middle, levels.intermediates);
    add("novice", low, levels.novices);
    text += table(rows);
    if (groups.between)
        text += *groups.between ? "the intermediates lie between\n"
                                : "ATTENTION: the intermediates do not lie between\n";
    return text + "\n";
}

int norms_quality(const Context& context, const QualityOptions& options) {
    const batches::SkillLevels levels = norm_levels(context, options);
    Json json{{"task", options.task}, {"score", nullptr}, {"metrics", Json::array()}};
    const std::string score = describe_score(levels, json["score"]);
    std::vector<std::vector<std::string>> rows{
        {"metric", "people", "Hedges g", "95 %", "delta", "ICC(2,1)", "ceiling %", "evidence"}};
    for (const auto& one : db::metric_panel(levels.novices, levels.experts, options.repeats)) {
        json["metrics"].push_back({{"metric", one.metric},
                                   {"novices", one.novices},
                                   {"experts", one.experts},
                                   {"hedges_g", optional_number(one.g)},
                                   {"hedges_g_low", optional_number(one.g_low)},
                                   {"hedges_g_high", optional_number(one.g_high)},
                                   {"cliff_delta", optional_number(one.cliff_delta)},
                                   {"repeats", one.repeats},
                                   {"repeated", one.repeated},
                                   {"icc_2_1", optional_number(one.icc)},
                                   {"icc_2_1_low", optional_number(one.icc_low)},
                                   {"icc_2_1_high", optional_number(one.icc_high)},
                                   {"ceiling_percent", optional_number(one.ceiling_percent)},
                                   {"evidence", one.evidence},
                                   {"why", one.why}});
        rows.push_back(
            {one.metric, std::to_string(one.novices) + " / " + std::to_string(one.experts),
             optional_text(one.g, 2),
             one.g ? fixed(*one.g_low, 2) + " to " + fixed(*one.g_high, 2) : "-",
             optional_text(one.cliff_delta, 2), optional_text(one.icc, 2),
             optional_text(one.ceiling_percent, 0), one.evidence ? "yes" : "NO: " + one.why});
    }
    print(context, json, score + table(rows));
    return 0;
}

}  // namespace

void add_norms_quality_command(CLI::App& norms, Context& context) {
    auto options = std::make_shared<QualityOptions>();
    CLI::App* panel = norms.add_subcommand(
        "quality", "How much each metric is worth, and whether the score tells groups apart");
    panel->add_option("TASK", options->task, "Task id")->required();
    panel->add_option("--novices", options->novices, "Group");
    panel->add_option("--intermediates", options->intermediates, "Group that should lie between");
    panel->add_option("--experts", options->experts, "Group");
    CLI::Option* recordings =
        panel->add_option("--recordings", options->recordings,
                          "Instead of groups: a folder with recordings of scripted operators");
    panel
        ->add_option("--batch", options->batch,
                     "Instead of groups: a batch of rollouts, planned with --metrics")
        ->excludes(recordings);
    panel->add_option("--repeats", options->repeats, "Attempts a person that enter the ICC")
        ->check(CLI::Range(2, 100))
        ->capture_default_str();
    panel->callback([&context, options] {
        context.run = [&context, options] { return norms_quality(context, *options); };
    });
}

}  // namespace placode::cli
