// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl standard show|set: the pass mark of a task, from two groups of people or from judges.

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "db/standards.h"
#include "sim/core/counted.h"
#include "ui/cli/people.h"
#include "ui/cli/session.h"
#include "ui/cli/stats_table.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct StandardOptions {
    std::string task, reason, angoff;
    std::vector<std::string> novices, experts;
    int last = 3;
    bool dry_run = false;
};

Json group_json(const curriculum::StandardGroup& group) {
    return {{"n", group.n},
            {"mean_points", group.mean_points},
            {"sd_points", group.sd_points},
            {"theoretical_wrong", group.theoretical_wrong},
            {"observed_wrong", group.observed_wrong}};
}

Json json_of(const curriculum::PassStandard& standard) {
    if (standard.method == "angoff")
        return {{"task", standard.task_id},
                {"version", standard.version},
                {"pass_points", standard.pass_points},
                {"method", standard.method},
                {"judges", standard.angoff.judges},
                {"items", standard.angoff.items},
                {"se_points", standard.angoff.se_points}};
    return {{"task", standard.task_id},
            {"version", standard.version},
            {"pass_points", standard.pass_points},
            {"method", standard.method},
            {"mean_of_last_attempts", standard.mean_of_last_attempts},
            {"novice", group_json(standard.novice)},
            {"expert", group_json(standard.expert)}};
}

std::string standard_text(const curriculum::PassStandard& standard) {
    if (standard.method == "angoff")
        return "pass mark " + fixed(standard.pass_points, 1) + " points (angoff, " +
               sim::counted(standard.angoff.judges, "judge") + ", standard error " +
               fixed(standard.angoff.se_points, 1) + ")";
    return "pass mark " + fixed(standard.pass_points, 1) + " points (" + standard.method + ", " +
           sim::counted(standard.novice.n, "novice") + ", " +
           sim::counted(standard.expert.n, "expert") + "); novices who pass " +
           fixed(100 * standard.novice.theoretical_wrong, 0) + " % by the curves, " +
           fixed(100 * standard.novice.observed_wrong, 0) + " % observed";
}

int show(const Context& context, const StandardOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kViewAttempts, Scope::kOwn);
    const curriculum::Task task = curriculum::load_task(options.task);
    const auto set = db::standard_at(session.store(), task.id);
    Json json{{"task", task.id}, {"set", set.has_value()}};
    if (!set) {
        json["pass_points"] = task.rubric.pass_points;
        print(context, json,
              "none was set; the task's own pass mark of " + fixed(task.rubric.pass_points, 1) +
                  " points holds");
        return 0;
    }
    json = json_of(set->standard);
    json["set"] = true;
    json["set_by"] = set->set_by;
    json["set_utc"] = set->set_utc;
    json["reason"] = set->reason;
    print(context, json,
          standard_text(set->standard) + ", version " + std::to_string(set->standard.version) +
              ", by " + set->set_by + " on " + set->set_utc);
    return 0;
}

std::vector<int64_t> accounts_named(Session& session, const std::vector<std::string>& logins) {
    std::vector<int64_t> people;
    for (const std::string& login : logins) people.push_back(session.find_user(login).id);
    return people;
}

/// One row a judge, one column a line of the rubric (its id), estimates from 0 to 1.
curriculum::PassStandard from_judges(const curriculum::Task& task, const std::string& file) {
    const StatsTable table = read_stats_table(file);
    std::vector<double> weights;
    std::vector<std::vector<double>> estimates(table.rows.size());
    for (const assessment::RubricItem& item : task.rubric.items) {
        const size_t column = table.column(item.id);
        for (size_t row = 0; row < table.rows.size(); ++row)
            estimates[row].push_back(table.needed(row, column));
        weights.push_back(std::min(item.max_points, 100.0));
    }
    return db::standard_of_judges(task.id, assessment::angoff(estimates, weights));
}

curriculum::PassStandard from_groups(Session& session, const curriculum::Task& task,
                                     const StandardOptions& options) {
    if (options.novices.empty() || options.experts.empty())
        throw InputError(
            "standard set: expected --novice and --expert with logins, or --angoff FILE.csv");
    const auto novices = accounts_named(session, options.novices),
               experts = accounts_named(session, options.experts);
    std::vector<int64_t> both = novices;
    both.insert(both.end(), experts.begin(), experts.end());
    db::need_fit_to_judge(session.store(), task.id, both, options.last);
    const auto means = [&](const std::vector<int64_t>& people) {
        return db::person_means(session.store(), task.id, people, options.last);
    };
    return db::standard_of_groups(task.id, means(novices), means(experts), options.last);
}

int set(const Context& context, const StandardOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kSetStandards, Scope::kOther);
    const curriculum::Task task = curriculum::load_task(options.task);
    curriculum::PassStandard standard;
    try {
        standard = options.angoff.empty() ? from_groups(session, task, options)
                                          : from_judges(task, options.angoff);
    } catch (const std::invalid_argument& error) {
        throw InputError("standard set: " +
                         (options.angoff.empty() ? std::string("these groups") : options.angoff) +
                         ": no pass mark: " + std::string(error.what()));
    }
    if (!options.dry_run) {
        try {
            standard.version = db::set_standard(session.store(), standard, options.reason);
        } catch (const db::StoreError& error) {
            if (error.kind() == db::StoreError::Kind::kRefused) throw InputError(error.what());
            throw;
        }
    }
    Json json = json_of(standard);
    json["dry_run"] = options.dry_run;
    print(context, json, standard_text(standard));
    return 0;
}

}  // namespace

void add_standard_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<StandardOptions>();
    CLI::App* standard = app.add_subcommand("standard", "Pass marks of tasks from two groups");
    standard->require_subcommand(1);
    const auto command = [&](const char* name, const char* help, auto work) {
        CLI::App* added = standard->add_subcommand(name, help);
        added->add_option("--task", options->task, "Id")->required();
        added->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    };
    command("show", "What holds, and since when", show);
    CLI::App* made =
        command("set", "Contrasting groups or judges: keeps the mark as the next version", set);
    made->add_option("--novice", options->novices, "Logins or numbers")->delimiter(',');
    made->add_option("--expert", options->experts, "Logins or numbers")->delimiter(',');
    made->add_option("--angoff", options->angoff,
                     "FILE.csv: a row a judge, a column an item of the rubric, 0 to 1");
    made->add_option("--last", options->last, "Attempts of which a person's mean is taken")
        ->check(CLI::Range(1, 100));
    made->add_option("--reason", options->reason, "Needed from the second version on");
    made->add_flag("--dry-run", options->dry_run, "Computes only");
}

}  // namespace placode::cli
