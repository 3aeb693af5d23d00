// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl rescore | scores: old attempts under a new rubric, both scores kept.

#include <memory>

#include "db/rescore.h"
#include "ui/cli/progress.h"
#include "ui/cli/rescore_report.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

struct RescoreCommandOptions {
    std::string task, user;
    bool dry_run = false;
    int64_t attempt = 0;
};

int rescore(const Context& context, const RescoreCommandOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    const curriculum::Task task = curriculum::load_task(options.task);
    db::RescoreOptions how;
    how.dry_run = options.dry_run;
    if (!options.user.empty()) how.user_id = session.find_user(options.user).id;
    const CancelOn cancel{SIGINT};
    return run_rescoring(context, session.store(), task, std::move(how), "rescoring");
}

int scores(const Context& context, const RescoreCommandOptions& options) {
    Session session(context, Missing::kRefuse);
    const db::AttemptDetail attempt = session.store().attempts().detail(options.attempt);
    session.need_for(db::Action::kViewAttempts, attempt.record.user_id);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"points", "verdict", "rubric", "metric set", "pre-processing", "scored (UTC)", "by"}};
    const auto add = [&](const assessment::Score& score, int preprocessing, const std::string& at,
                         const std::string& by) {
        json.push_back({{"points", score.points},
                        {"verdict", assessment::verdict_name(score.verdict)},
                        {"rubric", score.rubric_id},
                        {"rubric_version", score.rubric_version},
                        {"metric_set_version", score.metric_set_version},
                        {"preprocessing_version", preprocessing},
                        {"scored_utc", at},
                        {"scored_by", by}});
        rows.push_back({fixed(score.points, 2), assessment::verdict_name(score.verdict),
                        score.rubric_id + " " + std::to_string(score.rubric_version),
                        std::to_string(score.metric_set_version), std::to_string(preprocessing), at,
                        by});
    };
    add(attempt.score, attempt.record.preprocessing_version, attempt.record.started_utc,
        "when it was made");
    for (const auto& each : session.store().attempts().rescores(options.attempt))
        add(each.score, each.preprocessing_version, each.scored_utc, each.scored_by);
    print(context, json, table(rows));
    return 0;
}

}  // namespace

void add_rescore_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<RescoreCommandOptions>();
    CLI::App* rescored = app.add_subcommand(
        "rescore", "Scores stored attempts again from their recordings; the first score stays");
    rescored->add_option("--task", options->task, "Task id, or FILE.json with the new rubric")
        ->required();
    rescored->add_option("--user", options->user, "Only this person's attempts");
    rescored->add_flag("--dry-run", options->dry_run, "Computes and compares, saves nothing");
    rescored->callback([&context, options] {
        context.run = [&context, options] { return rescore(context, *options); };
    });
    CLI::App* listed = app.add_subcommand("scores", "All scores of one attempt");
    listed->add_option("ATTEMPT", options->attempt, "Number")->required();
    listed->callback([&context, options] {
        context.run = [&context, options] { return scores(context, *options); };
    });
}

}  // namespace placode::cli
