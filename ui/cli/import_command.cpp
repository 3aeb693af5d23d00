// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl import: a recording made elsewhere, or left over, becomes an attempt of a person.

#include <memory>

#include "assessment/scoring.h"
#include "curriculum/task.h"
#include "db/recording_file.h"
#include "ui/cli/save_recording.h"

namespace placode::cli {

SavedAttempt save_recording(Session& session, int64_t user_id, const std::string& file) {
    const sim::Recording recording = db::read_recording_file(file);
    const curriculum::Task task =
        curriculum::load_task_text(recording.header.task_json, file + " (its task)");
    db::AttemptResult result;
    result.header = recording.header;
    result.end = recording.end;
    result.events = recording.events;
    result.metrics = assessment::compute_metrics(recording);
    result.score = assessment::score_attempt(task.rubric, result.metrics, recording);
    result.recording_file = file;
    return {session.store().save_attempt(user_id, result), result.score, result.end.duration_s};
}

namespace {

struct Options {
    std::string file, user;
};

int import_recording(const Context& context, const Options& options) {
    Session session(context, Missing::kRefuse);
    const db::UserRecord user = session.find_user(options.user);
    const bool own = session.user() && session.user()->id == user.id;
    session.need(db::Action::kPerformAttempt, own ? db::Scope::kOwn : db::Scope::kOther);
    SavedAttempt saved;
    try {
        saved = save_recording(session, user.id, options.file);
    } catch (const db::StoreError& error) {
        if (error.kind() == db::StoreError::Kind::kDamaged) throw InputError(error.what());
        throw;
    }
    session.store().audit(session.actor(), "attempt.import", "attempt " + std::to_string(saved.id),
                          options.file);
    print(context, {{"attempt", saved.id}, {"user", user.login}, {"points", saved.score.points}},
          "saved as attempt " + std::to_string(saved.id) + " of " + user.login + ": " +
              fixed(saved.score.points, 1) + " points\n");
    return 0;
}

}  // namespace

void add_import_command(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("import", "Saves a recording file as an attempt of a person");
    command->add_option("FILE", options->file, "FILE.placode")->required();
    command->add_option("--user", options->user, "Login or number")->required();
    command->callback([&context, options] {
        context.run = [&context, options] { return import_recording(context, *options); };
    });
}

}  // namespace placode::cli
