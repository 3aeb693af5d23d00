// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <stdexcept>

#include "db/norm_bands.h"
#include "sim/core/near_word.h"
#include "ui/cli/norms_standard.h"
#include "ui/cli/people.h"

namespace placode::cli {
namespace {

struct PassMarkOptions {
    std::string task, metric = "points", novices, experts;
    bool per_attempt = false;
};

struct TwoLevels {
    db::LevelAttempts novices, experts;
};
TwoLevels two_levels(Session& session, const PassMarkOptions& options) {
    auto levels = db::level_attempts(session.store(), options.task,
                                     {{"expert", find_group(session, options.experts).members},
                                      {"novice", find_group(session, options.novices).members}});
    // A mark is a mark, whichever command computes it: as of db/standards.h.
    db::leave_demonstrations_out(session.store(), levels);
    as_input([&] {
        db::need_proof(levels);
        db::need_same_rules(levels);
    });
    return {std::move(levels[1]), std::move(levels[0])};
}

/// A metric that nobody measures has no values, which says less than that it is misspelt.
void need_metric(const std::string& id) {
    if (id == "points" || assessment::metric_definition(id) != nullptr) return;
    std::vector<std::string> known{"points"};
    for (const auto& each : assessment::metric_definitions()) known.emplace_back(each.id);
    throw InputError("--metric: unknown metric \"" + id +
                     "\"; expected \"points\" or one that `placodectl score` prints" +
                     sim::did_you_mean(id, known));
}

int standard(const Context& context, const PassMarkOptions& options) {
    need_metric(options.metric);
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    const TwoLevels levels = two_levels(session, options);
    const db::LevelAttempts &novices = levels.novices, &experts = levels.experts;
    assessment::ContrastingGroups groups;
    try {
        groups = db::pass_mark_between(novices, experts, options.metric, !options.per_attempt);
    } catch (const std::invalid_argument& error) {
        const auto values = [&](const db::LevelAttempts& level) {
            return std::to_string(
                db::level_values(level, options.metric, !options.per_attempt).size());
        };
        throw InputError("norms standard: " + std::string(error.what()) + " (" + values(novices) +
                         " novice and " + values(experts) + " expert values of " + options.metric +
                         ")");
    }
    print(context,
          {{"task", options.task},
           {"metric", options.metric},
           {"unit", options.per_attempt ? "attempt" : "person"},
           {"n_novice", groups.n_novice},
           {"n_expert", groups.n_expert},
           {"mean_novice", groups.mean_novice},
           {"sd_novice", groups.sd_novice},
           {"mean_expert", groups.mean_expert},
           {"sd_expert", groups.sd_expert},
           {"cut_score", groups.cut_score},
           {"theoretical_false_positive", groups.theoretical_false_positive},
           {"theoretical_false_negative", groups.theoretical_false_negative},
           {"observed_false_positive", groups.observed_false_positive},
           {"observed_false_negative", groups.observed_false_negative},
           {"auc", groups.auc}},
          "pass mark " + fixed(groups.cut_score, 2) + " " + options.metric + " (novices " +
              fixed(groups.mean_novice, 1) + " SD " + fixed(groups.sd_novice, 1) + ", experts " +
              fixed(groups.mean_expert, 1) + " SD " + fixed(groups.sd_expert, 1) +
              ")\nfalse passes: theoretical " + fixed(100 * groups.theoretical_false_positive, 1) +
              " %, observed " + fixed(100 * groups.observed_false_positive, 1) +
              " %; false fails: theoretical " + fixed(100 * groups.theoretical_false_negative, 1) +
              " %, observed " + fixed(100 * groups.observed_false_negative, 1) + " %");
    return 0;
}

}  // namespace

void add_norms_standard_command(CLI::App& norms, Context& context) {
    auto options = std::make_shared<PassMarkOptions>();
    CLI::App* mark = norms.add_subcommand("standard", "Pass mark from contrasting groups");
    mark->add_option("TASK", options->task, "Task id")->required();
    mark->add_option("--novices", options->novices, "Group")->required();
    mark->add_option("--experts", options->experts, "Group")->required();
    mark->add_option("--metric", options->metric, "\"points\" or a metric's id")
        ->capture_default_str();
    mark->add_flag("--per-attempt", options->per_attempt,
                   "Every attempt counts, not each person's mean");
    mark->callback([&context, options] {
        context.run = [&context, options] { return standard(context, *options); };
    });
}

}  // namespace placode::cli
