// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl task publish: a centre's own task becomes one that counts.

#include <memory>

#include "curriculum/task.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

struct TaskOptions {
    std::string file, reason;
};

int publish(const Context& context, const TaskOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    const curriculum::Task task = curriculum::load_task(options.file);
    db::DefinitionRecord definition;
    definition.kind = "task";
    definition.id = task.id;
    definition.version = task.version;
    definition.json = task.json;
    definition.reason = options.reason;
    as_input([&] { session.store().definitions().publish(definition); });
    const auto there = session.store().definitions().find("task", task.id, task.version);
    print(context,
          {{"kind", "task"},
           {"id", task.id},
           {"version", task.version},
           {"checksum", there->checksum}},
          "published task " + task.id + " version " + std::to_string(task.version) +
              "; it is never changed from now on");
    return 0;
}

}  // namespace

void add_task_commands(CLI::App& app, Context& context) {
    CLI::App* task = app.add_subcommand("task", "A centre's own tasks");
    task->require_subcommand(1);
    auto options = std::make_shared<TaskOptions>();
    CLI::App* command = task->add_subcommand(
        "publish", "Publishes a version for good: attempts at it count from then on");
    command->add_option("FILE", options->file, "FILE.json, or the id of one in the data folder")
        ->required();
    command->add_option("--reason", options->reason, "Needed after the first version");
    command->callback([&context, options] {
        context.run = [&context, options] { return publish(context, *options); };
    });
}

}  // namespace placode::cli
